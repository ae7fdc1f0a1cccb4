//! What of a disc is in sight along a sweep.

use polyhedron_generator::{Hold, Overlay, Sweep};

use crate::placing::Point;

/// What can stand before a light on one sweep.
#[derive(Debug, Clone, Copy)]
pub struct Before<'a, L> {
    /// How high the ground has reached.
    pub hold: &'a Hold<'a, L>,
    /// Highest line position of the mountains behind the last sample, if there are any.
    pub mountains: Option<f32>,
    /// What the third video switch shows of polyhedra, if the sweep meets any, and the spans that it has composed.
    pub bodies: Option<(&'a Overlay, Sweep<'a>)>,
}

impl<L: Fn(usize) -> f32> Before<'_, L> {
    /// Line position below which ground hides a point.
    fn horizon(&self, point: &Point) -> f32 {
        let ground = self.hold.at(point.near);
        let is_beyond = self.hold.near.samples().last().is_none_or(|last| point.near < *last);
        let mountains = self.mountains.filter(|_| is_beyond).unwrap_or(f32::INFINITY);
        ground.min(mountains)
    }

    /// Appends the stretches between two line positions over which `point` is in sight: disjoint, from the top.
    pub(crate) fn find(&self, point: &Point, [top, bottom]: [f32; 2], pieces: &mut Vec<[f32; 2]>) {
        let mut rest = [top, bottom.min(self.horizon(point))];
        if let Some((overlay, sweep)) = self.bodies {
            for [begin, end] in overlay.nearer_than(sweep, point.depth as f32) {
                add([rest[0], rest[1].min(begin)], pieces);
                rest[0] = rest[0].max(end);
            }
        }
        add(rest, pieces);
    }
}

fn add(piece: [f32; 2], pieces: &mut Vec<[f32; 2]>) {
    if piece[0] < piece[1] {
        pieces.push(piece);
    }
}
