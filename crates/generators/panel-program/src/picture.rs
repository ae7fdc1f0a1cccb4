//! What a frame shows, and what became of the panels.

use crate::{FillWork, Work};

/// No panel: what [`Picture::panel`] holds where nothing was drawn.
pub const NO_PANEL: u32 = u32::MAX;

/// A frame of the program, row by row from the top.
#[derive(Debug, Clone, PartialEq)]
pub struct Picture {
    /// Light; 0 where nothing was drawn, as black ground has it.
    pub light: Vec<f32>,
    /// Distance (m) as the depth buffer knows it; infinite where nothing was drawn.
    pub distance: Vec<f32>,
    /// Number of the panel, or [`NO_PANEL`].
    pub panel: Vec<u32>,
    /// How often each pixel was written.
    pub writes: Vec<u16>,
    /// What became of the panels.
    pub counts: Counts,
    /// What filling the panels has cost.
    pub work: FillWork,
    /// What the routines of the listing have done, from its files to this picture.
    pub listing: Work,
}

/// What became of the panels of a frame. Each panel is in one of them.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Counts {
    /// Panels that were filled.
    pub filled: u64,
    /// Left out because a corner lies beyond the screen, or has no image.
    pub discarded: u64,
    /// Wholly behind the eye, or beside the screen.
    pub unseen: u64,
    /// Edge-on, or without an area.
    pub edge_on: u64,
    /// Lost to a determinant of 0.
    pub lost: u64,
}

impl Picture {
    pub(crate) fn new(pixels: usize) -> Self {
        Self {
            light: vec![0.0; pixels],
            distance: vec![f32::INFINITY; pixels],
            panel: vec![NO_PANEL; pixels],
            writes: vec![0; pixels],
            counts: Counts::default(),
            work: FillWork::default(),
            listing: Work::default(),
        }
    }
}

impl Counts {
    /// All panels of the frame.
    pub fn panels(&self) -> u64 {
        self.filled + self.discarded + self.unseen + self.edge_on + self.lost
    }
}
