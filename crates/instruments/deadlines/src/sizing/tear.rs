//! How much of a late set can be seen (hardware report, section 4.5).

use hardware_model::Raster;
use landscape::Level;
use sweep_generator::RangeTable;
use sweep_program::{Miss, NO_CORNER, PreloadRegister, SweepProgram};

/// When the step that a late set leaves in the ground shows.
#[derive(Debug, Clone, Copy)]
pub struct TearLaw {
    /// Tangent of one line of the picture.
    line: f64,
    /// Smallest step that shows as a tear (lines).
    shows: f64,
}

/// Share of the difference between stale and right words that the height steps by, `e` of a region after the fold.
pub fn step(e: f64) -> f64 {
    e * e * e * (10.0 - 15.0 * e + 6.0 * e * e)
}

impl TearLaw {
    /// Steps of `shows` lines of a raster.
    pub fn new(raster: &Raster, shows: f64) -> Self {
        Self { line: 2.0 * raster.field.tan_half_height / f64::from(raster.lines), shows }
    }

    /// Whether a late set of `program` shows.
    pub fn is_seen(&self, miss: &Miss, program: &SweepProgram, level: &Level, table: &RangeTable) -> bool {
        let due = table.range_at(miss.time);
        if !due.is_finite() || due <= 0.0 || due > program.end_range {
            return false;
        }
        let came = miss.arrival.map_or(f64::INFINITY, |arrival| table.range_at(arrival));
        let axis = usize::from(miss.register == PreloadRegister::YFirst);
        let e = (came - due) * program.start.direction[axis].abs() / level.region_size();
        let height = step(e.clamp(0.0, 1.0)) * largest_difference(level, miss.corner);
        height >= self.shows * self.line * due
    }
}

/// Largest difference of height between a corner and those of its colour beside it: one of them is the stale one (m).
/// What the data bank has not brought is wrong however soon it comes: its hole is no tear.
fn largest_difference(level: &Level, corner: u32) -> f64 {
    if corner == NO_CORNER {
        return 0.0;
    }
    let columns = level.corners()[1];
    let [m, n] = [corner as usize / columns, corner as usize % columns].map(|index| index as i64);
    let height = |m: i64, n: i64| level.words()[level.clamped_index(m, n)][0];
    let here = height(m, n);
    let beside = [(m - 2, n), (m + 2, n), (m, n - 2), (m, n + 2)];
    beside.into_iter().map(|(m, n)| (height(m, n) - here).abs()).fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use super::step;

    /// The table of hardware section 4.5.
    #[test]
    fn steps_of_the_table() {
        let table =
            [(0.01, 1e-5), (0.05, 1.2e-3), (0.1, 8.6e-3), (0.2, 0.058), (0.3, 0.163), (0.5, 0.5), (1.0, 1.0)];
        for (e, expected) in table {
            assert!((step(e) - expected).abs() <= 0.04 * expected, "{e}: {}", step(e));
        }
    }
}
