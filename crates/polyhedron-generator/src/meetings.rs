//! What the sweeps cut out of a body that is in the picture as a whole. Edge by edge, so that what two faces share is found once;
//! all edges are asked at once whether they meet a sweep, and where they do is worked out eight side by side.

use std::ops::Range;

use fearless_simd::prelude::SimdMask;
use fearless_simd::{Simd, SimdBase, u32x16};
use signal::{LANES, eight};
use solids::Edge;

use crate::Span;
use crate::face::sweeps_of;
use crate::generator::Field;
use crate::likeness::{Likeness, UNSEEN};
use crate::view::Place;

/// Edges that are asked at once.
const ASKED: usize = 16;

/// Edges that are told by the bits of a word: how many of sixteen are met nobody can guess, of so many it matters less.
const WORD: usize = u64::BITS as usize;

/// Edges of a body, and where sweeps meet them; buffers are kept from body to body.
#[derive(Debug, Default)]
pub(crate) struct Meetings {
    /// Sweeps to the left of the left and of the right end of each edge; of one that nobody sees both are the same.
    left: [Vec<u32>; 2],
    /// Faces above and below the edge of each meeting, sweep by sweep.
    faces: Vec<[u32; 2]>,
    /// Where the meetings of each sweep end.
    sweep_ends: Vec<u32>,
    /// What each is worked out from, eight side by side.
    blocks: Vec<Block>,
    /// Where each is: line position, inverse range, inverse depth.
    places: [Vec<f32>; 3],
    /// Which meeting of a sweep is the lower end of a face.
    lower: Vec<u32>,
}

/// Eight edges with the sweeps that meet them.
#[derive(Debug, Clone, Copy, Default)]
struct Block {
    tangents: [f64; LANES],
    /// Ends on the picture, the left one first: x, y, inverse depth and spread of each.
    ends: [[[f64; LANES]; 4]; 2],
}

impl Meetings {
    /// Adds the spans of a body on each sweep that meets it, with all that `stamp` tells of them. Sweeps at ascending `tangents`
    /// may meet it, the first of which is number `first`.
    #[inline(always)]
    pub fn find<V: Simd>(
        &mut self,
        simd: V,
        field: &Field<'_>,
        (edges, likeness): (&[Edge], &Likeness),
        (first, tangents): (usize, &[f64]),
        stamp: Span,
        spans: &mut Vec<(u32, Span)>,
    ) {
        let sweeps = sweeps_of(likeness.sweeps.iter().copied());
        // Many a small body lies between two sweeps.
        if sweeps.is_empty() {
            return;
        }
        self.take(edges, likeness);
        for sweep in sweeps.clone() {
            self.meet(simd, (edges, likeness), (sweep, tangents[sweep as usize]));
        }
        self.place(simd, field);
        let mut begin = 0;
        for number in 0..sweeps.len() {
            let met = begin..self.sweep_ends[number] as usize;
            begin = met.end;
            self.cut(met, likeness, (first as u32 + sweeps.start + number as u32, stamp), spans);
        }
    }

    /// Takes the edges of a body, and forgets what was met of the one before.
    #[inline(always)]
    fn take(&mut self, edges: &[Edge], Likeness { sweeps, faces, .. }: &Likeness) {
        self.faces.clear();
        self.sweep_ends.clear();
        self.make_room(edges.len(), faces.len());
        // Behind the last there are none to be met.
        let asked = edges.len().next_multiple_of(WORD);
        self.left.iter_mut().for_each(|left| left[edges.len()..asked].fill(0));
        let [begins, ends] = &mut self.left;
        for (edge, (begin, end)) in edges.iter().zip(begins.iter_mut().zip(ends)) {
            let [a, b] = edge.corners.map(|corner| sweeps[corner as usize]);
            // Without a branch: which are seen cannot be guessed.
            let [along, back] = edge.faces.map(|face| faces[face as usize] != UNSEEN);
            *begin = a.min(b);
            *end = if along | back { a.max(b) } else { *begin };
        }
    }

    /// Makes room for a body, if there is not enough.
    fn make_room(&mut self, edges: usize, faces: usize) {
        let room = edges.next_multiple_of(WORD).max(self.left[0].len());
        self.left.iter_mut().for_each(|left| left.resize(room, 0));
        self.lower.resize(faces.max(self.lower.len()), 0);
    }

    /// Finds the edges that a sweep at a tangent meets.
    #[inline(always)]
    fn meet<V: Simd>(
        &mut self,
        simd: V,
        (edges, likeness): (&[Edge], &Likeness),
        (sweep, tangent): (u32, f64),
    ) {
        for first in (0..edges.len()).step_by(WORD) {
            let mut met = self.ask(simd, first, sweep);
            while met != 0 {
                let edge = &edges[first + met.trailing_zeros() as usize];
                met &= met - 1;
                self.keep(edge, tangent, likeness);
            }
        }
        self.sweep_ends.push(self.faces.len() as u32);
    }

    /// Which edges of a word a sweep meets: a bit each.
    #[inline(always)]
    fn ask<V: Simd>(&self, simd: V, first: usize, sweep: u32) -> u64 {
        let (at, mut met) = (u32x16::splat(simd, sweep), 0);
        for group in (0..WORD).step_by(ASKED) {
            let asked = first + group..first + group + ASKED;
            let [begin, end] =
                [0, 1].map(|side: usize| u32x16::from_slice(simd, &self.left[side][asked.clone()]));
            met |= (begin.simd_le(at) & at.simd_lt(end)).to_bitmask() << group;
        }
        met
    }

    /// Keeps an edge that the sweep at a tangent meets.
    #[inline(always)]
    fn keep(&mut self, Edge { corners, faces }: &Edge, tangent: f64, likeness: &Likeness) {
        // Outlines run counter-clockwise: an edge to the right is a lower one. Which way one runs cannot be guessed.
        let [a, b] = corners.map(|corner| likeness.sweeps[corner as usize]);
        let turned = usize::from(a > b);
        let [ends, faces] = [corners, faces].map(|pair| [pair[turned], pair[1 - turned]]);
        let (block, lane) = (self.faces.len() / LANES, self.faces.len() % LANES);
        if block == self.blocks.len() {
            self.blocks.push(Block::default());
        }
        let block = &mut self.blocks[block];
        block.tangents[lane] = tangent;
        for (to, corner) in block.ends.iter_mut().zip(ends) {
            let from = &likeness.corners[corner as usize / LANES];
            for axis in 0..4 {
                to[axis][lane] = from[axis][corner as usize % LANES];
            }
        }
        self.faces.push(faces);
    }

    /// Works out where all meetings are.
    #[inline(always)]
    fn place<V: Simd>(&mut self, simd: V, field: &Field<'_>) {
        let blocks = self.faces.len().div_ceil(LANES);
        let room = (LANES * blocks).max(self.places[0].len());
        self.places.iter_mut().for_each(|places| places.resize(room, 0.0));
        for (number, Block { tangents, ends: [left, right] }) in self.blocks[..blocks].iter().enumerate() {
            let [from, to] = [left, right].map(|[x, y, depth, _]| Place {
                x: eight(simd, x),
                y: eight(simd, y),
                depth: eight(simd, depth),
            });
            let tangent = eight(simd, tangents);
            let off = from.x - tangent * eight(simd, &left[3]);
            let beyond = to.x - tangent * eight(simd, &right[3]);
            let place = from.towards(&to, off / (off - beyond));
            let all = [field.line(place.y), field.near(&place), place.depth].map(|all| all.to_array());
            let first = LANES * number;
            for (places, all) in self.places.iter_mut().zip(all) {
                let places = &mut places[first..first + LANES];
                for n in 0..LANES {
                    places[n] = all[n] as f32;
                }
            }
        }
    }

    /// Adds the spans on one sweep, which has the meetings `met`: each from the edge above a face that is seen to the one below.
    #[inline(always)]
    fn cut(
        &mut self,
        met: Range<usize>,
        likeness: &Likeness,
        (sweep, stamp): (u32, Span),
        spans: &mut Vec<(u32, Span)>,
    ) {
        for (number, [above, _]) in (met.start..).zip(&self.faces[met.clone()]) {
            self.lower[*above as usize] = number as u32;
        }
        let [lines, nears, depths] = &self.places;
        for (upper, [_, below]) in (met.start..).zip(&self.faces[met.clone()]) {
            let reflectivity = likeness.faces[*below as usize];
            if reflectivity == UNSEEN {
                continue;
            }
            let lower = self.lower[*below as usize] as usize;
            let [top, bottom] = [lines[upper], lines[lower]];
            if top < bottom {
                let near = [nears[upper], nears[lower]];
                let depth = [depths[upper], depths[lower]];
                spans.push((sweep, Span { top, bottom, reflectivity, near, depth, ..stamp }));
            }
        }
    }
}
