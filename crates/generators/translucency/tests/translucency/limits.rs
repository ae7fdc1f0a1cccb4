//! A row of lamps at one sampling point, and figures that no feature has.

use raster::{Pattern, Sampling};
use translucency::{Capacity, Feature, FeatureError, Stack};

use super::{Placed, separate, stacked};

/// Lamps of a row that merge at the horizon: each 2 m behind the one before.
fn row() -> Vec<Placed> {
    let lamp = |id: u32| Feature::light(id, 0, [1.0, 0.8, 0.5], 0.02, 0.98).unwrap();
    (0..100).map(|id| Placed { distance: 10.0 + 2.0 * f64::from(id), feature: lamp(id) }).collect()
}

#[test]
fn a_row_of_lamps_loses_what_the_picture_lacks() {
    // The row's light is 1 - 0.98^n for n lamps.
    let light = |lamps: i32| 1.0 - (0..lamps).fold(1.0, |left, _| 0.98 * left);
    let whole = stacked(Capacity::UNLIMITED, &row()).colour_at(0)[0];
    assert!((whole - light(100)).abs() < 1e-14);
    for limit in [1, 2] {
        let stack = stacked(separate(4, limit), &row());
        let lost = whole - stack.colour_at(0)[0];
        assert!((lost - (light(100) - light(limit as i32))).abs() < 1e-14, "{lost}");
        assert!(lost <= stack.losses().bound[0]);
        assert_eq!((stack.losses().lights, stack.losses().translucent), (1, 0));
    }
}

#[test]
fn one_sheet_of_dust_survives_lamps_only_in_slots_of_its_own() {
    let dust = Placed { distance: 300.0, feature: Feature::surface(200, 0, [0.5; 3], 0.4).unwrap() };
    let set: Vec<Placed> = row().into_iter().chain([dust]).collect();
    let shows_dust =
        |capacity| stacked(capacity, &set).layers(0).any(|layer| layer.feature.id() == dust.feature.id());
    assert!(shows_dust(separate(4, 1)));
    assert!(!shows_dust(Capacity::Shared(Some(5))));
}

#[test]
fn figures_out_of_range_are_refused_by_id() {
    let wrong = [-0.1, 1.1, f64::NAN, f64::INFINITY];
    for value in wrong {
        let refused = Feature::surface(7, 0, [0.5; 3], value).unwrap_err().to_string();
        assert!(refused.starts_with("feature 7: translucency is"), "{refused}");
    }
    for value in [-0.1, f64::NAN, f64::INFINITY] {
        let refused = Feature::surface(7, 0, [0.5, value, 0.5], 0.5).unwrap_err().to_string();
        assert!(refused.starts_with("feature 7: colour has"), "{refused}");
        let refused = Feature::light(7, 0, [0.5; 3], value, 0.5).unwrap_err().to_string();
        assert!(refused.starts_with("feature 7: intensity is"), "{refused}");
        let sampling = Sampling::new(Pattern::One);
        let refused = Stack::new(sampling, Capacity::UNLIMITED, [value; 3]).err();
        assert!(matches!(refused, Some(FeatureError::Background(_))));
    }
    assert!(Feature::light(7, 0, [1e200; 3], 1e200, 0.5).is_err());
    assert!(Feature::surface(7, 0, [2.0; 3], 0.0).is_ok());
}

#[test]
fn what_is_invisible_is_not_stored_and_what_lets_nothing_through_is_opaque() {
    let feature = |translucency| Feature::surface(1, 0, [1.0; 3], translucency).unwrap();
    let of =
        |translucency| stacked(separate(0, 0), &[Placed { distance: 5.0, feature: feature(translucency) }]);
    assert_eq!((of(1.0).layers(0).count(), of(1.0).loss_at(0)), (0, None));
    assert_eq!((of(0.0).layers(0).count(), of(0.0).loss_at(0)), (1, None));
    assert!(of(0.5).loss_at(0).is_some());
}
