//! Photographs over their ground, where no camera stood: the closed loop against `exact`.

use std::sync::Arc;

use generator::{PlaneKind, Planes, Session, Stage};
use landscape::Landscape;
use lunoid_tests::Shipped;
use photo_make::{Reach, Wishes, make};
use photograph::Photograph;
use picture::{Depth, Transfer};
use quantities::{degrees, radians};
use scenario::{Curvature, PixelRule, RollDisplay};
use signal::Probe;

/// Middle of the flight, between the hills.
const FRAME: u64 = 60;

/// In the first turn of the flight over a photograph.
const FLIGHT_FRAME: u64 = 70;

/// The scenario in a small picture.
fn shipped(change: impl FnOnce(&mut scenario::Scenario)) -> Shipped {
    Shipped::changed("photo-drape", None, |scenario| {
        (scenario.raster.columns, scenario.raster.lines) = (Some(320), Some(240));
        change(scenario);
    })
}

fn session(stage: Stage, sets: &[(&str, &str)]) -> Box<dyn Session> {
    let generator =
        registry::configure_with(&::panels::ROW, sets).unwrap_or_else(|problems| panic!("{problems}"));
    generator.prepare(stage).unwrap()
}

/// A vertical photograph of all the ground with pixels of so many metres, in 16 bits.
fn photograph(stage: &Stage, pixel: f64) -> Photograph {
    let pixels = (800.0 / pixel) as u32;
    let wishes = Wishes {
        centre: [400.0, 400.0],
        size: [pixels; 2],
        ground_sample: pixel,
        reach: Reach::Field(radians(20.0)),
        focal_length: 0.15,
        heading: 0.0,
        pitch: -std::f64::consts::FRAC_PI_2,
        roll: 0.0,
        time: 0.0,
        depth: Depth::Sixteen,
        transfer: Transfer::new(1.0, 1.0).unwrap(),
        noise: 0.0,
        seed: 1,
    };
    let made = make(stage, &wishes).unwrap();
    let (camera, axes) = (made.file.camera, made.file.axes);
    Photograph::new(made.picture, photograph::Placement::Camera { camera, axes }, made.file.light).unwrap()
}

/// Mean distance of light over the pixels that show ground in both.
fn apart(a: &Planes, b: &Planes) -> f64 {
    let [a_light, b_light] = [a, b].map(|planes| planes.get(PlaneKind::Intensity).unwrap());
    let [a_range, b_range] = [a, b].map(|planes| planes.get(PlaneKind::Range).unwrap());
    let both: Vec<usize> = (0..a_light.len()).filter(|at| a_range[*at] > 0.0 && b_range[*at] > 0.0).collect();
    both.iter().map(|at| f64::from((a_light[*at] - b_light[*at]).abs())).sum::<f64>() / both.len() as f64
}

#[test]
fn the_closed_loop_closes_as_pixels_become_smaller() {
    let bare = shipped(|scenario| {
        scenario.features.populations.clear();
        scenario.laws.curvature = Some(Curvature::None);
        scenario.laws.pixel_rule = Some(PixelRule::Centre);
    });
    let stage = bare.stage().stage();
    let exact = bare.exact(FRAME).planes;
    let loops = [16.0, 8.0, 4.0, 2.0].map(|pixel| {
        let photographs: Arc<[Photograph]> = vec![photograph(&stage, pixel)].into();
        let landscape: Landscape = (*stage.landscape).clone().with_photographs(photographs);
        let draped = Stage { landscape: Arc::new(landscape), ..stage.clone() };
        let session = session(draped, &[("panels.spacing_m", "2"), ("panels.pattern", "\"1\"")]);
        apart(&bare.draw(&*session, FRAME, &mut Probe::off()).planes, &exact)
    });
    // Over three halvings, fitted by the ends.
    let order = libm::log2(loops[0] / loops[3]) / 3.0;
    assert!(order >= 0.9, "order {order}: {loops:?}");
}

#[test]
fn the_flight_leans_as_its_path_says() {
    let flight = |display| {
        Shipped::changed("photo-flight", None, |scenario| {
            (scenario.raster.columns, scenario.raster.lines) = (Some(160), Some(120));
            scenario.roll = display;
        })
    };
    let [leaning, upright] = [RollDisplay::Yoke, RollDisplay::None].map(flight);
    let of = |shipped: &Shipped| {
        let session = session(shipped.stage().stage(), &[]);
        shipped.draw(&*session, FLIGHT_FRAME, &mut Probe::off()).planes
    };
    let yoke = degrees(leaning.pose(FLIGHT_FRAME).pose.yoke);
    assert!((yoke + 18.2).abs() < 0.1, "{yoke}");
    assert_eq!(upright.pose(FLIGHT_FRAME).pose.yoke, 0.0);
    let found = of(&leaning);
    let [exact, turned] =
        [leaning.exact(FLIGHT_FRAME).planes, of(&upright)].map(|other| apart(&found, &other));
    assert!((exact - 0.0015).abs() < 0.00005 && turned > 10.0 * exact, "{exact} {turned}");
}

#[test]
fn the_figures_of_the_scenario_hold() {
    let shipped = shipped(|_| {});
    let exact = shipped.exact(FRAME).planes;
    let of = |sets: &[(&str, &str)]| {
        let session = session(shipped.stage().stage(), sets);
        apart(&shipped.draw(&*session, FRAME, &mut Probe::off()).planes, &exact)
    };
    let [texture, panel] = [of(&[]), of(&[("panels.drape", "panel"), ("panels.spacing_m", "16")])];
    assert!((texture - 0.0015).abs() < 0.00005 && (panel - 0.0148).abs() < 0.00005, "{texture} {panel}");
}
