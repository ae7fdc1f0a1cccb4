//! Lamps in whole pictures.

use super::*;

#[test]
fn a_lamp_in_the_sky_has_its_light_in_the_raster_and_of_a_beam() {
    let bare = seen(Effects::default());
    for calligraphic in [false, true] {
        for distance in [10.0, 30.0, 80.0] {
            let at = [EYE[0] + distance, EYE[1] + 0.03 * distance, EYE[2] + 0.12 * distance];
            let found = seen(lights(vec![LightPoint { calligraphic, ..lamp(at) }]));
            let away = DVec3::from_array(at).distance(DVec3::from_array(EYE));
            let diameter = 0.5 * focal(&usual()) / away;
            let expected = PI * diameter * diameter / 4.0;
            assert!((sum(&found, &bare) / expected - 1.0).abs() < 2e-6, "{calligraphic} {distance}");
        }
    }
}

/// Where the light is, the pixel of the projection is, whatever the attitude and the yoke.
#[test]
fn lamps_stand_in_true_perspective_under_every_attitude() {
    for projection in [Projection::Exact, Projection::AsReported, Projection::Corrected] {
        for (pitch, heading, yoke) in [(0.0, 0.0, 0.0), (-9.0, 40.0, 30.0), (-90.0, 70.0, -20.0)] {
            if projection != Projection::Exact && pitch < -80.0 {
                continue;
            }
            let settings = settings(
                PIXELS[0],
                PIXELS[1],
                laws(projection, Curvature::None, PixelRule::Centre),
                [1.0, 140.0],
            );
            let pose = Pose { yoke: radians(yoke), ..pose([100.0, 100.0, 30.0], pitch, heading) };
            let view = View::new(projection, &pose.attitude).with_yoke(pose.yoke);
            let at = DVec3::from_array(pose.eye) + view.perspective(0.1, -0.05).normalize() * 25.0;
            let bright = LightPoint { calligraphic: true, ..lamp(at.to_array()) };
            let found = seen_from(lights(vec![bright]), &pose, &settings);
            let bare = seen_from(Effects::default(), &pose, &settings);
            let (mut light, mut middle) = (0.0, [0.0; 2]);
            for index in 0..(PIXELS[0] * PIXELS[1]) as usize {
                let [one, other] = [&found, &bare].map(|planes| value(planes, PlaneKind::Intensity, index));
                light += one - other;
                middle[0] += (one - other) * ((index % 60) as f64 + 0.5);
                middle[1] += (one - other) * ((index / 60) as f64 + 0.5);
            }
            let field = settings.raster.field;
            let expected =
                [30.0 * (1.0 + 0.1 / field.tan_half_width), 20.0 * (1.0 - 0.05 / field.tan_half_height)];
            let off = [0, 1].map(|axis| (middle[axis] / light - expected[axis]).abs());
            assert!(off[0] < 1e-3 && off[1] < 1e-3, "{projection:?} {pitch} {yoke}: {off:?}");
        }
    }
}

/// A box hides the lower half of a lamp behind it; the lamp before it shows whole; the one in it not at all.
#[test]
fn a_body_hides_what_is_behind_it() {
    let stage = |lights: Vec<LightPoint>| {
        let scenery = scenery(Effects { lights, ..Effects::default() });
        let scenery = scenery.with_bodies(vec![standing_box(1, [70.0, 100.0, 0.0], 2.0, 2.0)]);
        planes(&ground(), scenery, &usual(), &pose(EYE, 0.0, 0.0))
    };
    let bare = stage(Vec::new());
    for calligraphic in [false, true] {
        let found = |north: f64, up: f64| {
            let lamp = LightPoint { calligraphic, colour: [1.0; 3], ..lamp([north, 100.0, up]) };
            let diameter = 0.5 * focal(&usual()) / (north - EYE[0]);
            sum(&stage(vec![lamp]), &bare) / (PI * diameter.max(1.5) * diameter.max(1.5) / 4.0)
        };
        // The box is black from here: its lit side is in the south, where the sun and the eye are.
        let half = found(90.0, 2.0)
            / (0.5 * focal(&usual()) / 40.0 / 1.5).min(1.0)
            / (0.5 * focal(&usual()) / 40.0 / 1.5).min(1.0);
        assert!((half - 0.5).abs() < 0.01, "{calligraphic}: {half}");
        assert!(found(70.0, 1.0).abs() < 1e-6);
    }
    let before = stage(vec![lamp([60.0, 100.0, 2.0])]);
    assert_eq!(value(&before, PlaneKind::Intensity, 20 * 60 + 30), 1.0);
    assert_eq!(value(&before, PlaneKind::Label, 20 * 60 + 30), f64::from(Label::Light.code()));
    assert_eq!(value(&before, PlaneKind::Range, 20 * 60 + 30), value(&bare, PlaneKind::Range, 20 * 60 + 30));
}

#[test]
fn a_lamp_at_the_eye_leaves_the_picture_as_it_is() {
    let bare = seen(Effects::default());
    let nowhere = [EYE, [f64::NAN; 3], [EYE[0], EYE[1], EYE[2] + 5e-4]].map(lamp).to_vec();
    let found = seen(lights(nowhere));
    for kind in PlaneKind::ALL {
        assert_eq!(found.get(kind), bare.get(kind), "{}", kind.name());
    }
}
