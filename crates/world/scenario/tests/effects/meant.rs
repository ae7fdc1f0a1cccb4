//! Tables mean what they say.

use super::*;

#[test]
fn a_light_is_read_as_it_is_meant() {
    let keys = "above_m = 3.5\ncolour = [1, 0.5, 0.25]\nintensity = 2\npriority = -4\ncalligraphic = true\n\
        beam = { heading_deg = 90, pitch_deg = 30, half_angle_deg = 20, power = 3 }\n\
        flash = { period_s = 2, duty = 0.25, phase = 0.5 }\nfrom_s = 1\nuntil_s = 9\n";
    let light = &parsed(&format!("{LAMP}{keys}")).effects.lights[0];
    let spot = Spot { at: [100.0, 50.0], above: 3.5 };
    assert_eq!(
        (light.id.as_str(), &light.place),
        ("a", &LightPlace::Ground { spot, diameter: 0.4, moves: None })
    );
    assert_eq!((light.colour, light.intensity, light.priority), ([1.0, 0.5, 0.25], 2.0, -4));
    assert_eq!(light.flash, Some(Flash { period: 2.0, duty: 0.25, phase: 0.5 }));
    assert_eq!((light.calligraphic, light.presence), (true, Presence { from: 1.0, until: 9.0 }));
    let Lobe { axis, half_angle, power } = light.beam.unwrap();
    assert!((axis - DVec3::new(0.0, 0.75_f64.sqrt(), 0.5)).length() < 1e-12, "{axis}");
    assert_eq!((half_angle, power), (radians(20.0), 3.0));
}

#[test]
fn what_is_left_out_has_its_default() {
    let beam = "beam = { half_angle_deg = 90 }\nflash = { period_s = 2 }\n";
    let light = &parsed(&format!("{LAMP}{beam}")).effects.lights[0];
    assert_eq!(light.beam, Some(Lobe { axis: DVec3::X, half_angle: radians(90.0), power: 1.0 }));
    assert_eq!(light.flash, Some(Flash { period: 2.0, duty: 0.5, phase: 0.0 }));
    assert_eq!(
        (light.colour, light.intensity, light.priority, light.calligraphic),
        ([1.0; 3], 1.0, 0, false)
    );
    assert_eq!(light.presence, Presence { from: 0.0, until: f64::INFINITY });
    let effects = parsed(&format!("{SHEET}{}", OVERLAY.replace("'a'", "'b'"))).effects;
    let (sheet, overlay) = (&effects.sheets[0], &effects.overlays[0]);
    assert_eq!((&sheet.place, sheet.medium, sheet.colour), (&SheetPlace::Foot, Medium::Share(0.7), [1.0; 3]));
    assert_eq!((overlay.share, overlay.colour, overlay.priority), (0.0, [1.0; 3], 0));
    assert!(effects.stars.is_none() && effects.earth.is_none() && !effects.sun_disc);
    let effects = parsed(&format!("{SEEDED}{EARTH}")).effects;
    let stars = effects.stars.unwrap();
    let sky = SeededSky { seed: 3, count: 50, brightest: -1.5, faintest: 6.0 };
    assert_eq!((stars.source, stars.calligraphic, stars.turn), (StarSource::Seeded(sky), false, [0.0; 3]));
    let earth = effects.earth.unwrap();
    assert_eq!((earth.albedo, earth.seen.unwrap().angular_diameter), ([0.38, 0.43, 0.54], radians(1.9)));
}

#[test]
fn sheets_overlays_stars_and_earth_are_read_as_they_are_meant() {
    let keys = "kappa_1_m = 0.05\nthickness_m = 10\nheight = 'datum'\ncolour = [0.5, 0.4, 0.3]\npriority = 2\nfrom_s = 3";
    let dust = SHEET.replace("tau = 0.7", keys);
    let sheet = &parsed(&dust).effects.sheets[0];
    assert_eq!(
        (&sheet.place, sheet.medium),
        (&SheetPlace::Datum, Medium::Dust { kappa: 0.05, thickness: 10.0 })
    );
    assert_eq!(
        (sheet.corners[2], sheet.colour, sheet.priority),
        (DVec3::new(100.0, 50.0, 9.0), [0.5, 0.4, 0.3], 2)
    );
    assert_eq!(sheet.presence, Presence { from: 3.0, until: f64::INFINITY });
    let overlay = format!("{OVERLAY}colour = [0.1, 0.2, 0.3]\ntau = 0.25\npriority = 3\nuntil_s = 5\n");
    let overlay = &parsed(&overlay).effects.overlays[0];
    assert_eq!((overlay.corners[1], overlay.colour, overlay.share), ([1.0, -1.0], [0.1, 0.2, 0.3], 0.25));
    assert_eq!((overlay.priority, overlay.presence), (3, Presence { from: 0.0, until: 5.0 }));
    let stars =
        format!("{SEEDED}brightest = 1\nfaintest = 2\ncalligraphic = true\nturn_deg = [90, 180, -90]\n");
    let stars = parsed(&stars).effects.stars.unwrap();
    let sky = SeededSky { seed: 3, count: 50, brightest: 1.0, faintest: 2.0 };
    assert_eq!((stars.source, stars.calligraphic), (StarSource::Seeded(sky), true));
    assert_eq!(stars.turn, [90.0, 180.0, -90.0].map(radians));
    let earth = format!("{EARTH}diameter_deg = 2\nalbedo = [0.1, 0.2, 0.3]\n");
    let earth = parsed(&earth).effects.earth.unwrap();
    let seen = earth.seen.unwrap();
    let direction =
        DVec3::from_array(landscape::Sun { azimuth: radians(200.0), elevation: radians(40.0) }.direction());
    assert_eq!(
        (earth.albedo, seen.direction, seen.angular_diameter),
        ([0.1, 0.2, 0.3], direction, radians(2.0))
    );
    assert!(parsed("disc = true\n").effects.sun_disc);
}
