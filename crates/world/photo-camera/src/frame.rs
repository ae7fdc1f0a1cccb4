//! Frames of the thesis's photograph: 10 x 10 squares of 512 pixels, turned by 180 degrees.
//!
//! The photograph counts I to the west and J to the south, from its north-east corner. Frames count from the south-east corner, I
//! to the west and J to the north. A frame displayed with its first row on top therefore has south up and west to the right.

/// Pixels along a side of a frame (reported).
const SIDE: usize = 512;
/// Index of the southernmost row J of the photograph, from which frames count (reported).
const LAST_ROW: usize = 4999;

/// A pixel of a frame of the photograph.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct FramePixel {
    /// Corner (I, J) of the frame, counted from the south-east; multiples of 512.
    pub frame: [usize; 2],
    /// Pixel IA, JA within the frame, 0..512.
    pub at: [usize; 2],
}

impl FramePixel {
    /// The frame and the pixel that hold a continuous pixel I, J; none outside the photograph.
    pub fn of([i, j]: [f64; 2]) -> Option<Self> {
        let inside = |at: f64| (0.0..(LAST_ROW + 1) as f64).contains(&at).then_some(at as usize);
        let counted = [inside(i)?, LAST_ROW - inside(j)?];
        Some(Self { frame: counted.map(|at| at / SIDE * SIDE), at: counted.map(|at| at % SIDE) })
    }

    /// The centre (I, J) of this pixel in the whole photograph.
    pub fn centre(self) -> [f64; 2] {
        let [i, j] = [0, 1].map(|k| (self.frame[k] + self.at[k]) as f64);
        [i + 0.5, LAST_ROW as f64 - j + 0.5]
    }

    /// Name of the frame: the letter of the photograph, then I and J by four digits each.
    pub fn frame_name(self, photograph: char) -> String {
        format!("{photograph}{:04}{:04}", self.frame[0], self.frame[1])
    }
}
