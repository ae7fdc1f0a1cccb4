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

/// Clips triangles at the depth `near` and at the screen with a margin of one sub-area, then projects and snaps them.
#[derive(Debug, Clone, Copy)]
pub struct Clipper<'a> {
    projection: &'a Projection,
    half_spaces: [HalfSpace; 5],
}

/// A corner by itself, as clipping finds it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Seen {
    /// On the screen or its margin.
    At(Point),
    /// Beyond borders, which have a bit each.
    Beyond(u8),
    /// One that cannot be drawn.
    Unfit,
}

impl<'a> Clipper<'a> {
    /// A clipper for a screen, at depth `near` (m, above 0).
    pub fn new(projection: &'a Projection, screen: &Screen, near: f64) -> Self {
        Self { projection, half_spaces: half_spaces(projection, screen, near) }
    }

    /// What is left of a triangle in camera axes (m), as triangles about its first corner.
    ///
    /// Two triangles with a common edge get the same cut of it, to the bit, so no gap opens between them. Triangles of the fan
    /// turn as the triangle does, or have no area. A cut that lies within 1/256 pixel of a corner may fold one over: a sampling
    /// point in the fold is then covered twice, and none is lost.
    ///
    /// # Errors If a coordinate is not finite or beyond 1e9 m, or a cut so close to the eye that it is not on the raster.
    pub fn clip(&self, corners: [DVec3; 3]) -> Result<Fan, ClipError> {
        let coordinates = corners.iter().flat_map(|corner| corner.to_array());
        if let Some(wrong) = coordinates.into_iter().find(|along| !is_near_enough(*along)) {
            return Err(ClipError::Corner(wrong));
        }
        let mut kept = Polygon::from_slice(&corners);
        for half_space in &self.half_spaces {
            // Most triangles are wholly inside: nothing is cut or copied.
            if !kept.iter().all(|&corner| half_space.height(corner) >= 0.0) {
                kept = half_space.keep(&kept);
            }
        }
        let snapped = kept.iter().map(|&corner| Point::snap(self.projection.project(corner)));
        let snapped = snapped.collect::<Result<SmallVec<[Point; 8]>, _>>()?;
        let Some((&first, others)) = snapped.split_first() else { return Ok(Fan::new()) };
        Ok(others.windows(2).map(|pair| [first, pair[0], pair[1]]).collect())
    }

    /// A corner in camera axes (m) by itself. Triangles that share corners ask once for each ([`Seen::whole`]).
    pub fn seen(&self, corner: DVec3) -> Seen {
        if !corner.to_array().into_iter().all(is_near_enough) {
            return Seen::Unfit;
        }
        let side =
            |(number, half_space): (usize, &HalfSpace)| u8::from(half_space.height(corner) < 0.0) << number;
        match self.half_spaces.iter().enumerate().map(side).fold(0, |all, bit| all | bit) {
            0 => Point::snap(self.projection.project(corner)).map_or(Seen::Unfit, Seen::At),
            beyond => Seen::Beyond(beyond),
        }
    }
}

impl Seen {
    /// The corners of a triangle that no border cuts: on the screen, or `None` if one border has them all beyond it. The outer `None` is a
    /// triangle that [`Clipper::clip`] has to look at.
    pub fn whole(corners: [Self; 3]) -> Option<Option<[Point; 3]>> {
        match corners {
            [Self::At(p), Self::At(q), Self::At(r)] => Some(Some([p, q, r])),
            [Self::Beyond(p), Self::Beyond(q), Self::Beyond(r)] if p & q & r != 0 => Some(None),
            _ => None,
        }
    }
}

fn is_near_enough(along: f64) -> bool {
    (-FARTHEST..=FARTHEST).contains(&along)
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
#[derive(Debug, Clone, Copy)]
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
