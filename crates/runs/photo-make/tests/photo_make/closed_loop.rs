//! Ground points of a photograph, projected by the camera file that was written, fall on the centres of their pixels.

use std::sync::Arc;

use exact::Exact;
use features::Features;
use generator::{Generator, PlaneKind, Planes, Stage};
use glam::DVec3;
use photo_camera::Image;
use photo_make::{Reach, Wishes, make};
use scenario::{Curvature, Laws, PixelRule, Projection, ShadowFineness, VehicleShape, View};
use signal::Probe;
use solids::Solid;

use crate::{attitudes, bumps, craters, plane, stage};

/// Largest residual that is allowed (pixels).
const RESIDUAL: f64 = 1e-6;

#[test]
fn every_ground_point_falls_on_the_centre_of_its_pixel() {
    let stage = stage(bumps(4.0), craters());
    for wishes in attitudes() {
        let made = make(&stage, &wishes).expect("a photograph");
        println!("pitch {:.2}: residual {:.1e} pixels", wishes.pitch, made.residual);
        assert!(made.residual < RESIDUAL, "{}", made.residual);
        let [columns, lines] = wishes.size.map(|count| count as usize);
        assert_eq!(made.ground.len(), columns * lines);
        // Once more by hand, and each point lies on the ground.
        for (at, point) in made.ground.iter().enumerate() {
            let Some(point) = point else { continue };
            let Image::Front { pixel, .. } = made.file.camera.project(*point) else { panic!("in front") };
            let centre = [(at % columns) as f64 + 0.5, (at / columns) as f64 + 0.5];
            assert!((pixel[0] - centre[0]).abs() < RESIDUAL && (pixel[1] - centre[1]).abs() < RESIDUAL);
            let ground = stage.landscape.height(point.y, point.x).expect("ground");
            assert!((ground - point.z).abs() < 1e-9, "{point}: {ground}");
        }
    }
}

/// The picture and the truth are of one ray: heights and shades of the drawn planes agree with the truth.
#[test]
fn the_picture_shows_the_ground_points() {
    let stage = stage(bumps(4.0), craters());
    for wishes in attitudes() {
        let made = make(&stage, &wishes).expect("a photograph");
        let [columns, lines] = wishes.size;
        let laws = Laws {
            projection: Projection::Exact,
            curvature: Curvature::None,
            pixel_rule: PixelRule::Centre,
            ..stage.view.laws
        };
        let field = made.stand.field;
        let view = View { columns, lines, field, laws, ranges: [0.0, 1e9], ..stage.view.clone() };
        let session = Exact.prepare(Stage { view, ..stage.clone() }).expect("a session");
        let mut planes =
            Planes::new(columns as usize, lines as usize, &[PlaneKind::Height, PlaneKind::Intensity]);
        session.frame(0, &made.stand.pose, &mut planes, &mut Probe::off()).expect("a frame");
        let heights = planes.get(PlaneKind::Height).expect("heights");
        let light = planes.get(PlaneKind::Intensity).expect("light");
        for (at, point) in made.ground.iter().enumerate() {
            let Some(point) = point else { continue };
            assert!((f64::from(heights[at]) - point.z).abs() < 1e-4, "{at}: {} {point}", heights[at]);
            let code = f64::from(made.picture.codes()[at]) / 65_535.0;
            assert!((code - f64::from(light[at])).abs() <= 0.5001 / 65_535.0, "{at}");
        }
    }
}

/// On a level plane the light is the sine of the sun's elevation, in every pixel.
#[test]
fn a_plane_has_the_light_of_its_sun() {
    let made =
        make(&stage(plane(5.0, [0.0; 2]), Features::default()), &crate::wishes()).expect("a photograph");
    let expected = libm::sin(35.0_f64.to_radians());
    for code in made.picture.codes() {
        assert!((f64::from(*code) / 65_535.0 - expected).abs() < 1e-5);
    }
    assert!(made.ground.iter().all(Option::is_some));
}

#[test]
fn threads_change_no_bit() {
    let stage = stage(bumps(4.0), craters());
    let wishes = attitudes().remove(3);
    let with = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
        pool.install(|| make(&stage, &wishes)).expect("a photograph")
    };
    let (one, three) = (with(1), with(3));
    assert_eq!((one.picture, one.ground, one.file), (three.picture, three.ground, three.file));
}

/// A vehicle that would stand under the camera casts no shadow, and shadow reaches as far as the picture.
#[test]
fn neither_the_vehicle_nor_the_reach_of_its_shadows_has_a_part() {
    let plain = stage(bumps(4.0), craters());
    let wishes = Wishes { reach: Reach::Height(60.0), ..crate::wishes() };
    let expected = make(&plain, &wishes).expect("a photograph").picture;
    let dark = expected.codes().iter().filter(|code| **code == 0).count();
    assert!(dark > 10, "{dark} dark pixels");
    let [low, high] = [-20.0, 20.0].map(DVec3::splat);
    let parts = vec![Arc::new(Solid::boxed(low, high, 1.0).expect("a box"))];
    let scenery = (*plain.scenery).clone().with_vehicle(Some(VehicleShape { parts, eye_height: 30.0 }));
    let near = ShadowFineness { reach: Some(1.0), ..ShadowFineness::default() };
    let view = View { shadows: Some(near), ..plain.view.clone() };
    let other = Stage { scenery: Arc::new(scenery), view, ..plain };
    assert_eq!(make(&other, &wishes).expect("a photograph").picture, expected);
}
