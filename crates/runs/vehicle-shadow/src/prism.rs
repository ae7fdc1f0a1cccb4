//! Convex regions of space in which what is seen is dark: behind a part of the vehicle, or over a patch of track.

use glam::{DVec2, DVec3};
use scenario::TrackPatch;
use solids::Body;

use crate::hull::hull;

/// Points p with `n.p <= c` for all of some planes (n, c); north, east, up (m).
#[derive(Debug, Clone, PartialEq)]
pub struct Prism(Vec<(DVec3, f64)>);

impl Prism {
    /// Where the line to the sun, in direction `to_sun`, meets the body: behind all faces that the sun lights, and
    /// within the outline that the sun sees. Nothing for a body that has no outline.
    pub fn shadow(body: &Body, to_sun: DVec3) -> Option<Self> {
        let (right, above) = to_sun.any_orthonormal_pair();
        let across = |vertex: DVec3| DVec2::new(right.dot(vertex), above.dot(vertex));
        let outline = hull(body.vertices().map(across).collect())?;
        let lit = body.normals().enumerate().filter(|(_, normal)| normal.dot(to_sun) > 0.0);
        let mut planes: Vec<(DVec3, f64)> =
            lit.map(|(face, normal)| (normal, normal.dot(body.on_face(face)))).collect();
        // The hull's corners turn from the first axis towards the second: outwards is to the other side.
        planes.extend(outline.iter().zip(outline.iter().cycle().skip(1)).map(|(&from, &to)| {
            let outwards = -(to - from).perp();
            (right * outwards.x + above * outwards.y, outwards.dot(from))
        }));
        Some(Self(planes))
    }

    /// Over and under a patch of track.
    pub fn patch(patch: &TrackPatch) -> Self {
        let corners = patch.corners.map(DVec2::from_array);
        // Clockwise seen from above, x north and y east: from x towards y.
        let plane = |index: usize| {
            let (from, to) = (corners[index], corners[(index + 1) % 4]);
            let outwards = -(to - from).perp();
            (outwards.extend(0.0), outwards.dot(from))
        };
        Self((0..4).map(plane).collect())
    }

    /// Whether it holds a point.
    pub fn holds(&self, point: DVec3) -> bool {
        self.0.iter().all(|(normal, offset)| normal.dot(point) <= *offset)
    }

    /// The shares of the way from `from` to `to` between which the line is inside.
    pub fn clip(&self, from: DVec3, to: DVec3) -> Option<[f64; 2]> {
        let (mut enters, mut leaves) = (0.0f64, 1.0f64);
        for (normal, offset) in &self.0 {
            let (outside, rate) = (normal.dot(from) - offset, normal.dot(to - from));
            if rate > 0.0 {
                leaves = leaves.min(-outside / rate);
            } else if rate < 0.0 {
                enters = enters.max(-outside / rate);
            } else if outside > 0.0 {
                return None;
            }
            if enters >= leaves {
                return None;
            }
        }
        Some([enters, leaves])
    }
}

/// The cylinder of a sphere's shadow, widened by what the disc of the sun adds: nothing outside is dark.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Reach {
    centre: DVec3,
    radius: f64,
    /// Unit vector to the sun.
    axis: DVec3,
    /// By how much the radius grows in 1 m.
    growth: f64,
}

impl Reach {
    /// Of the sphere around all bodies, under suns up to `growth` (tangent) away from `to_sun`.
    pub fn of(bodies: &[Body], to_sun: DVec3, growth: f64) -> Self {
        let low = bodies.iter().map(|body| body.centre - body.radius).fold(DVec3::INFINITY, DVec3::min);
        let high = bodies.iter().map(|body| body.centre + body.radius).fold(DVec3::NEG_INFINITY, DVec3::max);
        let centre = (low + high) * 0.5;
        let radius = bodies.iter().map(|body| body.centre.distance(centre) + body.radius).fold(0.0, f64::max);
        Self { centre, radius, axis: to_sun, growth }
    }

    /// Whether there may be shadow between two points.
    pub fn may_hold(&self, a: DVec3, b: DVec3) -> bool {
        let middle = (a + b) * 0.5 - self.centre;
        let half = a.distance(b) * 0.5;
        middle.cross(self.axis).length() <= self.radius + half + self.growth * (middle.length() + half)
    }

    /// How far from `eye` along `direction`, in its lengths, there may be shadow: 0 if nowhere, infinite if the ray
    /// stays within.
    pub fn along(&self, eye: DVec3, direction: DVec3) -> f64 {
        let from = eye - self.centre;
        let (place, step) = (from.cross(self.axis), direction.cross(self.axis));
        // |place + step t| = radius + growth |direction| t, and some more for the way from the centre to the eye.
        let radius = self.radius + self.growth * from.length();
        let growth = self.growth * direction.length();
        let a = step.length_squared() - growth * growth;
        let half_b = place.dot(step) - radius * growth;
        let c = place.length_squared() - radius * radius;
        if a <= 0.0 {
            return f64::INFINITY;
        }
        let square = half_b * half_b - a * c;
        if square < 0.0 { 0.0 } else { ((square.sqrt() - half_b) / a).max(0.0) }
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use glam::{DMat3, DVec3};
    use scenario::TrackPatch;
    use solids::{Body, Kind, Solid};

    use super::{Prism, Reach};

    /// A cube of 2 m, its middle 3 m up.
    fn cube() -> Body {
        let solid = Solid::boxed(DVec3::splat(-1.0), DVec3::splat(1.0), 1.0).unwrap();
        Body::place(0, Kind::Culture, &Arc::new(solid), DVec3::Z * 3.0, &DMat3::IDENTITY, 1.0)
    }

    /// The sun in the north, 45 degrees up: the shadow lies on the south side, from -4.. to -2.. at height 0.
    #[test]
    fn shadow_lies_behind_the_body_and_not_before_it() {
        let prism = Prism::shadow(&cube(), DVec3::new(1.0, 0.0, 1.0).normalize()).unwrap();
        for (at, expected) in [
            ([-3.0, 0.0, 0.0], true),
            ([-4.9, 0.9, 0.0], true),
            ([-5.1, 0.0, 0.0], false),
            ([-0.9, 0.0, 0.0], false),
            ([-3.0, 1.1, 0.0], false),
            ([0.0, 0.0, 3.0], true),
            ([3.0, 0.0, 6.0], false),
        ] {
            assert_eq!(prism.holds(DVec3::from_array(at)), expected, "{at:?}");
        }
        let [enters, leaves] = prism.clip(DVec3::new(-9.0, 0.0, 0.0), DVec3::new(1.0, 0.0, 0.0)).unwrap();
        assert!((enters - 0.4).abs() < 1e-12 && (leaves - 0.8).abs() < 1e-12, "{enters} {leaves}");
        assert_eq!(prism.clip(DVec3::new(-9.0, 2.0, 0.0), DVec3::new(1.0, 2.0, 0.0)), None);
        assert_eq!(prism.clip(DVec3::new(9.0, 0.0, 0.0), DVec3::new(1.0, 0.0, 0.0)), None);
    }

    #[test]
    fn a_patch_reaches_through_all_heights() {
        let patch = TrackPatch { laid: 0.0, corners: [[2.0, 0.0], [2.0, 1.0], [0.0, 1.0], [0.0, 0.0]] };
        let prism = Prism::patch(&patch);
        assert!(prism.holds(DVec3::new(1.0, 0.5, -80.0)) && prism.holds(DVec3::new(0.1, 0.9, 80.0)));
        assert!(!prism.holds(DVec3::new(1.0, 1.1, 0.0)) && !prism.holds(DVec3::new(-0.1, 0.5, 0.0)));
    }

    /// At the distance that is told a ray leaves the widening cylinder.
    #[test]
    fn a_ray_is_followed_to_the_edge_of_the_reach() {
        let to_sun = DVec3::new(0.6, 0.0, 0.8);
        for growth in [0.0, 0.005] {
            let reach = Reach::of(&[cube()], to_sun, growth);
            let eye = DVec3::new(0.3, -0.4, 2.5);
            for direction in [[1.0, 0.2, -0.3], [-1.0, 0.1, -0.9], [0.4, -2.0, -0.1]] {
                let direction = DVec3::from_array(direction);
                let along = reach.along(eye, direction);
                let from = eye - DVec3::Z * 3.0;
                let away = (from + direction * along).cross(to_sun).length();
                let edge = 3f64.sqrt() + growth * (from.length() + along * direction.length());
                assert!((away - edge).abs() < 1e-9, "{direction}: {away}, not {edge}");
            }
            assert_eq!(reach.along(eye, -to_sun), f64::INFINITY);
            assert_eq!(reach.along(DVec3::new(0.0, 90.0, 3.0), DVec3::Y), 0.0);
        }
    }
}
