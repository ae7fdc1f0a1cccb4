//! The effect of each switch in metres.

use terrain_builder::{Base, Effect, Ground, Switch, effects};

use crate::{HEAD, described, file_of, near};

fn effect(text: &str, switch: Switch) -> Effect {
    let found = effects(&described(text), &Base::Level(-100.0)).unwrap();
    found.into_iter().find(|effect| effect.switch == switch).unwrap()
}

#[test]
fn a_switch_without_its_feature_has_no_effect() {
    for found in effects(&described(HEAD), &Base::Level(-100.0)).unwrap() {
        assert_eq!((found.heights, found.boulders, found.moved), (0.0, 0.0, 0.0), "{found:?}");
    }
}

#[test]
fn every_switch_has_its_effect() {
    let lifted = effect(&file_of(&[3]), Switch::RoughnessLift);
    assert!((0.4..1.0).contains(&lifted.heights), "{lifted:?}");
    let sums = effect(&file_of(&[1]), Switch::GrowthSums);
    assert!(sums.heights > 100.0, "{sums:?}");
    let curve = effect(&file_of(&[1]), Switch::CurveDivision);
    assert!(curve.heights > 0.5 && curve.heights < 20.0, "{curve:?}");
    let grids = effect(&file_of(&[0, 2]), Switch::FeatureGrids);
    assert!(grids.heights > 0.1 && grids.heights < 60.0, "{grids:?}");
    let polar = file_of(&[5]).replace("26.", "80.");
    let crowded = effect(&polar, Switch::EvenInAngle);
    assert!(crowded.moved > 1.0 && crowded.heights == 0.0, "{crowded:?}");
}

#[test]
fn boulders_at_the_mean_radius_are_off_by_the_height_of_the_ground() {
    let text = file_of(&[0, 1, 5]);
    let found = effect(&text, Switch::MeanRadiusBoulders);
    let ground = Ground::new(described(&text), Base::Level(-100.0)).unwrap();
    let off = |placed: &terrain_builder::PlacedBoulder| placed.middle.abs();
    near(found.boulders, ground.boulders().iter().map(off).fold(0.0, f64::max), 0.0);
    assert_eq!(found.heights, 0.0);
}

#[test]
fn switches_have_the_words_of_the_file() {
    for (word, switch) in Switch::ALL {
        assert_eq!(switch.word(), word);
        let description = described(&format!("as_reported = [\"{word}\"]\n{HEAD}"));
        for (_, other) in Switch::ALL {
            assert_eq!(description.reported.has(other), other == switch);
        }
    }
}
