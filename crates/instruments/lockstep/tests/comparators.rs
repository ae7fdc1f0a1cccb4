//! A comparator of either engine under the same input: ramps, rests and turns about its thresholds, with every figure there or not.

use interpreter::parts::comparator::{Comparator, ComparatorFigures};
use lockstep::Dice;
use parts::{Comparator as Part, ComparatorLaw, ComparatorState, NoiseSource};

const STEP: f64 = 50e-9;

fn check(seed: u64) -> usize {
    let mut dice = Dice::new(seed);
    let law = ComparatorLaw {
        offset: dice.choose(&[0.0, 0.003]),
        hysteresis: dice.choose(&[0.001, 0.02]),
        delay: STEP * dice.choose(&[0.0, 0.3, 2.4]),
        overdrive: STEP * dice.choose(&[0.0, 0.001, 0.02]),
        longest: STEP * dice.choose(&[2.5, 9.0]),
        noise: dice.choose(&[0.0, 0.002]),
    };
    let part = Part::<f64>::new(STEP, &law, NoiseSource::new(seed, "comparator", 0));
    let figures = ComparatorFigures {
        offset: law.offset,
        hysteresis: law.hysteresis,
        delay: law.delay / STEP,
        charge: law.overdrive / STEP,
        patience: ((law.longest - law.delay) / STEP).max(0.0),
        noise: law.noise,
    };
    let mut state = ComparatorState::default();
    let mut comparator = Comparator::new(figures, false);
    let (mut machine, mut interpreter) = (Vec::new(), Vec::new());
    let mut input = -0.05;
    for sample in 1..600 {
        let before = input;
        input = (input + dice.choose(&[0.0, 0.01, 0.05]) * dice.normal()).clamp(-0.1, 0.1);
        let deviate = dice.normal();
        part.walk(&mut state, sample, deviate, [before, input], &mut machine);
        comparator.step(sample, deviate, [before, input], &mut interpreter);
    }
    assert_eq!(machine.len(), interpreter.len(), "seed {seed}: {law:?}");
    for (number, (machine, interpreter)) in machine.iter().zip(&interpreter).enumerate() {
        assert_eq!(machine.high, interpreter.high, "seed {seed}, trip {number}");
        let off = (machine.at.0 - interpreter.at).abs();
        assert!(off < 1e-9, "seed {seed}, trip {number}: {machine:?} against {interpreter:?}; {law:?}");
    }
    machine.len()
}

#[test]
fn both_engines_have_the_same_comparator() {
    let trips: usize = (0..300).map(check).sum();
    assert!(trips > 3000, "{trips} trips");
}
