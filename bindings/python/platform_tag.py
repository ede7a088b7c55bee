"""Platform tags of wheels for Linux."""


def linux(platform, needed, versions, accepted):
    """The platform tag of a wheel for Linux: manylinux or musllinux where pip accepts it, else `platform`.

    platform: such as "linux_x86_64". needed, versions: the libraries and the versions of symbols that the library needs.
    accepted: the tags that this machine accepts, best first: packaging.tags.platform_tags().
    """
    musl = [tag for tag in accepted if tag.startswith("musllinux_")]
    if musl:
        # musl has no versions of symbols: this machine's version or a newer one.
        return musl[0] if all(name == "libc.so" or name.startswith("libc.musl-") for name in needed) else platform
    if not needed <= {"libc.so.6"} or not all(version.startswith("GLIBC_2.") for version in versions):
        return platform
    # The newest glibc whose symbols the library needs; manylinux_2_17 (manylinux2014) is the oldest that pip is asked for.
    newest = max([17, *(int(version.split(".")[1]) for version in versions)])
    return platform.replace("linux", f"manylinux_2_{newest}", 1)
