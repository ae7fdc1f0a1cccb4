//! A face on the view-plane and what the sweeps cut out of it.

use std::ops::Range;

use crate::view::{Place, Sighting};

/// A corner on the picture.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Corner {
    pub place: Place,
    /// First sweep that passes through it or to the right of it.
    pub sweep: usize,
}

impl Corner {
    /// Of a place (x, y, depth) with the tangent `across` of a sweep through it.
    pub fn new([x, y, depth]: [f64; 3], across: f64, tangents: &[f64]) -> Self {
        let sweep = tangents.partition_point(|&tangent| tangent < across);
        Self { place: Place { x, y, depth }, sweep }
    }
}

/// A projected face and its crossings; buffers are kept from face to face.
#[derive(Debug, Clone, Default)]
pub(crate) struct Outline {
    corners: Vec<Corner>,
    clipped: Vec<Corner>,
    /// Upper and lower crossing of each sweep, from the first that meets the face.
    pub crossings: Vec<[Place; 2]>,
}

impl Outline {
    /// Finds the crossings of a face with sweeps at ascending `tangents`; returns the first sweep that meets it. Its corners
    /// are some of `all` and run counter-clockwise on the picture; what lies more than `half_height` off its middle is cut off
    /// first, unless all is `inside`: within it all sweeps run the same way.
    #[inline(always)]
    pub fn cross(
        &mut self,
        face: &[u32],
        all: &[Corner],
        (half_height, inside): (f64, bool),
        sighting: &Sighting,
        tangents: &[f64],
    ) -> usize {
        let corners = face.iter().map(|&corner| &all[corner as usize]);
        self.crossings.clear();
        if inside {
            return meet(corners, sighting, tangents, &mut self.crossings);
        }
        self.corners.clear();
        self.corners.extend(corners);
        let farthest = self.corners.iter().fold(0.0f64, |off, corner| off.max(corner.place.y.abs()));
        if farthest > half_height {
            self.clip(-1.0, half_height, sighting, tangents);
            self.clip(1.0, half_height, sighting, tangents);
        }
        meet(self.corners.iter(), sighting, tangents, &mut self.crossings)
    }

    fn clip(&mut self, side: f64, half_height: f64, sighting: &Sighting, tangents: &[f64]) {
        self.clipped.clear();
        let inside = |place: &Place| side * place.y <= half_height;
        for (index, to) in self.corners.iter().enumerate() {
            let from = &self.corners[(index + self.corners.len() - 1) % self.corners.len()].place;
            if inside(from) != inside(&to.place) {
                let share = (side * half_height - from.y) / (to.place.y - from.y);
                let Place { x, depth, .. } = from.towards(&to.place, share);
                let y = side * half_height;
                self.clipped.push(Corner::new([x, y, depth], x / sighting.spread(y), tangents));
            }
            if inside(&to.place) {
                self.clipped.push(*to);
            }
        }
        std::mem::swap(&mut self.corners, &mut self.clipped);
    }
}

/// Adds the crossings of a face with sweeps at ascending `tangents`; returns the first sweep that meets it.
#[inline(always)]
fn meet<'c>(
    corners: impl Iterator<Item = &'c Corner> + Clone,
    sighting: &Sighting,
    tangents: &[f64],
    crossings: &mut Vec<[Place; 2]>,
) -> usize {
    let reach = sweeps_of(corners.clone());
    // Most faces of small bodies lie between two sweeps.
    if reach.is_empty() {
        return reach.start;
    }
    crossings.resize(reach.len(), Default::default());
    let next = corners.clone().skip(1).chain(corners.clone().take(1));
    for (from, to) in corners.zip(next) {
        // Counter-clockwise: an edge to the right is a lower one. Either way it is met from its left corner on, so that two faces
        // that share it part at one place, to the bit.
        let (end, [left, right]) = if from.sweep <= to.sweep { (1, [from, to]) } else { (0, [to, from]) };
        let sweeps = left.sweep..right.sweep;
        if sweeps.is_empty() {
            continue;
        }
        let [left, right] = [&left.place, &right.place];
        let spread = [left, right].map(|place| sighting.spread(place.y));
        for sweep in sweeps {
            let [off, beyond] = [left.x - tangents[sweep] * spread[0], right.x - tangents[sweep] * spread[1]];
            crossings[sweep - reach.start][end] = left.towards(right, off / (off - beyond));
        }
    }
    reach.start
}

/// The sweeps that pass between the leftmost and the rightmost of some corners.
#[inline(always)]
fn sweeps_of<'c>(corners: impl Iterator<Item = &'c Corner>) -> Range<usize> {
    let widen = |[low, high]: [usize; 2], corner: &Corner| [low.min(corner.sweep), high.max(corner.sweep)];
    let [first, end] = corners.fold([usize::MAX, 0], widen);
    first..end
}

impl Place {
    #[inline(always)]
    fn towards(&self, to: &Place, share: f64) -> Place {
        let mix = |a: f64, b: f64| a + share * (b - a);
        Place { x: mix(self.x, to.x), y: mix(self.y, to.y), depth: mix(self.depth, to.depth) }
    }
}
