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

/// What is known of a square from one that holds it: nobody asks again.
#[derive(Debug, Clone, Copy, Default)]
struct Known {
    is_in_sector: bool,
    has_ground: bool,
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

    fn holds(self, Self([low, high]): Self) -> bool {
        let Self([l, h]) = self;
        (0..2).all(|k| l[k] <= low[k] && high[k] <= h[k])
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
        let mut found = Vec::new();
        for place in self.coarsest() {
            self.divide(place, Known::default(), &mut found);
        }
        found.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then_with(|| a.1.cmp(&b.1)));
        found.into_iter().map(|(_, place)| place).collect()
    }

    /// The square of the eye and those around it, as large as the reach.
    fn coarsest(&self) -> [Place; 9] {
        let side = |level: u32| self.spacing(level) * STRIPS as f64;
        let level = (0..COARSEST).find(|&level| side(level) >= self.reach).unwrap_or(COARSEST);
        let home = self.eye.map(|along| (along / side(level)).floor() as i64);
        std::array::from_fn(|k| Place { level, at: [home[0] + k as i64 / 3 - 1, home[1] + k as i64 % 3 - 1] })
    }

    fn divide(&self, place: Place, known: Known, found: &mut Vec<(f64, Place)>) {
        let square = self.square(place);
        let distance = square.distance(self.eye);
        if distance > self.reach {
            return;
        }
        let Some(known) = self.look(square, known) else { return };
        if place.level == 0 || self.spacing(place.level) <= self.resolution.angle * distance {
            found.push((distance, place));
            return;
        }
        for quarter in place.quarters() {
            self.divide(quarter, known, found);
        }
    }

    /// What is known of all within a square; nothing if there is no ground in view.
    fn look(&self, square: Square, known: Known) -> Option<Known> {
        let is_in_sector = known.is_in_sector || self.holds_in_sector(square)?;
        let has_ground = known.has_ground || self.holds_on_ground(square)?;
        Some(Known { is_in_sector, has_ground })
    }

    fn spacing(&self, level: u32) -> f64 {
        self.resolution.finest * (1u64 << level) as f64
    }

    fn square(&self, place: Place) -> Square {
        let side = self.spacing(place.level) * STRIPS as f64;
        Square([0, 1].map(|end| place.at.map(|index| (index + end) as f64 * side)))
    }

    /// Whether all of a square lies between the two edges of the view; nothing if none of it does.
    fn holds_in_sector(&self, square: Square) -> Option<bool> {
        let Some([left, right]) = self.sector else { return Some(true) };
        let slack = 1e-9 * self.reach;
        let corners = square.corners().map(|c| [c[0] - self.eye[0], c[1] - self.eye[1]]);
        let beside = corners.map(|c| [cross(left, c) >= -slack, cross(c, right) >= -slack]);
        let [of_left, of_right] = [0, 1].map(|edge: usize| beside.map(|corner| corner[edge]));
        let reaches = of_left.contains(&true) && of_right.contains(&true);
        reaches.then(|| !of_left.contains(&false) && !of_right.contains(&false))
    }

    /// Whether all of a square lies over ground; nothing if none of it does.
    fn holds_on_ground(&self, square: Square) -> Option<bool> {
        let on_ground = Square::bounding(square.corners().map(|corner| self.axes.to_ground(corner)));
        let has_ground =
            self.levels.iter().any(|&[over, around]| over.meets(on_ground) && square.meets(around));
        has_ground.then(|| self.levels.iter().any(|[over, _]| over.holds(on_ground)))
    }
}

/// Above 0 if `b` lies clockwise of `a`.
fn cross(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

#[cfg(test)]
mod tests {
    use super::{Cover, Known};
    use crate::Resolution;
    use crate::tests::cratered;
    use crate::tile::Place;
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
    /// Tiles of a square, each asked for itself.
    fn divided(cover: &Cover, place: Place, found: &mut Vec<Place>) {
        let square = cover.square(place);
        let distance = square.distance(cover.eye);
        if distance > cover.reach || cover.look(square, Known::default()).is_none() {
            return;
        }
        match place.level > 0 && cover.spacing(place.level) > cover.resolution.angle * distance {
            true => place.quarters().into_iter().for_each(|quarter| divided(cover, quarter, found)),
            false => found.push(place),
        }
    }

    /// Eyes on the ground, at its edges and beyond them, in sectors wide and narrow.
    #[test]
    fn what_is_known_of_a_square_holds_for_all_within_it() {
        let landscape = cratered(1, 0);
        for n in 0..200 {
            let part = |k: u64, low: f64, high: f64| low + (high - low) * unit_interval(k, &[n]);
            let resolution = Resolution { finest: 0.05, angle: part(1, 2e-3, 2e-2) };
            let sun = Sun { azimuth: part(2, -3.0, 3.0), elevation: 0.1 };
            let (heading, half) = (part(3, -3.0, 3.0), part(4, 0.05, 1.4));
            let edges = [-half, half].map(|beta| {
                let (sin, cos) = sin_cos(heading + beta);
                [cos, sin]
            });
            let eye = [part(5, -100.0, 700.0), part(6, -100.0, 700.0)];
            let cover = Cover::new(&landscape, resolution, &sun, eye, part(7, 10.0, 400.0), Some(edges));
            let (mut places, mut expected) = (cover.places(), Vec::new());
            cover.coarsest().into_iter().for_each(|place| divided(&cover, place, &mut expected));
            places.sort_unstable();
            expected.sort_unstable();
            assert_eq!(places, expected, "{n}");
        }
    }
}
