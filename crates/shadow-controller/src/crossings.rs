//! Where the sweeps of a frame cross boundary segments.

use std::ops::Range;

use rayon::iter::{IntoParallelRefIterator, ParallelIterator};
use remote_shadow::Segment;

/// Nearest place ahead of the eye that counts (m).
const NEAREST: f64 = 1e-6;

/// A segment from the eye: north, east (m).
pub(crate) type Line = Segment;

/// One sweep crosses one line: bits of the range, then whether a shadow ends there, then the line. In this form they
/// are sorted as they are met, beginnings before endings at the same range.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Default)]
pub(crate) struct Crossing(u128);

impl Crossing {
    /// `range` (m) must not be negative: only then its bits are in its order.
    fn new(range: f64, ends: bool, line: u32) -> Self {
        Self(u128::from(range.to_bits()) << 64 | u128::from(ends) << 32 | u128::from(line))
    }

    /// Ground range (m).
    pub(crate) fn range(self) -> f64 {
        f64::from_bits((self.0 >> 64) as u64)
    }

    /// Shadows begun (1) or ended (-1) there.
    pub(crate) fn step(self) -> i32 {
        1 - 2 * ((self.0 >> 32) as u32 as i32)
    }

    /// Index of the line.
    fn line(self) -> usize {
        self.0 as u32 as usize
    }
}

/// Sweeps as they lie ahead: `tan` of the angle from the middle of the view.
struct Fan<'a> {
    directions: &'a [[f64; 2]],
    middle: [f64; 2],
    tangents: Vec<f64>,
    /// Sweeps for a unit of `tan`, on average: a first guess.
    density: f64,
    /// By how many sweeps the guess can be wrong, rounding included.
    doubt: f64,
}

impl<'a> Fan<'a> {
    /// `None` without sweeps, or if they open to half a turn or more.
    fn new(directions: &'a [[f64; 2]]) -> Option<Self> {
        let (first, last) = (directions.first()?, directions.last()?);
        let sum = [first[0] + last[0], first[1] + last[1]];
        let length = (sum[0] * sum[0] + sum[1] * sum[1]).sqrt();
        let middle = (length > NEAREST).then(|| sum.map(|part| part / length))?;
        let tangents: Vec<f64> = directions.iter().map(|&d| cross(middle, d) / dot(middle, d)).collect();
        let width = tangents[tangents.len() - 1] - tangents[0];
        let density = if width > 0.0 { (tangents.len() - 1) as f64 / width } else { 0.0 };
        let wrong = |(n, tangent): (usize, f64)| ((tangent - tangents[0]) * density - n as f64).abs();
        let doubt = tangents.iter().copied().enumerate().map(wrong).fold(0.0, f64::max) + 1e-6;
        Some(Self { directions, middle, tangents, density, doubt })
    }

    /// Whether no sweep can lie between two places ahead, by the guess alone: most lines are that short.
    fn surely_misses(&self, a: [f64; 2], b: [f64; 2]) -> bool {
        let count = self.tangents.len() as f64;
        let [a, b] = [a, b].map(|[ahead, across]| (across / ahead - self.tangents[0]) * self.density);
        let (low, high) = (a.min(b) - self.doubt, a.max(b) + self.doubt);
        // Whole numbers up to `high`, and below `low`; what is cut off by the cast is above 0.
        let up_to = (high.max(-1.0).min(count) + 1.0) as u32;
        let below = count as u32 - (count - low.max(0.0).min(count)) as u32;
        up_to <= below
    }

    /// Number of sweeps to the left of a place ahead.
    fn sweeps_left_of(&self, [ahead, across]: [f64; 2]) -> usize {
        let tangent = across / ahead;
        let guess = (tangent - self.tangents[0]) * self.density;
        let mut n = (guess.max(0.0) as usize).min(self.tangents.len());
        while n > 0 && self.tangents[n - 1] >= tangent {
            n -= 1;
        }
        while n < self.tangents.len() && self.tangents[n] < tangent {
            n += 1;
        }
        n
    }

    /// Sweeps to the left of the two ends, as far as the line lies ahead; `None` if it lies behind or crosses none.
    fn span(&self, line: &Line) -> Option<[usize; 2]> {
        let [a, b] = [line.from, line.to].map(|end| [dot(self.middle, end), cross(self.middle, end)]);
        if a[0] < NEAREST && b[0] < NEAREST {
            return None;
        }
        if a[0] >= NEAREST && b[0] >= NEAREST && self.surely_misses(a, b) {
            return None;
        }
        Some([self.sweeps_left_of(clipped(a, b)), self.sweeps_left_of(clipped(b, a))])
    }

    fn crossing(&self, sweep: usize, line: &Line) -> f64 {
        let direction = self.directions[sweep];
        let way = [line.to[0] - line.from[0], line.to[1] - line.from[1]];
        let range = cross(line.from, way) / cross(direction, way);
        let [a, b] = [line.from, line.to].map(|end| dot(direction, end));
        // A line almost along the sweep: rounding must not throw the crossing off it.
        let within = if range.is_nan() { a.min(b) } else { range.max(a.min(b)).min(a.max(b)) };
        within.max(0.0)
    }
}

/// `a` (ahead, across), or if it lies behind the place ahead where the line to `b` begins to count.
fn clipped(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    if a[0] >= NEAREST {
        return a;
    }
    let share = (NEAREST - a[0]) / (b[0] - a[0]);
    [NEAREST, a[1] + share * (b[1] - a[1])]
}

/// Lines that some sweep of a frame crosses, in the order in which they were given.
pub(crate) struct Met<'a> {
    fan: Option<Fan<'a>>,
    lines: Vec<MetLine>,
}

/// A line, and the number of sweeps to the left of its two ends, which differ.
struct MetLine {
    line: Line,
    left: [u32; 2],
}

impl<'a> Met<'a> {
    /// For the sweeps of `directions`, from lists of any number of lines: most of them lie between two sweeps.
    pub(crate) fn new<T: Sync>(
        directions: &'a [[f64; 2]],
        lists: &[&[T]],
        line: impl Fn(&T) -> Line + Sync,
    ) -> Self {
        let fan = Fan::new(directions);
        let met = |fan: &Fan<'_>, line: Line| {
            let left = fan.span(&line)?.map(|sweeps| sweeps as u32);
            (left[0] != left[1]).then_some(MetLine { line, left })
        };
        let all = fan.as_ref().map(|fan| {
            lists
                .par_iter()
                .flat_map_iter(|list| list.iter().filter_map(|part| met(fan, line(part))))
                .collect()
        });
        Self { lines: all.unwrap_or_default(), fan }
    }

    /// Indices of the lines that sweeps of `band` cross, and those sweeps.
    fn within(&self, band: &Range<usize>) -> impl Iterator<Item = (usize, Range<usize>)> {
        let Range { start, end } = *band;
        let met = move |[a, b]: [u32; 2]| (a.min(b) as usize).max(start)..(a.max(b) as usize).min(end);
        let all = self.lines.iter().map(move |MetLine { left, .. }| met(*left)).enumerate();
        all.filter(|(_, sweeps)| !sweeps.is_empty())
    }

    /// The line of a crossing, from the eye.
    pub(crate) fn line(&self, crossing: Crossing) -> &Line {
        &self.lines[crossing.line()].line
    }
}

/// All crossings of a band of sweeps, sweep by sweep; used again from band to band.
#[derive(Debug, Default)]
pub(crate) struct Crossings {
    /// Where the crossings of each sweep begin; one more at the end.
    starts: Vec<usize>,
    /// Where the next crossing of each sweep goes.
    next: Vec<usize>,
    crossings: Vec<Crossing>,
}

impl Crossings {
    /// Finds where sweeps of `band` cross the lines.
    pub(crate) fn find(&mut self, met: &Met<'_>, band: Range<usize>) {
        self.starts.clear();
        self.starts.resize(band.len() + 1, 0);
        let Some(fan) = &met.fan else { return };
        let first = band.start;
        for (_, sweeps) in met.within(&band) {
            sweeps.for_each(|sweep| self.starts[sweep - first + 1] += 1);
        }
        for sweep in 1..self.starts.len() {
            self.starts[sweep] += self.starts[sweep - 1];
        }
        self.crossings.clear();
        self.crossings.resize(self.starts[band.len()], Crossing::default());
        self.next.clone_from(&self.starts);
        for (index, sweeps) in met.within(&band) {
            let MetLine { line, left: [a, b] } = &met.lines[index];
            for sweep in sweeps {
                let next = &mut self.next[sweep - first];
                // Leftwards its shadow lies beyond it.
                self.crossings[*next] = Crossing::new(fan.crossing(sweep, line), a < b, index as u32);
                *next += 1;
            }
        }
    }

    /// Crossings of one sweep, counted from the first of the band, by range; at one range beginnings come first.
    pub(crate) fn of(&mut self, number: usize) -> &[Crossing] {
        let own = &mut self.crossings[self.starts[number]..self.starts[number + 1]];
        own.sort_unstable();
        own
    }
}

fn dot(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

/// Above 0 if `b` lies to the right of `a`.
fn cross(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

#[cfg(test)]
mod tests {
    use proptest::prelude::{prop_assert, prop_assert_eq, proptest};

    use super::{Fan, Line};

    proptest! {
        /// The short way drops no line that a sweep crosses, in fans that are even in their tangents, in their angles or
        /// in neither, and leaves few lines that none does.
        #[test]
        fn a_line_that_is_passed_by_crosses_no_sweep(
            sweeps in 1..60usize,
            half in 0.01..1.4f64,
            bend in -0.9..0.9f64,
            places in proptest::collection::vec([-9.0..9.0f64, -9.0..9.0f64, -1.5..1.5f64, -1.5..1.5f64], 50),
        ) {
            let direction = |n: usize| {
                let place = (2 * n) as f64 / (sweeps - 1).max(1) as f64 - 1.0;
                let (sin, cos) = quantities::sin_cos(half * (place + bend * (1.0 - place * place) * 0.5));
                [cos, sin]
            };
            let directions: Vec<[f64; 2]> = (0..sweeps).map(direction).collect();
            let fan = Fan::new(&directions).expect("less than half a turn");
            for [north, east, way_north, way_east] in places {
                let line = Line { from: [north, east], to: [north + way_north, east + way_east] };
                let by_force = |end: [f64; 2]| {
                    let [ahead, across] = [super::dot(fan.middle, end), super::cross(fan.middle, end)];
                    (ahead > 0.0).then(|| fan.tangents.iter().filter(|&&t| t < across / ahead).count())
                };
                let (Some(a), Some(b)) = (by_force(line.from), by_force(line.to)) else { continue };
                match fan.span(&line) {
                    Some(span) => prop_assert_eq!(span, [a, b]),
                    None => prop_assert!(a == b, "{line:?} crosses {a}..{b}"),
                }
            }
        }
    }
}
