//! The samples of an area, in the axes of the bank.

/// Samples on a regular grid; line 0 is the southernmost, column 0 the westernmost.
#[derive(Debug, Clone)]
pub struct Patch {
    /// Place of line 0 and column 0: north, east of the bank's origin (m); 0 or up to one step above.
    pub first: [f64; 2],
    /// From line to line and from column to column (m), above 0.
    pub step: [f64; 2],
    /// Numbers of lines and columns.
    pub count: [usize; 2],
    /// Heights (m), line by line; NaN marks a void, also places that the file does not hold.
    pub heights: Vec<f64>,
    /// Line and column in the file of line 0 and column 0; negative outside it.
    pub file_first: [i64; 2],
    /// From line to line and from column to column in the file: 1 or -1.
    pub file_step: [i64; 2],
}

impl Patch {
    /// Place of a sample: north, east (m).
    pub fn place(&self, line: usize, column: usize) -> [f64; 2] {
        [self.first[0] + line as f64 * self.step[0], self.first[1] + column as f64 * self.step[1]]
    }

    /// Line and column in the file, counted from 0.
    pub fn in_file(&self, line: usize, column: usize) -> [i64; 2] {
        let at = |k: usize, index: usize| self.file_first[k] + index as i64 * self.file_step[k];
        [at(0, line), at(1, column)]
    }
}
