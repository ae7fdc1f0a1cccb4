//! Whether ground of the grid hides a ground point from the camera.

use glam::DVec3;
use photograph::{Photograph, Placement};

use crate::Ground;

/// What hides ground points from the camera of a photograph.
pub(crate) struct Sight<'a> {
    ground: &'a Ground,
    /// Perspective centre; a map has none, and nothing is hidden in it.
    centre: Option<DVec3>,
    /// Highest post (m): above it nothing hides.
    highest: f64,
}

impl<'a> Sight<'a> {
    /// The sight of `photo` over `ground`.
    pub fn new(ground: &'a Ground, photo: &Photograph) -> Self {
        let centre = match photo.placement() {
            Placement::Camera { camera, .. } => Some(camera.centre()),
            Placement::Map(_) => None,
        };
        let known = ground.filling.heights.iter().copied().filter(|height| !height.is_nan());
        Self { ground, centre, highest: known.fold(f64::NEG_INFINITY, f64::max) }
    }

    /// The ground that is looked at.
    pub fn ground(&self) -> &Ground {
        self.ground
    }

    /// Whether ground stands between `point` (m) and the camera.
    pub fn is_hidden(&self, point: DVec3) -> bool {
        let Some(way) = self.centre.map(|centre| centre - point) else { return false };
        let Some([first, step]) = self.steps(point, way.normalize()) else { return false };
        let far = way.length();
        let ways = (0..).map(|count| first + step * f64::from(count)).take_while(|way| *way < far);
        ways.map_while(|along| self.ground.post_of(point + way.normalize() * along))
            .take_while(|(_, height)| *height < self.highest)
            .map_while(|(post, height)| Some((self.ground.height_between(post)?, height)))
            .any(|(ground, height)| ground > height)
    }

    /// Lengths (m) along a line of sight: to the first line or column of posts, whichever the line crosses more of, and from one
    /// to the next. None where the line stands upright.
    fn steps(&self, point: DVec3, way: DVec3) -> Option<[f64; 2]> {
        let ((from, _), (to, _)) = (self.ground.post_of(point)?, self.ground.post_of(point + way)?);
        let across = [0, 1].map(|axis: usize| to[axis] - from[axis]);
        let axis = usize::from(across[1].abs() > across[0].abs());
        let ahead =
            if across[axis] > 0.0 { 1.0 - from[axis].rem_euclid(1.0) } else { from[axis].rem_euclid(1.0) };
        // A point on a line of posts looks at the next one.
        let ahead = if ahead > 0.0 { ahead } else { 1.0 };
        let step = 1.0 / across[axis].abs();
        step.is_finite().then_some([ahead * step, step])
    }
}
