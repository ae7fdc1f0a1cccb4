//! What the sweeps cut out of a body that is in the picture as a whole. Edge by edge, so that what two faces share is found once;
//! all edges are asked at once whether they meet a sweep, and where they do is worked out eight side by side.

use std::ops::Range;

use fearless_simd::prelude::SimdMask;
use fearless_simd::{Simd, SimdBase, u32x16};
use signal::{LANES, eight};
use solids::{Edge, EdgeBits, Solid};

use crate::Span;
use crate::face::sweeps_of;
use crate::generator::Field;
use crate::likeness::{Likeness, UNSEEN};
use crate::view::Place;

/// Groups of edges that are told by the bits of a word: how many of sixteen are met nobody can guess, of so many it matters less.
const GROUPS: usize = u64::BITS as usize / EdgeBits::TOGETHER;

/// Edges of a body, and where sweeps meet them; buffers are kept from body to body.
#[derive(Debug, Default)]
pub(crate) struct Meetings {
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
        (solid, likeness): (&Solid, &Likeness),
        (first, tangents): (usize, &[f64]),
        stamp: Span,
        spans: &mut Vec<(u32, Span)>,
    ) {
        let sweeps = sweeps_of(likeness.sweeps.iter().flatten().copied());
        // Many a small body lies between two sweeps.
        if sweeps.is_empty() {
            return;
        }
        self.faces.clear();
        self.sweep_ends.clear();
        self.lower.resize(solid.faces().len().max(self.lower.len()), 0);
        for sweep in sweeps.clone() {
            self.meet(simd, (solid, likeness), (sweep, tangents[sweep as usize]));
        }
        self.place(simd, field);
        let mut begin = 0;
        for number in 0..sweeps.len() {
            let met = begin..self.sweep_ends[number] as usize;
            begin = met.end;
            self.cut(met, likeness, (first as u32 + sweeps.start + number as u32, stamp), spans);
        }
    }

    /// Finds the edges that a sweep at a tangent meets.
    #[inline(always)]
    fn meet<V: Simd>(
        &mut self,
        simd: V,
        (solid, likeness): (&Solid, &Likeness),
        (sweep, tangent): (u32, f64),
    ) {
        let left = likeness.left_of(simd, sweep);
        let words = solid.edges().chunks(u64::BITS as usize).zip(solid.edge_bits().chunks(GROUPS));
        for (edges, bits) in words {
            let mut met = bits
                .iter()
                .rev()
                .fold(0, |met, bits| met << EdgeBits::TOGETHER | is_met(simd, bits, left, likeness.seen));
            while met != 0 {
                let edge = &edges[met.trailing_zeros() as usize];
                met &= met - 1;
                self.keep(edge, tangent, left, likeness);
            }
        }
        self.sweep_ends.push(self.faces.len() as u32);
    }

    /// Keeps an edge that the sweep at a tangent meets, which has the corners `left` to its left.
    #[inline(always)]
    fn keep(&mut self, Edge { corners, faces }: &Edge, tangent: f64, left: u32, likeness: &Likeness) {
        // Outlines run counter-clockwise: an edge to the right is a lower one. Which way one runs cannot be guessed.
        let turned = usize::from(left >> corners[0] & 1 == 0);
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

    /// Adds the spans on one sweep, which has the meetings `met`: from the top, each from the edge above a face that is seen to the
    /// one below.
    #[inline(always)]
    fn cut(
        &mut self,
        met: Range<usize>,
        likeness: &Likeness,
        (sweep, stamp): (u32, Span),
        spans: &mut Vec<(u32, Span)>,
    ) {
        let seen = |face: u32| likeness.faces[face as usize];
        for (number, [above, _]) in (met.start..).zip(&self.faces[met.clone()]) {
            self.lower[*above as usize] = number as u32;
        }
        let [lines, nears, depths] = &self.places;
        for (first, [above, _]) in (met.start..).zip(&self.faces[met.clone()]) {
            if seen(*above) != UNSEEN {
                continue;
            }
            let mut upper = first;
            // As many as there are at most, whatever rounding has made of the outlines.
            for _ in met.clone() {
                let below = self.faces[upper][1];
                let reflectivity = seen(below);
                if reflectivity == UNSEEN {
                    break;
                }
                let lower = self.lower[below as usize] as usize;
                let [top, bottom] = [lines[upper], lines[lower]];
                if top < bottom {
                    let near = [nears[upper], nears[lower]];
                    let depth = [depths[upper], depths[lower]];
                    spans.push((sweep, Span { top, bottom, reflectivity, near, depth, ..stamp }));
                }
                upper = lower;
            }
        }
    }
}

/// Which of sixteen edges are seen, and met by the sweep that has the corners `left` to its left: a bit each.
#[inline(always)]
fn is_met<V: Simd>(simd: V, edges: &EdgeBits, left: u32, seen: u64) -> u64 {
    let of = |bits: &[u32; EdgeBits::TOGETHER], these: u32| {
        let bits = u32x16::load_array(simd, *bits);
        (bits, bits & these)
    };
    let (corners, to_the_left) = of(&edges.corners, left);
    let [first, others] = [(0, seen as u32), (1, (seen >> u32::BITS) as u32)]
        .map(|(half, seen): (usize, u32)| of(&edges.faces[half], seen).1);
    let is_between = !(to_the_left.simd_eq(0) | to_the_left.simd_eq(corners));
    (is_between & !(first | others).simd_eq(0)).to_bitmask()
}
