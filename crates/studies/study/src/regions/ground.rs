//! Ground that is known everywhere.

use std::f64::consts::TAU;

use landscape::{Landscape, Level};
use quantities::sin_cos;

/// Height (m) and slopes to the north and east at a place (m from the south-west corner of the area).
pub(super) trait Relief {
    fn at(&self, place: [f64; 2]) -> [f64; 3];
}

/// A square of the finest level of a bank.
pub(super) struct Stored<'a> {
    level: &'a Level,
    corner: [f64; 2],
}

impl<'a> Stored<'a> {
    /// The square of side `side` (m) about `eye`, moved into the bank and onto its corners; `None` if the bank is smaller.
    pub fn about(landscape: &'a Landscape, eye: [f64; 3], side: f64) -> Option<Self> {
        let level = landscape.level();
        let [south, west, north, east] = level.extent();
        let region = level.region_size();
        let corner = |low: f64, high: f64, eye: f64| {
            let regions = ((eye - 0.5 * side - low) / region).floor();
            (high - low >= side)
                .then(|| low + region * regions.clamp(0.0, ((high - low - side) / region).floor()))
        };
        Some(Self { level, corner: [corner(south, north, eye[0])?, corner(west, east, eye[1])?] })
    }
}

impl Relief for Stored<'_> {
    fn at(&self, [north, east]: [f64; 2]) -> [f64; 3] {
        let found = self.level.locate(self.corner[0] + north, self.corner[1] + east);
        found.map_or([f64::NAN; 3], |(region, within)| super::height_and_slopes(self.level, region, within))
    }
}

/// Ground of two crossed waves.
pub(super) struct Waves {
    length: f64,
}

impl Waves {
    /// Waves of this length (m), a hundredth of it high.
    pub fn of_length(length: f64) -> Self {
        Self { length }
    }
}

impl Relief for Waves {
    fn at(&self, [north, east]: [f64; 2]) -> [f64; 3] {
        let (height, rate) = (0.01 * self.length, TAU / self.length);
        // Off the axes, so that no corner lies on a crest.
        let ([s, c], [t, d]) =
            (turn(rate * (0.8 * north + 0.6 * east) + 0.3), turn(rate * (0.6 * north - 0.8 * east) + 1.1));
        [height * (s + t), height * rate * (0.8 * c + 0.6 * d), height * rate * (0.6 * c - 0.8 * d)]
    }
}

fn turn(angle: f64) -> [f64; 2] {
    let (sin, cos) = sin_cos(angle);
    [sin, cos]
}
