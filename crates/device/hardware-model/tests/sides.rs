//! Each side of the machine made ideal without the other.

use hardware_model::{BUILT_IN, HardwareModel, ModelSource, Settings, ShadowParts, Side, Yoke};
use scenario::{Display, FieldOfView, LawWishes, RasterWishes, Scalar};

const FIELD: FieldOfView = FieldOfView { tan_half_width: 0.466_307_658, tan_half_height: 0.267_949_192 };
const DISPLAY: Display = Display { white: 1.0, gamma: 1.0 };

fn model(name: &str) -> HardwareModel {
    let source = ModelSource::BuiltIn(name.into());
    HardwareModel::load(&source, &[], &[]).unwrap_or_else(|faults| panic!("{faults}")).model
}

/// With a yoke, as for a scenario that shows roll.
fn settings(model: &HardwareModel) -> Settings {
    let wishes = RasterWishes::default();
    let settings = Settings::resolve(model, FIELD, wishes, None, LawWishes::default(), Scalar::F32, DISPLAY);
    Settings { yoke: Some(model.yoke), ..settings.unwrap() }
}

/// Every field is kept, or is that of the ideal machine: one that belongs to no side would be found here.
#[test]
fn without_both_sides_only_what_is_no_part_is_left() {
    let ideal = settings(&model("ideal"));
    for (name, _) in BUILT_IN {
        let own = settings(&model(name));
        let travel = own.yoke.unwrap().travel;
        let found = own.clone().with_ideal(Side::Analog).with_ideal(Side::Digital);
        let expected = Settings {
            raster: own.raster,
            timebase: own.timebase,
            range: own.range,
            laws: own.laws,
            seed: own.seed,
            sweep_memory: own.sweep_memory,
            yoke: ideal.yoke.map(|yoke| Yoke { travel, ..yoke }),
            ..ideal.clone()
        };
        assert_eq!(found, expected, "{name}");
    }
}

#[test]
fn a_side_leaves_the_other_alone() {
    let own = settings(&model("pra-overloaded"));
    let [digital, analog] = [Side::Digital, Side::Analog].map(|side| own.clone().with_ideal(side));
    assert_eq!((&digital.analog, digital.yoke), (&own.analog, own.yoke));
    assert_eq!(
        (analog.feature_generator, analog.shadow_controller),
        (own.feature_generator, own.shadow_controller)
    );
    assert_eq!((&analog.loader, analog.cpu, analog.data_banks), (&own.loader, own.cpu, own.data_banks));
    assert_eq!(analog.feature_words, own.feature_words);
    assert!(digital.loader.is_wired_through() && analog.analog.tubes_are_ideal());
}

/// The line generators are digital; a map on a tube is read by analog means.
#[test]
fn a_shadow_map_is_of_the_other_side() {
    let map = ShadowParts::ScanConverter { offset: [0.1, 0.0], gain: 0.02 };
    let own = Settings { shadow_controller: map, ..settings(&model("pra-nominal")) };
    let [digital, analog] =
        [Side::Digital, Side::Analog].map(|side| own.clone().with_ideal(side).shadow_controller);
    assert_eq!((digital, analog), (map, ShadowParts::default()));
}

#[test]
fn the_ideal_machine_is_ideal_on_both_sides() {
    let ideal = settings(&model("ideal"));
    for side in [Side::Digital, Side::Analog] {
        assert_eq!(ideal.clone().with_ideal(side), ideal);
    }
}
