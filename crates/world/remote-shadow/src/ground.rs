//! The ground as a sun sees it.

use std::sync::Arc;

use features::Crater;
use landscape::{Landscape, Level, Sun};

use crate::axes::SunAxes;
use crate::sheet::{Node, Sheet, Stand};

/// A landscape in squares: [`Landscape::at`], bit for bit, without a search for the craters of each point.
#[derive(Debug)]
pub(crate) struct GroundSheets {
    pub(crate) landscape: Arc<Landscape>,
    pub(crate) sheets: Vec<Sheet>,
}

impl GroundSheets {
    pub(crate) fn new(landscape: Arc<Landscape>) -> Self {
        let levels = 0..landscape.bank().levels().len();
        let sheets = levels.map(|index| Sheet::new(&landscape, index)).collect();
        Self { landscape, sheets }
    }

    /// Height at a place (m); `None` where there is no ground.
    pub(crate) fn height(&self, place: [f64; 2]) -> Option<f64> {
        self.heights(place).map(|[terrain, features]| terrain + features)
    }

    /// Heights of the terrain and of the features on it at a place (m); `None` where there is no ground.
    fn heights(&self, place: [f64; 2]) -> Option<[f64; 2]> {
        let (level, sheet, Stand { region, local, square }) = self.stand(place)?;
        let features = self.met(sheet, square, place).map(|(crater, [rho, ..])| crater.profile(rho)[0]);
        Some([level.height(region, local), features.fold(0.0, |sum, rise| sum + rise)])
    }

    /// Height and slopes of the terrain and those of the features on it at a place (m); `None` where there is no
    /// ground.
    fn at(&self, place: [f64; 2]) -> Option<[[f64; 3]; 2]> {
        let (level, sheet, Stand { region, local, square }) = self.stand(place)?;
        let [height, hu, hv] = level.height_and_slopes(region, local);
        let d = level.region_size();
        let mut features = [0.0; 3];
        for (crater, [rho, dx, dy]) in self.met(sheet, square, place) {
            let [rise, slope] = crater.profile(rho);
            features[0] += rise;
            if rho > 0.0 {
                features[1] += slope * dx / rho;
                features[2] += slope * dy / rho;
            }
        }
        Some([[height, hu / d, hv / d], features])
    }

    /// The finest level that has a place, and where it lies there.
    fn stand(&self, [x, y]: [f64; 2]) -> Option<(&Level, &Sheet, Stand)> {
        let levels = self.landscape.bank().levels().iter().zip(&self.sheets);
        levels.filter_map(|(level, sheet)| Some((level, sheet, sheet.stand(level, [x, y])?))).next()
    }

    /// Craters of a square that hold a place, in ascending order of index, each with the way to the place from its centre:
    /// length, north and east (m).
    fn met<'a>(
        &'a self,
        sheet: &'a Sheet,
        square: Node,
        [x, y]: [f64; 2],
    ) -> impl Iterator<Item = (Crater, [f64; 3])> {
        let features = self.landscape.features();
        sheet.craters(square).filter_map(move |index| {
            let (centre, outer) = features.craters().circle(index);
            let [dx, dy] = [x - centre[0], y - centre[1]];
            let way = dx * dx + dy * dy;
            // Spares most roots: a comfortable margin over their rounding.
            if way > 1.000_001 * outer * outer {
                return None;
            }
            let rho = way.sqrt();
            (rho < outer).then(|| (features.crater(index), [rho, dx, dy]))
        })
    }
}

/// The ground under one sun.
#[derive(Debug, Clone, Copy)]
pub(crate) struct LitGround<'a> {
    pub(crate) ground: &'a GroundSheets,
    pub(crate) axes: SunAxes,
    /// Distance between the places at which casters are looked for (m).
    pub(crate) lattice: f64,
}

/// A point of a profile.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Spot {
    /// Distance away from the sun (m).
    pub(crate) q: f64,
    /// `G cos e = h cos e + q sin e` (m): how far above the sun ray through the origin. The factor keeps it finite
    /// for a sun in the zenith.
    pub(crate) g: f64,
    /// Its derivative; below 0 is local shadow (section 7).
    pub(crate) rise: f64,
}

/// How far a point is above the sun ray through the origin, `G cos e` (m).
#[derive(Debug, Clone, Copy)]
pub(crate) struct Lift {
    pub(crate) g: f64,
    /// The same without the features.
    pub(crate) terrain: f64,
}

impl<'a> LitGround<'a> {
    pub(crate) fn new(ground: &'a GroundSheets, sun: &Sun, lattice: f64) -> Self {
        Self { ground, axes: SunAxes::new(sun), lattice }
    }

    /// The ground at (p, q) (m), `None` where there is none.
    pub(crate) fn spot(&self, p: f64, q: f64) -> Option<Spot> {
        let [terrain, features] = self.ground.at(self.axes.to_ground([p, q]))?;
        let [height, north, east] =
            [terrain[0] + features[0], terrain[1] + features[1], terrain[2] + features[2]];
        let away = self.axes.away();
        let slope = north * away[0] + east * away[1];
        let (sin, cos) = (self.axes.sin, self.axes.cos);
        Some(Spot { q, g: height * cos + q * sin, rise: slope * cos + sin })
    }

    /// The same without its derivative.
    pub(crate) fn lift(&self, p: f64, q: f64) -> Option<Lift> {
        let [terrain, features] = self.ground.heights(self.axes.to_ground([p, q]))?;
        let above = |height: f64| height * self.axes.cos + q * self.axes.sin;
        Some(Lift { g: above(terrain + features), terrain: above(terrain) })
    }
}

#[cfg(test)]
mod tests {
    use super::GroundSheets;
    use crate::tests::{cratered, two_levels};
    use landscape::Landscape;
    use quantities::unit_interval;
    use std::sync::Arc;

    fn is_the_landscape(landscape: Landscape, [from, length]: [f64; 2]) {
        let ground = GroundSheets::new(Arc::new(landscape));
        for n in 0..20_000 {
            let [x, y] = [0, 1].map(|axis| from + length * unit_interval(3, &[n, axis]));
            let found =
                ground.at([x, y]).map(|[terrain, features]| [0, 1, 2].map(|k| terrain[k] + features[k]));
            let expected = ground.landscape.at(x, y);
            assert_eq!(found, expected.map(|point| [point.height, point.slopes[0], point.slopes[1]]));
            assert_eq!(ground.height([x, y]), found.map(|[height, ..]| height));
        }
    }

    #[test]
    fn it_is_the_landscape_bit_for_bit() {
        is_the_landscape(cratered(7, 300), [-20.0, 640.0]);
        is_the_landscape(two_levels(), [-7000.0, 17_400.0]);
    }
}
