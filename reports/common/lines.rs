//! Markdown, line by line.

use std::fmt::Write;

/// A text that is written line by line.
pub trait Lines {
    /// What has been written so far.
    fn text(&mut self) -> &mut String;

    fn line(&mut self, line: impl AsRef<str>) {
        self.text().push_str(line.as_ref());
        self.text().push('\n');
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
