//! The error of the grid, and how it falls with the grid.

use std::sync::Arc;

use features::{Crater, Features, Shape};
use generator::Stage;
use landscape::relief::{Relief, Undulation};
use landscape::{Attitude, Bank, Landscape, Sun};
use lunsim::{Hardware, Lunsim, Parameters};
use quantities::{Rate, radians};
use scenario::{Curvature, Display, FieldOfView, Laws, PixelRule, Pose, Scenery, ShadowFineness, View};

use crate::lunsim::shared::{Distance, distance};

/// A square field of 30 degrees on every position of the recorder, so that a pixel's middle is a position's.
fn view() -> View {
    let half = libm::tan(radians(15.0));
    let update = Rate::new(1, 1).unwrap();
    View {
        columns: 1024,
        lines: 1024,
        field: FieldOfView { tan_half_width: half, tan_half_height: half },
        update,
        refresh: update,
        display: Display { white: 1.0, gamma: 1.0 },
        laws: Laws { curvature: Curvature::None, pixel_rule: PixelRule::Centre, ..Laws::default() },
        ranges: [1.0, 30_000.0],
        yoke: None,
        levels: None,
        shadows: Some(ShadowFineness::default()),
    }
}

fn program(grid: u32, restrictions: bool) -> Lunsim {
    let parameters = Parameters { grid, intensity_codes: 256, restrictions };
    Lunsim { parameters, hardware: Hardware::shipped().unwrap() }
}

/// One crater of each type, one in another.
fn craters() -> Features {
    let crater = |at: [f64; 2], shape, depth, rim| Crater::new(at, shape, depth, rim).unwrap();
    Features::new(vec![
        crater([5200.0, 3900.0], Shape::Bowl { r1: 500.0 }, 90.0, 0.0),
        crater([5300.0, 4900.0], Shape::RimmedBowl { r1: 350.0, r2: 500.0 }, 110.0, 25.0),
        crater([6500.0, 4100.0], Shape::FlatFloor { r1: 350.0, r2: 700.0, r3: 950.0 }, 140.0, 40.0),
        crater([6700.0, 3900.0], Shape::RimmedBowl { r1: 200.0, r2: 280.0 }, 50.0, 10.0),
    ])
}

fn stage(relief: &Relief, sun: f64) -> Stage {
    let bank = Bank::new("test", vec![relief.build().unwrap()], None).unwrap();
    let sun = Sun { azimuth: radians(sun), elevation: radians(14.0) };
    Stage {
        landscape: Arc::new(Landscape::new(bank, 1.0).with_features(craters())),
        scenery: Arc::new(Scenery::still(sun)),
        view: view(),
    }
}

fn pose(heading: f64) -> Pose {
    let attitude = Attitude { roll: 0.0, pitch: radians(-38.0), heading: radians(heading) };
    Pose { time: 0.0, eye: [3500.0, 4200.0, 1900.0], attitude, yoke: 0.0 }
}

/// Errors at grids of 64, 128, 256, 512 and 1024 points.
fn ladder(relief: &Relief, sun: f64, heading: f64, restrictions: bool) -> Vec<Distance> {
    let stage = stage(relief, sun);
    let at = |grid| distance(&program(grid, restrictions), &stage, 0, &pose(heading), 64);
    [64, 128, 256, 512, 1024].map(at).to_vec()
}

/// Reflectivity falls with the first order, shadow with it; the last grid is as near as docs/blocks/lunsim.md says.
fn expect_first_order(name: &str, ladder: &[Distance], documented: f64) {
    for (grid, found) in [64, 128, 256, 512, 1024].into_iter().zip(ladder) {
        println!("{name}, {grid} points: {found:?}");
        assert_eq!(found.missing, 0.0, "{name}, {grid} points");
    }
    for pair in ladder.windows(2) {
        let order = libm::log2(pair[0].reflectivity / pair[1].reflectivity);
        assert!((0.9..1.2).contains(&order), "{name}: order {order}");
        assert!(pair[1].shade < 0.75 * pair[0].shade, "{name}: {pair:?}");
    }
    let last = ladder[ladder.len() - 1];
    assert!((last.reflectivity - documented).abs() < 0.00005, "{name}: {last:?}, documented {documented}");
    assert!(last.shade < 0.005, "{name}: {last:?}");
}

/// What is drawn at a position is a grid point up to a step away, so the error is of first order in the step.
#[test]
fn the_error_falls_with_the_first_order_of_the_grid() {
    let flat = Relief::flat(1, [12_000.0, 9000.0], 300.0);
    expect_first_order("sun across", &ladder(&flat, 270.0, 0.0, true), 0.0015);
    expect_first_order("sun ahead", &ladder(&flat, 0.0, 0.0, true), 0.0015);
}

/// Lifted: rolling ground, a sun and a line of sight on no cardinal point.
#[test]
fn what_restrictions_forbade_converges_as_well() {
    let undulation =
        Undulation { rms_height: 15.0, hurst: 0.9, longest: 5000.0, shortest: 1000.0, waves: 60 };
    let rolling = Relief { undulation: Some(undulation), ..Relief::flat(4, [12_000.0, 9000.0], 300.0) };
    expect_first_order("lifted", &ladder(&rolling, 235.0, 12.0, false), 0.0018);
}
