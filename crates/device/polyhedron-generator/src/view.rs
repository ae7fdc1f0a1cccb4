//! From terrain axes to the view-plane.

use glam::DVec3;
use quantities::sin_cos;
use scenario::{Curvature, Projection};
use signal::Number;

/// A body with a vertex less than this ahead of the eye is skipped (m): D_near of section 12.
pub const NEAREST: f64 = 0.05;

/// The view-plane of a frame; the yoke is upright.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ViewPlane {
    /// Eye: north, east, up (m).
    pub eye: [f64; 3],
    /// Heading, clockwise from north (rad).
    pub heading: f64,
    /// Pitch, nose up (rad).
    pub pitch: f64,
    /// Law that says where the sweeps lie.
    pub projection: Projection,
    /// Whether bodies far away are lowered as the ground is.
    pub curvature: Curvature,
    /// Tangent of half the vertical field of view.
    pub tan_half_height: f64,
    /// Lines of the picture.
    pub lines: f64,
}

/// A point on the view-plane.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Place<N = f64> {
    /// To the right, over the distance of the view-plane.
    pub x: N,
    /// Downwards, over the distance of the view-plane.
    pub y: N,
    /// Inverse distance along the view axis (1/m): linear over the picture of a plane.
    pub depth: N,
}

impl<N: Number> Place<N> {
    /// A share of the way from here to another place.
    #[inline(always)]
    pub fn towards(&self, to: &Self, share: N) -> Self {
        let mix = |a: N, b: N| a + share * (b - a);
        Self { x: mix(self.x, to.x), y: mix(self.y, to.y), depth: mix(self.depth, to.depth) }
    }
}

impl ViewPlane {
    /// Where a point (north, east, up; m) is seen, which stands lower by the drop of the lunoid at its range; `None` if it is not at
    /// least [`NEAREST`] ahead.
    pub fn point(&self, at: DVec3) -> Option<Place> {
        let sighting = Sighting::new(self);
        let (eye, _) = sighting.eye_for(at);
        let ahead = sighting.turn((at - eye).to_array());
        (ahead[0] >= NEAREST).then(|| project(ahead))
    }

    /// Where a direction (unit vector: north, east, up) is seen, infinitely far; `None` if it is not ahead.
    pub fn direction(&self, towards: DVec3) -> Option<Place> {
        let ahead = Sighting::new(self).turn(towards.to_array());
        (ahead[0] > 0.0).then(|| Place { depth: 0.0, ..project(ahead) })
    }
}

/// A view-plane made ready for many points.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Sighting {
    eye: DVec3,
    heading: (f64, f64),
    pitch: (f64, f64),
    curvature: Curvature,
    straight: bool,
}

impl Sighting {
    pub fn new(view: &ViewPlane) -> Self {
        Self {
            eye: DVec3::from_array(view.eye),
            heading: sin_cos(view.heading),
            pitch: sin_cos(view.pitch),
            curvature: view.curvature,
            straight: view.projection == Projection::Exact,
        }
    }

    /// The eye as it would stand over ground that is not curved, for a body with its foot point at `foot`; and
    /// the horizontal range of that point (m).
    pub fn eye_for(&self, foot: DVec3) -> (DVec3, f64) {
        let range = (foot - self.eye).truncate().length();
        (self.eye + DVec3::Z * self.curvature.drop(range), range)
    }

    /// `Theta^T Phi^T` times `from_eye` (north, east, up): forward, starboard, down.
    #[inline(always)]
    pub fn turn<N: Number>(&self, [north, east, up]: [N; 3]) -> [N; 3] {
        let (sin_heading, cos_heading) = (north.like(self.heading.0), north.like(self.heading.1));
        let (sin, cos) = (north.like(self.pitch.0), north.like(self.pitch.1));
        let level = cos_heading * north + sin_heading * east;
        let starboard = cos_heading * east - sin_heading * north;
        [cos * level + sin * up, starboard, sin * level - cos * up]
    }

    /// Horizontal way forward for one of `depth^-1` along the view axis, at `y` on the view-plane.
    #[inline(always)]
    fn forward<N: Number>(&self, y: N) -> N {
        y.like(self.pitch.1) + y * y.like(self.pitch.0)
    }

    /// What a sweep's tangent multiplies in its line on the view-plane.
    #[inline(always)]
    pub fn spread<N: Number>(&self, y: N) -> N {
        if self.straight { self.forward(y) } else { y.like(1.0) }
    }

    /// The distance (m) of a point ahead that a sweep's tangent is a share of.
    pub fn forward_of(&self, [forward, _, down]: [f64; 3]) -> f64 {
        if self.straight { self.pitch.1 * forward + self.pitch.0 * down } else { forward }
    }

    /// Inverse horizontal range (1/m) of a place.
    #[inline(always)]
    pub fn near<N: Number>(&self, place: &Place<N>) -> N {
        let forward = self.forward(place.y);
        place.depth / (forward * forward + place.x * place.x).root()
    }
}

/// The picture of a point that is ahead: forward, starboard, down (m).
#[inline(always)]
pub(crate) fn project<N: Number>([forward, starboard, down]: [N; 3]) -> Place<N> {
    let depth = forward.like(1.0) / forward;
    Place { x: starboard * depth, y: down * depth, depth }
}

#[cfg(test)]
mod tests {
    use super::{Sighting, ViewPlane, project};
    use glam::DVec3;
    use quantities::radians;
    use scenario::{Curvature, Projection};

    #[test]
    fn check_table_23_6_without_roll() {
        let view = ViewPlane {
            eye: [10.0, 20.0, 2.0],
            heading: radians(30.0),
            pitch: radians(-5.0),
            projection: Projection::Exact,
            curvature: Curvature::None,
            tan_half_height: 0.3,
            lines: 500.0,
        };
        let sighting = Sighting::new(&view);
        let ahead = sighting.turn((DVec3::new(60.0, 45.0, 1.0) - DVec3::from_array(view.eye)).to_array());
        let expected = DVec3::new(55.67608525203552, -3.349364905389034, -3.867206451512648);
        assert!((DVec3::from_array(ahead) - expected).length() < 1e-13, "{ahead:?}");
        let place = project(ahead);
        assert!((place.x + 0.0601580533226621).abs() < 1e-15, "{}", place.x);
        assert!((place.y + 0.06945902237929458).abs() < 1e-15, "{}", place.y);
        let point = view.point(DVec3::new(60.0, 45.0, 1.0)).unwrap();
        assert_eq!(point, place);
        let behind = DVec3::from_array(view.eye) - DVec3::new(60.0, 45.0, 1.0);
        assert_eq!((view.point(behind), view.direction(behind)), (None, None));
        let far = view.direction(DVec3::new(60.0, 45.0, 1.0) - DVec3::from_array(view.eye)).unwrap();
        assert_eq!([far.x, far.y, far.depth], [place.x, place.y, 0.0]);
        // Inverse range along the ground.
        let range = (50.0f64 * 50.0 + 25.0 * 25.0).sqrt();
        assert!((sighting.near(&place) * range - 1.0).abs() < 1e-14);
    }
}
