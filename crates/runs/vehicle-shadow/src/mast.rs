//! The edge of a mast's shadow: where it lies on true ground, and where flat ground has it (section 19.7, measured).

use exact::{Ceilings, Outlook, Ray, Sight};
use glam::DVec3;
use landscape::{Landscape, Sun};
use scenario::Curvature;

/// Ground nearer to the foot than this (m) is not looked at: the mast stands there.
const NEAR: f64 = 0.01;
/// The elevation (rad) above which the sun is up: a shadow of 3000 km.
const UP: f64 = 1e-6;
/// How far apart (m) two rays to one place may meet the ground.
const SAME: f64 = 1e-6;

/// A vehicle as the report's formula has it: its top and its view port, straight above one foot.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Mast {
    /// Height of the top above the foot (m), above 0: Hv.
    pub top: f64,
    /// Height of the view port above the foot (m), above 0: h.
    pub eye: f64,
}

/// What becomes of the edge of a mast's shadow.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum MastEdge {
    /// There is no shadow: the sun is not up, or ground stands between it and the top.
    Dark,
    /// There is no ground under the mast, or the ray through its top meets none.
    OffGround,
    /// Nearer ground hides the edge from the view port.
    Hidden,
    /// The view port sees it.
    Seen {
        /// From the foot to the edge on flat ground (m): d.
        distance: f64,
        /// How much higher than the foot the edge lies on true ground (m): z.
        rise: f64,
        /// Angle (rad) at the view port between the edge on true ground and that on flat ground, measured in space.
        angle: f64,
    },
}

impl Mast {
    /// The report's vehicle: its top at 10 feet, its view port at 5.
    pub const REPORT: Self = Self { top: 3.048, eye: 1.524 };

    /// The edge that the mast casts from `at` (north, east; m) over the finest level of `landscape` and its craters, found as
    /// [`exact`] finds ground.
    pub fn edge(&self, landscape: &Landscape, ceilings: &Ceilings, at: [f64; 2], sun: Sun) -> MastEdge {
        let Some(ground) = landscape.height(at[0], at[1]) else { return MastEdge::OffGround };
        if sun.elevation <= UP {
            return MastEdge::Dark;
        }
        let foot = DVec3::new(at[0], at[1], ground);
        let outlook = |height: f64| {
            let eye = [foot.x, foot.y, foot.z + height];
            Outlook::new(landscape, ceilings, eye, Curvature::None, [NEAR, f64::INFINITY], None)
        };
        let (from_top, from_port) = (outlook(self.top), outlook(self.eye));
        let tangent = libm::tan(sun.elevation);
        let towards = [libm::cos(sun.azimuth), libm::sin(sun.azimuth)];
        let away = towards.map(|part| -part);
        if from_top.look(&Ray { direction: towards, rise: tangent }) != Sight::Sky {
            return MastEdge::Dark;
        }
        let Sight::Ground(spot) = from_top.look(&Ray { direction: away, rise: -tangent }) else {
            return MastEdge::OffGround;
        };
        let edge = DVec3::new(spot.place[0], spot.place[1], from_top.height(&spot));
        let rise = edge.z - foot.z;
        let is_seen = match from_port.look(&Ray { direction: away, rise: (rise - self.eye) / spot.range }) {
            Sight::Ground(seen) => (seen.range - spot.range).abs() < SAME,
            Sight::Sky | Sight::TooNear | Sight::Cut(_) => false,
        };
        if !is_seen {
            return MastEdge::Hidden;
        }
        let distance = self.top / tangent;
        let flat = foot + DVec3::new(distance * away[0], distance * away[1], 0.0);
        let port = foot + DVec3::Z * self.eye;
        let [a, b] = [edge, flat].map(|edge| (edge - port).normalize());
        MastEdge::Seen { distance, rise, angle: libm::atan2(a.cross(b).length(), a.dot(b)) }
    }
}
