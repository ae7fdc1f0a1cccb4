//! The yoke, and mountains beyond the ground.

use crate::scenes::{bumps, landscape, laws, plane, planes, pose, ray, settings, standing_box, sun, value};
use generator::{FrameError, Generator, Label, PlaneKind, Planes, Stage};
use landscape::{Landscape, Silhouette};
use quantities::radians;
use scenario::{Curvature, PixelRule, Pose, Projection, Scenery};
use signal::Probe;
use std::sync::Arc;

/// Turned by half a turn the picture stands on its head: same pixels, in reverse order.
#[test]
fn half_a_turn() {
    let ground = landscape(bumps(2, 0.6), 1.0);
    let height = ground.height(20.0, 20.0).unwrap() + 1.5;
    let scenery = || {
        Scenery::still(sun(100.0, 20.0)).with_bodies(vec![standing_box(
            0,
            [24.0, 25.0, height - 2.0],
            0.7,
            1.0,
        )])
    };
    for projection in [Projection::Exact, Projection::AsReported] {
        let settings = settings(20, 16, laws(projection, Curvature::None, PixelRule::Centre), [0.5, 45.0]);
        let upright = pose([20.0, 20.0, height], -6.0, 50.0);
        let turned = Pose { yoke: std::f64::consts::PI, ..upright };
        let [upright, turned] = [upright, turned].map(|pose| planes(&ground, scenery(), &settings, &pose));
        for kind in [PlaneKind::Label, PlaneKind::Range, PlaneKind::Intensity] {
            for index in 0..320 {
                let [a, b] = [value(&upright, kind, index), value(&turned, kind, 319 - index)];
                assert!(a == b || (a / b - 1.0).abs() < 1e-5, "{projection:?} {kind:?} {index}: {a} {b}");
            }
        }
    }
}

/// A level horizon under a vehicle with starboard down rises to the right: there the screen looks lower.
#[test]
fn the_horizon_leans() {
    let ground = landscape(plane(40.0, [20, 20], 0.0, [0.0; 2]), 1.0);
    let settings =
        settings(21, 400, laws(Projection::Exact, Curvature::None, PixelRule::Centre), [0.5, 390.0]);
    let pose = Pose { yoke: radians(10.0), ..pose([400.0, 400.0, 0.01], 0.0, 0.0) };
    let found = planes(&ground, Scenery::still(sun(0.0, 30.0)), &settings, &pose);
    let labels = found.get(PlaneKind::Label).unwrap();
    let field = settings.raster.field;
    for column in 0..21 {
        let x = field.tan_half_width * ((2 * column + 1) as f64 / 21.0 - 1.0);
        let first = (0..400).find(|line| labels[line * 21 + column] != 0.0).unwrap();
        let y = field.tan_half_height * (2.0 * first as f64 / 400.0 - 1.0);
        let expected = -x * libm::tan(radians(10.0));
        assert!((y - expected).abs() < 2e-3, "{x}: {y}, not {expected}");
    }
}

/// The tangent of `as-reported` has a pole, which the corners of a turned screen reach first.
#[test]
fn a_law_without_rays_is_refused_by_name() {
    let landscape = landscape(plane(40.0, [4, 4], 0.0, [0.0; 2]), 1.0);
    let frame = |projection, pitch: f64, yoke: f64| {
        let settings = settings(4, 4, laws(projection, Curvature::None, PixelRule::Centre), [0.5, 390.0]);
        let scenery = Arc::new(Scenery::still(sun(0.0, 9.0)));
        let session = exact::Exact
            .prepare(Stage { landscape: Arc::clone(&landscape), scenery, view: settings.view() })
            .unwrap();
        let pose = Pose { yoke: radians(yoke), ..pose([80.0, 80.0, 2.0], pitch, 0.0) };
        session.frame(3, &pose, &mut Planes::new(4, 4, &[PlaneKind::Intensity]), &mut Probe::off())
    };
    for pitch in [74.9, -74.9] {
        assert!(frame(Projection::AsReported, pitch, 0.0).is_ok());
        let refused = frame(Projection::AsReported, pitch, 40.0).unwrap_err();
        let text = "exact cannot draw a view 101.7 deg above or below the horizontal under the projection law as-reported, \
                    which has no ray at 90 deg or beyond: look less steeply, or set dpp.projection to exact";
        assert_eq!(refused, FrameError::Refused { frame: 3, reason: text.into() });
        assert!(frame(Projection::AsReported, 1.01 * pitch, 0.0).is_err());
    }
    for projection in [Projection::Corrected, Projection::Exact] {
        assert!([-180.0, -90.0, 75.0, 90.0].into_iter().all(|pitch| frame(projection, pitch, 40.0).is_ok()));
    }
}

#[test]
fn silhouettes_stand_in_the_sky() {
    let far = Silhouette::new(vec![[-0.3, 0.0], [0.1, 0.2], [0.3, 0.0]], 0.7).unwrap();
    let high = Silhouette::new(vec![[-1.0, 0.05], [1.0, 0.05]], 0.3).unwrap();
    let ground = Landscape::clone(&landscape(plane(40.0, [4, 4], 0.0, [0.0; 2]), 1.0));
    let ground = Arc::new(ground.with_silhouettes(vec![far.clone(), high]));
    let settings =
        settings(31, 40, laws(Projection::Exact, Curvature::None, PixelRule::Centre), [0.5, 390.0]);
    let pose = pose([80.0, 80.0, 2.0], 3.0, 0.0);
    let found = planes(&ground, Scenery::still(sun(0.0, 30.0)), &settings, &pose);
    let mut counts = [0; 4];
    for index in 0..31 * 40 {
        let ray = ray(&settings, &pose, index);
        let azimuth = libm::atan2(ray.direction[1], ray.direction[0]);
        let met = value(&found, PlaneKind::Range, index).is_finite();
        let (kind, intensity) = match ray.rise {
            _ if met => (0, 0.5),
            rise if far.tangent(azimuth).is_some_and(|tangent| rise < tangent) => (1, 0.7),
            rise if rise < 0.05 => (2, 0.3),
            _ => (3, 0.0),
        };
        counts[kind] += 1;
        assert!((value(&found, PlaneKind::Intensity, index) - intensity).abs() < 1e-7, "{index}");
        let label = [Label::Terrain, Label::Silhouette, Label::Silhouette, Label::Sky][kind];
        assert_eq!(value(&found, PlaneKind::Label, index), f64::from(label.code()));
    }
    assert!(counts.iter().all(|&count| count > 30), "{counts:?}");
}
