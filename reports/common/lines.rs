//! Markdown, line by line.

use std::fmt::Write;

/// Longest line of running text.
const WIDTH: usize = 118;

/// A line broken into shorter ones; the later lines of a list item are indented.
fn broken(line: &str) -> String {
    if line.chars().count() <= WIDTH {
        return line.to_owned();
    }
    let indent = if line.starts_with("* ") { "  " } else { "" };
    let (mut text, mut used) = (String::new(), 0);
    for word in line.split(' ').filter(|word| !word.is_empty()) {
        let length = word.chars().count();
        if used > 0 && used + 1 + length > WIDTH {
            text += "\n";
            text += indent;
            used = indent.len();
        } else if used > 0 {
            text += " ";
            used += 1;
        }
        text += word;
        used += length;
    }
    text
}

/// A text that is written line by line.
pub trait Lines {
    /// What has been written so far.
    fn text(&mut self) -> &mut String;

    /// Running text is broken into lines of at most [`WIDTH`] characters.
    fn line(&mut self, line: impl AsRef<str>) {
        for line in line.as_ref().split('\n') {
            if line.starts_with(['|', '#', '!']) {
                self.text().push_str(line);
            } else {
                self.text().push_str(&broken(line));
            }
            self.text().push('\n');
        }
    }

    /// A row of a table.
    fn row<S: AsRef<str>>(&mut self, cells: impl IntoIterator<Item = S>) {
        self.text().push('|');
        for cell in cells {
            let _ = write!(self.text(), " {} |", cell.as_ref());
        }
        self.text().push('\n');
    }

    /// The first row of a table, and the rule below it.
    fn header<S: AsRef<str>>(&mut self, cells: &[S]) {
        self.row(cells);
        self.row(cells.iter().map(|_| "---"));
    }
}
