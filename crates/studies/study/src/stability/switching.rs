//! Parts whose law changes: slew and saturation, comparators, holds.

use std::time::Instant;

use parts::{
    Amplifier, AmplifierLaw, AmplifierState, Comparator, ComparatorLaw, ComparatorState, NoiseSource,
    SampleHold, SampleHoldLaw, Trip,
};
use quantities::SweepTime;
use signal::Real;

use super::cell::{Action, Cell, Found, Theory, plain};
use crate::ladder::Extent;

const SAMPLES: usize = 256;
const FOLD: usize = 32;

/// A folded ramp between -1 and 1.
fn ramp(t: f64) -> f64 {
    let turns = t / FOLD as f64;
    1.0 - 2.0 * (turns - 2.0 * (turns / 2.0).round()).abs()
}

/// Slew against lag, saturation, recovery.
pub fn slew(_: Extent) -> Vec<Cell> {
    let law = |tau: f64, slew: f64, saturation: f64, recovery: f64| AmplifierLaw {
        tau,
        slew,
        saturation,
        recovery,
    };
    let free = f64::INFINITY;
    let cases = [
        ("no slew limit", law(2.0, free, free, 0.0)),
        ("slew just below the ramp", law(2.0, 0.0624, free, 0.0)),
        ("slew just above the ramp", law(2.0, 0.0626, free, 0.0)),
        ("slew of a thousandth of the ramp", law(2.0, 6e-5, free, 0.0)),
        ("slew 0", law(2.0, 0.0, free, 0.0)),
        ("lag of 1e-6 samples, slew below the ramp", law(1e-6, 0.05, free, 0.0)),
        ("lag of 1e6 samples, slew below the ramp", law(1e6, 0.05, free, 0.0)),
        ("saturation at half of the ramp, recovery 5", law(2.0, free, 0.5, 5.0)),
        ("saturation, recovery and slew", law(2.0, 0.05, 0.3, 20.0)),
        ("saturation, recovery as long as the lag", law(2.0, free, 0.5, 2.0)),
    ];
    cases.iter().flat_map(|(case, law)| slew_cells(case, law)).collect()
}

fn own_amplifier<S: Real>(law: &AmplifierLaw) -> (Vec<f64>, f64) {
    let (part, start) = (Amplifier::<S>::new(1.0, law), Instant::now());
    let mut state =
        AmplifierState { y: S::from_f64(ramp(0.0).clamp(-law.saturation, law.saturation)), excess: S::ZERO };
    let step = |k: usize| {
        let [from, to] = [k as f64, k as f64 + 1.0].map(|t| S::from_f64(ramp(t)));
        part.step(&mut state, from, to).to_f64()
    };
    let values = (0..SAMPLES).map(step).collect();
    (values, start.elapsed().as_secs_f64())
}

/// The law of the amplifier in small steps, its lag relaxed towards the input held over each: a second opinion.
fn amplifier_in_small_steps(law: &AmplifierLaw, fine: usize) -> Vec<f64> {
    let h = 1.0 / fine as f64;
    let share = -libm::expm1(-h / law.tau);
    let recovers = if law.recovery > 0.0 { -libm::expm1(-h / law.recovery) } else { 1.0 };
    let clip = |y: f64| y.clamp(-law.saturation, law.saturation);
    let (mut y, mut excess) = (clip(ramp(0.0)), 0.0);
    let mut values = Vec::with_capacity(SAMPLES);
    for sample in 0..SAMPLES {
        for k in 0..fine {
            let u = ramp(sample as f64 + (k as f64 + 0.5) * h);
            let before = y;
            y += ((u - y) * share).clamp(-law.slew * h, law.slew * h);
            let middle = 0.5 * (before + y);
            excess += (middle - clip(middle) - excess) * recovers;
        }
        values.push(if law.recovery > 0.0 { clip(y + excess) } else { clip(y) });
    }
    values
}

fn slew_cells(case: &str, law: &AmplifierLaw) -> Vec<Cell> {
    /// The second opinion is off by its step times the slope of the ramp.
    const FINE: usize = 1000;
    let truth = amplifier_in_small_steps(law, FINE);
    let found = |(values, time_s): (Vec<f64>, f64), action: Action| {
        let off = values.iter().zip(&truth).map(|(found, truth)| (found - truth).abs());
        Found {
            finite: values.iter().all(|value| value.is_finite()),
            // A saturation is the nearest value of the scalar.
            bounded: values
                .iter()
                .all(|value| value.abs() <= law.saturation.min(1.0) * (1.0 + f64::from(f32::EPSILON))),
            error: Some(off.fold(0.0, f64::max)),
            action,
            time_s,
        }
    };
    let theory = Theory::Answers(1e-4);
    let start = Instant::now();
    let coarse = amplifier_in_small_steps(law, 1);
    let coarse = (coarse, start.elapsed().as_secs_f64());
    vec![
        Cell::own("limits", case, "parts, f64", theory, found(own_amplifier::<f64>(law), Action::Split)),
        Cell::own("limits", case, "parts, f32", theory, found(own_amplifier::<f32>(law), Action::Split)),
        Cell::comparison("limits", case, "a step a sample", theory, found(coarse, Action::Stepped)),
    ]
}

/// Comparators that an input grazes.
pub fn comparators(_: Extent) -> Vec<Cell> {
    let overlaps = [-1e-3, -1e-12, 0.0, 1e-15, 1e-12, 1e-6, 1e-3];
    let hysteresis = [0.0, 1e-3];
    hysteresis.iter().flat_map(|&width| overlaps.map(|over| grazing(width, over))).collect()
}

/// Peaks that pass the upper threshold by `over`, down and up again far below the lower one.
fn grazing(hysteresis: f64, over: f64) -> Cell {
    const PEAK: f64 = 0.5;
    let law = ComparatorLaw {
        offset: PEAK - over - hysteresis / 2.0,
        hysteresis,
        delay: 0.0,
        overdrive: 0.0,
        longest: 0.0,
        noise: 0.0,
    };
    // The fold lies between two samples: what passes between them is found, or is not there.
    let slope = 1.0 / FOLD as f64;
    let peak_at = FOLD as f64 / 2.0;
    let input = |t: f64| {
        let within = (t / FOLD as f64).fract() * FOLD as f64;
        PEAK - slope * (within - peak_at).abs()
    };
    let (part, start) = (Comparator::<f64>::new(1.0, &law, NoiseSource::new(0, "study", 0)), Instant::now());
    let (mut state, mut trips): (_, Vec<Trip>) = (ComparatorState::default(), Vec::new());
    (1..=SAMPLES).for_each(|k| {
        part.step(&mut state, (0, k), input(k as f64 - 1.0), input(k as f64), &mut trips);
    });
    let time_s = start.elapsed().as_secs_f64();
    let peaks = SAMPLES / FOLD;
    let threshold = law.offset + hysteresis / 2.0;
    let most = if PEAK > threshold {
        2 * peaks
    } else if PEAK < threshold {
        0
    } else {
        2 * peaks
    };
    let alternate = trips.windows(2).all(|pair| pair[0].high != pair[1].high && pair[0].at.0 <= pair[1].at.0);
    // Up where the rise meets the upper threshold, down where the fall meets the lower one.
    let late = |trip: &Trip| {
        let peak = (trip.at.0 / FOLD as f64).floor() * FOLD as f64 + peak_at;
        let level = if trip.high { threshold } else { law.offset - hysteresis / 2.0 };
        let way = (PEAK - level) / slope;
        trip.at.0 - (peak + if trip.high { -way } else { way })
    };
    let error = trips.iter().map(|trip| late(trip).abs() * slope).fold(0.0, f64::max);
    let complete = over <= 1e-12 || trips.len() == most;
    let found = Found {
        finite: trips.iter().all(|trip| trip.at.0.is_finite()),
        // Chatter: more than one pulse a peak, or two trips the same way.
        bounded: trips.len() <= most && alternate && complete,
        error: Some(error),
        action: Action::Split,
        time_s,
    };
    let case = format!("peak {} above the threshold, hysteresis {hysteresis}", plain(over));
    Cell::own("comparator", &case, "parts, f64", Theory::Answers(1e-12), found)
}

/// Sample-and-hold on a ramp that moves.
pub fn holds(_: Extent) -> Vec<Cell> {
    let acquisition = [0.0, 1e-6, 1.0, 6.9, 100.0];
    let aperture = [0.0, 0.25, 3.0];
    acquisition
        .iter()
        .flat_map(|&acquired| aperture.map(|late| hold_cells(acquired, late)))
        .flatten()
        .collect()
}

/// Held at instants that no sample has: the ramp's value then, less what a lag is behind a ramp.
fn hold_cells(acquisition: f64, aperture: f64) -> Vec<Cell> {
    const SLOPE: f64 = 1e-3;
    let law = SampleHoldLaw { acquisition, aperture, jitter: 0.0, pedestal: 0.0, droop: 0.0 };
    let (part, start) = (SampleHold::<f64>::new(1.0, &law), Instant::now());
    let mut tracked = vec![0.0];
    for k in 0..SAMPLES {
        tracked.push(part.track(tracked[k], SLOPE * k as f64, SLOPE * (k + 1) as f64));
    }
    let tau = parts::settling_time_constant(acquisition, 0.001);
    let (mut error, mut nearest): (f64, f64) = (0.0, 0.0);
    for command in (0..20).map(|k| 200.0 + 2.0 * f64::from(k) + 0.37) {
        let at = part.taken_at(SweepTime(command), 0.0).0;
        let sample = at.floor() as usize;
        let (from, to) = (SLOPE * sample as f64, SLOPE * (sample + 1) as f64);
        let held = part.held(part.tracked(tracked[sample], from, to, at - sample as f64), 0.0);
        let gone = if tau > 0.0 { -libm::expm1(-at / tau) } else { 1.0 };
        let truth = SLOPE * (at - tau * gone);
        error = error.max((held - truth).abs());
        nearest = nearest.max((tracked[sample] - truth).abs());
    }
    let time_s = start.elapsed().as_secs_f64();
    let case = format!("acquisition {acquisition}, aperture {aperture} samples");
    let found = |error: f64, action: Action| Found {
        finite: error.is_finite(),
        bounded: tracked.iter().all(|value| value.abs() <= SLOPE * SAMPLES as f64),
        error: Some(error),
        action,
        time_s,
    };
    let theory = Theory::Answers(1e-12);
    vec![
        Cell::own("hold", &case, "parts, f64", theory, found(error, Action::Split)),
        Cell::comparison("hold", &case, "sample before", theory, found(nearest, Action::Stepped)),
    ]
}
