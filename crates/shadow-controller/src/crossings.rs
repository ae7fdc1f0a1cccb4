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
    pub(crate) fn line(self) -> usize {
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
        Some(Self { directions, middle, tangents, density })
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

    /// Sweeps to the left of the two ends, as far as the line lies ahead; `None` if it lies behind.
    fn span(&self, line: &Line) -> Option<[usize; 2]> {
        let [a, b] = [line.from, line.to].map(|end| [dot(self.middle, end), cross(self.middle, end)]);
        if a[0] < NEAREST && b[0] < NEAREST {
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

/// Which sweeps cross each line of a frame.
pub(crate) struct Spans<'a> {
    fan: Option<Fan<'a>>,
    /// Sweeps to the left of both ends.
    spans: Vec<[u32; 2]>,
}

impl<'a> Spans<'a> {
    /// For the sweeps of `directions`.
    pub(crate) fn new(directions: &'a [[f64; 2]], lines: &[Line]) -> Self {
        let fan = Fan::new(directions);
        let span = |fan: &Fan<'_>, line| fan.span(line).unwrap_or([0; 2]).map(|n| n as u32);
        let spans = fan.as_ref().map(|fan| lines.par_iter().map(|line| span(fan, line)).collect());
        Self { spans: spans.unwrap_or_default(), fan }
    }
}

/// All crossings of a band of sweeps, sweep by sweep; used again from band to band.
#[derive(Debug, Default)]
pub(crate) struct Crossings {
    /// Lines that are crossed, and by which sweeps of the band.
    met: Vec<(u32, Range<u32>)>,
    /// Where the crossings of each sweep begin; one more at the end.
    starts: Vec<usize>,
    /// Where the next crossing of each sweep goes.
    next: Vec<usize>,
    crossings: Vec<Crossing>,
}

impl Crossings {
    /// Finds where sweeps of `band` cross `lines`.
    pub(crate) fn find(&mut self, spans: &Spans<'_>, lines: &[Line], band: Range<usize>) {
        self.met.clear();
        self.starts.clear();
        self.starts.resize(band.len() + 1, 0);
        let Some(fan) = &spans.fan else { return };
        let [first, end] = [band.start as u32, band.end as u32];
        for (line, &[a, b]) in (0..).zip(&spans.spans) {
            let met = a.min(b).max(first)..a.max(b).min(end);
            if !met.is_empty() {
                met.clone().for_each(|sweep| self.starts[(sweep - first) as usize + 1] += 1);
                self.met.push((line, met));
            }
        }
        for sweep in 1..self.starts.len() {
            self.starts[sweep] += self.starts[sweep - 1];
        }
        self.fill(fan, &spans.spans, lines, band.start);
    }

    /// Crossings of one sweep, counted from the first of the band, by range; at one range beginnings come first.
    pub(crate) fn of(&mut self, number: usize) -> &[Crossing] {
        let own = &mut self.crossings[self.starts[number]..self.starts[number + 1]];
        own.sort_unstable();
        own
    }

    fn fill(&mut self, fan: &Fan<'_>, spans: &[[u32; 2]], lines: &[Line], first: usize) {
        self.crossings.clear();
        self.crossings.resize(self.starts[self.starts.len() - 1], Crossing::default());
        self.next.clone_from(&self.starts);
        for (line, met) in &self.met {
            // Leftwards its shadow lies beyond it.
            let [a, b] = spans[*line as usize];
            for sweep in met.start as usize..met.end as usize {
                let range = fan.crossing(sweep, &lines[*line as usize]);
                let next = &mut self.next[sweep - first];
                self.crossings[*next] = Crossing::new(range, a < b, *line);
                *next += 1;
            }
        }
    }
}

fn dot(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

/// Above 0 if `b` lies to the right of `a`.
fn cross(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}
