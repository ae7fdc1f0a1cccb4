//! Intensity of every point of the grid (block 13): Lambert's law from the slopes, and remote shadow.

use generator::Shade;
use landscape::{Landscape, Sun, SweepLight};
use rayon::prelude::*;

use crate::grid::Grid;
use crate::observer::Observer;
use crate::shadow::{March, shadows};

/// How a point of the grid is lit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Lit {
    /// Reflectivity before remote shadow, 0..=1.
    pub reflectivity: f64,
    /// What shadow it lies in.
    pub shade: Shade,
}

impl Lit {
    /// Whether it lies in shadow.
    pub fn is_dark(self) -> bool {
        self.shade != Shade::Lit
    }

    /// What it returns, 0..=1: nothing in shadow.
    pub fn intensity(self) -> f64 {
        if self.is_dark() { 0.0 } else { self.reflectivity }
    }
}

/// Light of every point of `grid`, and the march for remote shadow, if it `casts`.
pub(crate) fn light(
    grid: &Grid,
    observer: &Observer,
    landscape: &Landscape,
    sun: &Sun,
    casts: bool,
) -> (Vec<Lit>, March) {
    let law = SweepLight::new(sun, landscape.albedo(), *landscape.photometry(), observer.direction());
    let to_sun = Sun { elevation: 0.0, ..*sun }.direction();
    let horizontal = observer.in_axes([to_sun[0], to_sun[1]]);
    let tangent = libm::tan(sun.elevation);
    let (dark, march) = match casts {
        true => shadows(&grid.heights, grid.size, grid.steps, horizontal, tangent),
        false => (vec![false; grid.heights.len()], March::default()),
    };
    let point = |index: usize| {
        let (row, column) = (index / grid.size, index % grid.size);
        let [along, across] = grid.place(row, column);
        // The foot point has no direction; a millimetre keeps its sight finite.
        let range = (along * along + across * across).sqrt().max(1e-3);
        let direction = [along / range, across / range];
        let slopes = turned(grid.slopes(row, column), direction);
        let [sun_along, sun_across] = turned([law.along, law.across], direction);
        let law = SweepLight { along: sun_along, across: sun_across, ..law };
        let signed = law.at(slopes[0], slopes[1], (grid.heights[index] - observer.eye[2]) / range);
        let shade = match (signed <= 0.0, dark[index]) {
            (true, _) => Shade::Local,
            (false, true) => Shade::Remote,
            (false, false) => Shade::Lit,
        };
        Lit { reflectivity: signed.clamp(0.0, 1.0), shade }
    };
    let points = (0..grid.size * grid.size).into_par_iter().with_min_len(grid.size).map(point).collect();
    (points, march)
}

/// A vector of the observer's axes along `direction` (unit) and to the right of it.
fn turned([along, across]: [f64; 2], [cos, sin]: [f64; 2]) -> [f64; 2] {
    [along * cos + across * sin, across * cos - along * sin]
}
