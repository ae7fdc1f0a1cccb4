//! The sun of a photograph, found from its shadows.
//!
//! ```text
//!  photograph --> dark posts --+
//!                              +--> counts of each tile --> overlap --> search --> summit, without each tile in turn --> spread
//!  elevations --> dark posts --+
//! ```
//!
//! # Law
//!
//! - **Dark.** The usual light of a picture is its upper quartile. A post is dark where its light, less the darkest thousandth of the
//!   photograph, is below a tenth of the usual light. The same share holds for the light that a sun computes. So slopes that turn
//!   away from the sun become dark in both at one angle.
//! - **Overlap** of dark posts is the correlation of both maps of dark and lit posts (phi), -1 to 1. One map that is all dark or all
//!   lit has none.
//! - **Search.** All azimuths, elevations from 1 to 80 degrees in even ratios, some of the posts; then windows closer and closer around
//!   the best, with more posts. A paraboloid through the overlaps of a window has its summit at the sun.
//! - **Window.** The closest window counts in which the summit stays: two standard errors are less than half of the window.
//! - **Uncertainty** is two standard errors, by the jackknife: the ground has 4 x 4 tiles, and each is left out in
//!   turn. Two more parts are added in quadrature: half of the last step of the search, and how far the sun moves where every second
//!   post is left out. Between posts the ground is straight, so hills are too low and their shadows too short.

mod counts;
mod dark;
mod error;
mod search;
mod summit;

use landscape::Sun;
use photograph::Photograph;

use crate::Ground;
use dark::Dark;
pub use error::SunError;
use search::search;
use summit::{apart, settled};

/// A sun that was found from shadows.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FoundSun {
    /// The sun; its azimuth counts from the grid's north.
    pub sun: Sun,
    /// Two standard errors of azimuth and elevation (rad).
    pub uncertainty: [f64; 2],
    /// Correlation of the dark posts of photograph and ground, 0 to 1.
    pub overlap: f64,
    /// Posts that are dark in both, as a share of those that are dark in either, 0 to 1.
    pub common: f64,
    /// Shares of the posts that are dark: in the photograph, and under the found sun; 0 to 1.
    pub dark: [f64; 2],
}

/// The sun whose shadows over `ground` overlap best with what is dark in `photo`, on the threads of the current pool.
///
/// # Errors
/// If the photograph shows no shadow or nothing but shadow, or shadows of no sun overlap with it.
pub fn find_sun(ground: &Ground, photo: &Photograph) -> Result<FoundSun, SunError> {
    let dark = Dark::new(ground, photo)?;
    let (sun, spread) = settled(&search(ground, &dark)?).ok_or(SunError::NoSummit)?;
    let total = dark.counts(ground, &sun, 1).total();
    let moved = coarser(ground, photo).map(|other| apart(other, sun));
    Ok(FoundSun {
        sun,
        uncertainty: [0, 1]
            .map(|axis| moved.map_or(spread[axis], |moved| libm::hypot(spread[axis], moved[axis]))),
        overlap: total.overlap().ok_or(SunError::NoSummit)?,
        common: total.common(),
        dark: total.dark(),
    })
}

/// The sun that every second post tells; none where they are too few.
fn coarser(ground: &Ground, photo: &Photograph) -> Option<Sun> {
    let ground = ground.coarser();
    let dark = Dark::new(&ground, photo).ok()?;
    settled(&search(&ground, &dark).ok()?).map(|(sun, _)| sun)
}
