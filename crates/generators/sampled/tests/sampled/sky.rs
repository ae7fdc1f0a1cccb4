//! The Earth's disc, with ground before it and stars behind it.

use crate::shots::Shot;
use generator::{Label, PlaneKind};
use glam::DVec3;
use quantities::radians;
use scenario::{DiscFace, LightPoint, LightSource, SkyDisc};

const FOCAL: f64 = 1072.253460254779;

/// The Earth at a place on the screen (pixels), lit from a direction.
fn earth(shot: &Shot, at: [f64; 2], sun: DVec3) -> SkyDisc {
    SkyDisc {
        direction: shot.eye().direction(at).normalize(),
        angular_diameter: radians(1.899313867357),
        face: DiscFace::Ball { albedo: [0.3, 0.4, 0.5], sun },
    }
}

/// A look to the north, well above the horizon.
fn upward() -> Shot {
    let mut shot = Shot::new(48, 48, FOCAL);
    shot.pose.attitude.pitch = 0.5;
    shot
}

/// Area of the Earth in the middle of the picture: 35.547686 pixels across.
fn area() -> f64 {
    std::f64::consts::PI * 35.547686 * 35.547686 / 4.0
}

#[test]
fn the_earth_shows_its_phase() {
    let mut shot = upward();
    // Mean of the cosine over a disc: 2/3 when full, 2/(3 pi) when half.
    let to_eye = -shot.eye().direction([24.0, 24.0]);
    for (sun, mean) in [(to_eye, 2.0 / 3.0), (DVec3::Y, 2.0 / (3.0 * std::f64::consts::PI)), (-to_eye, 0.0)] {
        shot.effects.discs = vec![earth(&shot, [24.0, 24.0], sun)];
        let frame = shot.draw();
        let found = frame.sum(PlaneKind::Blue) / (0.5 * area());
        assert!((found - mean).abs() < 0.004, "{found}, not {mean}");
        let pixels = frame.labelled(Label::Silhouette).len() as f64;
        // Pixels that the rim crosses count whole.
        assert!((area()..area() + 150.0).contains(&pixels), "{pixels}");
    }
    // The sun in the east lights the right half.
    shot.effects.discs = vec![earth(&shot, [24.0, 24.0], DVec3::Y)];
    let frame = shot.draw();
    let half = |is_right: bool| {
        let pixels = frame.plane(PlaneKind::Blue).iter().enumerate();
        pixels
            .filter(|(index, _)| (index % 48 >= 24) == is_right)
            .map(|(_, light)| f64::from(*light))
            .sum::<f64>()
    };
    assert!(half(true) > 50.0 && half(false) == 0.0);
}

#[test]
fn the_ground_hides_the_earth() {
    let mut shot = Shot::new(48, 48, FOCAL);
    // Its middle lies 20 pixels below a horizon that is in the middle of the screen: nothing of it is left.
    shot.effects.discs = vec![earth(&shot, [24.0, 44.0], -DVec3::X)];
    let frame = shot.draw();
    assert!(frame.labelled(Label::Silhouette).iter().all(|index| index / 48 < 26));
    shot.effects.discs = vec![earth(&shot, [24.0, 24.0], -DVec3::X)];
    let light = shot.draw().sum(PlaneKind::Blue);
    // The border of the bank is 1.07 pixel below the horizon; the mean of the cosine over a diameter is pi/4.
    let strip = 1.07 * 35.5 * 0.5 * std::f64::consts::FRAC_PI_4;
    assert!((light - 0.5 * area() / 3.0 - strip).abs() < 0.1 * strip, "{light}");
}

#[test]
fn the_earth_hides_stars_and_lamps_hide_the_earth() {
    for calligraphic in [false, true] {
        let mut shot = upward();
        shot.effects.discs = vec![earth(&shot, [24.0, 24.0], DVec3::Y)];
        let without = shot.draw();
        let light = |at: [f64; 2]| LightPoint { calligraphic, ..shot.lamp(0, at, 100.0, 0.5) };
        let star = |at: [f64; 2]| {
            let direction = shot.eye().direction(at).normalize();
            LightPoint { source: LightSource::Star { direction, magnitude: -3.0 }, ..light(at) }
        };
        let with = |light: LightPoint| {
            let mut shot = shot.clone();
            shot.effects.lights = vec![light];
            shot.draw().sum(PlaneKind::Red) - without.sum(PlaneKind::Red)
        };
        assert_eq!(with(star([17.0, 24.0])), 0.0);
        assert!(with(star([3.0, 4.0])) > 1.0);
        assert!(with(light([17.0, 24.0])) > 1.0);
    }
}

/// The sun before the Earth, as the list has it: the nearer first.
#[test]
fn the_nearer_disc_hides_the_farther() {
    let mut shot = upward();
    let far = earth(&shot, [24.0, 24.0], -DVec3::X);
    let near = SkyDisc {
        direction: far.direction,
        angular_diameter: radians(0.532906214492),
        face: DiscFace::Sun { colour: [3.0, 2.0, 1.0] },
    };
    shot.effects.discs = vec![near, far];
    assert_eq!(shot.draw().colour(24 * 48 + 24), [3.0, 2.0, 1.0]);
    shot.effects.discs = vec![far, near];
    assert!(shot.draw().colour(24 * 48 + 24)[0] < 0.5);
}
