//! An analog chain as the parts step it and as a netlist: what the tests of the parts hold against an integrator and against
//! ngspice, and what the binary `goals` of the crate `benchmarks` takes the time of.
//!
//! ```text
//! triangle u ─▶ smoother ─▶ a ─┐
//! constant b ──────────────────┴▶ multiplier ─▶ lag ─▶ m ─┬▶ sample-and-hold ─▶ held
//!                                                         └▶ comparator ──────────┘ command
//! ```
//!
//! Eight of them run side by side as sweeps do, the triangle of each a little later than that of the one before.

use std::array;

use parts::{
    Comparator, ComparatorLaw, ComparatorState, LagStep, Multiplier, MultiplierLaw, NoiseSource, SampleHold,
    SampleHoldLaw, SecondOrder, SecondOrderState, SecondOrderStep, Trip,
};
use signal::{LANES, Lanes, Real};

/// Time of a rise and of a fall of the triangle (s).
pub const RISE: f64 = 2e-6;
/// How much later than the one before each triangle begins (s).
const LATER: f64 = 0.25e-6;
/// Value of the constant input.
pub const B: f64 = 0.9;
/// Law of the smoother, a second-order lag.
pub const SMOOTHER: SecondOrder = SecondOrder { natural: 1.6 / 40e-9, damping: 0.8 };
/// Time constant behind the multiplier (s).
pub const TAU_M: f64 = 20e-9;
/// Law of the multiplier.
pub const MULTIPLIER: MultiplierLaw =
    MultiplierLaw { gain: 0.002, feed_a: 0.003, feed_b: -0.002, offset: 0.001, nonlinearity: 0.0025 };
/// Of the comparator, which has no hysteresis.
pub const THRESHOLD: f64 = 0.4;
/// Of the comparator (s).
pub const DELAY: f64 = 40e-9;
const HOLD: SampleHoldLaw =
    SampleHoldLaw { acquisition: 400e-9, aperture: 0.0, jitter: 0.0, pedestal: 0.0, droop: 0.0 };
/// Time constant of the tracking switch: 400 ns over ln 1000 (s).
pub const TAU_H: f64 = 400e-9 / 6.907_755_278_982_137;
/// Times at which outputs are told (s apart).
pub const RASTER: f64 = 50e-9;

/// The triangle of a chain at a time (s).
fn triangle(chain: usize, time: f64) -> f64 {
    let turns = (time - LATER * chain as f64).max(0.0) / RISE;
    let phase = turns - 2.0 * (0.5 * turns).floor();
    if phase <= 1.0 { phase } else { 2.0 - phase }
}

/// Eight chains that are stepped side by side.
#[derive(Debug)]
pub struct Stepped<S> {
    h: f64,
    a_raster: usize,
    smoother: SecondOrderStep<S>,
    multiplier: Multiplier<S>,
    lag: LagStep<S>,
    comparator: Comparator<S>,
    hold: SampleHold<S>,
    triangles: Vec<Lanes<S>>,
}

/// What the chains gave.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Outputs<S> {
    /// Of the lags behind the multipliers, at 0, [`RASTER`], 2 [`RASTER`] ...
    pub m: Vec<Lanes<S>>,
    /// When each comparator tripped (s), and what was held then.
    pub held: [Vec<(f64, S)>; LANES],
}

impl<S: Real> Stepped<S> {
    /// For `times` rasters, with `a_raster` steps to one.
    pub fn new(a_raster: usize, times: usize) -> Self {
        let h = RASTER / a_raster as f64;
        let law = ComparatorLaw {
            offset: THRESHOLD,
            hysteresis: 0.0,
            delay: DELAY,
            overdrive: 0.0,
            longest: 500e-9,
            noise: 0.0,
        };
        let triangles = |n: usize| Lanes::from_fn(|chain| S::from_f64(triangle(chain, n as f64 * h)));
        Self {
            h,
            a_raster,
            smoother: SMOOTHER.step(h),
            multiplier: Multiplier::new(&MULTIPLIER),
            lag: LagStep::new(h, TAU_M),
            comparator: Comparator::new(h, &law, NoiseSource::new(0, "chain", 0)),
            hold: SampleHold::new(h, &HOLD),
            triangles: (0..=(times - 1) * a_raster).map(triangles).collect(),
        }
    }

    /// All steps, from rest.
    pub fn run(&self, out: &mut Outputs<S>) {
        let b = Lanes::splat(S::from_f64(B));
        let still = Lanes::default();
        let (mut a, mut m, mut tracked) = (SecondOrderState::default(), still, still);
        let mut comparators = [ComparatorState::default(); LANES];
        let mut trips: [Vec<Trip>; LANES] = Default::default();
        let mut product = self.multiplier.product(still, b);
        out.m.clear();
        out.held.iter_mut().for_each(Vec::clear);
        out.m.push(m);
        for (n, u) in (1..).zip(self.triangles.windows(2)) {
            a = self.smoother.step(a, u[0], u[1]);
            let next = self.multiplier.product(a.y, b);
            let after = self.lag.step(m, product, next);
            let follows = self.hold.track(tracked, m, after);
            for chain in 0..LANES {
                let (from, to) = (m[chain], after[chain]);
                self.comparator.step(&mut comparators[chain], (0, n), from, to, &mut trips[chain]);
                // A trip may come several steps after its passing.
                while let Some(trip) = trips[chain].first().copied().filter(|trip| trip.at.0 < n as f64) {
                    trips[chain].remove(0);
                    let at = self.hold.taken_at(trip.at, 0.0).0;
                    let value = self.hold.tracked(tracked[chain], from, to, at.fract());
                    out.held[chain].push((at * self.h, value));
                }
            }
            (product, m, tracked) = (next, after, follows);
            if n % self.a_raster == 0 {
                out.m.push(m);
            }
        }
    }
}

/// So many of the chains as elements of a netlist, node `m0` the output of the first lag and `held0` what it holds: RLC
/// smoothers, a formula, RC lags, delay lines, switches.
pub fn netlist(chains: usize) -> String {
    let elements: [String; LANES] = array::from_fn(elements);
    format!(
        "smoother, multiplier, comparator, sample-and-hold\n{}.model track SW(vt=0.25 vh=0 ron=1000 roff=1e14)\n",
        elements[..chains].concat()
    )
}

fn elements(n: usize) -> String {
    let SecondOrder { natural, damping } = SMOOTHER;
    let MultiplierLaw { gain, feed_a, feed_b, offset, nonlinearity } = MULTIPLIER;
    // L = 1 uH: C = 1 / (w^2 L), R = 2 z w L.
    let (c, r) = (1e6 / (natural * natural), 2e-6 * damping * natural);
    format!(
        "Vu{n} u{n} 0 PULSE(0 1 {later:e} {RISE:e} {RISE:e} 1e-15 {period:e})
Rs{n} u{n} s{n} {r:e}
Ls{n} s{n} a{n} 1e-6
Cs{n} a{n} 0 {c:e}
Bp{n} p{n} 0 V = {scale:e}*V(a{n}) + {feed_a:e}*V(a{n}) + {errors:e} + {nonlinearity:e}*V(a{n})*(1 - V(a{n})*V(a{n}))
Rm{n} p{n} q{n} 1000
Cm{n} q{n} 0 {cm:e} IC=0
Em{n} m{n} 0 q{n} 0 1
Bc{n} c{n} 0 V = 0.5*(1 - tanh(2e4*(V(m{n}) - {THRESHOLD})))
Rc{n} c{n} d{n} 50
Tc{n} d{n} 0 e{n} 0 Z0=50 TD={DELAY:e}
Rt{n} e{n} 0 50
Sh{n} m{n} held{n} e{n} 0 track
Ch{n} held{n} 0 {ch:e} IC=0
",
        later = LATER * n as f64,
        period = 2.0 * RISE,
        scale = (1.0 + gain) * B,
        errors = feed_b * B + offset,
        cm = TAU_M / 1e3,
        ch = TAU_H / 1e3,
    )
}
