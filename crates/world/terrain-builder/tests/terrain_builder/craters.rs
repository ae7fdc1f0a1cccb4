//! Craters: profiles, oblique impacts, and the nearest crater of the hybrid machine.

use std::f64::consts::FRAC_PI_2;

use proptest::prelude::{prop_assert, prop_assert_eq, proptest};
use quantities::{radians, sin_cos};
use terrain_builder::{Crater, CraterForm, Decay, NoNearest};

use crate::near;

/// The crater of the check table: 1 km, wall 40 m, depth 200 m.
fn form() -> CraterForm {
    CraterForm {
        centre: [0.0; 2],
        radius: 1000.0,
        wall: 0.04,
        depth: 0.2,
        decay: Decay::Exponential(4.0),
        extent: 2.5,
        impact_elevation: FRAC_PI_2,
        impact_direction: radians(30.0),
    }
}

fn height(form: CraterForm, distance: f64) -> f64 {
    Crater::new(form).unwrap().height([0.0, distance])
}

#[test]
fn the_bowl_of_the_check_table_comes_out() {
    for (distance, expected) in [(0.0, -200.0), (250.0, -185.0), (500.0, -140.0), (1000.0, 40.0)] {
        near(height(form(), distance), expected, 1e-10);
    }
    near(height(form(), 912.870_929_175_277), 0.0, 1e-10);
}

#[test]
fn both_decays_of_the_check_table_come_out() {
    let exponential = [
        (1200.0, 17.918_423_809_643),
        (1500.0, 5.327_466_712_107),
        (2000.0, 0.635_049_599_059),
        (2500.0, 0.0),
    ];
    for (distance, expected) in exponential {
        near(height(form(), distance), expected, 1e-11);
    }
    let linear = CraterForm { decay: Decay::Linear, ..form() };
    let expected = [(1200.0, 34.666_666_666_667), (1500.0, 26.666_666_666_667), (2000.0, 13.333_333_333_333)];
    for (distance, expected) in expected {
        near(height(linear, distance), expected, 1e-11);
    }
    assert_eq!(height(linear, 2500.0), 0.0);
    assert_eq!(height(form(), 2600.0), 0.0);
}

#[test]
fn the_wall_is_as_steep_as_the_check_table_says() {
    let slope = |from: f64, to: f64| (height(form(), to) - height(form(), from)) / (to - from);
    near(slope(999.999, 1000.0), 0.48, 1e-6);
    near(slope(1_000.000_001, 1_000.001), -0.160_397_585_865, 1e-6);
}

#[test]
fn an_oblique_impact_stretches_the_crater_as_the_check_table_says() {
    let rows = [
        (10.0, 1.333_333_333_333, 793.731_481_803_052),
        (5.0, 1.666_666_666_667, 677.316_023_697_521),
        (0.0, 2.0, 604.756_855_800_414),
    ];
    for (elevation, elongation, distance) in rows {
        let crater = Crater::new(CraterForm { impact_elevation: radians(elevation), ..form() }).unwrap();
        near(crater.elongation(), elongation, 1e-12);
        near(crater.profile_distance([600.0, 800.0]), distance, 1e-9);
        near(crater.reach(), 2500.0 * elongation, 1e-8);
    }
}

#[test]
fn the_rim_is_higher_downrange() {
    let crater = Crater::new(CraterForm { impact_elevation: radians(45.0), ..form() }).unwrap();
    let (sin, cos) = sin_cos(radians(30.0));
    let at = |along: f64| crater.height([along * cos, along * sin]);
    near(at(1000.0), 40.0 * 1.25, 1e-9);
    near(at(-1000.0), 40.0 * 0.75, 1e-9);
    assert_eq!(at(0.0), -200.0);
}

#[test]
fn impossible_craters_are_refused_by_their_key() {
    let refused = |form| Crater::new(form).expect_err("refused").key;
    assert_eq!(refused(CraterForm { radius: 0.0, ..form() }), "radius_m");
    assert_eq!(refused(CraterForm { radius: f64::NAN, ..form() }), "radius_m");
    assert_eq!(refused(CraterForm { wall: 1.1, ..form() }), "wall_percent");
    assert_eq!(refused(CraterForm { depth: -0.1, ..form() }), "depth_percent");
    assert_eq!(refused(CraterForm { extent: 1.0, ..form() }), "extent");
    assert_eq!(refused(CraterForm { decay: Decay::Exponential(0.0), ..form() }), "decay_constant");
    assert_eq!(refused(CraterForm { impact_elevation: radians(91.0), ..form() }), "impact_elevation_deg");
    assert_eq!(refused(CraterForm { impact_direction: f64::NAN, ..form() }), "impact_direction_deg");
    assert_eq!(refused(CraterForm { centre: [f64::NAN, 0.0], ..form() }), "longitude_deg");
    let told = Crater::new(CraterForm { wall: 1.5, ..form() }).expect_err("refused").to_string();
    assert_eq!(told, "`wall_percent` is 150: expected 0 to 100 % of the radius");
}

#[test]
fn the_nearest_crater_has_the_same_bowl_and_the_difference_that_is_told() {
    for decay in [Decay::Exponential(4.0), Decay::Exponential(12.0), Decay::Linear] {
        let crater = Crater::new(CraterForm { decay, ..form() }).unwrap();
        let nearest = crater.nearest().unwrap();
        let apart =
            |distance: f64| (crater.height([distance, 0.0]) - nearest.crater.profile(distance)[0]).abs();
        let bowl = (0..9128).map(|k| apart(0.1 * f64::from(k))).fold(0.0, f64::max);
        assert!(bowl < 1e-9, "{bowl}");
        let largest = (0..30_000).map(|k| apart(0.1 * f64::from(k))).fold(0.0, f64::max);
        assert!(largest <= 1.02 * nearest.largest_difference, "{largest} of {nearest:?}");
        assert!(largest >= 0.9 * nearest.largest_difference, "{largest} of {nearest:?}");
        // Another rim is no nearer.
        let outer = nearest.crater.outer();
        for (outer, rim) in [(1.05, 1.0), (0.95, 1.0), (1.0, 1.05), (1.0, 0.95)].map(|(a, b)| (a * outer, b))
        {
            let foot = nearest.crater.foot();
            let shape = features::Shape::RimmedBowl { r1: foot, r2: outer.max(foot + 1.0) };
            let other = features::Crater::new([0.0; 2], shape, 200.0, rim * nearest.crater.rim()).unwrap();
            let apart = (0..30_000)
                .map(|k| 0.1 * f64::from(k))
                .map(|distance| (crater.height([distance, 0.0]) - other.profile(distance)[0]).abs());
            assert!(apart.fold(0.0, f64::max) > nearest.largest_difference * 0.98);
        }
    }
}

#[test]
fn a_crater_that_the_machine_cannot_draw_has_no_nearest() {
    let oblique = Crater::new(CraterForm { impact_elevation: radians(40.0), ..form() }).unwrap();
    assert_eq!(oblique.nearest(), Err(NoNearest::Oblique));
    let flat = Crater::new(CraterForm { depth: 0.0, ..form() }).unwrap();
    assert_eq!(flat.nearest(), Err(NoNearest::Flat));
    let without_wall = Crater::new(CraterForm { wall: 0.0, ..form() }).unwrap().nearest().unwrap();
    near(without_wall.largest_difference, 0.0, 1e-12);
}

proptest! {
    #[test]
    fn a_straight_impact_is_a_surface_of_revolution_to_the_bit(
        north in -3000.0..3000.0f64, east in -3000.0..3000.0f64, direction in 0.0..6.0f64,
    ) {
        let height = |direction| {
            Crater::new(CraterForm { impact_direction: direction, ..form() }).unwrap().height([north, east])
        };
        prop_assert_eq!(height(direction).to_bits(), height(0.0).to_bits());
        let distance = (north * north + east * east).sqrt();
        prop_assert_eq!(height(direction).to_bits(), self::height(form(), distance).to_bits());
    }

    #[test]
    fn nothing_lies_beyond_the_reach_and_heights_are_continuous(
        elevation in 0.0..1.6f64, azimuth in 0.0..6.2f64, q in 0.0..3.0f64, turn in 0.0..6.3f64,
    ) {
        let form = CraterForm { impact_elevation: elevation.min(FRAC_PI_2), impact_direction: azimuth, ..form() };
        let crater = Crater::new(form).unwrap();
        let (sin, cos) = sin_cos(turn);
        let at = |distance: f64| crater.height([distance * cos, distance * sin]);
        prop_assert_eq!(at(crater.reach() * (1.0 + q)), 0.0);
        let distance = 1000.0 * q;
        prop_assert!((at(distance) - at(distance + 1e-6)).abs() < 2e-6);
    }
}
