//! What is fixed to the eye lies over everything.

use crate::shots::{Shot, is_same, level_ground};
use generator::{Label, PlaneKind};
use scenario::{LightPoint, Overlay};

/// An overlay over the left half of the screen.
fn left_half(id: u32, share: f64, colour: [f64; 3], priority: i8) -> Overlay {
    Overlay { id, corners: vec![[-1.0, -1.0], [0.0, -1.0], [0.0, 1.0], [-1.0, 1.0]], colour, share, priority }
}

/// Ground, a sheet at arm's length and lamps in both halves.
fn full() -> Shot {
    let mut shot = Shot::new(32, 24, 40.0);
    shot.ground = level_ground(2000.0, 0.5);
    shot.effects.sheets = vec![shot.filling(0, 0.1, [0.3, 0.2, 0.1], 0.8)];
    let lamp = |id: u32, at: [f64; 2]| LightPoint { calligraphic: id < 2, ..shot.lamp(id, at, 0.3, 0.02) };
    shot.effects.lights =
        vec![lamp(0, [8.2, 5.0]), lamp(1, [24.2, 5.0]), lamp(2, [8.2, 18.0]), lamp(3, [24.2, 18.0])];
    shot
}

#[test]
fn an_opaque_overlay_hides_everything() {
    let mut shot = full();
    let bare = shot.draw();
    shot.effects.overlays = vec![left_half(0, 0.0, [0.1, 0.7, 0.2], 0)];
    let frame = shot.draw();
    for index in 0..32 * 24 {
        let found = frame.colour(index);
        let expected = if index % 32 < 16 { [0.1, 0.7, 0.2] } else { bare.colour(index) };
        assert!(
            found.iter().zip(expected).all(|(found, expected)| is_same(*found, expected)),
            "{index}: {found:?}"
        );
        assert_eq!(
            frame.plane(PlaneKind::Label)[index] == f32::from(Label::EyeFixed.code()),
            index % 32 < 16
        );
    }
}

#[test]
fn overlays_dim_what_is_behind_them_by_their_priority() {
    let mut shot = full();
    let bare = shot.draw();
    let (red, blue) = ([1.0, 0.0, 0.0], [0.0, 0.0, 1.0]);
    shot.effects.overlays = vec![left_half(0, 0.5, red, 1), left_half(1, 0.5, blue, 2)];
    let frame = shot.draw();
    for index in (0..32 * 24).filter(|index| index % 32 < 16) {
        let behind = bare.colour(index).map(|channel| channel / 4.0);
        let expected = [behind[0] + 0.25, behind[1], behind[2] + 0.5];
        let found = frame.colour(index);
        let close = |(found, expected): (&f64, f64)| (found - expected).abs() < 1e-7;
        assert!(found.iter().zip(expected).all(close), "{index}: {found:?}, not {expected:?}");
    }
}
