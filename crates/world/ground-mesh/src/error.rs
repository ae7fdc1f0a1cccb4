//! Wishes for a mesh that cannot be met.

/// Why there is no mesh.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum MeshError {
    /// The eye is not over the bank, or no place at all.
    #[error(
        "eye at ({}, {}, {}) m: expected a place over the bank, north {} to {} m and east {} to {} m",
        eye[0], eye[1], eye[2], extent[0], extent[2], extent[1], extent[3]
    )]
    Eye {
        /// The eye that was given: north, east, up (m).
        eye: [f64; 3],
        /// South, west, north and east border of the bank (m).
        extent: [f64; 4],
    },
    /// Half the side of the innermost square (m) is out of range.
    #[error("half side of the finest ring is {found} m: expected {least} m to {most} m for this bank")]
    HalfSide {
        /// The value that was found (m).
        found: f64,
        /// The least that is allowed (m).
        least: f64,
        /// The largest that is allowed (m).
        most: f64,
    },
    /// The number of cells of half a ring is out of range.
    #[error("{0} cells in half a ring: expected a multiple of 4 from 8 to 16384")]
    Cells(u32),
    /// A figure that must be above 0.
    #[error("{what} is {found}: expected a finite number above 0")]
    Figure {
        /// Name of the figure with its unit.
        what: &'static str,
        /// The value that was found.
        found: f64,
    },
}
