//! Which tiles a frame can see: a cover without overlap, fine near the eye.

use landscape::{Landscape, Sun};

use crate::Resolution;
use crate::axes::SunAxes;
use crate::tile::{Place, STRIPS};

/// Coarsest tiles: their lattice numbers stay far from overflow.
const COARSEST: u32 = 32;

/// What a frame can see, in the axes of its sun.
pub(crate) struct Cover {
    axes: SunAxes,
    resolution: Resolution,
    eye: [f64; 2],
    reach: f64,
    sector: Option<[[f64; 2]; 2]>,
    /// Levels of ground: over the ground (north, east), and around them in the sun's axes.
    levels: Vec<[Square; 2]>,
}

/// A tile's square: least and largest p and q (m).
#[derive(Clone, Copy)]
struct Square([[f64; 2]; 2]);

impl Square {
    fn corners(self) -> [[f64; 2]; 4] {
        let Self([low, high]) = self;
        [low, [low[0], high[1]], [high[0], low[1]], high]
    }

    fn distance(self, place: [f64; 2]) -> f64 {
        let Self([low, high]) = self;
        let away = [0, 1].map(|k: usize| (low[k] - place[k]).max(place[k] - high[k]).max(0.0));
        (away[0] * away[0] + away[1] * away[1]).sqrt()
    }

    fn bounding(corners: [[f64; 2]; 4]) -> Self {
        let fold = |k: usize, f: fn(f64, f64) -> f64| corners.iter().map(|c| c[k]).reduce(f).unwrap_or(0.0);
        Self([[fold(0, f64::min), fold(1, f64::min)], [fold(0, f64::max), fold(1, f64::max)]])
    }

    fn meets(self, Self([low, high]): Self) -> bool {
        let Self([l, h]) = self;
        (0..2).all(|k| l[k] <= high[k] && h[k] >= low[k])
    }
}

impl Cover {
    pub(crate) fn new(
        landscape: &Landscape,
        resolution: Resolution,
        sun: &Sun,
        eye: [f64; 2],
        reach: f64,
        towards: Option<[[f64; 2]; 2]>,
    ) -> Self {
        let axes = SunAxes::new(sun);
        let turned = |place| axes.to_sun_axes(place);
        let extents = landscape.bank().levels().iter().map(|level| level.extent());
        let levels = extents.map(|[south, west, north, east]| {
            let over = Square([[south, west], [north, east]]);
            [over, Square::bounding(over.corners().map(turned))]
        });
        let (eye, sector, levels) = (turned(eye), towards.map(|edges| edges.map(turned)), levels.collect());
        Self { axes, resolution, eye, reach, sector, levels }
    }

    /// The tiles, by distance from the eye; no two overlap.
    pub(crate) fn places(&self) -> Vec<Place> {
        let side = |level: u32| self.spacing(level) * STRIPS as f64;
        let level = (0..COARSEST).find(|&level| side(level) >= self.reach).unwrap_or(COARSEST);
        let home = self.eye.map(|along| (along / side(level)).floor() as i64);
        let mut found = Vec::new();
        for k in 0..9 {
            let at = [home[0] + k / 3 - 1, home[1] + k % 3 - 1];
            self.divide(Place { level, at }, &mut found);
        }
        found.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        found.into_iter().map(|(_, place)| place).collect()
    }

    fn divide(&self, place: Place, found: &mut Vec<(f64, Place)>) {
        let square = self.square(place);
        let distance = square.distance(self.eye);
        if distance > self.reach || !self.is_in_sector(square) || !self.has_ground(square) {
            return;
        }
        if place.level == 0 || self.spacing(place.level) <= self.resolution.angle * distance {
            found.push((distance, place));
            return;
        }
        for quarter in place.quarters() {
            self.divide(quarter, found);
        }
    }

    fn spacing(&self, level: u32) -> f64 {
        self.resolution.finest * (1u64 << level) as f64
    }

    fn square(&self, place: Place) -> Square {
        let side = self.spacing(place.level) * STRIPS as f64;
        Square([0, 1].map(|end| place.at.map(|index| (index + end) as f64 * side)))
    }

    /// Whether some of the square may lie between the two edges of the view.
    fn is_in_sector(&self, square: Square) -> bool {
        let Some([left, right]) = self.sector else { return true };
        let slack = 1e-9 * self.reach;
        let corners = square.corners().map(|c| [c[0] - self.eye[0], c[1] - self.eye[1]]);
        corners.iter().any(|&c| cross(left, c) >= -slack)
            && corners.iter().any(|&c| cross(c, right) >= -slack)
    }

    fn has_ground(&self, square: Square) -> bool {
        let on_ground = Square::bounding(square.corners().map(|corner| self.axes.to_ground(corner)));
        self.levels.iter().any(|&[over, around]| over.meets(on_ground) && square.meets(around))
    }
}

/// Above 0 if `b` lies clockwise of `a`.
fn cross(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

#[cfg(test)]
mod tests {
    use super::Cover;
    use crate::Resolution;
    use crate::tests::cratered;
    use landscape::Sun;
    use quantities::{sin_cos, unit_interval};

    #[test]
    fn every_place_in_view_is_covered_once_and_finely_enough() {
        let landscape = cratered(1, 0);
        let resolution = Resolution { finest: 0.05, angle: 4e-3 };
        let sun = Sun { azimuth: 0.7, elevation: 0.1 };
        let (eye, reach, heading) = ([310.0, 280.0], 250.0, 2.0);
        let edges = [-0.4, 0.4].map(|beta| {
            let (sin, cos) = sin_cos(heading + beta);
            [cos, sin]
        });
        let cover = Cover::new(&landscape, resolution, &sun, eye, reach, Some(edges));
        let places = cover.places();
        for n in 0..5000 {
            let (sin, cos) = sin_cos(heading + 0.8 * (unit_interval(1, &[n]) - 0.5));
            let range = reach * unit_interval(2, &[n]);
            let point = cover.axes.to_sun_axes([eye[0] + range * cos, eye[1] + range * sin]);
            let holders: Vec<_> =
                places.iter().filter(|&&place| cover.square(place).distance(point) == 0.0).collect();
            assert_eq!(holders.len(), 1, "{range}");
            assert!(cover.spacing(holders[0].level) <= resolution.finest.max(resolution.angle * range));
        }
        let behind = cover.axes.to_sun_axes([eye[0] - 50.0 * edges[0][0], eye[1] - 50.0 * edges[0][1]]);
        assert!(places.iter().all(|&place| cover.square(place).distance(behind) > 0.0));
    }
}
