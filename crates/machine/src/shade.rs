//! Which bodies can cast shadow into the sector of the sweeps: only their shadows are found and kept.

use landscape::Sun;
use quantities::sin_cos;

/// The sector of the sweeps and the way that shadows fall in it.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Shade {
    eye: [f64; 2],
    /// Unit vectors (north, east) of the left and the right edge, less than half a turn apart.
    edges: [[f64; 2]; 2],
    /// Unit vector away from the sun.
    away: [f64; 2],
}

/// Room for rounding beside a shadow (m).
const SLACK: f64 = 1e-3;

impl Shade {
    /// Of a sector between two unit vectors (north, east) from `eye` (north, east; m).
    pub fn new(eye: [f64; 2], edges: [[f64; 2]; 2], sun: &Sun) -> Self {
        let (sin, cos) = sin_cos(sun.azimuth);
        Self { eye, edges, away: [-cos, -sin] }
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
        !(is_left || is_right || is_across)
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
        ) {
            let eye = [120.0, -40.0];
            let edges = [unit(heading - half), unit(heading + half)];
            let shade = Shade::new(eye, edges, &Sun { azimuth, elevation: 0.2 });
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
            Shade::new([0.0; 2], edges, &Sun { azimuth: -std::f64::consts::FRAC_PI_2, elevation: 0.1 });
        for (place, meets) in [
            ([50.0, 0.0], true),
            ([50.0, -90.0], true),
            ([1.0, -90.0], true),
            ([-3.0, -90.0], false),
            ([-50.0, 0.0], false),
            ([50.0, 40.0], false),
        ] {
            assert_eq!(shade.may_meet(place, 2.0), meets, "{place:?}");
        }
    }
}
