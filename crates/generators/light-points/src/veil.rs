//! What nearer calligraphic points let through, sampling point by sampling point.

use crate::share::Share;

/// Whether calligraphic points dim those behind them.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Accumulation {
    /// The veil takes in each point that is read out. Inferred: claims 7, 12 and 13 give each point a translucency and an order.
    Points,
    /// Only the stack dims a point: the narrow reading of claim 15.
    StackOnly,
}

/// The veil store of the sampling points of one sub-area (claim 15).
#[derive(Debug, Clone, PartialEq)]
pub struct Veil {
    accumulation: Accumulation,
    left: Vec<f64>,
}

impl Veil {
    /// A store of `samples` sampling points that hides nothing.
    pub fn new(samples: usize, accumulation: Accumulation) -> Self {
        Self { accumulation, left: vec![1.0; samples] }
    }

    /// Lifts the veil from all sampling points, for the next sub-area or frame.
    pub fn lift(&mut self) {
        self.left.fill(1.0);
    }

    /// Reads out one point; points come near to far. `covered` has the numbers of the sampling points under its disc, and `stack` gives
    /// the share of light (0 to 1) that nearer features of the stack let through at one of them, 0 where an opaque one is nearer.
    /// `translucency` is the share of light (0 to 1) that the point itself lets through.
    ///
    /// # Panics If the number of a sampling point is not in the store.
    pub fn read_out(
        &mut self,
        covered: impl IntoIterator<Item = usize>,
        stack: impl Fn(usize) -> f64,
        translucency: f64,
    ) -> Share {
        let mut share = Share::default();
        for sample in covered {
            let left = &mut self.left[sample];
            share.aperture += 1;
            share.attenuation += *left * stack(sample);
            if self.accumulation == Accumulation::Points {
                *left *= translucency;
            }
        }
        share
    }
}
