//! What a sweep begins with: an array that jumps from the eye's foot, and one that has settled at the first range.

use hardware_model::{AnalogParts, HardwareModel, ModelSource};
use lunoid_tests::Shipped;

/// A pixel counts as lost if it is this much darker than by `exact` (levels of 255).
const DARKER: i32 = 24;

fn nominal() -> AnalogParts {
    let source = ModelSource::BuiltIn("pra-nominal".into());
    HardwareModel::load(&source, &[], &[]).unwrap_or_else(|e| panic!("{e}")).model.analog
}

/// Share of the pixels that are darker than they should be, frame 60 of first light by parts of 1970.
fn lost(preset: bool) -> f64 {
    let mut shipped = Shipped::read("first-light", Some(160));
    let right = shipped.exact(60).picture;
    shipped.settings.analog = nominal();
    shipped.settings.analog.sweep.preset = preset;
    let found = shipped.machine(60).picture;
    let pairs = found.pixels().iter().zip(right.pixels());
    let darker = pairs.filter(|(found, right)| i32::from(**found) + DARKER < i32::from(**right)).count();
    darker as f64 / right.pixels().len() as f64
}

#[test]
fn a_preset_leaves_no_wedge() {
    let [preset, jumps] = [lost(true), lost(false)];
    println!(
        "darker than by exact: {:.1} % preset, {:.1} % from the eye's foot",
        100.0 * preset,
        100.0 * jumps
    );
    assert!(jumps > 0.2, "{jumps}: the transient is held");
    assert!(preset < 0.1 * jumps, "{preset} against {jumps}");
}
