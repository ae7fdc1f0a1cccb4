//! A sub-generator whose multipliers are off.

use features::{Crater, Shape};
use hardware_model::AnalogParts;
use parts::{LagStep, Spread, Tolerance, relative_sigma, time_constant};

use crate::FeatureLoad;

/// Errors are held within this: a squarer keeps its sign.
const LARGEST: f64 = 0.5;

/// An offset leaves this of the square of a circle's radius.
const SMALLEST: f64 = 1e-4;

/// What one sub-generator is.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Chain {
    /// Scale errors of the squarers of north and east (shares).
    squarers: [f64; 2],
    /// Offset of their sum (share of the square of the footprint's radius).
    offset: f64,
    /// Offset of the footprint's comparator (share of the square of the footprint's radius).
    pub threshold: f64,
    /// Scale of the parabola.
    pub gain: f64,
    /// Time constant of the chain (s).
    pub tau: f64,
    /// A whole step of it.
    pub lag: LagStep<f64>,
}

impl Chain {
    /// Number `index` of the sub-generators of type `kind` (from 0), for steps of `h` seconds.
    pub fn new(h: f64, parts: &AnalogParts, spread: &Spread, kind: usize, index: u64) -> Self {
        let name = |figure: &str| format!("fg.{}.{figure}", kind + 1);
        let error =
            |figure: &str| spread.error(&name(figure), index, parts.feature.error).clamp(-LARGEST, LARGEST);
        let sigma = if parts.spread { relative_sigma::BANDWIDTH } else { 0.0 };
        let tau = parts.feature.bandwidth.map_or(0.0, |nominal| {
            time_constant(spread.figure(&name("bandwidth"), index, &Tolerance { nominal, sigma }))
        });
        Self {
            squarers: [error("square-x"), error("square-y")],
            offset: error("sum"),
            threshold: parts.comparator_law(spread, &name("comparator"), index).offset,
            gain: 1.0 + error("parabola"),
            tau,
            lag: LagStep::new(h, tau),
        }
    }

    /// The crater that it makes of one on a sweep along `direction` (cosine, sine of azimuth): with o along the sweep from
    /// the foot and the centre q to the right, `(1 + e_x) x^2 + (1 + e_y) y^2` is `K ((o - o_0)^2 + w^2)`; with the offset e
    /// of the sum a circle r is met where this is `r^2 - e R^2`.
    pub fn distorted(&self, crater: &Crater, load: &FeatureLoad, [c, s]: [f64; 2]) -> (Crater, FeatureLoad) {
        let ([x, y], q) = (self.squarers.map(|error| 1.0 + error), load.side);
        let k = x * c * c + y * s * s;
        let middle = load.middle + q * c * s * (y - x) / k;
        let load = FeatureLoad { middle, side: q * (x * y).sqrt() / k, ..*load };
        (self.reshaped(crater, k), load)
    }

    fn reshaped(&self, crater: &Crater, k: f64) -> Crater {
        let offset = self.offset * crater.outer() * crater.outer();
        let circle = |r: f64| ((r * r - offset).max(SMALLEST * r * r) / k).sqrt();
        let bowl = |r1: f64| crater.depth() * (1.0 - offset / (r1 * r1)).max(0.0);
        let (shape, depth) = match crater.shape() {
            Shape::Bowl { r1 } => (Shape::Bowl { r1: circle(r1) }, bowl(r1)),
            Shape::RimmedBowl { r1, r2 } => (Shape::RimmedBowl { r1: circle(r1), r2: circle(r2) }, bowl(r1)),
            Shape::FlatFloor { r1, r2, r3 } => {
                (Shape::FlatFloor { r1: circle(r1), r2: circle(r2), r3: circle(r3) }, crater.depth())
            }
        };
        Crater::new(crater.centre(), shape, depth, crater.rim()).unwrap_or(*crater)
    }
}

#[cfg(test)]
impl Chain {
    /// A chain of these errors and this time constant.
    pub fn of(h: f64, squarers: [f64; 2], offset: f64, gain: f64, tau: f64) -> Self {
        Self { squarers, offset, threshold: 0.0, gain, tau, lag: LagStep::new(h, tau) }
    }
}
