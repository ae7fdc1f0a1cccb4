//! Random landscapes on both engines; a scene that differs is shrunk before it is told.

use hardware_model::{BankPlace, KindBank};
use lockstep::{ComparedScene, Trials, frame_of, random, shrink, trials};
use scenario::Scalar;
use signal::{Axis, Waveform};
use signal_plane::signals;

/// The message of a failure has seeds and the smallest scenes that differ.
fn check(found: &Trials) {
    let told: Vec<_> = found.faults.iter().map(ToString::to_string).collect();
    assert!(told.is_empty(), "{} scenes differ:\n{}", told.len(), told.join("\n"));
}

/// Signals along ground range that the second engine has no opinion on (docs/lockstep.md says why).
const WITHOUT_OPINION: [&str; 1] = ["sc.or"];

/// All signals along ground range but those: these scenes must have put them to the test. A new signal is among them by itself.
fn compared() -> impl Iterator<Item = &'static str> {
    let signals = signals().iter().filter(|signal| signal.axis == Axis::Ground).map(|signal| signal.name);
    signals.filter(|name| !WITHOUT_OPINION.contains(name))
}

/// Events of drums, craters, shadows and the processor, which some of these scenes have.
const DIGITAL: [&str; 15] = [
    "absent",
    "record",
    "feature-record",
    "crater-load",
    "crater-late",
    "crater-dropped",
    "segment-load",
    "segment-late",
    "segment-dropped",
    "set-up-begins",
    "set-up",
    "set-up-late",
    "old-set-up",
    "tables",
    "tables-late",
];

#[test]
fn two_hundred_in_f64() {
    let found = trials(0..200, Scalar::F64);
    check(&found);
    assert!(found.scenes >= 190, "{} scenes could be drawn", found.scenes);
    for name in compared() {
        let tally = found.report.signals.get(name).cloned().unwrap_or_default();
        // Gates are not compared where comparators are real.
        assert!(tally.samples > 15_000, "{name}: {} samples compared", tally.samples);
        assert!(tally.doubtful < tally.samples / 1000, "{name}: {} samples doubtful", tally.doubtful);
    }
    for word in ["stop", "transfer", "load", "late"] {
        assert!(found.report.events[word] > 1000, "{word}: {}", found.report.events[word]);
    }
    for word in ["home", "wanted", "access", "wasted", "cancelled", "diagonal"] {
        let count = found.report.events.get(word).copied().unwrap_or(0);
        assert!(count > 100, "{word}: {count}");
    }
    for word in DIGITAL {
        let count = found.report.events.get(word).copied().unwrap_or(0);
        assert!(count > 0, "{word}: {count}");
    }
    assert!(found.report.counts["features"] > 100, "few sweeps met a crater");
}

#[test]
fn some_in_f32() {
    check(&trials(200..260, Scalar::F32));
}

/// A late word that comes on the very tick of a sample is seen by that sample.
#[test]
fn a_late_word_on_the_tick_of_a_sample() {
    let found = trials(102_874..102_875, Scalar::F64);
    check(&found);
    assert!(found.report.events["late"] > 100);
}

/// A corner that moves over from the diagonal register and is overwritten by another fold of the same tick was there: the event
/// list, which stops a debug build if it is told otherwise, has it as wasted.
#[test]
fn folds_of_one_tick_behind_diagonal_registers() {
    check(&trials(511..512, Scalar::F64));
}

/// An I/O processor is ordered once a crossing, also where sets of a later crossing go before the rest of an earlier one's.
#[test]
fn the_channel_is_ordered_once_a_crossing() {
    for seed in [311, 1001, 1059, 1112, 1224, 1289, 1302, 1320] {
        check(&trials(seed..seed + 1, Scalar::F64));
    }
}

/// A comparator finds a fold of one axis before an earlier one of the other, or before words that are on their way to a preload
/// register: its polarity and its words do not wait for these.
#[test]
fn folds_that_are_found_out_of_turn() {
    for seed in [1881, 1990] {
        check(&trials(seed..seed + 1, Scalar::F64));
    }
}

/// A fade begins at a sample, and the video passes black behind it. The crosstalk at the sample is that of the sample.
#[test]
fn a_fade_that_begins_at_a_sample() {
    check(&trials(2452..2453, Scalar::F64));
}

/// Boundaries of shadow on drums are too rare among the first scenes: these have a low sun, and squares that come while the frame runs.
#[test]
fn boundaries_of_shadow_on_drums() {
    let has_them = |&seed: &u64| {
        let scene = random::machine(seed);
        scene.shadows.is_some() && scene.data_banks.drum.is_some()
    };
    let mut came = 0;
    for (seed, place) in
        (0..).filter(has_them).take(6).zip([BankPlace::Apart, BankPlace::Together].into_iter().cycle())
    {
        let mut scene = random::machine(seed);
        scene.sun.elevation = 0.01;
        let drum = scene.data_banks.drum.expect("they have drums");
        let edit = drum.rotation as f64 / 48.0;
        let shadows = KindBank { place, record_words: 24, record_regions: 1, buffer_words: None, edit };
        scene.kind_banks.shadows = shadows;
        let Ok(report) = scene.lockstep(frame_of(seed)) else { continue };
        assert_eq!(report.first_difference(), None, "seed {seed}, {place:?}");
        came += report.events.get("shadow-record").copied().unwrap_or(0);
    }
    assert!(came > 0, "no square of shadows came while a frame ran");
}

/// The ground ends beyond a sample if it falls far to the next place, which may be a rim before the next sample.
#[test]
fn the_end_of_the_ground_at_a_rim() {
    for seed in [202_999, 204_085, 207_370] {
        check(&trials(seed..seed + 1, Scalar::F64));
    }
}

/// A signal broken on its way into the comparison: only where a crater is, only beyond the twentieth sample.
fn tampered(scene: &ComparedScene, seed: u64) -> Option<String> {
    let engines = lockstep::Engines::new(scene.stage());
    let crooked = |wave: &mut Waveform| {
        if wave.signal.name == "fg.slope.v" {
            wave.values.iter_mut().skip(20).for_each(|value| *value = -*value);
        }
    };
    let seen = engines.run(frame_of(seed), &scene.pose(), 0..scene.sweeps, &crooked).ok()?;
    let mut sum = lockstep::Report::default();
    seen.into_iter().for_each(|seen| sum.add(seen.report));
    sum.first_difference()
}

#[test]
fn what_differs_is_shrunk_to_what_makes_it_differ() {
    let seed = (0..).find(|&seed| tampered(&random::landscape(seed), seed).is_some()).unwrap();
    let whole = random::landscape(seed);
    assert!(whole.lockstep(frame_of(seed)).unwrap().first_difference().is_none());
    let shrunk = shrink::shrink(whole.clone(), |scene| tampered(scene, seed)).unwrap();
    assert!(shrunk.difference.starts_with("fg.slope.v, frame"), "{}", shrunk.difference);
    let small = &shrunk.scene;
    assert_eq!(small.craters.len(), 1, "{}", shrunk.describe());
    assert!(small.texture.is_empty() && small.coarse.is_none());
    assert!(small.level.words().iter().flatten().all(|&word| word == 0.0), "the ground is still rough");
    assert!(small.samples < whole.samples && small.sweeps <= whole.sweeps);
    let words = shrunk.describe();
    assert!(words.contains("1 craters") && words.contains("level ground"), "{words}");
}

#[test]
fn what_does_not_differ_is_not_shrunk() {
    assert_eq!(shrink::shrink(random::landscape(3), |_| None), None);
}
