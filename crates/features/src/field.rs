//! All craters of a problem area.

use crate::Crater;

/// What features add to the ground at a point.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Rise {
    /// Height (m).
    pub height: f64,
    /// Slopes to the north and to the east.
    pub slopes: [f64; 2],
    /// Whether the point is inside the footprint of a feature.
    pub present: bool,
}

/// All craters of a problem area, and where they are.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Features {
    craters: Vec<Crater>,
}

impl Features {
    /// An index over `craters`; their order is kept and names them.
    pub fn new(craters: Vec<Crater>) -> Self {
        Self { craters }
    }

    /// All craters.
    pub fn craters(&self) -> &[Crater] {
        &self.craters
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.craters.is_empty()
    }

    /// Indices of the craters whose footprints meet the box from `low` to `high` (north, east; m), ascending.
    pub fn in_box(&self, low: [f64; 2], high: [f64; 2], found: &mut Vec<u32>) {
        found.clear();
        for (index, crater) in self.craters.iter().enumerate() {
            let (centre, outer) = (crater.centre(), crater.outer());
            if (0..2).all(|axis| centre[axis] + outer >= low[axis] && centre[axis] - outer <= high[axis]) {
                found.push(index as u32);
            }
        }
    }

    /// What the features add at (x, y) (m): heights and slopes summed in ascending order of index.
    pub fn at(&self, x: f64, y: f64) -> Rise {
        let mut rise = Rise::default();
        for crater in &self.craters {
            let [dx, dy] = [x - crater.centre()[0], y - crater.centre()[1]];
            let rho = (dx * dx + dy * dy).sqrt();
            if rho < crater.outer() {
                let [height, slope] = crater.profile(rho);
                rise.height += height;
                rise.present = true;
                if rho > 0.0 {
                    rise.slopes[0] += slope * dx / rho;
                    rise.slopes[1] += slope * dy / rho;
                }
            }
        }
        rise
    }
}
