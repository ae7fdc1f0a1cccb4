//! Where the sweeps of a frame cross boundary segments.

use std::ops::Range;

use fearless_simd::{Level, Simd, dispatch};
use rayon::iter::ParallelIterator;
use rayon::slice::ParallelSlice;

use crate::fan::{Fan, Line, Sifted, TOGETHER};

/// Sweeps that are worked on together.
pub(crate) const BAND: usize = 64;

/// Lists that are looked over together.
const PART: usize = 256;

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

/// Lines that some sweep of a frame crosses, in the order in which they were given.
pub(crate) struct Met<'a> {
    fan: Option<Fan<'a>>,
    lines: Vec<MetLine>,
    /// Indices of the lines that each band of sweeps crosses, band by band.
    by_band: Vec<u32>,
    /// Where those of each band begin; one more at the end.
    starts: Vec<usize>,
}

/// A line, and the number of sweeps to the left of its two ends, which differ.
#[derive(Debug, Clone, Copy)]
struct MetLine {
    line: Line,
    left: [u32; 2],
}

impl MetLine {
    /// Sweeps that cross it.
    fn sweeps(&self) -> Range<usize> {
        let [a, b] = self.left;
        a.min(b) as usize..a.max(b) as usize
    }

    /// Bands of sweeps that do.
    fn bands(&self) -> Range<usize> {
        let Range { start, end } = self.sweeps();
        start / BAND..end.div_ceil(BAND)
    }
}

impl<'a> Met<'a> {
    /// For the sweeps of `directions`, from lists of any number of lines: most of them lie between two sweeps.
    pub(crate) fn new<T: Sync>(
        directions: &'a [[f64; 2]],
        lists: &[&[T]],
        line: impl Fn(&T) -> Line + Sync,
    ) -> Self {
        let (fan, vectors) = (Fan::new(directions), Level::new());
        let met = |fan: &Fan<'_>| {
            let part = |lists: &[&[T]]| dispatch!(vectors, simd => met_of(simd, fan, lists, &line));
            lists.par_chunks(PART).map(part).collect::<Vec<_>>().concat()
        };
        let lines = fan.as_ref().map(met).unwrap_or_default();
        let mut starts = vec![0; directions.len().div_ceil(BAND) + 1];
        for met in &lines {
            met.bands().for_each(|band| starts[band + 1] += 1);
        }
        for band in 1..starts.len() {
            starts[band] += starts[band - 1];
        }
        let (mut next, mut by_band) = (starts.clone(), vec![0; starts[starts.len() - 1]]);
        for (index, met) in (0..).zip(&lines) {
            for band in met.bands() {
                by_band[next[band]] = index;
                next[band] += 1;
            }
        }
        Self { fan, lines, by_band, starts }
    }

    /// Indices of the lines that sweeps of a band cross, and those sweeps, counted from the first of the band.
    fn within(&self, band: usize) -> impl Iterator<Item = (u32, Range<usize>)> {
        let first = band * BAND;
        self.by_band[self.starts[band]..self.starts[band + 1]].iter().map(move |&index| {
            let Range { start, end } = self.lines[index as usize].sweeps();
            (index, start.max(first) - first..end.min(first + BAND) - first)
        })
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
    /// Finds where the sweeps of a band, `count` of them, cross the lines.
    pub(crate) fn find(&mut self, met: &Met<'_>, band: usize, count: usize) {
        self.starts.clear();
        self.starts.resize(count + 1, 0);
        let Some(fan) = &met.fan else { return };
        for (_, sweeps) in met.within(band) {
            sweeps.for_each(|sweep| self.starts[sweep + 1] += 1);
        }
        for sweep in 1..self.starts.len() {
            self.starts[sweep] += self.starts[sweep - 1];
        }
        self.crossings.clear();
        self.crossings.resize(self.starts[count], Crossing::default());
        self.next.clone_from(&self.starts);
        for (index, sweeps) in met.within(band) {
            let MetLine { line, left: [a, b] } = &met.lines[index as usize];
            for sweep in sweeps {
                let next = &mut self.next[sweep];
                // Leftwards its shadow lies beyond it.
                self.crossings[*next] = Crossing::new(fan.crossing(band * BAND + sweep, line), a < b, index);
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

/// Lines that a part of the lists has room for before it asks for more memory.
const ROOM: usize = 1024;

/// The lines of some lists that sweeps cross.
#[inline(always)]
fn met_of<V: Simd, T>(simd: V, fan: &Fan<'_>, lists: &[&[T]], line: impl Fn(&T) -> Line) -> Vec<MetLine> {
    let mut all = Vec::with_capacity(ROOM);
    for list in lists {
        let (chunks, rest) = list.as_chunks::<TOGETHER>();
        for chunk in chunks {
            keep_met(fan, chunk, fan.sift(simd, |n| line(&chunk[n])), &line, &mut all);
        }
        if let Some(last) = rest.len().checked_sub(1) {
            // The last one stands in for those that are not there.
            keep_met(fan, rest, fan.sift(simd, |n| line(&rest[n.min(last)])), &line, &mut all);
        }
    }
    all
}

/// Keeps those lines of a chunk that sweeps cross.
#[inline(always)]
fn keep_met<T>(
    fan: &Fan<'_>,
    chunk: &[T],
    sifted: Sifted,
    line: impl Fn(&T) -> Line,
    all: &mut Vec<MetLine>,
) {
    let Sifted { mut may_cross, known, left } = sifted;
    while may_cross != 0 {
        let n = may_cross.trailing_zeros() as usize;
        may_cross &= may_cross - 1;
        let Some(part) = chunk.get(n) else { return };
        let line = line(part);
        let known = (known >> n & 1 == 1).then(|| left.map(|left| left[n] as usize));
        let left = known.or_else(|| fan.span(&line)).map(|left| left.map(|sweeps| sweeps as u32));
        all.extend(left.filter(|[a, b]| a != b).map(|left| MetLine { line, left }));
    }
}
