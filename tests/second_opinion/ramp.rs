//! The second engine's own ramp against its equations.

use interpreter::parts::figures::RampFigures;
use interpreter::parts::ramp::{RampCircuit, level_of, word_for};

/// Whole steps against two thousand short ones, Euler's: stairs, their settling, pulses, and two poles behind them or none.
#[test]
fn a_step_is_what_its_equations_make_of_it() {
    for (settle, smoother) in [(0.4, 0.8), (0.0, 0.8), (0.3, 0.1), (0.3, 1.5), (0.4, 0.0)] {
        let figures = RampFigures { bits: Some(6), settle, smoother, glitch: 0.04, nonlinearity: 0.0 };
        let place = |k: i32| 0.2 + 0.007 * f64::from(k);
        let mut ramp = RampCircuit::at_rest(figures, 1.0, place(0));
        let (mut converted, mut y, mut rate) = (ramp.output(), ramp.output(), 0.0);
        let (w, dt) = (1.0 / smoother, 1.0 / 2000.0);
        for k in 0..80 {
            let [before, word] = [k.max(1) - 1, k].map(|k| word_for(place(k), 6));
            let weight = (before ^ word).checked_ilog2().map_or(0.0, |bit| libm::exp2(f64::from(bit) - 5.0));
            converted += if settle > 0.0 { weight * 0.04 / settle } else { 0.0 };
            let level = level_of(word, 6, 0.0);
            for _ in 0..2000 {
                converted = if settle > 0.0 { converted + (level - converted) * dt / settle } else { level };
                let pull = w * w * (converted - y) - 2.0 * 0.8 * w * rate;
                (y, rate) = if smoother > 0.0 { (y + rate * dt, rate + pull * dt) } else { (converted, 0.0) };
            }
            let found = ramp.step(place(k), place(k + 1));
            assert!((found - y).abs() < 3e-4, "{settle} {smoother}, step {k}: {found} {y}");
        }
    }
}
