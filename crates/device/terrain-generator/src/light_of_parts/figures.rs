//! What the seed makes of the figures of the stage.

use std::f64::consts::PI;

use hardware_model::{AnalogParts, FEEDTHROUGH_FREQUENCY, LoopParts};
use parts::{
    Feedthrough, LagStep, LoopLag, Multiplier, MultiplierLaw, Spread, Tolerance, relative_sigma,
    time_constant,
};

use super::stage::{Cell, Divider, Root};

/// What of the static error of a multiplier its offset, its bend and the feedthrough of either input have, as in the array.
const EACH: f64 = 0.5;

/// Draws parts for steps of `h` seconds.
pub(super) struct Draw<'a> {
    h: f64,
    parts: &'a AnalogParts,
    spread: Spread,
}

impl<'a> Draw<'a> {
    pub fn new(h: f64, parts: &'a AnalogParts, seed: u64) -> Self {
        Self { h, parts, spread: Spread::new(seed) }
    }

    fn error(&self, part: &str, number: u64, sigma: f64) -> f64 {
        self.spread.error(&format!("tg.light.{part}"), number, sigma)
    }

    /// Time constant of a part (s); 0 where it follows at once.
    fn tau(&self, part: &str, number: u64, bandwidth: Option<f64>) -> f64 {
        let sigma = if self.parts.spread { relative_sigma::BANDWIDTH } else { 0.0 };
        let part = format!("tg.light.{part}.bandwidth");
        let drawn = |nominal| self.spread.figure(&part, number, &Tolerance { nominal, sigma });
        bandwidth.map_or(0.0, |nominal| time_constant(drawn(nominal)))
    }

    /// A product or a squarer.
    pub fn cell(&self, part: &str, number: u64) -> Cell {
        let figures = &self.parts.reflectivity.multiplier;
        let error = |figure: &str, sigma: f64| self.error(&format!("{part}.{figure}"), number, sigma);
        let each = EACH * figures.error;
        let leak = error("feedthrough", figures.feedthrough);
        Cell {
            multiplier: Multiplier::new(&MultiplierLaw {
                gain: error("eg", figures.scale_error),
                feed_a: error("ex", each),
                feed_b: error("ey", each),
                offset: error("eo", each),
                nonlinearity: error("en", each),
            }),
            leak: Feedthrough::new(self.h, leak, FEEDTHROUGH_FREQUENCY),
            lag: LagStep::new(self.h, self.tau(part, number, figures.bandwidth)),
        }
    }

    pub fn summer(&self, number: u64) -> LagStep<f64> {
        LagStep::new(self.h, self.tau("sum", number, self.parts.reflectivity.summer_bandwidth))
    }

    /// Scale of the multiplier in the feedback of a part; one that is far off has a hundredth.
    fn scale(&self, part: &str) -> f64 {
        let error = self.error(&format!("{part}.eg"), 0, self.parts.reflectivity.multiplier.scale_error);
        (1.0 + error).max(0.01)
    }

    fn lag(&self, part: &str, parts: LoopParts) -> LoopLag {
        LoopLag::new(self.h, self.tau(part, 0, parts.bandwidth))
    }

    pub fn root(&self) -> Root {
        let parts = self.parts.reflectivity.root;
        Root {
            scale: self.scale("root"),
            offset: self.error("root.eo", 0, parts.error),
            lag: self.lag("root", parts),
        }
    }

    pub fn divider(&self) -> Divider {
        let parts = self.parts.reflectivity.divider;
        let error = |figure: &str| self.error(&format!("divider.{figure}"), 0, EACH * parts.error);
        Divider {
            scale: self.scale("divider"),
            feed_output: error("ex"),
            feed_divisor: error("ey"),
            offset: error("eo"),
            lag: self.lag("divider", parts),
        }
    }
}

/// Delay of the way to the divider's output (s), nominal, over ground whose normal has this share of full scale.
pub(super) fn delay(parts: &AnalogParts, normal: f64) -> f64 {
    let figures = &parts.reflectivity;
    let tau = |bandwidth: Option<f64>| bandwidth.map_or(0.0, |bandwidth| 1.0 / (2.0 * PI * bandwidth));
    tau(figures.multiplier.bandwidth)
        + tau(figures.summer_bandwidth)
        + tau(figures.divider.bandwidth) / normal
}
