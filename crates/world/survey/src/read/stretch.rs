//! A stretch of lines and columns of a file.

use std::ops::Range;

/// Lines and columns of a file, both counted from 0. Columns may go on beyond the last one of a file that goes once around
/// its globe: the first column follows the last one there.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Window {
    /// Lines, from the first stored.
    pub lines: Range<usize>,
    /// Columns, from the first stored.
    pub columns: Range<usize>,
}

impl Window {
    /// Samples of the window.
    pub(crate) fn count(&self) -> usize {
        self.lines.len() * self.columns.len()
    }

    /// Blocks of so many lines and columns that the window touches: which one down, which one across.
    pub(crate) fn blocks(&self, [lines, columns]: [usize; 2]) -> impl Iterator<Item = [usize; 2]> + use<> {
        let touched = |range: &Range<usize>, size: usize| range.start / size..range.end.div_ceil(size);
        let (down, across) = (touched(&self.lines, lines), touched(&self.columns, columns));
        down.flat_map(move |down| across.clone().map(move |across| [down, across]))
    }

    /// Puts the samples of a block into those of the window; `number(index)` is sample `index` of the block, line by line.
    pub(crate) fn put(
        &self,
        [lines, columns]: [usize; 2],
        [down, across]: [usize; 2],
        samples: &mut [f64],
        number: impl Fn(usize) -> f64,
    ) {
        let held = |range: &Range<usize>, size: usize, at: usize| {
            range.start.max(at * size)..range.end.min((at + 1) * size)
        };
        for line in held(&self.lines, lines, down) {
            for column in held(&self.columns, columns, across) {
                let place = (line - self.lines.start) * self.columns.len() + column - self.columns.start;
                samples[place] = number((line - down * lines) * columns + column - across * columns);
            }
        }
    }
}
