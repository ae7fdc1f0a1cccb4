//! Clipping of triangles before they are projected.

use glam::DVec3;
use smallvec::SmallVec;

use crate::fixed::{OffRaster, Point};
use crate::keep::keep;
use crate::projection::Projection;
use crate::screen::Screen;

/// Corners of the triangles that the clipping leaves of one, on the screen: none to six triangles.
pub type Fan = SmallVec<[[Point; 3]; 6]>;

/// Corners of a clipped triangle: a half-space adds one at most, and there are five.
type Polygon = SmallVec<[DVec3; 8]>;

/// Farthest coordinate of a corner (m). Chosen: a cut at a near plane of half a metre is good to less than a snap up to there.
const FARTHEST: f64 = 1e9;

/// A corner that cannot be drawn.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum ClipError {
    /// A coordinate in camera axes (m) that is not finite or too far away.
    #[error("corner coordinate {0} m: expected a number from -1e9 to 1e9")]
    Corner(f64),
    /// A corner that is not on the largest raster, because `near` is too small for how far away the corners lie.
    #[error(transparent)]
    Raster(#[from] OffRaster),
}

/// Clips a triangle in camera axes (m) at depth `near` (m, above 0) and at the screen with a margin of one sub-area, projects
/// and snaps what is left, and fans it about its first corner.
///
/// Two triangles with a common edge get the same cut of it, to the bit, so no gap opens between them. Triangles of the fan
/// turn as the triangle does, or have no area. A cut that lies within 1/256 pixel of a corner may fold one over: a sampling
/// point in the fold is then covered twice, and none is lost.
///
/// # Errors If a coordinate is not finite or beyond 1e9 m, or a cut so close to the eye that it is not on the raster.
pub fn clip(
    corners: [DVec3; 3],
    projection: &Projection,
    screen: &Screen,
    near: f64,
) -> Result<Fan, ClipError> {
    let coordinates = corners.iter().flat_map(|corner| corner.to_array());
    if let Some(wrong) = coordinates.into_iter().find(|along| !(-FARTHEST..=FARTHEST).contains(along)) {
        return Err(ClipError::Corner(wrong));
    }
    let mut kept = Polygon::from_slice(&corners);
    for half_space in half_spaces(projection, screen, near) {
        // Most triangles are wholly inside: nothing is cut or copied.
        if !kept.iter().all(|&corner| half_space.height(corner) >= 0.0) {
            kept = half_space.keep(&kept);
        }
    }
    let snapped = kept.iter().map(|&corner| Point::snap(projection.project(corner)));
    let snapped = snapped.collect::<Result<SmallVec<[Point; 8]>, _>>()?;
    let Some((&first, others)) = snapped.split_first() else { return Ok(Fan::new()) };
    Ok(others.windows(2).map(|pair| [first, pair[0], pair[1]]).collect())
}

/// What can be seen: before the eye, and on the screen with its margin.
fn half_spaces(projection: &Projection, screen: &Screen, near: f64) -> [HalfSpace; 5] {
    let margin = f64::from(screen.side());
    let [left, top] = projection.centre.map(|centre| centre + margin);
    let [right, bottom] =
        [0, 1].map(|axis| f64::from(screen.size()[axis]) + margin - projection.centre[axis]);
    let focal = projection.focal;
    let through_eye = |x: f64, y: f64, z: f64| HalfSpace { normal: DVec3::new(x, y, z), offset: 0.0 };
    [
        HalfSpace { normal: DVec3::Z, offset: -near },
        through_eye(focal, 0.0, left),
        through_eye(-focal, 0.0, right),
        through_eye(0.0, focal, top),
        through_eye(0.0, -focal, bottom),
    ]
}

/// Points with `normal . p + offset >= 0`.
struct HalfSpace {
    normal: DVec3,
    offset: f64,
}

impl HalfSpace {
    fn height(&self, point: DVec3) -> f64 {
        self.normal.dot(point) + self.offset
    }

    fn keep(&self, polygon: &Polygon) -> Polygon {
        keep(polygon, |point| self.height(point), |from: DVec3, to: DVec3, share| from + (to - from) * share)
    }
}
