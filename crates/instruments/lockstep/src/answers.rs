//! Comparators behind the line generators, answer by answer.

use shadow_controller::comparator_of;
use signal::Waveform;

use crate::bounds;
use crate::compare::Sides;
use crate::report::{Difference, Report};

/// Compares the `answers` of the machine's comparators, each with its number, with those that the interpreter has for each edge of the
/// gate of shadow; `turns` are the line generators that find the edges. An answer is a sample of the tally.
pub fn compare_answers(sides: &Sides<'_>, answers: &[Waveform], turns: &[usize], report: &mut Report) {
    for wave in answers {
        let Some(number) = comparator_of(wave.signal.name) else { continue };
        let all = sides.record.shadow_answers.iter().zip(turns);
        let mut own: Vec<f64> = all.filter(|(_, turn)| **turn == number).filter_map(|(at, _)| *at).collect();
        own.sort_by(f64::total_cmp);
        let allowed = bounds::of_parts(sides.scene.settings.scalar);
        let tally = report.signals.entry(wave.signal.name.to_owned()).or_default();
        tally.samples += own.len() as u64;
        // What one of them does not have agrees with nothing.
        let at = |times: &[f64], index: usize| times.get(index).copied().unwrap_or(f64::NAN);
        let mut pairs =
            (0..own.len().max(wave.times.len())).map(|index| (at(&wave.times, index), at(&own, index)));
        let differing = pairs.find(|(machine, own)| {
            // A place in the sweep is known to as many digits whatever its sample.
            let agrees = (machine - own).abs() <= allowed * own.max(1.0);
            !agrees
        });
        let Some((machine, interpreter)) = differing else { continue };
        let place = if machine.is_nan() { interpreter } else { machine };
        let found = sides.place(wave.signal.name, place.max(0.0) as usize);
        report.difference.get_or_insert(Difference { machine, interpreter, allowed, ..found });
    }
}
