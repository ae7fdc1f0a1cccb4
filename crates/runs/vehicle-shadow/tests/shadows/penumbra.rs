//! The sun as a disc: how dark the ground is across the edge of a wall's shadow.

use glam::DVec3;
use quantities::radians;
use scenario::{FieldOfView, Scenery};
use solids::Solid;
use vehicle_shadow::{
    Augmentation, GroundLaw, Method, OutlineRule, SUN_HALF_ANGLE_DEG, SUN_POINTS, Shade, Shape, Shot,
    TrueGround,
};

use crate::scenes::{flat, shot, stage, sun};

/// Looking straight down on flat ground from 10 m, 2 m to each side of a place `ahead` (m), north up the picture.
fn from_above(ahead: f64) -> Shot {
    let level = shot([240.0 + ahead, 240.0, 10.0], 10.0, [0.0, -90.0, 0.0]);
    let field = FieldOfView { tan_half_width: 0.2, tan_half_height: 0.2 };
    Shot { vehicle: landscape::Attitude::default(), field, ..level }
}

const LINES: usize = 400;

/// Shares down the middle of the picture under a sun in the south, of a wall `height` m high whose foot is `ahead` of the
/// eye's to the south.
fn across_the_edge(height: f64, ahead: f64, ground: GroundLaw) -> Vec<f64> {
    let wall =
        Solid::boxed(DVec3::new(-ahead - 0.5, -50.0, 0.0), DVec3::new(-ahead, 50.0, height), 1.0).unwrap();
    let augmentation = Augmentation {
        inputs: String::new(),
        shape: Shape::new(vec![wall], 10.0),
        eye_height: 10.0,
        sun: Some(sun(180.0, 20.0)),
        penumbra: true,
        ground,
        method: Method::Synchronised { dac_bits: 24 },
    };
    let shade: Shade = augmentation.shade(0, &from_above(ahead), [5, LINES]).unwrap().shade;
    shade.shares().chunks(5).map(|line| line[2]).collect()
}

/// Share of the sun's disc below a straight edge `up` half angles above its middle.
fn covered(up: f64) -> f64 {
    let up = up.clamp(-1.0, 1.0);
    1.0 - (libm::acos(up) - up * (1.0 - up * up).sqrt()) / std::f64::consts::PI
}

fn check(height: f64, ground: GroundLaw) {
    let ahead = height / libm::tan(radians(20.0));
    let found = across_the_edge(height, ahead, ground);
    let mut between = 0;
    for (line, &share) in found.iter().enumerate() {
        // The top of the picture is north, away from the sun.
        let beyond = 10.0 * 0.2 * (1.0 - (2.0 * line as f64 + 1.0) / LINES as f64);
        let elevation = libm::atan(height / (ahead + beyond));
        let up = (elevation - radians(20.0)) / radians(SUN_HALF_ANGLE_DEG);
        let expected = covered(up);
        assert!(
            (share - expected).abs() < 2.5 / SUN_POINTS as f64,
            "{height}: line {line}: {share}, not {expected}"
        );
        between += usize::from(share > 0.05 && share < 0.95);
    }
    // The width grows with the way from the wall's top: 2 half angles times that way, seen flat.
    let way = height / libm::sin(radians(20.0));
    let width = 2.0 * radians(SUN_HALF_ANGLE_DEG) * way / libm::sin(radians(20.0)) * LINES as f64 / 4.0;
    assert!(
        (between as f64) > 0.6 * width && (between as f64) < width,
        "{height}: {between} of {width} lines"
    );
}

#[test]
fn the_edge_of_a_wall_is_a_segment_of_the_disc() {
    for height in [2.0, 8.0] {
        check(height, GroundLaw::Flat(OutlineRule::Parts));
        check(height, GroundLaw::Flat(OutlineRule::Walk));
        let stage = stage(&flat(), Scenery::still(sun(180.0, 20.0)), [5, LINES as u32]);
        let ground = Box::new(TrueGround::new(stage).unwrap());
        check(height, GroundLaw::True { ground, tracks: Vec::new() });
    }
}
