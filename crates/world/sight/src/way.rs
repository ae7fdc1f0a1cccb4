//! A straight way on the map, and where it crosses the borders of regions.

use landscape::Level;

/// A way from the observer to the target; places along it go by their share of the way (0..=1).
#[derive(Debug, Clone, Copy)]
pub struct Way {
    /// Place of the observer: north, east (m).
    pub from: [f64; 2],
    /// From the observer to the target: north, east (m).
    pub step: [f64; 2],
    /// Length of the way (m).
    pub length: f64,
}

impl Way {
    /// The way between two places (north, east, m); `None` where they are one.
    pub fn new(from: [f64; 2], to: [f64; 2]) -> Option<Self> {
        let step = [to[0] - from[0], to[1] - from[1]];
        let length = libm::hypot(step[0], step[1]);
        (length > 0.0).then_some(Self { from, step, length })
    }

    /// Place (north, east, m) at a share.
    pub fn place(&self, share: f64) -> [f64; 2] {
        [0, 1].map(|axis| self.from[axis] + share * self.step[axis])
    }

    /// Local place in a region of a level at a share.
    pub fn local(&self, level: &Level, region: [usize; 2], share: f64) -> [f64; 2] {
        let [x, y] = self.place(share);
        let at = level.in_regions(x, y);
        [0, 1].map(|axis| (at[axis] - region[axis] as f64).clamp(0.0, 1.0))
    }

    /// Adds the shares inside `ends` at which the way crosses a border of regions of a level.
    pub fn borders(&self, level: &Level, ends: [f64; 2], cuts: &mut Vec<f64>) {
        let [first, last] = ends.map(|share| {
            let [x, y] = self.place(share);
            level.in_regions(x, y)
        });
        for axis in 0..2 {
            let per_share = self.step[axis] / level.region_size();
            let [low, high] = [first[axis].min(last[axis]), first[axis].max(last[axis])];
            let start = level.in_regions(self.from[0], self.from[1])[axis];
            let lines = (low.floor() as i64 + 1..high.ceil() as i64).map(|line| line as f64);
            let shares = lines.map(|line| (line - start) / per_share);
            cuts.extend(shares.filter(|share| *share > ends[0] && *share < ends[1]));
        }
    }

    /// Adds the shares between 0 and 1 at which the way crosses the outer border of a level.
    pub fn edges(&self, level: &Level, cuts: &mut Vec<f64>) {
        let [south, west, north, east] = level.extent();
        for (axis, edge) in [(0, south), (0, north), (1, west), (1, east)] {
            let share = (edge - self.from[axis]) / self.step[axis];
            cuts.extend(Some(share).filter(|share| *share > 0.0 && *share < 1.0));
        }
    }
}
