//! Which bodies can cast shadow into the sector of the sweeps: only their shadows are found and kept.

use landscape::Sun;
use quantities::sin_cos;

/// The sector of the sweeps and the way that shadows fall in it.
#[derive(Debug, Clone, Copy)]
pub struct Shade {
    eye: [f64; 2],
    /// Unit vectors (north, east) of the left and the right edge, less than half a turn apart.
    edges: [[f64; 2]; 2],
    /// Unit vector away from the sun.
    away: [f64; 2],
    /// Ground range at which the sweeps begin (m).
    start: f64,
}

/// Room for rounding beside a shadow (m).
const SLACK: f64 = 1e-3;

impl Shade {
    /// Of a sector between two unit vectors (north, east) from `eye` (north, east; m), from ground range `start` (m) on.
    pub fn new(eye: [f64; 2], edges: [[f64; 2]; 2], start: f64, sun: &Sun) -> Self {
        let (sin, cos) = sin_cos(sun.azimuth);
        Self { eye, edges, away: [-cos, -sin], start }
    }

    /// Whether the shadow of what stands within `radius` (m) of a place may reach into the sector. It lies on the strip from
    /// there away from the sun, however far; a line parallel to a side of strip or sector parts the two, or they meet.
    pub fn may_meet(&self, place: [f64; 2], radius: f64) -> bool {
        let (reach, away, [left, right]) = (radius + SLACK, self.away, self.edges);
        let place = [place[0] - self.eye[0], place[1] - self.eye[1]];
        let is_left = cross(left, place) < -reach && cross(left, away) <= 0.0;
        let is_right = cross(place, right) < -reach && cross(away, right) <= 0.0;
        let (across, edges) = (cross(away, place), self.edges.map(|edge| cross(away, edge)));
        let is_across = (across < -reach && edges.iter().all(|&edge| edge >= 0.0))
            || (across > reach && edges.iter().all(|&edge| edge <= 0.0));
        !(is_left || is_right || is_across || self.ends_before_start([across - reach, across + reach]))
    }

    /// Whether all that a strip away from the sun has of the sector lies nearer than the sweeps begin. `sides`: how far its
    /// sides pass from the eye (m), clockwise counting. A strip across the sector ends where they meet its edges.
    fn ends_before_start(&self, sides: [f64; 2]) -> bool {
        let [left, right] = self.edges.map(|edge| cross(self.away, edge));
        // One that leads into the sector has no end there.
        let crosses = (left > 0.0 && right > 0.0) || (left < 0.0 && right < 0.0);
        let is_near = |along: f64| sides.iter().all(|side| (side / along).max(0.0) < self.start);
        crosses && is_near(left) && is_near(right)
    }
}

/// Above 0 if `b` lies clockwise of `a`.
fn cross(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

#[cfg(test)]
mod tests {
    use super::Shade;
    use landscape::Sun;
    use proptest::prelude::{prop_assert, proptest};
    use quantities::sin_cos;

    fn unit(angle: f64) -> [f64; 2] {
        let (sin, cos) = sin_cos(angle);
        [cos, sin]
    }

    proptest! {
        #[test]
        fn a_shadow_that_reaches_into_the_sector_is_not_left_out(
            heading in -4.0..4.0f64,
            half in 0.0..1.5f64,
            azimuth in -4.0..4.0f64,
            share in 0.0..1.0f64,
            (range, beside, along) in (0.0..300.0f64, -1.0..1.0f64, 0.0..1000.0f64),
            radius in 0.01..5.0f64,
            near in 0.0..1.0f64,
        ) {
            let eye = [120.0, -40.0];
            let edges = [unit(heading - half), unit(heading + half)];
            let shade = Shade::new(eye, edges, near * range, &Sun { azimuth, elevation: 0.2 });
            // A place in the sector, and a body whose shadow lies there.
            let (seen, away) = (unit(heading - half + 2.0 * half * share), unit(azimuth + std::f64::consts::PI));
            let spot = [0, 1].map(|axis| eye[axis] + range * seen[axis]);
            let across = [-away[1], away[0]];
            let place = [0, 1].map(|axis| spot[axis] - along * away[axis] + beside * radius * across[axis]);
            prop_assert!(shade.may_meet(place, radius));
        }
    }

    #[test]
    fn what_casts_no_shadow_there_is_left_out() {
        // Looking north from the origin, 60 degrees wide, the sun low in the west: shadows fall to the east.
        let edges = [unit(-0.52), unit(0.52)];
        let shade =
            Shade::new([0.0; 2], edges, 3.0, &Sun { azimuth: -std::f64::consts::FRAC_PI_2, elevation: 0.1 });
        for (place, meets) in [
            ([50.0, 0.0], true),
            ([50.0, -90.0], true),
            ([1.0, -90.0], true),
            ([-3.0, -90.0], false),
            ([-50.0, 0.0], false),
            ([50.0, 40.0], false),
            // Across the sector where no sweep has begun yet, and behind that.
            ([0.2, -1.0], false),
            ([1.5, -1.0], true),
        ] {
            assert_eq!(shade.may_meet(place, 2.0), meets, "{place:?}");
        }
    }
}
