//! Edge slots of a frame: how many edges are in view, and what goes where slots are short.

use std::collections::HashSet;

use crate::list::List;
use crate::piece::{Piece, Spot};

/// Edges of one list: two pieces that meet share theirs.
#[derive(Default)]
struct Edges(HashSet<[u64; 4]>);

impl Edges {
    /// Adds the edges of a piece; how many of them are new.
    fn add(&mut self, piece: &Piece) -> u64 {
        let spots = &piece.spots;
        let next = spots.iter().cycle().skip(1);
        let is_new = |(a, b): (&_, &_)| u64::from(self.0.insert(key(a, b)));
        spots.iter().zip(next).map(is_new).sum()
    }
}

/// An edge by the bits of its ends, in one order for both directions.
fn key(a: &Spot, b: &Spot) -> [u64; 4] {
    let [mut first, mut last] = [a, b].map(|spot| spot.at.map(f64::to_bits));
    if last < first {
        std::mem::swap(&mut first, &mut last);
    }
    [first[0], first[1], last[0], last[1]]
}

/// Edges of pieces that stand list by list: how many each of `lists` lists has.
pub fn of_lists<'a>(pieces: impl Iterator<Item = &'a Piece>, lists: usize) -> Vec<u64> {
    let mut counts = vec![0; lists];
    let mut edges = (0, Edges::default());
    for piece in pieces {
        if piece.list != edges.0 {
            edges = (piece.list, Edges::default());
        }
        counts[piece.list as usize] += edges.1.add(piece);
    }
    counts
}

/// Pieces with and without slots.
pub struct Slotted {
    /// Pieces that have slots, in their order.
    pub kept: Vec<Piece>,
    /// Pieces that have none: those of levels that fell, then others.
    pub lost: Vec<Piece>,
    /// Faces of those, but for the levels that fell.
    pub lost_faces: u64,
}

/// Gives `slots` slots to the edges of pieces that stand list by list. Levels of detail fall first, the last list first; then whole faces go, from
/// the last list its last face first. Without limit (`u64::MAX`) no edge is counted.
pub fn limited(lists: &mut [List], pieces: Vec<Piece>, slots: u64) -> Slotted {
    if slots == u64::MAX {
        return Slotted { kept: pieces, lost: Vec::new(), lost_faces: 0 };
    }
    let counts = of_lists(pieces.iter(), lists.len());
    let mut asked: u64 = counts.iter().sum();
    for (list, count) in lists.iter_mut().zip(&counts).rev() {
        if asked > slots && list.level.is_some() && *count > 0 {
            list.has_fallen = true;
            asked -= count;
        }
    }
    let has_fallen = |piece: &Piece| lists[piece.list as usize].has_fallen;
    let (mut lost, mut kept): (Vec<Piece>, Vec<Piece>) = pieces.into_iter().partition(has_fallen);
    let without = kept.split_off(if asked > slots { fitting(&kept, slots) } else { kept.len() });
    let lost_faces = faces(&without);
    lost.extend(without);
    Slotted { kept, lost, lost_faces }
}

/// Number of the first pieces that have slots, whole faces alone.
fn fitting(pieces: &[Piece], slots: u64) -> usize {
    let mut used = 0;
    let mut edges = (0, Edges::default());
    let mut first = 0;
    for face in pieces.chunk_by(|a, b| (a.list, a.face) == (b.list, b.face)) {
        if face[0].list != edges.0 {
            edges = (face[0].list, Edges::default());
        }
        used += face.iter().map(|piece| edges.1.add(piece)).sum::<u64>();
        if used > slots {
            break;
        }
        first += face.len();
    }
    first
}

/// Faces that pieces are of.
fn faces(pieces: &[Piece]) -> u64 {
    pieces.chunk_by(|a, b| (a.list, a.face) == (b.list, b.face)).count() as u64
}
