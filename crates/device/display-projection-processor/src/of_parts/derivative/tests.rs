//! Sweeps side by side against sweeps that take every step alone.

use hardware_model::AnalogParts;
use signal::{LANES, Lanes, Real};

use super::Derivative;
use crate::of_parts::chain::Scratch;
use crate::of_parts::figures::Figures;
use crate::of_parts::lane::{Beam, Group};

/// Ground that rises and falls about level, in which noise decides, and leaps here and there.
fn elevation<S: Real>(round: u64, samples: usize) -> Vec<Lanes<S>> {
    let drawn = |words: &[u64]| quantities::unit_interval(4, words);
    let mut at = [0.0; LANES];
    let step = |sample: u64| {
        Lanes::from_fn(|lane| {
            let words = |what: u64| [round, sample, lane as u64, what];
            let size = if drawn(&words(0)) < 0.05 { 0.1 } else { 4e-4 };
            at[lane] += size * (drawn(&words(1)) - 0.48 - 0.02 * lane as f64);
            S::from_f64(at[lane])
        })
    };
    (0..samples as u64).map(step).collect()
}

fn go_side_by_side_as_alone<S: Real>(parts: &AnalogParts) {
    let circuit = Derivative::<S>::new(50e-9, &Figures { parts, seed: 1970 });
    let mut stretches = 0;
    for round in 0..12 {
        let samples = 1 + 60 * round as usize;
        let elevation = elevation::<S>(round, samples);
        let ends = std::array::from_fn(|lane| if lane < 3 { samples * lane / 3 } else { samples });
        let sweeps = std::array::from_fn(|lane| 100 * round + 7 * lane as u64);
        let group = Group { elevation: &elevation, ends, sweeps };
        let run = |is_alone: bool| {
            let (mut on, mut hold) = ([const { Vec::new() }; LANES], vec![Lanes::default(); samples]);
            hold[0] = elevation[0];
            let (mut beams, mut scratch) = (on.each_mut().map(Beam::begin), Scratch::default());
            if is_alone {
                let mut latches = circuit.latches(&group, &mut scratch);
                (0..LANES).for_each(|lane| latches.settle(lane));
                for sample in 1..samples {
                    (0..LANES).for_each(|lane| latches.step(lane, sample, &mut beams[lane], &mut hold));
                }
            } else {
                circuit.run(&group, &mut scratch, &mut beams, &mut hold);
            }
            for (beam, end) in beams.iter_mut().zip(ends) {
                beam.turn_off(end as f64);
            }
            (on, hold)
        };
        let ((on, hold), (alone_on, alone_hold)) = (run(false), run(true));
        assert_eq!(on, alone_on, "round {round}");
        for lane in 0..LANES {
            for sample in 0..ends[lane] {
                assert_eq!(hold[sample][lane], alone_hold[sample][lane], "round {round}: {sample}, {lane}");
            }
        }
        stretches += on.iter().map(Vec::len).sum::<usize>();
    }
    assert!(stretches > 250, "{stretches}");
}

#[test]
fn sweeps_go_side_by_side_as_they_go_alone() {
    let mut noisy = AnalogParts::ideal();
    noisy.spread = true;
    noisy.amplifier.noise = 5e-4;
    noisy.projection.bandwidth = Some(8e6);
    noisy.comparator.hysteresis = 1e-3;
    noisy.comparator.delay = 40e-9;
    noisy.sample_hold.acquire = 400e-9;
    noisy.sample_hold.aperture = 20e-9;
    noisy.sample_hold.jitter = 1e-9;
    for parts in [&AnalogParts::ideal(), &noisy] {
        go_side_by_side_as_alone::<f32>(parts);
        go_side_by_side_as_alone::<f64>(parts);
    }
}
