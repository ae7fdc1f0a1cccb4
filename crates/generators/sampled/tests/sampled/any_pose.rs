//! Frames from wild poses are numbers everywhere.

use crate::shots::{HOME, Shot, level_ground};
use generator::{Label, PlaneKind};
use glam::DVec3;
use light_points::Blending;
use quantities::unit_interval;
use raster::{Filter, Pattern};
use scenario::{Curvature, DiscFace, LightPoint, LightSource, Medium, Overlay, Sheet, SkyDisc};
use std::f64::consts::{FRAC_PI_2, PI};

const PLANES: [PlaneKind; 7] = [
    PlaneKind::Intensity,
    PlaneKind::Range,
    PlaneKind::Distance,
    PlaneKind::Label,
    PlaneKind::Red,
    PlaneKind::Green,
    PlaneKind::Blue,
];

/// A scene with something of every kind close about the eye, some of it through the eye.
fn furnished(seed: u64) -> Shot {
    let part = |k: u64| unit_interval(seed, &[k]);
    let mut shot = Shot::new(20, 12, 10.0);
    shot.ground = level_ground(HOME, 0.5);
    let heights = [0.001, 0.1, 2.0, 500.0, 1e6];
    shot.pose.eye = [HOME + part(0), HOME + part(1), heights[seed as usize % heights.len()]];
    let pitches = [-FRAC_PI_2, FRAC_PI_2, 0.0, PI * (part(2) - 0.5), -0.3];
    shot.pose.attitude.pitch = pitches[seed as usize / 5 % pitches.len()];
    shot.pose.attitude.heading = 7.0 * part(3);
    shot.pose.yoke = [0.0, PI, 0.7, -FRAC_PI_2][seed as usize % 4];
    shot.view.laws.curvature = [Curvature::None, Curvature::Parabolic, Curvature::Exact][seed as usize % 3];
    shot.run.sampling.pattern = [Pattern::Four, Pattern::Sixteen, Pattern::OffCentre16][seed as usize % 3];
    shot.run.sampling.filter = [Filter::Box, Filter::Tent, Filter::Gaussian][seed as usize / 3 % 3];
    shot.run.sampling.blending = [Blending::Hiding, Blending::Additive][seed as usize % 2];
    let eye = DVec3::from_array(shot.pose.eye);
    let near = |k: u64| {
        let size = [1e-9, 0.04, 1.0, 300.0][(k + seed) as usize % 4];
        eye + size * DVec3::new(part(10 * k) - 0.5, part(10 * k + 1) - 0.5, part(10 * k + 2) - 0.5)
    };
    let lamp = |id: u32| {
        let at = if id == 0 { eye } else { near(100 + u64::from(id)) };
        LightPoint { calligraphic: id.is_multiple_of(2), ..crate::shots::lamp(id, at, 0.3) }
    };
    shot.effects.lights = (0..20).map(lamp).collect();
    let star = |id: u32| {
        let direction = (near(200 + u64::from(id)) - eye).normalize();
        LightPoint { source: LightSource::Star { direction, magnitude: -4.0 }, ..lamp(id) }
    };
    shot.effects.lights.extend((20..40).map(star));
    let sheet = |id: u32| {
        let mut corners: Vec<DVec3> = (0..3).map(|k| near(300 + 3 * u64::from(id) + k)).collect();
        match id {
            0 => corners[0] = eye,
            1 => corners[1] = corners[0],
            _ => {}
        }
        let dust = Medium::Dust { kappa: 0.1, thickness: 2.0 };
        let medium = [dust, Medium::Share(0.3), Medium::Share(0.0)][id as usize % 3];
        Sheet { id, corners, colour: [0.5; 3], medium, priority: 0 }
    };
    shot.effects.sheets = (0..9).map(sheet).collect();
    shot.effects.overlays = vec![Overlay {
        id: 0,
        corners: vec![[0.5, 0.5], [2.0, 0.5], [0.5, 2.0]],
        colour: [0.2; 3],
        share: [0.0, 0.5][seed as usize % 2],
        priority: 0,
    }];
    let direction = (near(400) - eye).normalize();
    let face = DiscFace::Ball { albedo: [0.3; 3], sun: DVec3::Z };
    shot.effects.discs = vec![SkyDisc { direction, angular_diameter: 0.5, face }];
    shot
}

#[test]
fn no_pose_gives_what_is_no_number() {
    for seed in 0..300 {
        let shot = furnished(seed);
        let frame = shot.draw();
        for kind in PLANES {
            let wrong = frame.plane(kind).iter().position(|value| value.is_nan() || *value < 0.0);
            assert_eq!(wrong, None, "seed {seed}, {kind:?}");
        }
    }
}

#[test]
fn straight_down_is_ground_and_straight_up_is_sky() {
    let mut shot = Shot::new(20, 12, 10.0);
    shot.ground = level_ground(HOME, 0.5);
    for yoke in [0.0, 1.0, -2.0] {
        shot.pose.yoke = yoke;
        for (pitch, is_ground) in [(-FRAC_PI_2, true), (FRAC_PI_2, false)] {
            shot.pose.attitude.pitch = pitch;
            let frame = shot.draw();
            let ground = frame.labelled(Label::Terrain).len();
            assert_eq!(ground, if is_ground { 240 } else { 0 }, "pitch {pitch}, yoke {yoke}");
        }
    }
}
