//! Scenes whose picture is known.

use generator::{Label, PlaneKind, Shade};
use landscape::LUNOID_RADIUS;
use quantities::radians;
use scenario::{Curvature, Laws, View};

use crate::scenes::{Given, bowl, draw, plain, pose, settings, sun, unrestricted, value};

fn curved(settings: Given) -> Given {
    let laws = Laws { curvature: Curvature::Parabolic, ..settings.view.laws };
    Given { view: View { laws, ..settings.view }, ..settings }
}

/// Straight down from a height, the middle of pixel (column, line) is this far north and east of the foot point (m).
fn below(height: f64, settings: &Given, [column, line]: [usize; 2]) -> [f64; 2] {
    let half = settings.view.field.tan_half_width;
    let place =
        |pixel: usize| half * (f64::from(2 * pixel as u32 + 1) / f64::from(settings.view.columns) - 1.0);
    [-height * place(line), height * place(column)]
}

#[test]
fn level_ground_is_sin_e_everywhere() {
    let settings = settings(64, 30.0, 128);
    for (pitch, heading) in [(-20.0, 0.0), (-45.0, 90.0), (-90.0, 180.0), (-75.0, 270.0)] {
        let planes = draw(
            &plain(40_000.0, vec![]),
            sun(90.0, 25.0),
            &settings,
            &pose([20_000.0, 20_000.0, 1000.0], pitch, heading),
        );
        let expected = libm::sin(radians(25.0)) as f32;
        for kind in [PlaneKind::Reflectivity, PlaneKind::Label] {
            let expected = if kind == PlaneKind::Label { f32::from(Label::Terrain.code()) } else { expected };
            let wrong = planes.get(kind).unwrap().iter().filter(|value| **value != expected).count();
            assert_eq!(wrong, 0, "{kind:?} at pitch {pitch}, heading {heading}");
        }
    }
}

/// Ground range of a pixel is height over depression, to a grid step.
#[test]
fn ground_range_is_height_over_depression() {
    let settings = settings(64, 30.0, 1024);
    let planes = draw(
        &plain(40_000.0, vec![]),
        sun(0.0, 25.0),
        &settings,
        &pose([1000.0, 20_000.0, 2000.0], -35.0, 0.0),
    );
    let half = settings.view.field.tan_half_height;
    // The area reaches from 50 to 20 degrees of depression.
    let step = 2000.0 * (1.0 / libm::tan(radians(20.0)) - 1.0 / libm::tan(radians(50.0))) / 1023.0;
    for line in 0..64 {
        let y = half * ((2 * line + 1) as f64 / 64.0 - 1.0);
        let expected = 2000.0 / libm::tan(radians(35.0) + libm::atan(y));
        let found = value(&planes, PlaneKind::Range, [32, line]);
        // Half a position of the recorder beside a step of the grid.
        let position = expected * expected / 2000.0 * half / 1024.0 * 2.0;
        assert!((found - expected).abs() < 1.5 * step + position, "line {line}: {found}, not {expected}");
    }
}

/// A paraboloid has slopes that grow with the radius: central differences have them exactly, and what is left is the
/// step from the point drawn to the middle of the pixel.
#[test]
fn a_bowl_is_lit_by_the_law_of_its_slopes() {
    let (r1, depth, height) = (400.0, 60.0, 3000.0);
    let settings = settings(128, 20.0, 512);
    let landscape = plain(20_000.0, vec![bowl([10_000.0; 2], r1, depth)]);
    let light = sun(270.0, 40.0);
    let planes = draw(&landscape, light, &settings, &pose([10_000.0, 10_000.0, height], -90.0, 0.0));
    let step = 2.0 * (height + depth) * settings.view.field.tan_half_width / 511.0;
    let bend = 2.0 * depth / (r1 * r1);
    let mut inside = 0;
    for pixel in 0..128 * 128 {
        let at = [pixel % 128, pixel / 128];
        // The bowl's ground lies up to 60 m deeper, and so a little farther out than level ground would.
        let [north, east] = below(height, &settings, at);
        if (north * north + east * east).sqrt() > r1 - 5.0 * step {
            continue;
        }
        let lower = depth * (1.0 - (north * north + east * east) / (r1 * r1));
        let [north, east] = [north, east].map(|place| place * (1.0 + lower / height));
        let expected = light.reflectivity([bend * north, bend * east]);
        let found = value(&planes, PlaneKind::Reflectivity, at);
        assert!((found - expected).abs() < 2.0 * bend * step, "pixel {at:?}: {found}, not {expected}");
        inside += 1;
    }
    assert!(inside > 6000, "{inside}");
}

/// Check value 23.4: at 5 degrees of sun the shadow in a bowl of radius 100 m and depth 20 m ends 56.2557 m beyond
/// its centre, whichever cardinal point the sun stands on.
#[test]
fn the_shadow_in_a_bowl_ends_where_the_sunlight_comes_over_its_rim() {
    let settings = settings(256, 6.0, 1024);
    let landscape = plain(8000.0, vec![bowl([4000.0; 2], 100.0, 20.0)]);
    for azimuth in [0.0, 90.0, 180.0, 270.0] {
        let planes =
            draw(&landscape, sun(azimuth, 5.0), &settings, &pose([4000.0, 4000.0, 3000.0], -90.0, 0.0));
        let away = |at: [usize; 2]| {
            let [north, east] = below(3000.0, &settings, at);
            let towards = sun(azimuth, 0.0).direction();
            -(north * towards[0] + east * towards[1])
        };
        let line_of_sight =
            (0..256).map(|pixel| if azimuth % 180.0 == 0.0 { [128, pixel] } else { [pixel, 128] });
        let dark =
            line_of_sight.filter(|at| value(&planes, PlaneKind::Shadow, *at) != f64::from(Shade::Lit.code()));
        let end = dark.map(away).fold(f64::NEG_INFINITY, f64::max);
        // A pixel is 1.23 m, a step of the grid 0.32 m.
        assert!((end - 56.2557).abs() < 1.6, "sun at {azimuth}: {end}");
    }
}

/// The lunoid's horizon lies sqrt(2 H / R) below the horizontal; on a flat Moon the picture goes on to the end of the
/// range.
#[test]
fn the_horizon_of_the_curved_lunoid() {
    let height = 200.0;
    let level = unrestricted(settings(512, 4.0, 1024));
    let landscape = plain(120_000.0, vec![]);
    let eye = pose([100.0, 60_000.0, height], 0.0, 0.0);
    let half = level.view.field.tan_half_height;
    for (settings, dip) in [
        (curved(level.clone()), (2.0 * height / LUNOID_RADIUS).sqrt()),
        (level.clone(), height / level.view.ranges[1]),
    ] {
        let planes = draw(&landscape, sun(90.0, 30.0), &settings, &eye);
        let first = (0..512).find(|line| value(&planes, PlaneKind::Range, [256, *line]).is_finite()).unwrap();
        let expected = 256.0 * (1.0 + dip / half);
        assert!((first as f64 - expected).abs() < 1.5, "{first}, not {expected}");
        assert_eq!(value(&planes, PlaneKind::Label, [256, 0]), f64::from(Label::Sky.code()));
    }
}

/// Slopes are those of heights from which the drop is taken off: far ground leans away from the observer by s / R.
#[test]
fn light_turns_with_the_lunoid() {
    let settings = curved(settings(32, 10.0, 256));
    let planes = draw(
        &plain(60_000.0, vec![]),
        sun(0.0, 10.0),
        &settings,
        &pose([100.0, 30_000.0, 5000.0], -12.0, 0.0),
    );
    for line in 0..32 {
        let range = value(&planes, PlaneKind::Range, [16, line]);
        let found = value(&planes, PlaneKind::Reflectivity, [16, line]);
        let expected = sun(0.0, 10.0).reflectivity([-range / LUNOID_RADIUS, 0.0]);
        // The middle column is half a pixel beside the line of sight, and the farthest row has one neighbour.
        assert!((found - expected).abs() < 1e-4, "{range} m: {found}, not {expected}");
        assert!(found > libm::sin(radians(10.0)) + 0.9 * range / LUNOID_RADIUS);
    }
}
