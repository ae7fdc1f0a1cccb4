//! What the sweeps cut out of a body that is in the picture as a whole. Edge by edge, so that what two faces share is found once;
//! sixteen edges are asked at once whether they meet a sweep, and where they do is worked out eight side by side.

use std::ops::Range;

use fearless_simd::prelude::{Select, SimdMask};
use fearless_simd::{Simd, SimdBase, f64x4, f64x8, mask32x16, u32x16};
use signal::{LANES, turn_square};
use solids::{EdgeWords, Solid};

use crate::Span;
use crate::generator::Field;
use crate::likeness::{Likeness, UNSEEN};
use crate::table::Drawing;
use crate::view::Place;

/// Edges of a body, and where sweeps meet them; buffers are kept from body to body.
#[derive(Debug, Default)]
pub(crate) struct Meetings {
    /// Words of the edges along which a face is seen; behind the last, edges that nothing meets.
    seen: Vec<u32>,
    /// The edge of each meeting, sweep by sweep: its left corner first, and the face above it.
    edges: Vec<u32>,
    /// Tangent of the sweep of each meeting.
    tangents: Vec<f64>,
    /// Where the meetings of each sweep end.
    sweep_ends: Vec<usize>,
    /// Where each is: line position, inverse range, inverse depth.
    places: [Vec<f32>; 3],
    /// Of a sweep: the meetings that have no seen face above them.
    tops: Vec<usize>,
    /// Which meeting of a sweep is the lower end of each face.
    lower: Vec<usize>,
}

impl Meetings {
    /// Adds the spans of a body on each sweep that meets it, with all that `stamp` tells of them. Sweeps at ascending `tangents`
    /// may meet it, the first of which is number `first`.
    #[inline(always)]
    pub fn find<V: Simd>(
        &mut self,
        simd: V,
        field: &Field<'_>,
        (solid, likeness): (&Solid, &Likeness),
        (first, tangents): (usize, &[f64]),
        stamp: Span,
        drawing: &mut Drawing,
    ) {
        let sweeps = likeness.sweeps(simd, tangents);
        // Many a small body lies between two sweeps.
        if sweeps.is_empty() {
            return;
        }
        let words = self.take_seen(simd, solid.edge_words(), likeness.seen);
        let room = words * sweeps.len() + EdgeWords::TOGETHER;
        grow(&mut self.edges, room);
        grow(&mut self.tangents, room);
        grow(&mut self.lower, solid.faces().len());
        self.sweep_ends.clear();
        let mut count = 0;
        for &tangent in &tangents[sweeps.clone()] {
            count = self.meet(simd, words, (likeness.left_of(simd, tangent), tangent), count);
            self.sweep_ends.push(count);
        }
        self.place(simd, field, likeness, count);
        let mut begin = 0;
        for number in 0..sweeps.len() {
            let met = begin..self.sweep_ends[number];
            begin = met.end;
            self.cut(met, likeness, ((first + sweeps.start + number) as u32, stamp), drawing);
        }
    }

    /// Takes the edges along which a face is seen; returns how many words to look at.
    #[inline(always)]
    fn take_seen<V: Simd>(&mut self, simd: V, edges: &[EdgeWords], seen: u64) -> usize {
        grow(&mut self.seen, EdgeWords::TOGETHER * (edges.len() + 1));
        let seen = [u32x16::splat(simd, seen as u32), u32x16::splat(simd, (seen >> u32::BITS) as u32)];
        let mut count = 0;
        for words in edges {
            let words = u32x16::load_array(simd, words.0);
            let is_seen = bits(seen, words >> 16 & 0xff) | bits(seen, words >> 24);
            let is_wanted = is_seen.simd_ne(0) & words.simd_ne(0);
            count = append(words, is_wanted, &mut self.seen, count);
        }
        u32x16::splat(simd, 0).store_slice(&mut self.seen[count..count + EdgeWords::TOGETHER]);
        count.next_multiple_of(EdgeWords::TOGETHER)
    }

    /// Finds the edges that a sweep at a tangent meets, which has the corners `left` to its left; returns the `count` of meetings
    /// with those that are added.
    #[inline(always)]
    fn meet<V: Simd>(
        &mut self,
        simd: V,
        words: usize,
        (left, tangent): (u32, f64),
        mut count: usize,
    ) -> usize {
        let (left, tangent) = (u32x16::splat(simd, left), f64x8::splat(simd, tangent));
        for words in self.seen[..words].chunks_exact(EdgeWords::TOGETHER) {
            let words = u32x16::from_slice(simd, words);
            let [from, to] = [left >> (words & 0xff) & 1, left >> (words >> 8 & 0xff) & 1];
            // Outlines run counter-clockwise: an edge to the right is a lower one.
            let turned = (words >> 8 & 0x00ff_00ff) | (words << 8 & 0xff00_ff00);
            let words = from.simd_eq(1).select(words, turned);
            tangent.store_slice(&mut self.tangents[count..count + LANES]);
            tangent.store_slice(&mut self.tangents[count + LANES..count + 2 * LANES]);
            count = append(words, from.simd_ne(to), &mut self.edges, count);
        }
        count
    }

    /// Works out where all meetings are.
    #[inline(always)]
    fn place<V: Simd>(&mut self, simd: V, field: &Field<'_>, likeness: &Likeness, count: usize) {
        let corners = likeness.corners.as_flattened();
        let room = count.next_multiple_of(LANES);
        self.edges[count..room].fill(0);
        self.places.iter_mut().for_each(|places| grow(places, room));
        for first in (0..room).step_by(LANES) {
            let all = first..first + LANES;
            let mut ends = [f64x8::splat(simd, 0.0); LANES];
            for (ends, edge) in ends.iter_mut().zip(&self.edges[all.clone()]) {
                let [left, right, ..] = edge.to_le_bytes();
                *ends = simd.combine_f64x4(
                    f64x4::load_array(simd, corners[usize::from(left)]),
                    f64x4::load_array(simd, corners[usize::from(right)]),
                );
            }
            turn_square(&mut ends);
            let [x, y, depth, spread, to_x, to_y, to_depth, to_spread] = ends;
            let tangent = f64x8::from_slice(simd, &self.tangents[all.clone()]);
            let [off, beyond] = [x - tangent * spread, to_x - tangent * to_spread];
            let to = Place { x: to_x, y: to_y, depth: to_depth };
            let place = Place { x, y, depth }.towards(&to, off / (off - beyond));
            let found = [field.line(place.y), field.near(&place), place.depth].map(|found| found.to_array());
            for (places, found) in self.places.iter_mut().zip(found) {
                let places = &mut places[all.clone()];
                for n in 0..LANES {
                    places[n] = found[n] as f32;
                }
            }
        }
    }

    /// Adds the spans on one sweep, which has the meetings `met`: from the top, each from the edge above a face that is seen to the
    /// one below.
    #[inline(always)]
    fn cut(
        &mut self,
        met: Range<usize>,
        likeness: &Likeness,
        (sweep, stamp): (u32, Span),
        drawing: &mut Drawing,
    ) {
        let faces = |meeting: usize| {
            let [_, _, above, below] = self.edges[meeting].to_le_bytes();
            [above, below].map(usize::from)
        };
        grow(&mut self.tops, met.len());
        let mut tops = 0;
        for meeting in met.clone() {
            let [above, _] = faces(meeting);
            self.lower[above] = meeting;
            // Kept or not without a branch: which of them it is cannot be guessed.
            self.tops[tops] = meeting;
            tops += usize::from(likeness.seen >> above & 1 == 0);
        }
        let [lines, nears, depths] = &self.places;
        for &top in &self.tops[..tops] {
            let (mut upper, mut stack) = (top, drawing.begin());
            // As many as there are at most, whatever rounding has made of the outlines.
            for _ in met.clone() {
                let [_, below] = faces(upper);
                let reflectivity = likeness.faces[below];
                if reflectivity == UNSEEN {
                    break;
                }
                let lower = self.lower[below];
                let [top, bottom] = [lines[upper], lines[lower]];
                if top < bottom {
                    let near = [nears[upper], nears[lower]];
                    let depth = [depths[upper], depths[lower]];
                    drawing.add(&mut stack, Span { top, bottom, reflectivity, near, depth, ..stamp });
                } else {
                    let next = drawing.begin();
                    drawing.end(sweep, std::mem::replace(&mut stack, next));
                }
                upper = lower;
            }
            drawing.end(sweep, stack);
        }
    }
}

/// Sees to it that a buffer has room for so many.
#[inline(always)]
fn grow<T: Copy + Default>(buffer: &mut Vec<T>, room: usize) {
    if buffer.len() < room {
        buffer.resize(room, T::default());
    }
}

/// A bit each of 64, by their numbers.
#[inline(always)]
fn bits<V: Simd>([first, others]: [u32x16<V>; 2], numbers: u32x16<V>) -> u32x16<V> {
    let half = (numbers & 32).simd_eq(0).select(first, others);
    half >> (numbers & 31) & 1
}

/// Writes those of sixteen words that are wanted behind the first `count`, and zeros up to sixteen; returns how many there are then.
#[inline(always)]
fn append<V: Simd>(words: u32x16<V>, is_wanted: mask32x16<V>, to: &mut [u32], count: usize) -> usize {
    words.compress(is_wanted).store_slice(&mut to[count..count + EdgeWords::TOGETHER]);
    count + is_wanted.to_bitmask().count_ones() as usize
}
