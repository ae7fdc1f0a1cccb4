//! The chain by exact steps of its parts.

use parts::{
    Comparator, ComparatorLaw, ComparatorState, LagStep, Multiplier, NoiseSource, SampleHold,
    SecondOrderState, SecondOrderStep, Trip,
};

use super::{B, DELAY, HOLD, MULTIPLIER, RASTER, SMOOTHER, TAU_M, THRESHOLD, triangle};

/// The chain, stepped.
#[derive(Debug)]
pub struct Stepped {
    h: f64,
    smoother: SecondOrderStep<f64>,
    multiplier: Multiplier<f64>,
    lag: LagStep<f64>,
    comparator: Comparator<f64>,
    hold: SampleHold<f64>,
}

impl Stepped {
    /// With `a_raster` steps to a time at which outputs are compared, at least 1.
    pub fn new(a_raster: usize) -> Self {
        let h = RASTER / a_raster.max(1) as f64;
        let law = ComparatorLaw {
            offset: THRESHOLD,
            hysteresis: 0.0,
            delay: DELAY,
            overdrive: 0.0,
            longest: 500e-9,
            noise: 0.0,
        };
        Self {
            h,
            smoother: SMOOTHER.step(h),
            multiplier: Multiplier::new(&MULTIPLIER),
            lag: LagStep::new(h, TAU_M),
            comparator: Comparator::new(h, &law, NoiseSource::new(0, "chain", 0)),
            hold: SampleHold::new(h, &HOLD),
        }
    }

    /// Output of the lag behind the multiplier at 0, [`RASTER`], 2 [`RASTER`] ... up to `times` of them; what was held
    /// at each trip of the comparator comes back with it.
    pub fn run(&self, times: usize, out: &mut Vec<f64>, held: &mut Vec<f64>) {
        let a_raster = (RASTER / self.h).round() as usize;
        let (mut a, mut m, mut tracked) = (SecondOrderState::default(), 0.0, 0.0);
        let (mut state, mut trips): (ComparatorState, Vec<Trip>) = Default::default();
        let mut product = self.multiplier.product(0.0, B);
        out.clear();
        held.clear();
        out.push(m);
        let mut u = triangle(0.0);
        for n in 1..times * a_raster {
            let next_u = triangle(n as f64 * self.h);
            a = self.smoother.step(a, u, next_u);
            let next = self.multiplier.product(a.y, B);
            let after = self.lag.step(m, product, next);
            self.comparator.step(&mut state, (0, n), m, after, &mut trips);
            let follows = self.hold.track(tracked, m, after);
            trips.retain(|trip| {
                let is_due = trip.at.0 < n as f64;
                if is_due {
                    held.push(self.hold.tracked(tracked, m, after, trip.at.0.fract()));
                }
                !is_due
            });
            (u, product, m, tracked) = (next_u, next, after, follows);
            if n % a_raster == 0 {
                out.push(m);
            }
        }
    }
}
