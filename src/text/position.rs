//! Line and column of a text.

/// Line and column, both counted from 1; columns count characters.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct Position {
    /// Line.
    pub line: usize,
    /// Column.
    pub column: usize,
}

impl Position {
    /// The position of the byte `offset` in `text`; its end if it lies beyond.
    #[must_use]
    pub fn of(text: &str, offset: usize) -> Self {
        let mut end = offset.min(text.len());
        while !text.is_char_boundary(end) {
            end -= 1;
        }
        let before = &text[..end];
        let start = before.rfind('\n').map_or(0, |at| at + 1);
        Self { line: 1 + before.matches('\n').count(), column: 1 + before[start..].chars().count() }
    }

    /// The byte offset of the position in `text`; its end if it lies beyond.
    #[must_use]
    pub fn offset(self, text: &str) -> usize {
        let start = text.split_inclusive('\n').take(self.line - 1).map(str::len).sum::<usize>();
        let inside = text[start..].char_indices().nth(self.column - 1);
        inside.map_or(text.len(), |(at, _)| start + at)
    }
}
