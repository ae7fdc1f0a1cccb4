//! Two poles of any damping and any speed, against the exponential of their matrix.

use parts::{SecondOrder, SecondOrderState};
use signal::Real;

use super::cell::{Action, Cell, Theory, plain};
use super::exponential::exponential_less_one;
use super::linear::{FOLD, ROUNDINGS, Run, SAMPLES, ramp, run};
use crate::ladder::Extent;
use crate::solver::{Flow, implicit, runge_kutta};

/// Damping: none, little, critical, nearly critical from both sides, far above.
const DAMPING: [f64; 9] = [0.0, 1e-6, 0.1, 1.0 - 1e-12, 1.0, 1.0 + 1e-12, 2.0, 10.0, 1e6];
/// Natural frequency (rad a sample): slow, and stiff.
const NATURAL: [f64; 7] = [1e-3, 0.1, 1.0, 3.0, 30.0, 1e3, 1e6];

/// A second order of natural frequency `w` (rad a sample) and damping `z`.
struct Poles {
    w: f64,
    z: f64,
}

impl Flow<2> for Poles {
    fn rate(&self, t: f64, y: &[f64; 2]) -> [f64; 2] {
        [y[1], self.w * (self.w * (ramp(t) - y[0]) - 2.0 * self.z * y[1])]
    }

    fn jacobian(&self, _: f64, _: &[f64; 2]) -> [[f64; 2]; 2] {
        [[0.0, 1.0], [-self.w * self.w, -2.0 * self.z * self.w]]
    }
}

/// Second order of every damping and every speed.
pub fn second_orders(_: Extent) -> Vec<Cell> {
    let cases = NATURAL.into_iter().flat_map(|w| DAMPING.map(|z| Poles { w, z }));
    cases.flat_map(|poles| second_order_cells(&poles)).collect()
}

fn own_poles<S: Real>(poles: &Poles) -> Run {
    let part = SecondOrder { natural: poles.w, damping: poles.z }.step::<S>(1.0);
    let mut state = SecondOrderState { y: S::ZERO, rate: S::ZERO };
    run(SAMPLES, |t| {
        state = part.step(state, S::from_f64(ramp(t)), S::from_f64(ramp(t + 1.0)));
        state.y.to_f64()
    })
}

/// The poles and the ramp that drives them as one linear system: output, its rate over w, input, slope of the input. Folds
/// are at samples, so its exponential over a sample is the answer to rounding, and it knows no case of damping.
fn by_exponential(&Poles { w, z }: &Poles) -> Run {
    let step = exponential_less_one(&[
        [0.0, w, 0.0, 0.0],
        [-w, -2.0 * z * w, w, 0.0],
        [0.0, 0.0, 0.0, 1.0],
        [0.0; 4],
    ]);
    let mut y = [0.0; 2];
    run(SAMPLES, |t| {
        let state = [y[0], y[1], ramp(t), ramp(t + 1.0) - ramp(t)];
        let change = |row: usize| (0..4).map(|k| step[row][k] * state[k]).sum::<f64>();
        y = [0, 1].map(|row| y[row] + change(row));
        y[0]
    })
}

fn second_order_cells(poles: &Poles) -> Vec<Cell> {
    let Poles { w, z } = *poles;
    let (row, case) = ("second order", format!("w h = {}, damping {z}", plain(w)));
    let truth = by_exponential(poles);
    // A ramp's slope jumps by 2 / FOLD at each fold and the beat adds up without damping: a swing of slope over w each.
    let folds = (SAMPLES / FOLD) as f64;
    let swing = 2.0 * folds / (FOLD as f64 * w);
    let found = |run: Run, action: Action| run.found(&truth.values, 1.0 + swing, action);
    let stepped = |step: &dyn Fn(f64, &[f64; 2]) -> [f64; 2]| {
        let mut y = [0.0; 2];
        let values = run(SAMPLES, |t| {
            y = step(t, &y);
            y[0]
        });
        found(values, Action::Stepped)
    };
    // A rounding of every step, which the poles may keep, and which turns the phase of the swing.
    let rounding = |last_place: f64| Theory::Answers(ROUNDINGS * SAMPLES as f64 * last_place);
    let theory = rounding(f64::EPSILON);
    let single = rounding(f64::from(f32::EPSILON));
    vec![
        Cell::own(row, &case, "parts, f64", theory, found(own_poles::<f64>(poles), Action::Exact)),
        Cell::own(row, &case, "parts, f32", single, found(own_poles::<f32>(poles), Action::Exact)),
        Cell::comparison(row, &case, "trapezoidal", theory, stepped(&|t, y| implicit(poles, t, 1.0, y, 0.5))),
        Cell::comparison(
            row,
            &case,
            "backward Euler",
            theory,
            stepped(&|t, y| implicit(poles, t, 1.0, y, 1.0)),
        ),
        Cell::comparison(row, &case, "Runge-Kutta", theory, stepped(&|t, y| runge_kutta(poles, t, 1.0, y))),
    ]
}

#[cfg(test)]
mod tests {
    use super::{NATURAL, Poles, by_exponential, plain, ramp, run, second_orders};
    use crate::ladder::Extent;
    use crate::solver::runge_kutta;
    use crate::stability::linear::SAMPLES;

    /// The judge is judged: small explicit steps, where they are not too many.
    #[test]
    fn the_exponential_agrees_with_small_steps() {
        for (w, z) in [(0.1, 0.0), (1.0, 0.1), (1.0, 1.0), (3.0, 0.0), (3.0, 2.0), (0.1, 10.0)] {
            let poles = Poles { w, z };
            let (mut y, fine) = ([0.0; 2], 400);
            let h = 1.0 / f64::from(fine);
            let steps = run(SAMPLES, |t| {
                (0..fine).for_each(|k| y = runge_kutta(&poles, t + f64::from(k) * h, h, &y));
                y[0]
            });
            let found = by_exponential(&poles).values;
            let off = found.iter().zip(&steps.values).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            assert!(off < 1e-8, "w = {w}, z = {z}: {off}");
            assert!(found.iter().fold(0.0, |most: f64, y| most.max(y.abs())) > 0.1 * ramp(8.0).min(w));
        }
    }

    #[test]
    fn stiff_poles_hold_where_explicit_steps_run_away() {
        let cells = second_orders(Extent::Quick);
        for w in NATURAL.into_iter().filter(|w| *w >= 3.0) {
            for z in [0.0, 0.1, 1.0, 10.0] {
                let case = format!("w h = {}, damping {z}", plain(w));
                let of = |method: &str| {
                    cells.iter().find(|cell| cell.case == case && cell.method == method).unwrap()
                };
                assert!(of("parts, f64").is_sound() && of("parts, f32").is_sound(), "{case}");
                assert!(!of("Runge-Kutta").is_sound(), "{case}");
            }
        }
    }
}
