//! Linear parts: time constants, chains, drift.

use std::time::Instant;

use parts::{LagStep, SecondOrder, SecondOrderState};
use signal::Real;

use super::cell::{Action, Cell, Found, Theory, plain};
use crate::ladder::Extent;
use crate::solver::{Flow, implicit, runge_kutta};

/// Time constants over a sample.
const RATIOS: [f64; 13] = [1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 0.1, 1.0, 10.0, 100.0, 1e3, 1e4, 1e5, 1e6];
/// Samples of a run, and from fold to fold of the ramp that drives it.
pub const SAMPLES: usize = 128;
pub const FOLD: usize = 16;
/// Rounding of a run, in units of the last place: some at every sample, and a lag forgets them.
pub const ROUNDINGS: f64 = 16.0;

/// A folded ramp from 0, one unit from fold to fold.
pub fn ramp(t: f64) -> f64 {
    let turns = t / FOLD as f64;
    (turns - 2.0 * (turns / 2.0).round()).abs()
}

/// Runs at samples 1, 2 ...: values of a method.
pub struct Run {
    /// Values at samples 1, 2 and so on.
    pub values: Vec<f64>,
    /// Seconds that it took.
    pub time_s: f64,
}

/// Runs `step` from the begin of each sample on.
pub fn run(samples: usize, mut step: impl FnMut(f64) -> f64) -> Run {
    let start = Instant::now();
    let values = (0..samples).map(|k| step(k as f64)).collect();
    Run { values, time_s: start.elapsed().as_secs_f64() }
}

impl Run {
    /// Against the truth, where nothing may lie farther from 0 than `bound`.
    pub fn found(&self, truth: &[f64], bound: f64, action: Action) -> Found {
        let off = self.values.iter().zip(truth).map(|(found, truth)| (found - truth).abs());
        Found {
            finite: self.values.iter().all(|value| value.is_finite()),
            bounded: self.values.iter().all(|value| value.abs() <= bound),
            error: Some(off.fold(0.0, |most: f64, off| if off > most || off.is_nan() { off } else { most })),
            action,
            time_s: self.time_s,
        }
    }
}

/// One lag of `tau` samples.
struct Lag(f64);

impl Flow<1> for Lag {
    fn rate(&self, t: f64, y: &[f64; 1]) -> [f64; 1] {
        [(ramp(t) - y[0]) / self.0]
    }

    fn jacobian(&self, _: f64, _: &[f64; 1]) -> [[f64; 1]; 1] {
        [[-1.0 / self.0]]
    }
}

/// The machine's lag behind the folded ramp.
fn own_lag<S: Real>(tau: f64) -> Run {
    let (lag, mut y) = (LagStep::<S>::new(1.0, tau), S::ZERO);
    run(SAMPLES, |t| {
        y = lag.step(y, S::from_f64(ramp(t)), S::from_f64(ramp(t + 1.0)));
        y.to_f64()
    })
}

/// The lag behind the folded ramp in closed form: `y = u - s tau + (y0 - u0 + s tau) e^(-t / tau)` from fold to fold.
fn lag_in_closed_form(tau: f64) -> Vec<f64> {
    let (mut y0, mut values) = (0.0, Vec::with_capacity(SAMPLES));
    for (leg, begin) in (0..SAMPLES).step_by(FOLD).enumerate() {
        let slope = if leg % 2 == 0 { 1.0 } else { -1.0 } / FOLD as f64;
        let at = |t: f64| {
            // expm1, so that a slow lag's small answer is not the difference of two large ones.
            let gone = -libm::expm1(-t / tau);
            y0 + (ramp(begin as f64) - y0) * gone + slope * (t - tau * gone)
        };
        let leg: Vec<f64> = (1..=FOLD).map(|t| at(t as f64)).collect();
        y0 = leg[FOLD - 1];
        values.extend(leg);
    }
    values
}

/// A lag of every time constant.
pub fn time_constants(_: Extent) -> Vec<Cell> {
    RATIOS.iter().flat_map(|&tau| lag_cells(tau)).collect()
}

fn lag_cells(tau: f64) -> Vec<Cell> {
    let (case, truth) = (format!("lag of {} samples", plain(tau)), lag_in_closed_form(tau));
    let row = "time constant";
    // The closed form of a slow lag is itself a difference of terms as large as its ramp.
    let rounding = |last_place: f64| Theory::Answers(last_place * ROUNDINGS * tau.clamp(1.0, SAMPLES as f64));
    let own = |run: Run| run.found(&truth, 1.0, Action::Exact);
    let flow = Lag(tau);
    let stepped = |step: &dyn Fn(f64, &[f64; 1]) -> [f64; 1]| {
        let mut y = [0.0];
        let run = run(SAMPLES, |t| {
            y = step(t, &y);
            y[0]
        });
        run.found(&truth, 1.0, Action::Stepped)
    };
    let theory = rounding(f64::EPSILON);
    vec![
        Cell::own(row, &case, "parts, f64", theory, own(own_lag::<f64>(tau))),
        Cell::own(row, &case, "parts, f32", rounding(f64::from(f32::EPSILON)), own(own_lag::<f32>(tau))),
        Cell::comparison(row, &case, "trapezoidal", theory, stepped(&|t, y| implicit(&flow, t, 1.0, y, 0.5))),
        Cell::comparison(
            row,
            &case,
            "backward Euler",
            theory,
            stepped(&|t, y| implicit(&flow, t, 1.0, y, 1.0)),
        ),
        Cell::comparison(row, &case, "Runge-Kutta", theory, stepped(&|t, y| runge_kutta(&flow, t, 1.0, y))),
    ]
}

/// Chains of lags: alike, nearly alike, and thirteen decades in one.
pub fn chains(_: Extent) -> Vec<Cell> {
    let alike = |tau: f64, count: usize| vec![tau; count];
    let cases = [
        ("2 lags of 1 sample", alike(1.0, 2)),
        ("8 lags of 1 sample", alike(1.0, 8)),
        ("8 lags of 1e-6 samples", alike(1e-6, 8)),
        ("8 lags of 1e6 samples", alike(1e6, 8)),
        ("lags of 3 and 3 (1 + 1e-12) samples", vec![3.0, 3.0 * (1.0 + 1e-12)]),
        ("13 decades, slow to fast", RATIOS.iter().rev().copied().collect()),
        ("13 decades, fast to slow", RATIOS.to_vec()),
    ];
    cases.iter().flat_map(|(case, taus)| chain_cells(case, taus)).collect()
}

fn own_chain<S: Real>(taus: &[f64], fine: usize) -> Run {
    let h = 1.0 / fine as f64;
    let lags: Vec<LagStep<S>> = taus.iter().map(|&tau| LagStep::new(h, tau)).collect();
    let mut states = vec![S::ZERO; taus.len()];
    let mut step = |t: f64| {
        let [mut from, mut to] = [t, t + h].map(|t| S::from_f64(ramp(t)));
        for (lag, state) in lags.iter().zip(&mut states) {
            let before = *state;
            *state = lag.step(before, from, to);
            (from, to) = (before, *state);
        }
        to.to_f64()
    };
    let start = Instant::now();
    let mut values = Vec::with_capacity(SAMPLES);
    for sample in 0..SAMPLES {
        values.push((0..fine).fold(0.0, |_, k| step(sample as f64 + k as f64 * h)));
    }
    Run { values, time_s: start.elapsed().as_secs_f64() }
}

fn chain_cells(case: &str, taus: &[f64]) -> Vec<Cell> {
    /// Steps of a sample of the reference: its error is so many times smaller, squared.
    const FINE: usize = 64;
    let truth = own_chain::<f64>(taus, FINE).values;
    // A straight line stands for the output of the lag before: off by no more than a quarter of the bend of the ramp.
    let theory = Theory::Answers(2.0 / FOLD as f64 / 4.0);
    let own = |run: Run| run.found(&truth, 1.0, Action::Exact);
    vec![
        Cell::own("chain", case, "parts, f64", theory, own(own_chain::<f64>(taus, 1))),
        Cell::own("chain", case, "parts, f32", theory, own(own_chain::<f32>(taus, 1))),
    ]
}

/// What is left after very many samples.
pub fn drift(extent: Extent) -> Vec<Cell> {
    let samples: u64 = if extent == Extent::Quick { 1_000_000 } else { 1_000_000_000 };
    vec![
        settled::<f64>(samples, "parts, f64", f64::EPSILON),
        settled::<f32>(samples, "parts, f32", f64::from(f32::EPSILON)),
        swing(samples),
    ]
}

/// A lag of a thousand samples behind a constant: nothing may creep.
fn settled<S: Real>(samples: u64, method: &'static str, last_place: f64) -> Cell {
    const TAU: f64 = 1000.0;
    let (lag, level) = (LagStep::<S>::new(1.0, TAU), S::from_f64(0.7));
    let (mut y, start) = (S::ZERO, Instant::now());
    for _ in 0..samples {
        y = lag.step(y, level, level);
    }
    let run = Run { values: vec![y.to_f64()], time_s: start.elapsed().as_secs_f64() };
    let found = run.found(&[level.to_f64()], level.to_f64() * (1.0 + TAU * last_place), Action::Exact);
    // A lag stands still where a step is less than a rounding: epsilon tau / h from its goal.
    let theory = Theory::Answers(last_place * TAU);
    Cell::own(
        "drift",
        &format!("{} samples, lag of 1000 behind a constant", plain(samples as f64)),
        method,
        theory,
        found,
    )
}

/// An undamped second order that was let go: its swing may neither grow nor die.
fn swing(samples: u64) -> Cell {
    let part = SecondOrder { natural: 0.1, damping: 0.0 }.step::<f64>(1.0);
    let (mut state, start) = (SecondOrderState { y: 1.0, rate: 0.0 }, Instant::now());
    for _ in 0..samples {
        state = part.step(state, 0.0, 0.0);
    }
    let amplitude = (state.y * state.y + 100.0 * state.rate * state.rate).sqrt();
    let run = Run { values: vec![amplitude], time_s: start.elapsed().as_secs_f64() };
    // One rounding of the matrix, raised to the number of samples.
    let theory = Theory::Answers(4.0 * f64::EPSILON * samples as f64);
    let found = run.found(&[1.0], 1.0 + 4.0 * f64::EPSILON * samples as f64, Action::Exact);
    Cell::own(
        "drift",
        &format!("{} samples, undamped swing", plain(samples as f64)),
        "parts, f64",
        theory,
        found,
    )
}
