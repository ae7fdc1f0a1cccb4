//! What the listing does, counted piece by piece.

use crate::fill::written::WrittenFill;

/// Numbers of the grid that the listing reads, whatever part of it is cut out: 210 rows of 238 columns.
const NUMBERS_OF_GRID: u64 = 210 * 238;

/// Pieces of work of the listing, in the order of its routines.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Work {
    /// TER_CROP: numbers that are read by format.
    pub numbers: u64,
    /// READ_IMAGE: bytes of the photograph.
    pub bytes: u64,
    /// TER_INTRP: visits of posts, two each.
    pub visits: u64,
    /// REAL_EL: rows of posts, a record each.
    pub rows: u64,
    /// TER_DMS: posts that become georectangular.
    pub placed: u64,
    /// IM_REFIJ: posts that are projected into the photograph.
    pub referenced: u64,
    /// IM_REFAVG: pixels in the means of panels.
    pub averaged: u64,
    /// IM_REFAVG: panels, a record each.
    pub panels: u64,
    /// AFFIN: how often it runs.
    pub affine: u64,
    /// NEW_IJ: posts that are projected into the picture.
    pub projected: u64,
    /// NODE_DEPTH: posts whose distance is taken.
    pub measured: u64,
    /// FILL: work over panels and pixels.
    pub fill: FillPieces,
}

/// Pieces of the routine FILL and of FRAMEFIL, which it calls.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct FillPieces {
    /// Cells of picture and depth buffer, cleared once.
    pub cells: u64,
    /// Panels whose record is read and whose plane is found.
    pub panels: u64,
    /// What filling panels with both ends of a span takes; nothing where another way fills.
    pub written: WrittenFill,
    /// Pixels that a panel was written into, each as often as it was.
    pub pixels: u64,
    /// Records of the picture, a row of the screen each.
    pub records: u64,
}

impl Work {
    /// Work before any picture, but for the means of panels: of `rows` x `columns` posts and a photograph of `bytes` pixels.
    pub(crate) fn before_pictures([rows, columns]: [usize; 2], bytes: usize) -> Self {
        let posts = (rows * columns) as u64;
        Self {
            numbers: NUMBERS_OF_GRID,
            bytes: bytes as u64,
            visits: 2 * posts,
            rows: rows as u64,
            placed: posts,
            referenced: posts,
            ..Self::default()
        }
    }
}
