//! What the program could not do: each refused with the report's reason, and drawn once it is lifted.

use std::sync::Arc;

use generator::{FrameError, Omission, PlaneKind, Planes, Weight};
use glam::{DMat3, DVec3};
use landscape::relief::Relief;
use landscape::{AlbedoMap, Landscape, Layer, Photometry, Silhouette, Source, Sun, Texels, Texture};
use lunsim::Parameters;
use scenario::{LevelSwitch, Pose, Scenery, Standing, TrackPatch};
use signal::Probe;
use solids::{Body, Kind, Solid};

use crate::scenes::{Scene, plain, pose, prepare, relief, settings, stage, sun};

const SIDE: f64 = 4000.0;

fn usual() -> Scene {
    stage(&plain(SIDE, vec![]), sun(270.0, 20.0), &settings(16, 30.0, 32))
}

fn lifted(stage: &Scene) -> Scene {
    let parameters = Parameters { restrictions: false, ..stage.parameters };
    Scene { parameters, ..stage.clone() }
}

/// What is said of `stage`; without restrictions it is drawn, and what is left out is listed.
fn refused(stage: Scene) -> (String, Vec<Omission>) {
    let message = prepare(stage.clone()).err().expect("a restriction").to_string();
    assert!(message.starts_with("lunsim cannot do "), "{message}");
    assert!(message.ends_with("--set lunsim.restrictions=false"), "{message}");
    let session = prepare(lifted(&stage)).expect("no restriction");
    let mut planes = Planes::new(16, 16, &PlaneKind::ALL);
    session.frame(0, &pose([100.0, 2000.0, 300.0], -35.0, 0.0), &mut planes, &mut Probe::off()).unwrap();
    assert!(planes.get(PlaneKind::Intensity).unwrap().iter().any(|value| *value > 0.0));
    (message, session.omissions())
}

fn over(landscape: Landscape) -> Scene {
    Scene { landscape: Arc::new(landscape), ..usual() }
}

fn with(change: impl Fn(&mut Scene)) -> Scene {
    let mut stage = usual();
    change(&mut stage);
    stage
}

#[test]
fn the_usual_stage_is_drawn_whole() {
    assert!(prepare(usual()).unwrap().omissions().is_empty());
}

#[test]
fn what_has_a_law_all_the_same() {
    let tilted = Relief { tilt: [0.01, 0.0], ..Relief::flat(1, [SIDE, SIDE], 100.0) };
    let level = (*plain(SIDE, vec![])).clone();
    let cases = [
        (
            Scene { landscape: relief(&tilted, vec![]), ..usual() },
            "ground of any relief ([landscape]: its surface is smooth",
        ),
        (over(level.with_photometry(Photometry::LunarLambert)), "another law of reflection"),
        (with(|scene| scene.parameters.grid = 1025), "a grid of 1025 points ([lunsim]: at most 1024"),
        (
            Scene { scenery: Arc::new(Scenery::still(sun(271.0, 20.0))), ..usual() },
            "a sun at azimuth 271.000 deg",
        ),
    ];
    for (stage, words) in cases {
        let (message, omissions) = refused(stage);
        assert!(message.contains(words), "{message}");
        assert!(omissions.is_empty(), "{words}: {omissions:?}");
    }
}

#[test]
fn what_has_no_law_is_left_out() {
    let level = (*plain(SIDE, vec![])).clone();
    let grain = Layer { cell: 1.0, amplitude: 0.1, range: 50.0 };
    let texture = Texture::new(&[grain], Source::Pattern, 1, 100.0, [0.0; 2]).unwrap();
    let outline = Silhouette::new(vec![[0.0, 0.0], [0.1, 0.02], [0.2, 0.0]], 0.5).unwrap();
    let patch = TrackPatch { laid: 5.0, corners: [[1.0, 1.0], [2.0, 1.0], [2.0, 2.0], [1.0, 2.0]] };
    let cube = Arc::new(Solid::boxed(DVec3::ZERO, DVec3::ONE, 0.9).unwrap());
    let body = Body::place(0, Kind::Rock, &cube, DVec3::new(2000.0, 2000.0, 0.0), &DMat3::IDENTITY, 1.0);
    let standing = Standing { from: 0.0, until: f64::INFINITY, body };
    let still = || Scenery::still(sun(270.0, 20.0));
    let map = AlbedoMap::new([0.0, 0.0, 9.0, 9.0], [1, 1], Texels::Grey(vec![0.5])).unwrap();
    let cases = [
        (over(level.clone().with_albedo_map(Some(map))), "a map of albedo"),
        (over(level.clone().with_texture(Some(texture))), "texture"),
        (over(level.with_silhouettes(vec![outline])), "far silhouettes"),
        (Scene { scenery: Arc::new(still().with_patches(vec![patch])), ..usual() }, "vehicle tracks"),
        (
            Scene { scenery: Arc::new(still().with_bodies(vec![standing])), ..usual() },
            "rocks and man-made things",
        ),
        (with(|scene| scene.view.levels = Some(LevelSwitch { range: 500.0, blend: 0.0 })), "a second level"),
        (with(|scene| scene.view.yoke = Some(hardware_model::HardwareModel::ideal().yoke)), "roll"),
    ];
    for (stage, words) in cases {
        let (message, omissions) = refused(stage);
        assert!(message.contains(words), "{message}");
        let [omission] = omissions.as_slice() else { panic!("{words}: {omissions:?}") };
        assert!(omission.what.contains(words) && omission.weight == Weight::NotModelled, "{omission:?}");
    }
}

#[test]
fn all_that_is_wrong_is_said_at_once() {
    let mut stage = usual();
    stage.parameters.grid = 2000;
    stage.scenery = Arc::new(Scenery::still(Sun { azimuth: 0.1, elevation: 0.2 }));
    let (message, _) = refused(stage);
    assert!(
        message.contains("a grid of 2000") && message.contains("a sun at azimuth 5.730 deg"),
        "{message}"
    );
}

#[test]
fn a_line_of_sight_is_cardinal_and_not_above_the_horizontal() {
    let draw = |stage: Scene, pose: &Pose| {
        let mut planes = Planes::new(16, 16, &[PlaneKind::Intensity]);
        prepare(stage).unwrap().frame(3, pose, &mut planes, &mut Probe::off()).map(|_| ())
    };
    let eye = [2000.0, 2000.0, 100.0];
    for (pose, words) in [
        (pose(eye, -30.0, 45.0), "a line of sight at heading 45.000 deg"),
        (pose(eye, -14.0, 90.0), "an upper edge of the picture 1.000 deg above the horizontal"),
    ] {
        let error = draw(usual(), &pose).unwrap_err();
        assert!(matches!(error, FrameError::Refused { frame: 3, .. }), "{error:?}");
        assert!(error.to_string().contains(&format!("frame 3: lunsim cannot do {words}")), "{error}");
        assert_eq!(draw(lifted(&usual()), &pose), Ok(()));
    }
    // Paths are written in degrees: their rounding is no restriction.
    for heading in [0.0, 90.0, 180.0, 270.0, -90.0, 360.0] {
        assert_eq!(draw(usual(), &pose(eye, -15.0, heading)), Ok(()), "{heading}");
    }
    assert_eq!(draw(usual(), &pose(eye, -90.0, 0.0)), Ok(()));
}
