//! One sub-generator with a crater in its registers: the laws of section 9 along a straight line.

use std::ops::Range;

use features::Crater;
use signal::Real;

use crate::{FeatureLoad, Surface};

/// Part of a crater's law, from the outside inwards.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Zone {
    /// Outside the footprint.
    Outside,
    /// Rim.
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
struct Parabola<S> {
    vertex: S,
    rise: S,
    at: S,
    scale: S,
}

impl SubGenerator {
    pub fn new(crater: &Crater, load: &FeatureLoad) -> Self {
        let (floor, foot, outer) = (crater.floor(), crater.foot(), crater.outer());
        let (depth, rim) = (crater.depth(), crater.rim());
        // Without a rim nobody asks for the ring, and its scale is infinite.
        let ring =
            Parabola { vertex: rim, rise: -rim, at: 0.5 * (foot + outer), scale: 2.0 / (outer - foot) };
        let hollow = Parabola { vertex: -depth, rise: depth, at: floor, scale: 1.0 / (foot - floor) };
        Self { middle: load.middle, side: load.side, ring, hollow }
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
        let outputs = surface.height[samples.clone()]
            .iter_mut()
            .zip(&mut surface.along[samples.clone()])
            .zip(&mut surface.across[samples.clone()]);
        for (range, ((height, along), across)) in ranges[samples].iter().zip(outputs) {
            // The difference is taken in f64: far away a range has no millimetres left in f32.
            let offset = S::from_f64(range - self.middle);
            let [rise, bend] = law(&parabola, offset * offset + left * left);
            height[lane] += rise;
            along[lane] += bend * offset;
            across[lane] += bend * left;
        }
    }

    /// Adds a share of the crater's slopes, by the law of `zone`, to one sample of a lane, and its height if the sample is in
    /// the zone.
    pub fn add_share<S: Real>(
        &self,
        zone: Zone,
        (range, sample): (f64, usize),
        (share, is_inside): (f64, bool),
        lane: usize,
        surface: &mut Surface<'_, S>,
    ) {
        let [height, along, across] = self.at(zone, range);
        if is_inside {
            surface.height[sample][lane] += S::from_f64(height);
        }
        surface.along[sample][lane] += S::from_f64(share * along);
        surface.across[sample][lane] += S::from_f64(share * across);
    }

    /// Height, slope along and slope across at one range, by the law of `zone`.
    pub fn at(&self, zone: Zone, range: f64) -> [f64; 3] {
        let offset = range - self.middle;
        let square = offset * offset + self.side * self.side;
        let [rise, bend] = match zone {
            Zone::Outside => [0.0; 2],
            Zone::Ring => self.ring.ring(square),
            Zone::Hollow if self.hollow.at > 0.0 => self.hollow.floor_and_wall(square),
            Zone::Hollow => self.hollow.bowl(square),
        };
        [rise, bend * offset, -bend * self.side]
    }
}

/// The laws take `rho^2` and give height and `h' / rho`, so that slopes are products with the offsets from the centre.
impl<S: Real> Parabola<S> {
    /// Types 1 and 2: a parabola about the centre needs no root.
    #[inline(always)]
    fn bowl(&self, square: S) -> [S; 2] {
        let bend = self.rise * self.scale * self.scale;
        [self.vertex + bend * square, bend + bend]
    }

    #[inline(always)]
    fn floor_and_wall(&self, square: S) -> [S; 2] {
        if square <= self.at * self.at { [self.vertex, S::ZERO] } else { self.ring(square) }
    }

    /// A parabola about a circle.
    #[inline(always)]
    fn ring(&self, square: S) -> [S; 2] {
        let rho = square.sqrt();
        let place = (rho - self.at) * self.scale;
        let rise = self.rise * place;
        [self.vertex + rise * place, (rise + rise) * self.scale / rho]
    }
}

impl Parabola<f64> {
    fn cast<S: Real>(&self) -> Parabola<S> {
        let [vertex, rise, at, scale] = [self.vertex, self.rise, self.at, self.scale].map(S::from_f64);
        Parabola { vertex, rise, at, scale }
    }
}
