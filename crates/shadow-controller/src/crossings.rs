//! Where the sweeps of a frame cross boundary segments.

use std::ops::Range;

use fearless_simd::{Level, Simd, dispatch};
use rayon::iter::{IndexedParallelIterator, ParallelIterator};
use rayon::slice::ParallelSlice;

use crate::fan::{Fan, Line, Sifted, TOGETHER};
use crate::line_generators::Boundary;
use crate::nearly::sort_nearly;

/// Lists that are looked over together.
const PART: usize = 256;

/// Lines, or crossings of a sweep, that there is room for before more memory is asked for.
pub(crate) const ROOM: usize = 1024;

/// One sweep crosses one line: bits of the range, then whether a shadow ends there, then which crossing it is: its part
/// and its place there. In this form they are sorted as they are met, beginnings before endings at the same range.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Default)]
pub(crate) struct Crossing(u128);

impl Crossing {
    /// `range` (m) must not be negative: only then its bits are in its order. There are less than 2^31 parts.
    fn new(range: f64, ends: bool, [part, place]: [u32; 2]) -> Self {
        let place = u64::from(ends) << 63 | u64::from(part) << 32 | u64::from(place);
        Self(u128::from(range.to_bits()) << 64 | u128::from(place))
    }

    /// Ground range (m).
    pub(crate) fn range(self) -> f64 {
        f64::from_bits((self.0 >> 64) as u64)
    }

    /// Shadows begun (1) or ended (-1) there.
    pub(crate) fn step(self) -> i32 {
        1 - 2 * ((self.0 >> 63) as i32 & 1)
    }

    /// Part and place there.
    fn place(self) -> [usize; 2] {
        [(self.0 >> 32) as usize & 0x7fff_ffff, self.0 as u32 as usize]
    }
}

/// Where the sweeps of a frame cross lines, in the order in which these were given.
pub(crate) struct Met(Vec<Part>);

/// Of some lists: all crossings, sweep by sweep.
#[derive(Default)]
struct Part {
    crossings: Vec<Crossing>,
    /// What each of them is if it parts light from shadow.
    boundaries: Vec<Boundary>,
    /// Where those of each sweep end.
    ends: Vec<u32>,
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
}

impl Met {
    /// For the sweeps of `directions`, from lists of any number of lines: most of them lie between two sweeps.
    pub(crate) fn new<T: Sync>(
        directions: &[[f64; 2]],
        lists: &[&[T]],
        line: impl Fn(&T) -> Line + Sync,
    ) -> Self {
        let Some(fan) = Fan::new(directions) else { return Self(Vec::new()) };
        let vectors = Level::new();
        let part = |lines: &mut Vec<MetLine>, (number, lists): (usize, &[&[T]])| {
            lines.clear();
            dispatch!(vectors, simd => find_met(simd, &fan, lists, &line, lines));
            Part::new(&fan, number as u32, lines, directions.len())
        };
        Self(lists.par_chunks(PART).enumerate().map_init(|| Vec::with_capacity(ROOM), part).collect())
    }

    /// What a crossing is if it parts light from shadow.
    pub(crate) fn boundary(&self, crossing: Crossing) -> Boundary {
        let [part, place] = crossing.place();
        self.0[part].boundaries[place]
    }
}

impl Part {
    /// Part `number`: finds where the sweeps of the fan, `sweeps` of them, cross `lines`.
    fn new(fan: &Fan<'_>, number: u32, lines: &[MetLine], sweeps: usize) -> Self {
        let mut ends = begins(lines, sweeps);
        let count = lines.iter().map(|met| met.sweeps().len()).sum();
        let (mut crossings, mut boundaries) =
            (vec![Crossing::default(); count], vec![Boundary::default(); count]);
        for met in lines {
            let MetLine { line, left: [a, b] } = met;
            for sweep in met.sweeps() {
                let (place, range) = (ends[sweep], fan.crossing(sweep, line));
                // Leftwards its shadow lies beyond it.
                crossings[place as usize] = Crossing::new(range, a < b, [number, place]);
                boundaries[place as usize] = Boundary::new(line, fan.direction(sweep), range);
                ends[sweep] += 1;
            }
        }
        Self { crossings, boundaries, ends }
    }

    /// Crossings of one sweep.
    fn of(&self, sweep: usize) -> &[Crossing] {
        let begin = if sweep == 0 { 0 } else { self.ends[sweep - 1] };
        &self.crossings[begin as usize..self.ends[sweep] as usize]
    }
}

/// Where the crossings of each sweep begin.
fn begins(lines: &[MetLine], sweeps: usize) -> Vec<u32> {
    // First how many more lines cross a sweep than the one before, modulo 2^32.
    let mut begins = vec![0u32; sweeps + 1];
    for Range { start, end } in lines.iter().map(MetLine::sweeps) {
        begins[start] = begins[start].wrapping_add(1);
        begins[end] = begins[end].wrapping_sub(1);
    }
    begins.truncate(sweeps);
    let (mut crossing, mut all) = (0u32, 0);
    for begin in &mut begins {
        crossing = crossing.wrapping_add(*begin);
        *begin = all;
        all += crossing;
    }
    begins
}

/// All crossings of a sweep; used again from sweep to sweep.
#[derive(Debug)]
pub(crate) struct Crossings {
    crossings: Vec<Crossing>,
    apart: Vec<Crossing>,
}

impl Crossings {
    /// Room for those of a sweep.
    pub(crate) fn new() -> Self {
        Self { crossings: Vec::with_capacity(ROOM), apart: Vec::with_capacity(ROOM) }
    }

    /// Crossings of one sweep by range; at one range beginnings come first.
    pub(crate) fn of(&mut self, met: &Met, sweep: usize) -> &[Crossing] {
        self.crossings.clear();
        met.0.iter().for_each(|part| self.crossings.extend_from_slice(part.of(sweep)));
        // Tiles come by their distance from the eye.
        sort_nearly(&mut self.crossings, &mut self.apart);
        &self.crossings
    }
}

/// Adds the lines of some lists that sweeps cross to `all`.
#[inline(always)]
fn find_met<V: Simd, T>(
    simd: V,
    fan: &Fan<'_>,
    lists: &[&[T]],
    line: impl Fn(&T) -> Line,
    all: &mut Vec<MetLine>,
) {
    for list in lists {
        let (chunks, rest) = list.as_chunks::<TOGETHER>();
        for chunk in chunks {
            keep_met(fan, chunk, fan.sift(simd, |n| line(&chunk[n])), &line, all);
        }
        if let Some(last) = rest.len().checked_sub(1) {
            // The last one stands in for those that are not there.
            keep_met(fan, rest, fan.sift(simd, |n| line(&rest[n.min(last)])), &line, all);
        }
    }
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
