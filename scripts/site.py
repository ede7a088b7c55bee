#!/usr/bin/env python3
"""Builds the pages as HTML in one folder that can be published, with the C and C++ references, cargo doc and the demo beside it.

    python3 scripts/site.py [FOLDER]            (needs mkdocs; FOLDER is target/site otherwise)

Every link of the pages is checked. What cannot be built because a tool is missing prints SKIPPED.
"""

import html.parser
import os
import pathlib
import re
import shutil
import subprocess
import sys
import urllib.parse

ROOT = pathlib.Path(__file__).resolve().parents[1]
TARGET = pathlib.Path(os.environ.get("CARGO_TARGET_DIR", ROOT / "target")).resolve()
LINK = re.compile(r"(\]\()([^)\s#]*)(#[^)\s]*)?(\))")
SECTIONS = ("start", "guide", "cookbook", "reference", "evidence", "maintain")


def place(path):
    """Where a file of the repository is in the sources of the site: pages keep their folders, other files are copied to files/."""
    if path == ROOT / "README.md":
        return pathlib.PurePosixPath("index.md")
    if path == ROOT / "docs" / "README.md":
        return pathlib.PurePosixPath("pages.md")
    if path.is_relative_to(ROOT / "docs"):
        return pathlib.PurePosixPath(path.relative_to(ROOT / "docs").as_posix())
    return pathlib.PurePosixPath("files") / path.relative_to(ROOT).as_posix()


def copied(page, sources, others):
    """A page with its links rewritten; files that are no pages are added to `others`."""
    here = place(page).parent

    def link(match):
        target = match[2]
        if not target or "://" in target:
            return match[0]
        path = (page.parent / urllib.parse.unquote(target)).resolve()
        if path.is_dir():
            path = next((path / name for name in ("README.md", "kstrip.m") if (path / name).exists()), path)
        if not path.is_file():
            return match[0]  # mkdocs reports it
        there = place(path)
        if there.parts[0] == "files":
            others.add(path)
            # Markdown outside docs is shown as it is
            if there.suffix == ".md":
                there = there.with_suffix(".md.txt")
        return f"{match[1]}{os.path.relpath(there, here)}{match[3] or ''}{match[4]}".replace(os.sep, "/")

    parts = re.split(r"(?ms)^(```.*?^```$)", page.read_text(encoding="utf-8"))
    text = "".join(part if part.startswith("```") else LINK.sub(link, part) for part in parts)
    file = sources / place(page)
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(text, encoding="utf-8")


def title(page):
    return page.read_text(encoding="utf-8").split("\n", 1)[0].lstrip("# ").replace('"', "'")


def navigation():
    lines = ['  - "kstrip": index.md', '  - "All pages": pages.md']
    for section in SECTIONS:
        lines.append(f'  - "{section.capitalize()}":')
        lines += [f'      - "{title(page)}": {place(page)}' for page in sorted((ROOT / "docs" / section).glob("*.md"))]
    return "\n".join(lines)


def pages(folder, work):
    """The pages by mkdocs, which reports links to what does not exist."""
    sources, others = work / "src", set()
    shutil.rmtree(work, ignore_errors=True)
    for page in [ROOT / "README.md", *sorted((ROOT / "docs").rglob("*.md"))]:
        copied(page, sources, others)
    for picture in [*(ROOT / "docs").rglob("*.svg"), *(ROOT / "docs").rglob("*.png")]:
        others.add(picture)
    others.add(ROOT / "docs" / "maintain" / "abi.txt")
    for path in others:
        there = place(path)
        there = there.with_suffix(".md.txt") if there.parts[0] == "files" and there.suffix == ".md" else there
        file = sources / there
        file.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(path, file)
    settings = work / "mkdocs.yml"
    settings.write_text(f"""site_name: kstrip
docs_dir: {sources}
site_dir: {folder}
use_directory_urls: false
theme: {{name: readthedocs, highlightjs: false, navigation_depth: 2}}
markdown_extensions: [tables, fenced_code, toc, attr_list]
plugins: []
validation: {{nav: {{omitted_files: warn, not_found: warn}}, links: {{not_found: warn, anchors: warn, unrecognized_links: warn}}}}
nav:
{navigation()}
""", encoding="utf-8")
    subprocess.run([sys.executable, "-m", "mkdocs", "build", "--quiet", "--strict", "--config-file", str(settings)], check=True)


class Links(html.parser.HTMLParser):
    def __init__(self):
        super().__init__()
        self.found, self.anchors = [], set()

    def handle_starttag(self, tag, attributes):
        for name, value in attributes:
            if name in ("href", "src") and value:
                self.found.append(value)
            if name in ("id", "name") and value:
                self.anchors.add(value)


def check(folder):
    """The links of every page that mkdocs wrote lead to a file and, with #, to a place in it."""
    read = {}

    def of(path):
        if path not in read:
            read[path] = Links()
            read[path].feed(path.read_text(encoding="utf-8"))
        return read[path]

    faults, count = [], 0
    files = [path for path in folder.rglob("*.html") if path.relative_to(folder).parts[0] not in ("c", "cpp", "rust", "demo", "files")]
    for page in files:
        for link in of(page).found:
            url = urllib.parse.urlsplit(link)
            if url.scheme or url.netloc or not (url.path or url.fragment):
                continue
            target = (page.parent / urllib.parse.unquote(url.path)).resolve() if url.path else page
            count += 1
            if not target.exists():
                faults.append(f"{page.relative_to(folder)}: {link}")
            elif url.fragment and target.suffix == ".html" and target in files and urllib.parse.unquote(url.fragment) not in of(target).anchors:
                faults.append(f"{page.relative_to(folder)}: {link}")
    if faults or len(files) < 40 or count < 1000:
        sys.exit("\n".join([*faults, f"{len(files)} pages, {count} links, {len(faults)} faults"]))
    print(f"{len(files)} pages, {count} links, none broken")


def reference(name, settings, folder):
    if not shutil.which("doxygen"):
        print(f"SKIPPED: the reference of {name} beside the pages, because doxygen is not installed")
        return
    work = TARGET / f"doxygen-site-{name}"
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir(parents=True)
    text = (ROOT / "docs" / settings).read_text(encoding="utf-8")
    (work / "Doxyfile").write_text(f'{text}\nOUTPUT_DIRECTORY = "{work}"\n', encoding="utf-8")
    subprocess.run(["doxygen", str(work / "Doxyfile")], cwd=ROOT, check=True)
    shutil.copytree(work / "html", folder / name)
    shutil.rmtree(work)


def main():
    folder = pathlib.Path(sys.argv[1]).resolve() if len(sys.argv) > 1 else TARGET / "site"
    try:
        import mkdocs  # noqa: F401
    except ImportError:
        print("SKIPPED: the pages as HTML, because this Python has no mkdocs")
        sys.exit(77)
    shutil.rmtree(folder, ignore_errors=True)
    work = TARGET / "site-work"
    pages(folder, work)
    reference("c", "Doxyfile", folder)
    reference("cpp", "Doxyfile.cpp", folder)
    rust = TARGET / "doc"
    if (rust / "kstrip" / "index.html").exists():
        shutil.copytree(rust, folder / "rust")
    else:
        print("SKIPPED: the Rust documentation beside the pages, because `cargo doc --no-deps --lib` has not run")
    demo = TARGET / "web" / "index.html"
    if demo.exists():
        (folder / "demo").mkdir()
        shutil.copyfile(demo, folder / "demo" / "index.html")
    else:
        print("SKIPPED: the demo beside the pages, because `scripts/web.sh` has not run")
    beside = [(path, words) for path, words in (("c/index.html", "C reference"), ("cpp/index.html", "C++ reference"),
              ("rust/kstrip/index.html", "Rust documentation"), ("demo/index.html", "Browser demo")) if (folder / path).exists()]
    (folder / "404.html").unlink(missing_ok=True)
    start = folder / "index.html"
    links = "".join(f'<li><a href="{path}">{words}</a></li>' for path, words in beside)
    text = start.read_text(encoding="utf-8")
    mark = '<h2 id="run-the-tests">'
    assert mark in text, "the place of the references"
    start.write_text(text.replace(mark, f"<ul>{links}</ul>\n{mark}"), encoding="utf-8")
    check(folder)
    shutil.rmtree(work)
    print(f"the site is in {folder}")


if __name__ == "__main__":
    main()
