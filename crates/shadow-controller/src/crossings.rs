//! Where the sweeps of a frame cross boundary segments.

use std::ops::Range;

use fearless_simd::{Level, Simd, dispatch};
use rayon::iter::{IntoParallelIterator, ParallelIterator};
use remote_shadow::{Outlines, Segment};

use crate::crossing::{Crossing, Place};
use crate::fan::{Fan, Guesses, Line, Sifted, TOGETHER, WORD};
use crate::line_generators::Boundary;

/// Parts of all lists that are looked over one by one: a few for each thread, so that none waits long for another.
const PARTS: usize = 16;

/// Lines, or crossings of a sweep, that there is room for before more memory is asked for.
pub(crate) const ROOM: usize = 1024;

/// Where places of the ground are for the sweeps.
pub(crate) trait Sighting: Sync {
    /// A place (north, east; m) from the eye.
    fn seen(&self, place: [f64; 2]) -> [f64; 2];

    /// The same of some: north of each, then east (m).
    #[inline(always)]
    fn all_seen(&self, mut places: [[f64; TOGETHER]; 2]) -> [[f64; TOGETHER]; 2] {
        for n in 0..TOGETHER {
            [places[0][n], places[1][n]] = self.seen([places[0][n], places[1][n]]);
        }
        places
    }

    /// A segment from the eye.
    #[inline(always)]
    fn line(&self, Segment { from, to }: Segment) -> Line {
        Line { from: self.seen(from), to: self.seen(to) }
    }
}

/// Where the sweeps of a frame cross segments of some lists, in the order in which these were given.
pub(crate) struct Met<'a, F, C> {
    lists: &'a [&'a Outlines],
    sighting: F,
    directions: &'a [[f64; 2]],
    parts: Vec<Part<C>>,
}

/// Of some lists: all crossings, sweep by sweep.
#[derive(Default)]
struct Part<C> {
    crossings: Vec<C>,
    /// Where those of each sweep end.
    ends: Vec<u32>,
}

/// A line, where it is from, and the number of sweeps to the left of its two ends, which differ.
#[derive(Debug, Clone, Copy)]
struct MetLine {
    line: Line,
    place: Place,
    left: [u32; 2],
}

impl MetLine {
    /// Sweeps that cross it.
    fn sweeps(&self) -> Range<usize> {
        let [a, b] = self.left;
        a.min(b) as usize..a.max(b) as usize
    }
}

impl<'a, F: Sighting, C: Crossing> Met<'a, F, C> {
    /// For the sweeps of `directions`, from lists of any number of segments: most of them lie between two sweeps.
    pub(crate) fn new(directions: &'a [[f64; 2]], lists: &'a [&'a Outlines], sighting: F) -> Self {
        let mut met = Self { lists, sighting, directions, parts: Vec::new() };
        let Some(fan) = Fan::new(directions) else { return met };
        let vectors = Level::new();
        let part = |(guesses, lines): &mut (Guesses, Vec<MetLine>), part: (usize, &[&Outlines])| dispatch!(vectors, simd => met.part(simd, &fan, part, guesses, lines));
        let room = || (Guesses::default(), Vec::with_capacity(ROOM));
        let parts = like_parts(lists).into_par_iter().map_init(room, part).collect();
        met.parts = parts;
        met
    }

    /// Number of sweeps.
    pub(crate) fn sweeps(&self) -> usize {
        self.directions.len()
    }

    /// What a crossing of a sweep is if it parts light from shadow; `None` if its line is not known.
    pub(crate) fn boundary(&self, sweep: usize, crossing: C) -> Option<Boundary> {
        let line = self.line(crossing.place()?);
        Some(Boundary::new(&line, self.directions[sweep], crossing.range()))
    }

    #[inline(always)]
    fn line(&self, [list, number]: Place) -> Line {
        self.sighting.line(self.lists[list as usize].segment(number as usize))
    }

    /// Finds where the sweeps of the fan cross lines of some lists, the first of which is number `first`.
    #[inline(always)]
    fn part<V: Simd>(
        &self,
        simd: V,
        fan: &Fan<'_>,
        (first, lists): (usize, &[&Outlines]),
        guesses: &mut Guesses,
        lines: &mut Vec<MetLine>,
    ) -> Part<C> {
        lines.clear();
        for (list, outlines) in (first..).zip(lists) {
            find_met(simd, fan, list as u32, outlines, &self.sighting, guesses, lines);
        }
        let mut ends = begins(lines, self.sweeps());
        let mut crossings = vec![C::default(); lines.iter().map(|line| line.sweeps().len()).sum()];
        for met in &*lines {
            let [a, b] = met.left;
            for sweep in met.sweeps() {
                // Leftwards its shadow lies beyond it.
                crossings[ends[sweep] as usize] = C::new(fan.crossing(sweep, &met.line), a < b, met.place);
                ends[sweep] += 1;
            }
        }
        Part { crossings, ends }
    }
}

impl<C> Part<C> {
    /// Crossings of one sweep.
    fn of(&self, sweep: usize) -> &[C] {
        let begin = if sweep == 0 { 0 } else { self.ends[sweep - 1] };
        &self.crossings[begin as usize..self.ends[sweep] as usize]
    }
}

/// Lists in parts that have about as many corners, each with the number of its first list.
fn like_parts<'a>(lists: &'a [&'a Outlines]) -> Vec<(usize, &'a [&'a Outlines])> {
    let all = lists.iter().map(|list| list.corners().len()).sum::<usize>().max(1);
    let (mut corners, mut first) = (0, 0);
    let parts = lists.chunk_by(|list, _| {
        let before = corners;
        corners += list.corners().len();
        before * PARTS / all == corners * PARTS / all
    });
    let numbered = parts.map(|part| {
        let number = first;
        first += part.len();
        (number, part)
    });
    numbered.collect()
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
pub(crate) struct Crossings<C> {
    crossings: Vec<C>,
    apart: Vec<C>,
}

impl<C: Crossing> Crossings<C> {
    /// Room for those of a sweep.
    pub(crate) fn new() -> Self {
        Self { crossings: Vec::with_capacity(ROOM), apart: Vec::with_capacity(ROOM) }
    }

    /// Crossings of one sweep in their order.
    pub(crate) fn of<F>(&mut self, met: &Met<'_, F, C>, sweep: usize) -> &[C] {
        // Tiles come by their distance from the eye.
        C::sort(met.parts.iter().map(|part| part.of(sweep)), &mut self.crossings, &mut self.apart);
        &self.crossings
    }
}

/// Adds the segments of a list that sweeps cross to `met`.
#[inline(always)]
fn find_met<V: Simd>(
    simd: V,
    fan: &Fan<'_>,
    list: u32,
    outlines: &Outlines,
    sighting: &impl Sighting,
    guesses: &mut Guesses,
    met: &mut Vec<MetLine>,
) {
    let (corners, mut ends, guesser) = (outlines.corners(), outlines.ends(), fan.guesser(simd));
    guesses.make_room(corners.len());
    // A loop, no closure: it has the vectors of its caller.
    for first in (0..corners.len()).step_by(TOGETHER) {
        guesser.guess(first, sighting.all_seen(corners.some(first)), guesses);
    }
    let count = corners.len().saturating_sub(1);
    for first in (0..count).step_by(WORD) {
        let mut sifted = guesses.sift(simd, first, WORD.min(count - first));
        while let Some((&end, others)) = ends.split_first()
            && (end as usize) < first + WORD
        {
            sifted.may_cross &= !(1 << (end as usize - first));
            ends = others;
        }
        keep_met(fan, [list, first as u32], sifted, guesses, met);
    }
}

/// Keeps those of a word of lines, of which the first is at `place`, that sweeps cross.
#[inline(always)]
fn keep_met(
    fan: &Fan<'_>,
    [list, first]: Place,
    Sifted { mut may_cross, known }: Sifted,
    guesses: &Guesses,
    met: &mut Vec<MetLine>,
) {
    while may_cross != 0 {
        let n = may_cross.trailing_zeros();
        may_cross &= may_cross - 1;
        let number = first + n;
        let line = guesses.line(number as usize);
        let left = if known >> n & 1 == 1 {
            guesses.left(number as usize)
        } else {
            match fan.span(&line) {
                Some([a, b]) if a != b => [a as u32, b as u32],
                _ => continue,
            }
        };
        met.push(MetLine { line, place: [list, number], left });
    }
}
