//! What the sweeps cut out of a body that is in the picture as a whole. Edge by edge, so that what two faces share is found once;
//! all edges are asked at once whether they meet a sweep, and where they do is worked out eight side by side.

use fearless_simd::prelude::SimdMask;
use fearless_simd::{Simd, SimdBase, f64x8, u32x16};
use signal::{LANES, eight};
use solids::Edge;

use crate::Span;
use crate::face::sweeps_of;
use crate::generator::Field;
use crate::likeness::{Likeness, UNSEEN};
use crate::view::Place;

/// Edges that are asked at once.
const ASKED: usize = 16;

/// Edges of a body, and those of them that one sweep meets; buffers are kept from body to body.
#[derive(Debug, Default)]
pub(crate) struct Meetings {
    /// Sweeps to the left of the left and of the right end of each edge; of one that nobody sees both are the same.
    left: [Vec<u32>; 2],
    /// Faces above and below each edge that is met.
    faces: Vec<[u32; 2]>,
    /// Its ends on the picture, the left one first: x, y, inverse depth, spread of each.
    ends: Vec<[[[f64; LANES]; 4]; 2]>,
    /// Where it is met: line position, inverse range, inverse depth.
    places: [Vec<f32>; 3],
    /// Which of those that are met is the lower end of a face.
    lower: Vec<u32>,
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
        for sweep in sweeps {
            self.meet(simd, (edges, likeness), sweep);
            self.place(simd, field, tangents[sweep as usize]);
            self.cut(likeness, (first as u32 + sweep, stamp), spans);
        }
    }

    /// Takes the edges of a body.
    #[inline(always)]
    fn take(&mut self, edges: &[Edge], Likeness { sweeps, faces, .. }: &Likeness) {
        self.make_room(edges.len(), faces.len());
        // Behind the last there are none to be met.
        let asked = edges.len().next_multiple_of(ASKED);
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
        let room = edges.next_multiple_of(ASKED);
        if self.lower.len() < faces || self.left[0].len() < room {
            self.left.iter_mut().for_each(|left| left.resize(room.max(left.len()), 0));
            self.ends.resize(self.left[0].len() / LANES, Default::default());
            self.places.iter_mut().for_each(|places| places.resize(self.left[0].len(), 0.0));
            self.lower.resize(faces.max(self.lower.len()), 0);
        }
    }

    /// Finds the edges that a sweep meets.
    #[inline(always)]
    fn meet<V: Simd>(&mut self, simd: V, (edges, likeness): (&[Edge], &Likeness), sweep: u32) {
        self.faces.clear();
        let [begins, ends] = &self.left;
        let at = u32x16::splat(simd, sweep);
        for first in (0..edges.len()).step_by(ASKED) {
            let [begin, end] =
                [begins, ends].map(|left| u32x16::from_slice(simd, &left[first..first + ASKED]));
            let mut met = (begin.simd_le(at) & at.simd_lt(end)).to_bitmask();
            while met != 0 {
                let Edge { corners, faces } = &edges[first + met.trailing_zeros() as usize];
                met &= met - 1;
                // Outlines run counter-clockwise: an edge to the right is a lower one. Which way one runs cannot be guessed.
                let [a, b] = corners.map(|corner| likeness.sweeps[corner as usize]);
                let turned = usize::from(a > b);
                let [ends, faces] = [corners, faces].map(|pair| [pair[turned], pair[1 - turned]]);
                let number = self.faces.len();
                let (block, lane) = (&mut self.ends[number / LANES], number % LANES);
                for (to, corner) in block.iter_mut().zip(ends) {
                    let from = &likeness.corners[corner as usize / LANES];
                    for axis in 0..4 {
                        to[axis][lane] = from[axis][corner as usize % LANES];
                    }
                }
                self.faces.push(faces);
                self.lower[faces[0] as usize] = number as u32;
            }
        }
    }

    /// Works out where these are met by the sweep at a tangent.
    #[inline(always)]
    fn place<V: Simd>(&mut self, simd: V, field: &Field<'_>, tangent: f64) {
        let tangent = f64x8::splat(simd, tangent);
        for (number, ends) in self.ends[..self.faces.len().div_ceil(LANES)].iter().enumerate() {
            let [left, right] = ends;
            let [from, to] = [left, right].map(|[x, y, depth, _]| Place {
                x: eight(simd, x),
                y: eight(simd, y),
                depth: eight(simd, depth),
            });
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

    /// Adds the span of each face that is seen: from the edge above it to the one below it.
    #[inline(always)]
    fn cut(&self, likeness: &Likeness, (sweep, stamp): (u32, Span), spans: &mut Vec<(u32, Span)>) {
        let [lines, nears, depths] = &self.places;
        for (upper, [_, face]) in self.faces.iter().enumerate() {
            let reflectivity = likeness.faces[*face as usize];
            if reflectivity == UNSEEN {
                continue;
            }
            let lower = self.lower[*face as usize] as usize;
            let [top, bottom] = [lines[upper], lines[lower]];
            if top < bottom {
                let near = [nears[upper], nears[lower]];
                let depth = [depths[upper], depths[lower]];
                spans.push((sweep, Span { top, bottom, reflectivity, near, depth, ..stamp }));
            }
        }
    }
}
