//! One sub-generator with a crater in its registers: the laws of section 9 along a straight line.

use std::ops::Range;

use features::Crater;
use signal::{Number, Real};

use crate::{FeatureLoad, Surface};

/// Part of a crater's law, from the outside inwards.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Zone {
    /// Outside the footprint of the crater.
    Outside,
    /// Rim between the outer foot and the hollow.
    Ring,
    /// Bowl, or floor and wall.
    Hollow,
}

/// Parameters of a crater on a sweep. Bowls are hollows with a floor of radius 0.
#[derive(Debug, Clone, Copy)]
pub(crate) struct SubGenerator {
    middle: f64,
    side: f64,
    ring: Parabola<f64>,
    hollow: Parabola<f64>,
}

/// Height against distance from the centre: `vertex + rise ((rho - at) scale)^2`.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Parabola<T> {
    pub vertex: T,
    pub rise: T,
    pub at: T,
    pub scale: T,
}

impl SubGenerator {
    pub fn new(crater: &Crater, load: &FeatureLoad) -> Self {
        Self { middle: load.middle, side: load.side, ring: ring(crater), hollow: hollow(crater) }
    }

    /// Adds the crater to the samples of a lane, all of which are in `zone`.
    pub fn add<S: Real>(
        &self,
        zone: Zone,
        ranges: &[f64],
        samples: Range<usize>,
        lane: usize,
        surface: &mut Surface<'_, S>,
    ) {
        match zone {
            Zone::Outside => {}
            Zone::Ring => self.add_by(&self.ring, Parabola::ring, ranges, samples, lane, surface),
            Zone::Hollow if self.hollow.at > 0.0 => {
                self.add_by(&self.hollow, Parabola::floor_and_wall, ranges, samples, lane, surface);
            }
            Zone::Hollow => self.add_by(&self.hollow, Parabola::bowl, ranges, samples, lane, surface),
        }
    }

    #[inline(always)]
    fn add_by<S: Real>(
        &self,
        parabola: &Parabola<f64>,
        law: impl Fn(&Parabola<S>, S) -> [S; 2],
        ranges: &[f64],
        samples: Range<usize>,
        lane: usize,
        surface: &mut Surface<'_, S>,
    ) {
        let (parabola, left) = (parabola.cast(), S::from_f64(-self.side));
        // A piece has a few samples: four iterators for it would cost as much as two of them.
        let height = &mut surface.height[samples.clone()];
        let along = &mut surface.along[samples.clone()][..height.len()];
        let across = &mut surface.across[samples.clone()][..height.len()];
        for (at, range) in ranges[samples].iter().enumerate() {
            // The difference is taken in f64: far away a range has no millimetres left in f32.
            let offset = S::from_f64(range - self.middle);
            let [rise, rise_along, rise_across] = around(offset, left, |square| law(&parabola, square));
            height[at][lane] += rise;
            along[at][lane] += rise_along;
            across[at][lane] += rise_across;
        }
    }

    /// Height, slope along and slope across at one range, by the law of `zone`.
    pub fn at(&self, zone: Zone, range: f64) -> [f64; 3] {
        around(range - self.middle, -self.side, |square| match zone {
            Zone::Outside => [0.0; 2],
            Zone::Ring => self.ring.ring(square),
            Zone::Hollow if self.hollow.at > 0.0 => self.hollow.floor_and_wall(square),
            Zone::Hollow => self.hollow.bowl(square),
        })
    }
}

/// Height, slope along and slope across by a `law` of the square of the distance from the centre. The place lies `offset` beyond
/// the centre, and the centre lies to the `left` of the sweep (m).
#[inline(always)]
pub(crate) fn around<T: Number>(offset: T, left: T, law: impl FnOnce(T) -> [T; 2]) -> [T; 3] {
    let [rise, bend] = law(offset * offset + left * left);
    [rise, bend * offset, bend * left]
}

/// The rim. Without one nobody asks for it, and its scale is infinite.
pub(crate) fn ring(crater: &Crater) -> Parabola<f64> {
    let (foot, outer, rim) = (crater.foot(), crater.outer(), crater.rim());
    Parabola { vertex: rim, rise: -rim, at: 0.5 * (foot + outer), scale: 2.0 / (outer - foot) }
}

/// Bowl, or floor and wall.
pub(crate) fn hollow(crater: &Crater) -> Parabola<f64> {
    let (floor, foot, depth) = (crater.floor(), crater.foot(), crater.depth());
    Parabola { vertex: -depth, rise: depth, at: floor, scale: 1.0 / (foot - floor) }
}

/// The laws take `rho^2` and give height and `h' / rho`, so that slopes are products with the offsets from the centre.
impl<T: Number> Parabola<T> {
    /// Types 1 and 2: a parabola about the centre needs no root.
    #[inline(always)]
    pub fn bowl(&self, square: T) -> [T; 2] {
        let bend = self.rise * self.scale * self.scale;
        [self.vertex + bend * square, bend + bend]
    }

    /// Type 3: on the floor its edge is as far away as it can be.
    #[inline(always)]
    pub fn floor_and_wall(&self, square: T) -> [T; 2] {
        self.about(square.root().at_least(self.at))
    }

    /// A parabola about a circle.
    #[inline(always)]
    pub fn ring(&self, square: T) -> [T; 2] {
        self.about(square.root())
    }

    #[inline(always)]
    fn about(&self, rho: T) -> [T; 2] {
        let place = (rho - self.at) * self.scale;
        let rise = self.rise * place;
        [self.vertex + rise * place, (rise + rise) * self.scale / rho]
    }
}

impl Parabola<f64> {
    pub fn cast<S: Real>(&self) -> Parabola<S> {
        let [vertex, rise, at, scale] = [self.vertex, self.rise, self.at, self.scale].map(S::from_f64);
        Parabola { vertex, rise, at, scale }
    }
}
