//! Output amplifiers of the main signals: what they leave as it is, what goes to nothing with them, and their extremes.

use std::collections::BTreeMap;

use control_plane::MachineStage;
use generator::{PlaneKind, Planes};
use hardware_model::{HardwareModel, MAIN_WIRES, ModelSource, Settings, WireParts};
use lunoid_tests::shipped::folder;
use lunoid_tests::{ComparedScene, random};
use machine::Prepare;
use scenario::Scalar;
use signal::Probe;

/// What a frame came to: its picture, and the signals of every sweep by name.
struct Frame {
    picture: Vec<f32>,
    signals: BTreeMap<(u32, &'static str), Vec<f64>>,
}

fn frame(scene: &ComparedScene, stage: MachineStage) -> Frame {
    let session = stage.prepare();
    let mut planes = Planes::new(scene.sweeps as usize, scene.lines as usize, &[PlaneKind::Intensity]);
    let mut probe = Probe::new(vec!["*".into()], 0..scene.sweeps);
    session.frame(1, &scene.pose(), &mut planes, &mut probe).unwrap();
    let waveforms = probe.waveforms.into_iter();
    Frame {
        picture: planes.get(PlaneKind::Intensity).unwrap().to_vec(),
        signals: waveforms.map(|wave| ((wave.sweep, wave.signal.name), wave.values)).collect(),
    }
}

fn drawn(scene: &ComparedScene, wires: WireParts) -> Frame {
    let stage = scene.stage();
    let mut settings = stage.settings.clone();
    settings.analog.wires = wires;
    frame(scene, MachineStage { settings, ..stage })
}

fn ideal(scene: &ComparedScene) -> Frame {
    drawn(scene, WireParts::IDEAL)
}

fn band(hertz: f64) -> WireParts {
    WireParts { bandwidth: Some(hertz), ..WireParts::IDEAL }
}

fn only(names: &[&str], wires: WireParts) -> WireParts {
    WireParts { driven: MAIN_WIRES.map(|wire| names.contains(&wire)), ..wires }
}

/// Mean amount by which two pictures differ.
fn apart(a: &Frame, b: &Frame) -> f64 {
    let pairs = a.picture.iter().zip(&b.picture);
    pairs.map(|(a, b)| f64::from((a - b).abs())).sum::<f64>() / a.picture.len() as f64
}

/// Signals that differ in any sweep.
fn changed(a: &Frame, b: &Frame) -> Vec<&'static str> {
    let mut names: Vec<_> = a
        .signals
        .iter()
        .filter(|(key, values)| b.signals[*key] != **values)
        .map(|((_, name), _)| *name)
        .collect();
    names.sort_unstable();
    names.dedup();
    names
}

fn scene(seed: u64, scalar: Scalar) -> ComparedScene {
    ComparedScene { scalar, ..random::landscape(seed) }
}

#[test]
fn wires_without_amplifiers_are_the_ideal_machine_to_the_bit() {
    for (seed, scalar) in [(7100, Scalar::F32), (7101, Scalar::F64), (7102, Scalar::F32)] {
        let scene = scene(seed, scalar);
        let none = drawn(&scene, only(&[], WireParts { slew: Some(1e3), ..band(1e4) }));
        let ideal = ideal(&scene);
        assert!(changed(&none, &ideal).is_empty() && none.picture == ideal.picture, "{seed}");
        assert!(apart(&drawn(&scene, band(1e6)), &ideal) > 0.0, "{seed}: a band of 1 MHz does nothing");
    }
}

/// What lags is what the next block has, and nothing before it: by the figure of the report.
#[test]
fn each_wire_changes_what_lies_behind_it() {
    let scene = ComparedScene {
        laws: scenario::Laws { ..scene(7103, Scalar::F64).laws },
        ..scene(7103, Scalar::F64)
    };
    let clean = ideal(&scene);
    let is_behind = |wire: &str, name: &str| match wire {
        "tg.reflectivity" | "fg.reflectivity" => {
            name == wire || matches!(name, "mu.reflectivity" | "sm.video" | "sm.write" | "mu.vs1")
        }
        "mu.reflectivity" => matches!(name, "mu.reflectivity" | "sm.video" | "sm.write"),
        "mu.height" => name == wire || name.starts_with("dpp.") || name.starts_with("sm."),
        "tg.slope.u" | "tg.slope.v" => {
            // Both slopes are turned into the sweep's axes and back.
            name.starts_with("tg.slope")
                || name.starts_with("tg.light.")
                || name.ends_with("reflectivity")
                || name.starts_with("sm.")
                || matches!(name, "mu.vs1")
                || name.starts_with("dpp.")
        }
        "fg.slope.u" | "fg.slope.v" => {
            name.starts_with("fg.slope")
                || matches!(name, "fg.reflectivity" | "mu.reflectivity" | "mu.vs1")
                || name.starts_with("sm.")
        }
        _ => {
            name == wire
                || name.ends_with("reflectivity")
                || name == "mu.height"
                || name == "mu.vs1"
                || name.starts_with("dpp.")
                || name.starts_with("sm.")
        }
    };
    for wire in MAIN_WIRES {
        let lagging = drawn(&scene, only(&[wire], band(2e4)));
        let changed = changed(&lagging, &clean);
        assert!(changed.contains(&wire), "{wire}: {changed:?}");
        let before: Vec<_> = changed.iter().filter(|name| !is_behind(wire, name)).collect();
        assert!(before.is_empty(), "{wire} changes {before:?}");
    }
}

/// Wires go to the ideal ones with the time constant, of first order, and pictures with them. What is left between pictures is how
/// a step is drawn in which local shadow begins: a signed cubic there, pieces on both sides of its begin here.
#[test]
fn a_wide_band_is_the_ideal_machine() {
    // A step of these scenes is 10 microseconds.
    let bands = [1e5, 1e6, 1e7, 1e8];
    let (mut pictures, mut heights, mut left) = ([0.0; 4], [0.0_f64; 4], 0.0);
    for seed in 7200..7206 {
        let scene = scene(seed, Scalar::F64);
        let (clean, limit) = (ideal(&scene), drawn(&scene, band(1e14)));
        left += apart(&limit, &clean) / 6.0;
        for ((sum, most), hertz) in pictures.iter_mut().zip(&mut heights).zip(bands) {
            let found = drawn(&scene, band(hertz));
            *sum += apart(&found, &limit) / 6.0;
            for (key, values) in found.signals.iter().filter(|((_, name), _)| *name == "mu.height") {
                let off = values.iter().zip(&clean.signals[key]).map(|(a, b)| (a - b).abs());
                *most = off.fold(*most, f64::max);
            }
        }
    }
    println!("pictures {pictures:?}, heights (m) {heights:?}, left {left}");
    for sizes in [pictures, heights] {
        assert!(sizes.windows(2).all(|pair| pair[1] < 0.2 * pair[0]), "{sizes:?}");
    }
    assert!(heights[3] < 0.11 * heights[2] && heights[3] < 0.02, "{heights:?}");
    assert!(left < 5e-5, "{left}");
}

/// A rate that no signal reaches is none; one that signals reach shows.
#[test]
fn a_fast_amplifier_does_not_slew() {
    for seed in 7300..7303 {
        let scene = scene(seed, Scalar::F64);
        let rate = |volts: f64| drawn(&scene, WireParts { slew: Some(volts), ..WireParts::IDEAL });
        let limit = rate(1e15);
        let [slow, fast] = [1e4, 1e13].map(|volts| apart(&rate(volts), &limit));
        assert!(slow > 1e-3 && fast < 1e-8, "{seed}: {slow} {fast}");
    }
}

#[test]
fn extremes_give_light_and_numbers() {
    for (seed, scalar) in [(7400, Scalar::F32), (7401, Scalar::F64), (7402, Scalar::F32)] {
        let scene = scene(seed, scalar);
        for bandwidth in [None, Some(1e-3), Some(1e4), Some(1e12)] {
            for slew in [None, Some(1e-9), Some(1e3), Some(1e15)] {
                let found = drawn(&scene, WireParts { bandwidth, slew, ..WireParts::IDEAL });
                let in_light = |value: &f32| (0.0..=1.001).contains(value);
                assert!(found.picture.iter().all(in_light), "{seed} {bandwidth:?} {slew:?}");
                let numbers = found.signals.values().flatten().all(|value| value.is_finite());
                assert!(numbers, "{seed} {bandwidth:?} {slew:?}");
            }
        }
    }
}

/// Amplifiers stand behind blocks of real parts as behind ideal ones.
#[test]
fn wires_go_with_real_parts() {
    let nominal = ModelSource::find("pra-nominal", &folder()).unwrap();
    let parts = HardwareModel::load(&nominal, &[], &[]).unwrap().model.analog;
    let scene = scene(7500, Scalar::F32);
    let with = |wires: WireParts| {
        let stage = scene.stage();
        let mut analog = parts.clone();
        analog.wires = wires;
        frame(&scene, MachineStage { settings: Settings { analog, ..stage.settings.clone() }, ..stage })
    };
    let (clean, slow) = (with(WireParts::IDEAL), with(band(2e4)));
    assert!(slow.picture.iter().all(|value| value.is_finite()));
    let changed = changed(&slow, &clean);
    for wire in MAIN_WIRES {
        assert!(changed.contains(&wire), "{wire}: {changed:?}");
    }
}
