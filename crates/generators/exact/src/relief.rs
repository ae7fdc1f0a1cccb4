//! The terrain along a stretch of a line: one level, or two that fade into each other.

use landscape::bernstein::{Coefficients, DEGREE, product};
use landscape::patch::{Patch, restriction};
use landscape::{Level, basis};

use crate::ceilings::{Ceiling, LevelCeilings};
use crate::line::Line;
use crate::profile::{Terms, first_reach};
use crate::rings::Added;

/// A line in the units of a level: regions from its corner.
#[derive(Debug, Clone, Copy)]
pub struct Track<'a> {
    /// Level of terrain coefficients under the line.
    pub level: &'a Level,
    /// Bounds on the heights of that level.
    pub ceilings: &'a LevelCeilings,
    /// Origin of the line.
    pub origin: [f64; 2],
    /// Its step for a metre of range.
    pub step: [f64; 2],
}

impl<'a> Track<'a> {
    /// `line` over a level.
    pub fn new(level: &'a Level, ceilings: &'a LevelCeilings, line: &Line) -> Self {
        let origin = level.in_regions(line.origin[0], line.origin[1]);
        Self {
            level,
            ceilings,
            origin,
            step: line.direction.map(|direction| direction / level.region_size()),
        }
    }

    /// Regions to the north and to the east.
    pub fn regions(&self) -> [usize; 2] {
        self.level.corners().map(|corners| corners - 1)
    }

    /// Ranges at which the line enters and leaves the level; the first is above the second if it passes by.
    pub fn inside(&self) -> [f64; 2] {
        let mut inside = [f64::NEG_INFINITY, f64::INFINITY];
        for (axis, count) in self.regions().into_iter().enumerate() {
            let metres = 1.0 / self.step[axis];
            if self.step[axis] == 0.0 {
                let outside = !(self.origin[axis] >= 0.0 && self.origin[axis] <= count as f64);
                inside[1] = if outside { f64::NEG_INFINITY } else { inside[1] };
                continue;
            }
            let ends = [(0.0 - self.origin[axis]) * metres, (count as f64 - self.origin[axis]) * metres];
            inside = [inside[0].max(ends[0].min(ends[1])), inside[1].min(ends[0].max(ends[1]))];
        }
        inside
    }
}

/// One region that a line passes.
#[derive(Debug, Clone, Copy)]
pub struct Sheet<'a> {
    track: Track<'a>,
    region: [usize; 2],
}

impl<'a> Sheet<'a> {
    /// A region of a level.
    pub fn new(track: Track<'a>, region: [usize; 2]) -> Self {
        Self { track, region }
    }

    fn ceiling(&self) -> &'a Ceiling {
        self.track.ceilings.over(self.region)
    }

    fn local(&self, range: f64) -> [f64; 2] {
        let Track { origin, step, .. } = self.track;
        std::array::from_fn(|axis| origin[axis] + range * step[axis] - self.region[axis] as f64)
    }

    /// Unit vector of the line over the ground: north, east.
    fn direction(&self) -> [f64; 2] {
        self.track.step.map(|step| step * self.track.level.region_size())
    }

    fn along(&self, ends: [f64; 2]) -> Coefficients {
        Patch::new(self.track.level, self.region).along(self.local(ends[0]), self.local(ends[1]))
    }

    fn is_under(&self, line: &Line, ends: [f64; 2], rise: f64) -> bool {
        let plane = &self.ceiling().plane;
        line.stays_above(ends.map(|range| plane.height(self.local(range)) + rise), ends)
    }

    /// Height (m) and slopes to the north and east at a range.
    fn at(&self, range: f64) -> [f64; 3] {
        let level = self.track.level;
        let [height, hu, hv] = level.height_and_slopes(self.region, self.local(range));
        [height, hu / level.region_size(), hv / level.region_size()]
    }
}

/// How the fine level gives way to the coarse one: `h = w fine + (1 - w) coarse`, `w = g00((s - from) / length)`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Blend {
    /// Range at which it begins (m).
    pub from: f64,
    /// Length of the blend (m).
    pub length: f64,
}

impl Blend {
    fn share(&self, range: f64) -> f64 {
        (range - self.from) / self.length
    }

    /// Weight of the fine level over a stretch in Bernstein form: the control heights of g00 are 1, 1, 1, 0, 0, 0.
    fn weights(&self, ends: [f64; 2]) -> [f64; 6] {
        restriction(self.share(ends[0]), self.share(ends[1])).map(|row| row[0] + row[1] + row[2])
    }
}

/// Terrain along a stretch.
#[derive(Debug, Clone, Copy)]
pub enum Relief<'a> {
    /// Terrain of a single level.
    One(Sheet<'a>),
    /// The fine level on its way to the coarse one.
    Two(Sheet<'a>, Sheet<'a>, Blend),
}

impl Relief<'_> {
    /// The most that craters add to it (m); `None` where there are none.
    pub fn crater_rise(&self) -> Option<f64> {
        match self {
            Self::One(sheet) => sheet.ceiling().rise,
            Self::Two(fine, coarse, _) => {
                [fine, coarse].iter().filter_map(|s| s.ceiling().rise).reduce(f64::max)
            }
        }
    }

    /// Whether the line passes above it, and above `rise` metres on top of it, for certain.
    pub fn is_under(&self, line: &Line, ends: [f64; 2], rise: f64) -> bool {
        match self {
            Self::One(sheet) => sheet.is_under(line, ends, rise),
            Self::Two(fine, coarse, _) => [fine, coarse].iter().all(|sheet| sheet.is_under(line, ends, rise)),
        }
    }

    /// The first share of the stretch at which the line is in or under the ground: terrain, and what craters add.
    pub fn first_reach(&self, line: &Line, ends: [f64; 2], added: &Added) -> Option<f64> {
        match self {
            Self::One(sheet) => reach(sheet.along(ends), line, ends, added),
            Self::Two(fine, coarse, blend) => {
                let [fine, coarse] = [fine, coarse].map(|sheet| sheet.along(ends));
                reach(faded(&fine, &coarse, &blend.weights(ends)), line, ends, added)
            }
        }
    }

    /// Height (m) and slopes to the north and east at a range; over a fade with the rate of the weight along the line.
    pub fn at(&self, range: f64) -> [f64; 3] {
        match self {
            Self::One(sheet) => sheet.at(range),
            Self::Two(fine, coarse, blend) => {
                let share = blend.share(range);
                let (weight, rate) = (basis::values(share)[0], basis::derivatives(share)[0] / blend.length);
                let direction = fine.direction();
                let (fine, coarse) = (fine.at(range), coarse.at(range));
                let mut joined: [f64; 3] =
                    std::array::from_fn(|k| coarse[k] + weight * (fine[k] - coarse[k]));
                joined[1] += direction[0] * rate * (fine[0] - coarse[0]);
                joined[2] += direction[1] * rate * (fine[0] - coarse[0]);
                joined
            }
        }
    }
}

fn reach<const N: usize>(heights: [f64; N], line: &Line, ends: [f64; 2], added: &Added) -> Option<f64> {
    let mut under = line.under(&heights, ends);
    if !added.is_nothing() {
        added.to(&mut under);
    }
    first_reach(&under, &Terms { distances: &added.distances, bend: line.bend }, ends)
}

/// `coarse + w (fine - coarse)`, exactly: degree 10 + 5.
fn faded(fine: &Coefficients, coarse: &Coefficients, weights: &[f64; 6]) -> [f64; DEGREE + 6] {
    let gap: Coefficients = std::array::from_fn(|k| fine[k] - coarse[k]);
    let (gap, coarse): ([f64; 16], [f64; 16]) = (product(&gap, weights), product(coarse, &[1.0; 6]));
    std::array::from_fn(|k| coarse[k] + gap[k])
}
