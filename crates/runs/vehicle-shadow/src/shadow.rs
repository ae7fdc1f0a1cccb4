//! The shadow in one picture: from its gates to what it took.

use crate::blanking::Blanking;
use crate::gate::PictureGates;
use crate::insertion::Shade;
use crate::work::Work;

/// The shadow in one picture.
#[derive(Debug, Clone, PartialEq)]
pub struct Shadow {
    /// Where lines are dark, in the raster of the method.
    pub gates: PictureGates,
    /// Half width of the view-plane at distance 1 that those lines cross.
    pub half_width: f64,
    /// How dark each pixel becomes.
    pub shade: Shade,
    /// Counts of the work that the shadow takes.
    pub work: Work,
    /// Where the video is blanked.
    pub blanking: Blanking,
}
