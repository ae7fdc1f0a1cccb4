//! Where the sweeps of a frame cross boundary segments.

use std::ops::{Range, RangeInclusive};

use fearless_simd::{Level, Simd, dispatch};
use rayon::iter::{IndexedParallelIterator, ParallelIterator};
use rayon::slice::ParallelSlice;
use remote_shadow::{Outlines, Segment};

use crate::fan::{Fan, Line, Sifted, TOGETHER};
use crate::line_generators::Boundary;
use crate::nearly::sort_nearly;

/// Lists that are looked over together.
const PART: usize = 256;

/// Sweeps that are worked on together.
pub(crate) const BAND: usize = 64;

/// Lines, or crossings of a sweep, that there is room for before more memory is asked for.
pub(crate) const ROOM: usize = 1024;

/// A segment: its list and its number there, less than 2^31 lists.
type Place = [u32; 2];

/// One sweep crosses one line: bits of the range, then whether a shadow ends there, then which line it is. In this form they
/// are sorted as they are met, beginnings before endings at the same range.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Default)]
pub(crate) struct Crossing(u128);

impl Crossing {
    /// `range` (m) must not be negative: only then its bits are in its order.
    fn new(range: f64, ends: bool, [list, number]: Place) -> Self {
        let place = u64::from(ends) << 63 | u64::from(list) << 32 | u64::from(number);
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

    /// The line that is crossed.
    fn place(self) -> Place {
        [(self.0 >> 32) as u32 & 0x7fff_ffff, self.0 as u32]
    }
}

/// The segments of some lists, and how each is seen from the eye.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Lines<'a, F> {
    pub lists: &'a [&'a Outlines],
    pub seen: F,
}

impl<F: Fn(Segment) -> Line> Lines<'_, F> {
    #[inline(always)]
    fn at(&self, [list, number]: Place) -> Line {
        (self.seen)(self.lists[list as usize].segment(number as usize))
    }
}

/// The lines that sweeps of a frame meet, in the order in which these were given.
pub(crate) struct Met<'a, F> {
    lines: Lines<'a, F>,
    directions: &'a [[f64; 2]],
    fan: Option<Fan<'a>>,
    parts: Vec<Part>,
}

/// Of some lists: the lines that sweeps meet, band by band; one that several bands meet is there several times.
#[derive(Default)]
struct Part {
    met: Vec<MetLine>,
    /// Where those of each band end.
    ends: Vec<u32>,
}

/// A line, and the number of sweeps to the left of its two ends, which differ.
#[derive(Debug, Clone, Copy, Default)]
struct MetLine {
    place: Place,
    left: [u32; 2],
}

impl MetLine {
    /// Sweeps that cross it, which are some.
    fn sweeps(&self) -> Range<usize> {
        let [a, b] = self.left;
        a.min(b) as usize..a.max(b) as usize
    }

    /// The bands that they are of.
    fn bands(&self) -> RangeInclusive<usize> {
        let Range { start, end } = self.sweeps();
        start / BAND..=(end - 1) / BAND
    }

    /// Those of them that are of a band.
    fn sweeps_of(&self, band: usize) -> Range<usize> {
        let Range { start, end } = self.sweeps();
        start.max(band * BAND)..end.min((band + 1) * BAND)
    }
}

impl<'a, F: Fn(Segment) -> Line + Sync> Met<'a, F> {
    /// For the sweeps of `directions`, from lists of any number of segments: most of them lie between two sweeps.
    pub(crate) fn new(directions: &'a [[f64; 2]], lines: Lines<'a, F>) -> Self {
        let (fan, vectors) = (Fan::new(directions), Level::new());
        let part = |met: &mut Vec<MetLine>, (number, lists): (usize, &[&Outlines])| {
            met.clear();
            for fan in &fan {
                for (list, outlines) in (number * PART..).zip(lists) {
                    dispatch!(vectors, simd => find_met(simd, fan, list as u32, outlines, &lines.seen, met));
                }
            }
            Part::new(met, directions.len().div_ceil(BAND))
        };
        let lists = lines.lists.par_chunks(PART).enumerate();
        let parts = lists.map_init(|| Vec::with_capacity(ROOM), part).collect();
        Self { lines, directions, fan, parts }
    }

    /// Number of sweeps.
    pub(crate) fn sweeps(&self) -> usize {
        self.directions.len()
    }

    /// What a crossing of a sweep is if it parts light from shadow.
    pub(crate) fn boundary(&self, sweep: usize, crossing: Crossing) -> Boundary {
        Boundary::new(&self.lines.at(crossing.place()), self.directions[sweep], crossing.range())
    }
}

impl Part {
    /// Sorts lines into bands: a counting sort.
    fn new(met: &[MetLine], bands: usize) -> Self {
        let mut ends = vec![0u32; bands];
        met.iter().flat_map(MetLine::bands).for_each(|band| ends[band] += 1);
        let mut all = 0;
        for end in &mut ends {
            // First where they begin.
            (*end, all) = (all, all + *end);
        }
        let mut sorted = vec![MetLine::default(); all as usize];
        for line in met {
            for band in line.bands() {
                sorted[ends[band] as usize] = *line;
                ends[band] += 1;
            }
        }
        Self { met: sorted, ends }
    }

    /// Those of a band.
    fn of(&self, band: usize) -> &[MetLine] {
        let begin = if band == 0 { 0 } else { self.ends[band - 1] };
        &self.met[begin as usize..self.ends[band] as usize]
    }
}

/// All crossings of a band of sweeps; used again from band to band.
#[derive(Debug)]
pub(crate) struct Crossings {
    crossings: Vec<Crossing>,
    /// Where those of each sweep of the band end.
    ends: [u32; BAND],
    apart: Vec<Crossing>,
}

impl Crossings {
    /// Room for those of a sweep.
    pub(crate) fn new() -> Self {
        let room = || Vec::with_capacity(ROOM);
        Self { crossings: room(), ends: [0; BAND], apart: room() }
    }

    /// Finds those of a band.
    pub(crate) fn find<F: Fn(Segment) -> Line>(&mut self, met: &Met<'_, F>, band: usize) {
        let Self { crossings, ends, .. } = self;
        let of_band = || met.parts.iter().flat_map(|part| part.of(band));
        *ends = begins(of_band().map(|line| line.sweeps_of(band)), band * BAND);
        crossings.clear();
        crossings.resize(of_band().map(|line| line.sweeps_of(band).len()).sum(), Crossing::default());
        for (fan, line) in met.fan.iter().flat_map(|fan| of_band().map(move |line| (fan, line))) {
            let ([a, b], seen) = (line.left, met.lines.at(line.place));
            for sweep in line.sweeps_of(band) {
                let end = &mut ends[sweep % BAND];
                // Leftwards its shadow lies beyond it.
                crossings[*end as usize] = Crossing::new(fan.crossing(sweep, &seen), a < b, line.place);
                *end += 1;
            }
        }
    }

    /// Crossings of one sweep of the band by range; at one range beginnings come first.
    pub(crate) fn of(&mut self, sweep: usize) -> &[Crossing] {
        let place = sweep % BAND;
        let begin = if place == 0 { 0 } else { self.ends[place - 1] };
        let crossings = &mut self.crossings[begin as usize..self.ends[place] as usize];
        // Tiles come by their distance from the eye.
        sort_nearly(crossings, &mut self.apart);
        crossings
    }
}

/// Where the crossings of each sweep of a band begin, of which `first` is the first, if lines cross `all`.
fn begins(all: impl Iterator<Item = Range<usize>>, first: usize) -> [u32; BAND] {
    // First how many more lines cross a sweep than the one before, modulo 2^32.
    let mut more = [0u32; BAND + 1];
    for Range { start, end } in all {
        more[start - first] = more[start - first].wrapping_add(1);
        more[end - first] = more[end - first].wrapping_sub(1);
    }
    let (mut crossing, mut before) = (0u32, 0);
    std::array::from_fn(|sweep| {
        crossing = crossing.wrapping_add(more[sweep]);
        let begin = before;
        before += crossing;
        begin
    })
}

/// Adds the segments of a list that sweeps cross to `met`.
#[inline(always)]
fn find_met<V: Simd>(
    simd: V,
    fan: &Fan<'_>,
    list: u32,
    outlines: &Outlines,
    seen: &impl Fn(Segment) -> Line,
    met: &mut Vec<MetLine>,
) {
    let (corners, mut ends) = (outlines.corners(), outlines.ends());
    let count = corners.len().saturating_sub(1);
    for first in (0..count).step_by(TOGETHER) {
        // The last one stands in for those that are not there.
        let line = |n: usize| seen(outlines.segment((first + n).min(count - 1)));
        let mut sifted = match corners[first..].first_chunk::<{ TOGETHER + 1 }>() {
            Some(chain) => fan.sift(simd, |n| seen(Segment { from: chain[n], to: chain[n + 1] })),
            None => fan.sift(simd, line),
        };
        sifted.may_cross &= !0 >> (u64::BITS as usize - TOGETHER.min(count - first));
        while let Some((&end, others)) = ends.split_first()
            && (end as usize) < first + TOGETHER
        {
            sifted.may_cross &= !(1 << (end as usize - first));
            ends = others;
        }
        keep_met(fan, [list, first as u32], sifted, line, met);
    }
}

/// Keeps those of eight lines, of which the first is at `place`, that sweeps cross.
#[inline(always)]
fn keep_met(
    fan: &Fan<'_>,
    [list, first]: Place,
    sifted: Sifted,
    line: impl Fn(usize) -> Line,
    met: &mut Vec<MetLine>,
) {
    let Sifted { mut may_cross, known, left } = sifted;
    while may_cross != 0 {
        let n = may_cross.trailing_zeros() as usize;
        may_cross &= may_cross - 1;
        let known = (known >> n & 1 == 1).then(|| left.map(|left| left[n] as usize));
        let left = known.or_else(|| fan.span(&line(n))).map(|left| left.map(|sweeps| sweeps as u32));
        let place = [list, first + n as u32];
        met.extend(left.filter(|[a, b]| a != b).map(|left| MetLine { place, left }));
    }
}
