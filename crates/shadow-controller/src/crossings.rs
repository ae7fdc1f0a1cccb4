//! Where the sweeps of a frame cross boundary segments.

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

/// All crossings of a frame, sweep by sweep.
#[derive(Debug, Default)]
pub(crate) struct Crossings {
    spans: Vec<[u32; 2]>,
    starts: Vec<usize>,
    crossings: Vec<Crossing>,
}

impl Crossings {
    /// Finds where sweeps of `directions` cross `lines`.
    pub(crate) fn new(directions: &[[f64; 2]], lines: &[Line]) -> Self {
        let Some(fan) = Fan::new(directions) else { return Self::default() };
        let mut found = Self { starts: vec![0; directions.len() + 1], ..Self::default() };
        found.count(&fan, lines);
        found.fill(&fan, lines);
        found
    }

    /// Crossings of one sweep, by range; at one range beginnings come first.
    pub(crate) fn of(&mut self, sweep: usize) -> &[Crossing] {
        let (Some(&start), Some(&end)) = (self.starts.get(sweep), self.starts.get(sweep + 1)) else {
            return &[];
        };
        let own = &mut self.crossings[start..end];
        own.sort_unstable();
        own
    }

    fn count(&mut self, fan: &Fan<'_>, lines: &[Line]) {
        self.spans.extend(lines.iter().map(|line| fan.span(line).unwrap_or([0; 2]).map(|n| n as u32)));
        for &[a, b] in &self.spans {
            for sweep in a.min(b)..a.max(b) {
                self.starts[sweep as usize + 1] += 1;
            }
        }
        for sweep in 1..self.starts.len() {
            self.starts[sweep] += self.starts[sweep - 1];
        }
    }

    fn fill(&mut self, fan: &Fan<'_>, lines: &[Line]) {
        self.crossings.resize(self.starts[self.starts.len() - 1], Crossing::default());
        let mut next = self.starts.clone();
        for (index, (line, &[a, b])) in lines.iter().zip(&self.spans).enumerate() {
            // Leftwards its shadow lies beyond it.
            let ends = a < b;
            for sweep in a.min(b) as usize..a.max(b) as usize {
                let range = fan.crossing(sweep, line);
                self.crossings[next[sweep]] = Crossing::new(range, ends, index as u32);
                next[sweep] += 1;
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
