//! An amplifier of either engine under the same input: jumps, ramps and rest, with every bound there or not.

use interpreter::parts::amplifier::AmplifierCircuit;
use interpreter::parts::figures::AmplifierFigures;
use lockstep::Dice;
use parts::{Amplifier, AmplifierLaw, AmplifierState};

const STEP: f64 = 50e-9;

fn check(seed: u64) {
    let mut dice = Dice::new(seed);
    let tau = STEP * libm::exp2(dice.between(-5.0, 2.0));
    let slew = dice.choose(&[f64::INFINITY, 0.05 / STEP, 0.4 / STEP]);
    let saturation = dice.choose(&[f64::INFINITY, 0.5, 1.1]);
    let recovery = dice.choose(&[0.0, 0.3 * STEP, 5.0 * STEP]);
    let part = Amplifier::<f64>::new(STEP, &AmplifierLaw { tau, slew, saturation, recovery });
    let figures = AmplifierFigures { tau, slew, saturation, recovery };
    let mut input = dice.between(-0.4, 0.4);
    let mut state = AmplifierState { y: input, excess: 0.0 };
    let mut circuit = AmplifierCircuit::at_rest(figures, STEP, input);
    for step in 0..400 {
        let before = input;
        input = match dice.count(0, 5) {
            0 => dice.between(-1.3, 1.3),
            1 | 2 => input,
            _ => (input + dice.between(-0.1, 0.1)).clamp(-1.3, 1.3),
        };
        let [machine, interpreter] = [part.step(&mut state, before, input), circuit.step(input)];
        assert!(
            (machine - interpreter).abs() < 1e-10,
            "seed {seed}, step {step}: {machine} against {interpreter} under {before}..{input}; {figures:?}"
        );
    }
}

#[test]
fn both_engines_have_the_same_amplifier() {
    (0..300).for_each(check);
}
