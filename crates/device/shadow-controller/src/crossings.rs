//! Where the sweeps of a frame cross boundary segments.

use std::ops::Range;

use fearless_simd::{Level, Simd, dispatch};
use rayon::iter::{IntoParallelIterator, ParallelIterator};
use remote_shadow::{Outlines, Segment};

use crate::crossing::{Crossing, Known, place};
use crate::fan::{Fan, Line, TOGETHER};
use crate::line_generators::Boundary;
use crate::lines::{Finder, MetLine};
use crate::nearly::sort_nearly;

/// Most parts of all lists that are looked over one by one: a few for each thread, so that none waits long for another.
const PARTS: usize = 16;

/// Least corners of such a part: each part asks for some work a sweep, whatever it holds.
const LEAST_PART: usize = 8192;

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

impl<'a, F: Sighting, C: Crossing> Met<'a, F, C> {
    /// For the sweeps of `directions`, from lists of any number of segments: most of them lie between two sweeps.
    pub(crate) fn new(directions: &'a [[f64; 2]], lists: &'a [&'a Outlines], sighting: F) -> Self {
        let mut met = Self { lists, sighting, directions, parts: Vec::new() };
        let Some(fan) = Fan::new(directions) else { return met };
        let vectors = Level::new();
        let part = |finder: &mut Finder, part| dispatch!(vectors, simd => met.part(simd, &fan, part, finder));
        let parts = like_parts(lists).into_par_iter().map_init(Finder::new, part).collect();
        met.parts = parts;
        met
    }

    /// Finds where the sweeps of the fan cross lines of some lists, the first of which is number `first`.
    #[inline(always)]
    fn part<V: Simd>(
        &self,
        simd: V,
        fan: &Fan<'_>,
        lists: (usize, &[&Outlines]),
        finder: &mut Finder,
    ) -> Part<C> {
        let lines = finder.of(simd, fan, lists, &self.sighting);
        let mut ends = begins(lines, self.sweeps());
        let mut crossings = vec![C::default(); lines.iter().map(|line| line.sweeps().len()).sum()];
        for met in lines {
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

impl<F, C> Met<'_, F, C> {
    /// Returns the number of sweeps.
    pub(crate) fn sweeps(&self) -> usize {
        self.directions.len()
    }

    /// Crossings of one sweep, part by part.
    pub(crate) fn of(&self, sweep: usize) -> impl Iterator<Item = &[C]> {
        self.parts.iter().map(move |part| part.of(sweep))
    }
}

impl<F: Sighting> Met<'_, F, Known> {
    /// What a crossing of a sweep is if it parts light from shadow.
    pub(crate) fn boundary(&self, sweep: usize, crossing: Known) -> Boundary {
        let [list, number] = place(crossing);
        let line = self.sighting.line(self.lists[list as usize].segment(number as usize));
        Boundary::new(&line, self.directions[sweep], crossing.range())
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
    let all = lists.iter().map(|list| list.corners().len()).sum::<usize>();
    let share = all.div_ceil(PARTS).max(LEAST_PART);
    let (mut corners, mut first) = (0, 0);
    let parts = lists.chunk_by(|list, _| {
        let before = corners;
        corners += list.corners().len();
        before / share == corners / share
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

/// All crossings of a sweep whose lines are known; used again from sweep to sweep.
#[derive(Debug)]
pub(crate) struct Crossings {
    crossings: Vec<Known>,
    apart: Vec<Known>,
}

impl Crossings {
    /// Room for those of a sweep.
    pub(crate) fn new() -> Self {
        Self { crossings: Vec::with_capacity(ROOM), apart: Vec::with_capacity(ROOM) }
    }

    /// Crossings of one sweep in their order.
    pub(crate) fn of<F>(&mut self, met: &Met<'_, F, Known>, sweep: usize) -> &[Known] {
        // Tiles come by their distance from the eye.
        sort_nearly(met.of(sweep).flatten().copied(), &mut self.crossings, &mut self.apart);
        &self.crossings
    }
}
