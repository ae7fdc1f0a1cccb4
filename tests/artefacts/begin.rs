//! What a sweep begins with: an array that jumps from the eye's foot, and one that has settled at the first range.

use generator::Planes;
use hardware_model::{AnalogParts, HardwareModel, ModelSource};
use lunoid_tests::Shipped;
use machine::Prepare;
use signal::Probe;

use crate::artefacts::look::{largest, median};

const FRAME: u64 = 60;
const SWEEPS: u32 = 160;

/// Parts of 1970, but without noise: what an array begins with is no matter of chance.
fn nominal() -> AnalogParts {
    let source = ModelSource::BuiltIn("pra-nominal".into());
    let mut parts = HardwareModel::load(&source, &[], &[]).unwrap_or_else(|e| panic!("{e}")).model.analog;
    parts.amplifier.noise = 0.0;
    parts
}

/// What the array puts out at the samples of each sweep (m).
fn heights(shipped: &Shipped) -> Vec<Vec<f64>> {
    let session = shipped.stage().prepare();
    let mut probe = Probe::new(vec!["tg.sum.height".into()], 0..SWEEPS);
    let pose = shipped.pose(FRAME).pose;
    session.frame(FRAME, &pose, &mut Planes::new(0, 0, &[]), &mut probe).expect("a shipped frame");
    probe.waveforms.into_iter().map(|wave| wave.values).collect()
}

/// By how much the height at the first sample is off, of a scenario by parts of 1970 (m): beyond its static errors, which go on in
/// a straight line over the samples behind it. The middle of all sweeps, and the largest.
fn transient(scenario: &str, preset: bool) -> [f64; 2] {
    let mut shipped = Shipped::read(scenario, Some(SWEEPS));
    let right = heights(&shipped);
    shipped.settings.analog = nominal();
    shipped.settings.analog.sweep.preset = preset;
    let found = heights(&shipped);
    let off = |(found, right): (&Vec<f64>, &Vec<f64>)| {
        let error = |sample: usize| found[sample] - right[sample];
        (error(0) - (2.0 * error(8) - error(16))).abs()
    };
    let all: Vec<f64> = found.iter().zip(&right).map(off).collect();
    [median(&all), largest(all)]
}

/// docs/artefacts.md has these numbers.
#[test]
fn a_preset_array_begins_where_the_ground_is() {
    let [preset, jumps] = [true, false].map(|preset| transient("first-light", preset));
    println!("first sample off by {preset:.3?} m preset, by {jumps:.3?} m from the eye's foot");
    assert!(jumps[0] > 0.3, "{jumps:?}: the array is on its way");
    assert!(preset[0] < 0.1 * jumps[0] && preset[1] < 0.1 * jumps[1], "{preset:?} against {jumps:?}");
}

/// Scenes that showed ticks where their sweeps begin, before retrace preset the accumulators.
#[test]
#[ignore = "long: .ci/long runs it"]
fn no_other_scene_begins_with_a_tick() {
    for scenario in ["craters", "descent", "full-drive", "long-shadows", "nominal-drive"] {
        let [preset, jumps] = [true, false].map(|preset| transient(scenario, preset));
        println!(
            "{scenario}: first sample off by {preset:.4?} m preset, by {jumps:.4?} m from the eye's foot"
        );
        // The largest of `full-drive` is 0.025 m; why that sweep has so much was not looked into.
        assert!(preset[0] < 0.005 && preset[1] < jumps[1], "{scenario}: {preset:?} against {jumps:?}");
    }
}
