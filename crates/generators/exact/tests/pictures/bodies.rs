//! Bodies in the picture: places, depth, and the rule of the report.

use std::sync::Arc;

use crate::scenes::{
    landscape, laws, level, plane, planes, pose, ray, settings, standing_box, sun, sunk_box, value,
};
use generator::{Label, PlaneKind, Shade};
use glam::DVec3;
use hardware_model::Settings;
use landscape::{Landscape, Photometry, parabolic_drop};
use scenario::{
    BodyVisibility, Curvature, Laws, PixelRule, Pose, Projection, Scenery, ShadowFineness, ShadowedBodies,
    Standing,
};
use solids::Solid;

const PIXELS: [u32; 2] = [61, 81];

fn body_settings(laws: Laws) -> Settings {
    settings(PIXELS[0], PIXELS[1], laws, [1.0, 150.0])
}

fn usual(visibility: BodyVisibility) -> Laws {
    let laws = laws(Projection::Exact, Curvature::None, PixelRule::Centre);
    Laws { body_visibility: visibility, ..laws }
}

/// Range at which a ray comes into a box along the axes, and the axis of that side: slab by slab.
fn into_box(low: [f64; 3], high: [f64; 3], eye: [f64; 3], direction: [f64; 3]) -> Option<(f64, usize)> {
    let (mut into, mut out) = ((f64::NEG_INFINITY, 0), f64::INFINITY);
    for axis in 0..3 {
        let ends = [(low[axis] - eye[axis]) / direction[axis], (high[axis] - eye[axis]) / direction[axis]];
        let (first, last) = (ends[0].min(ends[1]), ends[0].max(ends[1]));
        into = if first > into.0 { (first, axis) } else { into };
        out = out.min(last);
    }
    (into.0 <= out && into.0 > 0.0).then_some(into)
}

fn culture(found: &generator::Planes) -> Vec<usize> {
    let labels = found.get(PlaneKind::Label).unwrap();
    let code = f32::from(Label::Culture.code());
    (0..labels.len()).filter(|&index| labels[index] == code).collect()
}

#[test]
fn a_box_stands_where_it_stands() {
    let ground = landscape(plane(50.0, [6, 6], 0.0, [0.0; 2]), 0.5);
    for (curvature, turn) in [(Curvature::None, 0.0), (Curvature::Parabolic, 0.0), (Curvature::None, 0.4)] {
        let settings = body_settings(Laws { curvature, ..usual(BodyVisibility::Depth) });
        let pose = Pose { yoke: turn, ..pose([100.3, 90.2, 2.5], -4.0, 37.0) };
        let foot = [115.0, 104.0, 0.0];
        let light = sun(250.0, 20.0);
        let scenery = Scenery::still(light).with_bodies(vec![standing_box(0, foot, 1.5, 2.0)]);
        let found = planes(&ground, scenery, &settings, &pose);
        let range = libm::hypot(foot[0] - pose.eye[0], foot[1] - pose.eye[1]);
        let drop = if curvature == Curvature::None { 0.0 } else { parabolic_drop(range) };
        let (low, high) = ([113.5, 102.5, -drop], [116.5, 105.5, 2.0 - drop]);
        let mut seen = 0;
        for index in 0..(PIXELS[0] * PIXELS[1]) as usize {
            let ray = ray(&settings, &pose, index);
            let expected = into_box(low, high, pose.eye, [ray.direction[0], ray.direction[1], ray.rise]);
            let expected = expected.filter(|(range, _)| pose.eye[2] + range * ray.rise > -drop + 1e-9);
            let is_body = value(&found, PlaneKind::Label, index) == 4.0;
            assert_eq!(is_body, expected.is_some(), "{index}");
            let Some((at, axis)) = expected else { continue };
            assert!((value(&found, PlaneKind::Range, index) / at - 1.0).abs() < 1e-6);
            let side = [[-1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, 1.0]][axis];
            let normal = [PlaneKind::NormalNorth, PlaneKind::NormalEast, PlaneKind::NormalUp]
                .map(|kind| value(&found, kind, index));
            assert_eq!(normal, side);
            let lit: f64 = (0..3).map(|k| side[k] * light.direction()[k]).sum();
            assert!((value(&found, PlaneKind::Intensity, index) - lit.max(0.0)).abs() < 1e-7);
            let height = pose.eye[2] + at * ray.rise + drop;
            assert!((value(&found, PlaneKind::Height, index) - height).abs() < 1e-6);
            seen += 1;
        }
        assert!(seen > 80, "{seen}");
    }
}

/// Light by the law of the box, pixel by pixel: the mirrored sun and the ray of the pixel.
#[test]
fn a_box_returns_light_by_a_law_of_its_own() {
    let ground = landscape(plane(50.0, [6, 6], 0.0, [0.0; 2]), 0.5);
    let settings = body_settings(usual(BodyVisibility::Depth));
    // Its southern side mirrors this sun to the eye.
    let (pose, light) = (pose([100.3, 90.2, 2.5], -4.0, 37.0), sun(137.0, 8.0));
    let gloss = Photometry::Specular { strength: 3.0, exponent: 6 };
    let mut standing = standing_box(0, [115.0, 104.0, 0.0], 1.5, 2.0);
    let solid = Solid::boxed(DVec3::new(-1.5, -1.5, 0.0), DVec3::new(1.5, 1.5, 2.0), 0.25).unwrap();
    standing.body = standing.body.shaped(&Arc::new(solid.reflecting(gloss)));
    let scenery = Scenery::still(light).with_bodies(vec![standing]);
    let found = planes(&ground, scenery, &settings, &pose);
    let pixels = culture(&found);
    assert!(pixels.len() > 80, "{}", pixels.len());
    let mut most: f64 = 0.0;
    for index in pixels {
        let normal = DVec3::from_array(
            [PlaneKind::NormalNorth, PlaneKind::NormalEast, PlaneKind::NormalUp]
                .map(|kind| value(&found, kind, index)),
        );
        let ray = ray(&settings, &pose, index);
        let (to_eye, to_sun) = (
            -DVec3::new(ray.direction[0], ray.direction[1], ray.rise).normalize(),
            DVec3::from_array(light.direction()),
        );
        let lambert = normal.dot(to_sun).max(0.0);
        let mirrored = 2.0 * normal.dot(to_sun) * normal - to_sun;
        let shine = if lambert > 0.0 { 3.0 * libm::pow(mirrored.dot(to_eye).max(0.0), 6.0) } else { 0.0 };
        let expected = 0.25 * lambert * (1.0 + shine);
        assert!((value(&found, PlaneKind::Intensity, index) - expected).abs() < 1e-7, "{index}");
        most = most.max(shine);
    }
    assert!(most > 2.0, "a highlight must show: {most}");
}

/// Level ground with a ridge 3 m high across at x = 60 m.
fn ridge() -> Arc<Landscape> {
    let height = |m: f64| if m == 6.0 { 3.0 } else { 0.0 };
    landscape(level(10.0, [12, 6], |m, _| [height(m), 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]), 0.5)
}

fn draw(bodies: Vec<Standing>, laws: Laws, shadows: bool, light: landscape::Sun) -> generator::Planes {
    let shadows = shadows.then(ShadowFineness::default);
    let settings = Settings { shadows, ..body_settings(laws) };
    let scenery = Scenery::still(light).with_bodies(bodies);
    planes(&ridge(), scenery, &settings, &pose([30.0, 30.0, 3.2], 0.0, 0.0))
}

/// A box 4 m high behind a ridge of 3 m: its foot is hidden, its head is not.
#[test]
fn behind_a_ridge_by_depth_and_as_reported() {
    let behind = || vec![standing_box(0, [80.0, 30.0, 0.0], 2.0, 4.0)];
    let light = sun(100.0, 40.0);
    let by_depth = culture(&draw(behind(), usual(BodyVisibility::Depth), false, light));
    assert!(by_depth.len() > 5, "{by_depth:?}");
    assert!(culture(&draw(behind(), usual(BodyVisibility::AsReported), false, light)).is_empty());
    let before = || vec![standing_box(0, [45.0, 30.0, 0.0], 2.0, 4.0)];
    let pictures = [BodyVisibility::Depth, BodyVisibility::AsReported]
        .map(|law| draw(before(), usual(law), false, light));
    assert_eq!(pictures[0], pictures[1], "in the open both laws agree");
    // Sunk into the ground, its foot point in sight: drawn whole.
    let sunk = sunk_box(0, [45.0, 30.0, 0.0], 2.0, [-1.5, 2.5]);
    let [cut, whole] = [BodyVisibility::Depth, BodyVisibility::AsReported]
        .map(|law| culture(&draw(vec![sunk.clone()], usual(law), false, light)).len());
    assert!(cut > 10 && whole > cut, "{cut} {whole}");
}

#[test]
fn the_nearer_body_hides_the_farther() {
    for law in [BodyVisibility::Depth, BodyVisibility::AsReported] {
        let near = standing_box(0, [45.0, 30.0, 0.0], 1.0, 1.0);
        let far = standing_box(1, [50.0, 30.0, 0.0], 1.0, 1.0);
        let alone = culture(&draw(vec![near.clone()], usual(law), false, sun(100.0, 40.0)));
        let both = draw(vec![far, near], usual(law), false, sun(100.0, 40.0));
        for index in alone {
            assert!(value(&both, PlaneKind::Range, index) < 17.0);
        }
        assert!(culture(&both).iter().any(|&index| value(&both, PlaneKind::Range, index) > 18.0));
    }
}

#[test]
fn bodies_in_remote_shadow() {
    // The sun is 3 degrees high in the north: the ridge's shadow goes 57 m to the south.
    let body = || vec![standing_box(0, [45.0, 30.0, 0.0], 1.0, 1.0)];
    let laws = |shadowed_bodies| Laws { shadowed_bodies, ..usual(BodyVisibility::Depth) };
    let vanished = draw(body(), laws(ShadowedBodies::Vanish), true, sun(0.0, 3.0));
    assert!(culture(&vanished).is_empty());
    let dark = draw(body(), laws(ShadowedBodies::Dark), true, sun(0.0, 3.0));
    let (mut top, pixels) = (0, culture(&dark));
    assert!(pixels.len() > 10);
    for index in pixels {
        assert_eq!(value(&dark, PlaneKind::Intensity, index), 0.0);
        let is_top = value(&dark, PlaneKind::NormalUp, index) == 1.0;
        let shade = if is_top { Shade::Remote } else { Shade::Local };
        assert_eq!(value(&dark, PlaneKind::Shadow, index), f64::from(shade.code()));
        top += usize::from(is_top);
    }
    assert!(top > 0);
}

#[test]
fn bodies_come_and_go() {
    let one = Standing { from: 0.0, until: 5.0, ..standing_box(0, [45.0, 30.0, 0.0], 1.0, 1.0) };
    let scenery = Scenery::still(sun(100.0, 40.0)).with_bodies(vec![one]);
    let counts = [0.0, 4.9, 5.0].map(|time| {
        let pose = Pose { time, ..pose([30.0, 30.0, 3.2], 0.0, 0.0) };
        culture(&planes(&ridge(), scenery.clone(), &body_settings(usual(BodyVisibility::Depth)), &pose)).len()
    });
    assert!(counts[0] > 10 && counts[0] == counts[1] && counts[2] == 0, "{counts:?}");
}

/// A pole thinner than a line, lying across: its edges are known, so the line's mean has its share.
#[test]
fn a_body_smaller_than_a_line_has_its_share() {
    let ground = landscape(plane(50.0, [6, 6], 0.0, [0.0; 2]), 0.0);
    let settings = settings(
        1,
        30,
        Laws { pixel_rule: PixelRule::LineMean, ..usual(BodyVisibility::Depth) },
        [1.0, 150.0],
    );
    let pose = pose([100.0, 90.0, 2.0], 0.0, 0.0);
    let body = standing_box(0, [120.0, 90.0, 2.0], 0.01, 0.02);
    let light = sun(180.0, 30.0);
    let found = planes(&ground, Scenery::still(light).with_bodies(vec![body]), &settings, &pose);
    let sum: f64 = (0..30).map(|index| value(&found, PlaneKind::Intensity, index)).sum();
    // The south side, 0.02 m at 19.99 m, faces the sun at 30 degrees; the top is edge-on.
    let line = 2.0 * settings.raster.field.tan_half_height / 30.0;
    let expected = 0.02 / 19.99 / line * libm::cos(light.elevation);
    assert!((sum - expected).abs() < 1e-4, "{sum}, not {expected}");
}
