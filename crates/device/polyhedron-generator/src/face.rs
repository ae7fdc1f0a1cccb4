//! A face on the view-plane and what the sweeps cut out of it, where some of its body lies above or below the picture.

use std::ops::Range;

use crate::view::{Place, Sighting};

/// A corner on the picture.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Corner {
    pub place: Place,
    /// What a sweep's tangent multiplies there ([`Sighting::spread`]).
    pub spread: f64,
    /// First sweep that passes through it or to the right of it.
    pub sweep: u32,
    /// Reflectivity there, where light is smooth.
    pub light: f64,
}

/// Where a sweep crosses an edge of a face.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Crossing {
    pub place: Place,
    /// Reflectivity there, linear along the edge on the view-plane.
    pub light: f64,
}

impl Crossing {
    /// At a share of the way along an edge.
    fn on([from, to]: [&Corner; 2], share: f64) -> Self {
        let light = from.light + share * (to.light - from.light);
        Self { place: from.place.towards(&to.place, share), light }
    }
}

impl Corner {
    /// Of a place, for sweeps at ascending `tangents`.
    pub fn new(Crossing { place, light }: Crossing, sighting: &Sighting, tangents: &[f64]) -> Self {
        let spread = sighting.spread(place.y);
        let across = place.x / spread;
        Self { place, spread, sweep: tangents.partition_point(|&tangent| tangent < across) as u32, light }
    }
}

/// A projected face and its crossings; buffers are kept from face to face.
#[derive(Debug, Clone, Default)]
pub(crate) struct Outline {
    corners: Vec<Corner>,
    clipped: Vec<Corner>,
    /// Upper and lower crossing of each sweep, from the first that meets the face.
    pub crossings: Vec<[Crossing; 2]>,
}

impl Outline {
    /// Finds the crossings of a face with sweeps at ascending `tangents`; returns the first sweep that meets it. Its `corners`
    /// run counter-clockwise on the picture; what lies more than `half_height` off its middle is cut off
    /// first: within it all sweeps run the same way.
    pub fn cross(
        &mut self,
        face: impl Iterator<Item = Corner>,
        half_height: f64,
        sighting: &Sighting,
        tangents: &[f64],
    ) -> u32 {
        self.corners.clear();
        self.corners.extend(face);
        let farthest = self.corners.iter().fold(0.0f64, |off, corner| off.max(corner.place.y.abs()));
        if farthest > half_height {
            self.clip(-1.0, half_height, sighting, tangents);
            self.clip(1.0, half_height, sighting, tangents);
        }
        self.meet(tangents)
    }

    fn clip(&mut self, side: f64, half_height: f64, sighting: &Sighting, tangents: &[f64]) {
        self.clipped.clear();
        let inside = |place: &Place| side * place.y <= half_height;
        for (index, to) in self.corners.iter().enumerate() {
            let from = &self.corners[(index + self.corners.len() - 1) % self.corners.len()];
            if inside(&from.place) != inside(&to.place) {
                let share = (side * half_height - from.place.y) / (to.place.y - from.place.y);
                let mut cut = Crossing::on([from, to], share);
                cut.place.y = side * half_height;
                self.clipped.push(Corner::new(cut, sighting, tangents));
            }
            if inside(&to.place) {
                self.clipped.push(*to);
            }
        }
        std::mem::swap(&mut self.corners, &mut self.clipped);
    }

    /// Finds the crossings of what is left; returns the first sweep that meets it.
    fn meet(&mut self, tangents: &[f64]) -> u32 {
        let Self { corners, crossings, .. } = self;
        let reach = sweeps_of(corners.iter().map(|corner| corner.sweep));
        crossings.clear();
        crossings.resize(reach.len(), Default::default());
        let next = corners.iter().cycle().skip(1);
        for (from, to) in corners.iter().zip(next) {
            // Counter-clockwise: an edge to the right is a lower one. Either way it is met from its left corner on, so that two
            // faces that share it part at one place, to the bit.
            let (end, [left, right]) = if from.sweep <= to.sweep { (1, [from, to]) } else { (0, [to, from]) };
            for sweep in left.sweep..right.sweep {
                let tangent = tangents[sweep as usize];
                let [off, beyond] = [left, right].map(|end| end.place.x - tangent * end.spread);
                let share = off / (off - beyond);
                crossings[(sweep - reach.start) as usize][end] = Crossing::on([left, right], share);
            }
        }
        reach.start
    }
}

/// The sweeps that pass between the leftmost and the rightmost of some corners, by the sweeps of these.
pub(crate) fn sweeps_of(corners: impl Iterator<Item = u32>) -> Range<u32> {
    let [first, end] = corners.fold([u32::MAX, 0], |[low, high], sweep| [low.min(sweep), high.max(sweep)]);
    first.min(end)..end
}
