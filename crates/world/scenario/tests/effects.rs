//! Lights, sheets, overlays, stars and discs of the sky: read, refused, placed on their ground.

use std::fs;

use ephemeris::{Instant, MOON_RADIUS, Place, Sky, icrf_to_local};
use glam::DVec3;
use landscape::{Attitude, Bank, Landscape, Level};
use proptest::prelude::*;
use quantities::{Rate, degrees, radians};
use scenario::{
    DiscFace, Effects, Flash, GroundSource, LightPlace, LightPoint, LightSource, Lobe, Medium, Presence,
    Scenario, Scenery, SceneryProblem, SceneryProblems, SeededSky, SheetPlace, SkyDisc, Spot, Stance,
    StarSource,
};

/// Ground that rises by 0.1 to the north.
const GOOD: &str = r#"format = 1
title = "t"
shows = "s"
frames = 90
[landscape.generated]
seed = 1
extent_m = [600, 640]
region_size_m = 40
tilt_m_per_m = [0.1, 0.0]
[path]
keyframes = [{ t_s = 0, x_m = 100, y_m = 300 }, { t_s = 100, x_m = 500, y_m = 300 }]
[sun]
azimuth_deg = 10
elevation_deg = 12
"#;

/// The line of the first of more tables after the good ones.
const MORE: usize = 15;

fn parsed(tables: &str) -> Scenario {
    Scenario::parse("t.toml", &format!("{GOOD}{tables}")).unwrap_or_else(|list| panic!("{tables}: {list}"))
}

fn rate() -> Rate {
    Rate::new(30, 1).unwrap()
}

fn placed(scenario: &Scenario) -> Result<Scenery, SceneryProblems> {
    let GroundSource::Generated(relief) = &scenario.ground else { panic!("generated") };
    let bank = Bank::new("t", vec![relief.build().unwrap()], None).unwrap();
    Scenery::of(scenario, &Landscape::new(bank, 1.0), rate())
}

fn made(tables: &str) -> Scenery {
    placed(&parsed(tables)).unwrap_or_else(|problems| panic!("{problems}"))
}

/// Places of lamps (m), to a nanometre.
fn lamps(effects: &Effects) -> Vec<(u32, [f64; 3])> {
    let place = |light: &LightPoint| match light.source {
        LightSource::Lamp { at, .. } => {
            Some((light.id, at.to_array().map(|part| (1e9 * part).round() / 1e9)))
        }
        LightSource::Star { .. } => None,
    };
    effects.lights.iter().filter_map(place).collect()
}

/// Line and title of each fault.
fn faults(tables: &str) -> Vec<(Option<usize>, String)> {
    match Scenario::parse("t.toml", &format!("{GOOD}{tables}")) {
        Ok(_) => Vec::new(),
        Err(list) => list.iter().map(|problem| (problem.record().line, problem.title.clone())).collect(),
    }
}

const LAMP: &str = "[[light]]\nid = 'a'\nx_m = 100\ny_m = 50\ndiameter_m = 0.4\n";
const CARRIED: &str = "[[object]]\nid = 'cart'\nmodel = 'marker'\nx_m = 300\ny_m = 330\nheading_deg = 90\n\
    [[light]]\nid = 'a'\non = 'cart'\nat_m = [2, 1, 3]\ndiameter_m = 0.4\n";
const STAR: &str = "[[light]]\nid = 'a'\nazimuth_deg = 90\nelevation_deg = 30\nmagnitude = 1.5\n";
const SHEET: &str =
    "[[sheet]]\nid = 'a'\ncorners_m = [[100, 0, 0], [100, 50, 0], [100, 50, 9], [100, 0, 9]]\ntau = 0.7\n";
const OVERLAY: &str = "[[overlay]]\nid = 'a'\ncorners = [[-1, -1], [1, -1], [1, 1]]\n";
const SEEDED: &str = "[stars]\nseed = 3\ncount = 50\n";
const EARTH: &str = "[earth]\nazimuth_deg = 200\nelevation_deg = 40\n";

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

#[test]
fn bad_tables_are_refused_at_their_place() {
    let with = |base: &str, keys: &str| format!("{base}{keys}\n");
    let without = |base: &str, line: &str| base.replacen(line, "", 1);
    let twins = format!("{LAMP}{}", LAMP.replace("100", "101"));
    let moves = "moves = { keyframes = [{ t_s = 0, x_m = 100, y_m = 50 }] }";
    for (tables, line, expected) in [
        (LAMP.replace("'a'", "'a b'"), 1, "letters, digits and dashes"),
        (without(LAMP, "id = 'a'\n"), 0, "missing key `light[0].id`"),
        (without(LAMP, "y_m = 50\n"), 0, "missing key `light[0].y_m`"),
        (without(LAMP, "diameter_m = 0.4\n"), 0, "missing key `light[0].diameter_m`"),
        (LAMP.replace("0.4", "0"), 4, "above 0"),
        (LAMP.replace("0.4", "10001"), 4, "at most 10000"),
        (LAMP.replace("0.4", "nan"), 4, "not nan"),
        (LAMP.replace("100", "inf"), 2, "not inf"),
        (twins, 6, "two lights, sheets or overlays are called \"a\""),
        (format!("{LAMP}{SHEET}"), 6, "two lights, sheets or overlays are called \"a\""),
        (format!("{LAMP}{OVERLAY}"), 6, "two lights, sheets or overlays are called \"a\""),
        (with(LAMP, "above_m = -1"), 5, "from 0 to 1000000"),
        (with(LAMP, "intensity = -1"), 5, "from 0 to 1000"),
        (with(LAMP, "colour = [1, 1]"), 5, "an array of 3 numbers"),
        (with(LAMP, "colour = [1, 1, 1.5]"), 5, "from 0 to 1"),
        (with(LAMP, "priority = 101"), 5, "from -100 to 100"),
        (with(LAMP, "calligraphic = 1"), 5, "true or false"),
        (with(LAMP, "beam = { power = 2 }"), 5, "missing key `light[0].beam.half_angle_deg`"),
        (with(LAMP, "beam = { half_angle_deg = 0 }"), 5, "above 0"),
        (with(LAMP, "beam = { half_angle_deg = 90.5 }"), 5, "at most 90"),
        (with(LAMP, "beam = { half_angle_deg = 9, power = -1 }"), 5, "from 0 to 10000"),
        (with(LAMP, "beam = { half_angle_deg = 9, pitch_deg = 91 }"), 5, "from -90 to 90"),
        (with(LAMP, "beam = 4"), 5, "must be a table"),
        (with(LAMP, "flash = { duty = 0.5 }"), 5, "missing key `light[0].flash.period_s`"),
        (with(LAMP, "flash = { period_s = 1, duty = 1.5 }"), 5, "from 0 to 1"),
        (with(LAMP, "flash = { period_s = 1, phase = 1 }"), 5, "below 1"),
        (with(LAMP, "from_s = 5\nuntil_s = 5"), 6, "is not after the time from which on it is there"),
        (with(LAMP, "count = 5"), 5, "`light[0].count` without `light[0].to`"),
        (with(LAMP, "to = { x_m = 1, y_m = 2 }"), 5, "`light[0].to` without `light[0].count`"),
        (with(LAMP, "to = { x_m = 1, y_m = 2 }\ncount = 1"), 6, "from 2 to 100000"),
        (with(LAMP, "to = { x_m = 1 }\ncount = 3"), 5, "missing key `light[0].to.y_m`"),
        (with(LAMP, &format!("to = {{ x_m = 1, y_m = 2 }}\ncount = 3\n{moves}")), 7, "which stands still"),
        (with(LAMP, "moves = {}"), 5, "says nothing"),
        (with(LAMP, "on = 'cart'"), 1, "is in more than one place"),
        (with(LAMP, "magnitude = 3"), 1, "is in more than one place"),
        ("[[light]]\nid = 'a'\ndiameter_m = 1\n".into(), 1, "is nowhere"),
        (with(STAR, "diameter_m = 1"), 5, "of a star, which is infinitely far"),
        (with(STAR, "beam = { half_angle_deg = 9 }"), 5, "of a star, which is infinitely far"),
        (with(STAR, moves), 5, "of a star, which is infinitely far"),
        (with(STAR, "count = 9"), 5, "of a star, which is infinitely far"),
        (without(STAR, "magnitude = 1.5\n"), 0, "missing key `light[0].magnitude`"),
        (STAR.replace("1.5", "51"), 4, "from -50 to 50"),
        (STAR.replace("30", "91"), 3, "from -90 to 90"),
        (CARRIED.replace("on = 'cart'", "on = 'car'"), 8, "one of \"cart\""),
        (without(CARRIED, "at_m = [2, 1, 3]\n"), 6, "missing key `light[0].at_m`"),
        (with(CARRIED, moves), 11, "of a lamp on an object"),
        (with(CARRIED, "count = 9"), 11, "of a lamp on an object"),
        (CARRIED[CARRIED.find("[[light]]").unwrap()..].into(), 2, "without an object that it could name"),
        (without(SHEET, "tau = 0.7\n"), 0, "missing key `sheet[0].tau` or `sheet[0].kappa_1_m`"),
        (with(SHEET, "kappa_1_m = 0.1\nthickness_m = 1"), 4, "both say how much light goes through"),
        (with(SHEET, "thickness_m = 1"), 4, "beside `tau`"),
        (SHEET.replace("tau = 0.7", "kappa_1_m = 1"), 0, "missing key `sheet[0].thickness_m`"),
        (SHEET.replace("tau = 0.7", "kappa_1_m = -1\nthickness_m = 1"), 3, "from 0 to 1000000"),
        (SHEET.replace("tau = 0.7", "tau = 1.1"), 3, "from 0 to 1"),
        (SHEET.replace("[100, 50, 0], ", "[110, 50, 0], "), 2, "beside the plane"),
        (SHEET.replace("[100, 50, 9], [100, 0, 9]", "[100, 0, 9], [100, 50, 9]"), 2, "it has no area"),
        (SHEET.replace("[100, 50, 0]", "[100, 0, 0]"), 2, "corners 0 and 1 are in one place"),
        (SHEET.replace(", [100, 50, 9], [100, 0, 9]", ""), 2, "3 to 16 of them"),
        (SHEET.replace(", [100, 50, 9], [100, 0, 9]", ", [100, 99, 0]"), 2, "on one line"),
        (SHEET.replace("[100, 50, 9]", "[100, 50]"), 2, "triples"),
        (SHEET.replace("[100, 50, 9]", "[100, 50, nan]"), 2, "not nan"),
        (SHEET.replace("[100, 50, 9]", "[100, 50, 2e7]"), 2, "from -1e7 to 1e7 m"),
        (with(SHEET, "height = 'air'"), 4, "one of \"foot\""),
        (with(SHEET, &format!("height = 'foot'\n{moves}")), 4, "beside `moves`"),
        (with(SHEET, "moves = { spin_deg_s = 3 }"), 4, "without `keyframes`"),
        (OVERLAY.replace("[1, 1]", "[1, 5]"), 2, "from -4 to 4"),
        (OVERLAY.replace("[1, 1]", "[1, 1], [0.5, 0]"), 2, "on the outer side"),
        (OVERLAY.replace(", [1, 1]", ""), 2, "3 to 16 of them"),
        (with(OVERLAY, "tau = -0.5"), 3, "from 0 to 1"),
        ("[stars]\n".into(), 0, "missing key `stars.file` or `stars.seed`"),
        ("[stars]\nseed = 1\n".into(), 0, "missing key `stars.count`"),
        ("[stars]\ncount = 1\n".into(), 0, "missing key `stars.seed`"),
        (SEEDED.replace("50", "20001"), 2, "from 1 to 20000"),
        (with(SEEDED, "faintest = -2"), 3, "not above the brightest"),
        (with(SEEDED, "turn_deg = [1, 2]"), 3, "an array of 3 numbers"),
        (with(SEEDED, "turn_deg = [1, 2, inf]"), 3, "not inf"),
        (without(EARTH, "azimuth_deg = 200\n"), 0, "missing key `earth.azimuth_deg`"),
        (with(EARTH, "diameter_deg = 0"), 3, "above 0"),
        (with(EARTH, "albedo = [1, 1, 2]"), 3, "from 0 to 1"),
        ("disc = 'yes'\n".into(), 0, "true or false"),
    ] {
        let found = faults(&tables);
        assert_eq!(found.len(), 1, "{tables}: {found:?}");
        assert!(
            found[0].0 == Some(MORE + line) && found[0].1.contains(expected),
            "{tables}: {expected}: {found:?}"
        );
    }
}

const EXAMPLES: &str = include_str!("../../../../docs/scenario-format.md");

/// Numbers of an example from its first light on: where each begins, and its length.
fn numbers(text: &str) -> Vec<(usize, usize)> {
    let is_part = |c: char| c.is_ascii_digit() || ".-".contains(c);
    let begins = |at: &usize| {
        let before = text[..*at].chars().next_back().unwrap_or(' ');
        text[*at..].starts_with(is_part) && "[ ".contains(before)
    };
    let from = text.find("[[light]]").unwrap();
    let starts = (from..text.len()).filter(begins);
    starts.map(|at| (at, text[at..].find(|c: char| !is_part(c)).unwrap_or(0))).collect()
}

#[test]
fn no_number_may_be_nan_or_infinite() {
    let start = EXAMPLES.find("format = 1\ntitle = \"Lights\"").unwrap();
    let example = &EXAMPLES[start..start + EXAMPLES[start..].find("```").unwrap()];
    assert!(Scenario::parse("t.toml", example).is_ok());
    let numbers = numbers(example);
    assert!(numbers.len() > 100, "{}", numbers.len());
    for (at, length) in numbers {
        for word in ["nan", "inf", "-inf"] {
            let text = [&example[..at], word, &example[at + length..]].concat();
            let line = text[..at].lines().count();
            let list = Scenario::parse("t.toml", &text).expect_err(word);
            assert!(list.iter().any(|problem| problem.record().line == Some(line)), "line {line}: {list}");
        }
    }
}

#[test]
fn a_fault_of_an_object_says_nothing_about_its_lamp() {
    let found = faults(&CARRIED.replace("x_m = 300", "x_m = 'x'"));
    assert!(found.len() == 1 && found[0].1.contains("object[0].x_m"), "{found:?}");
}

#[test]
fn light_points_count_through_the_mission() {
    let names = |table: &str, id: &str| table.replace("id = 'a'", &format!("id = '{id}'"));
    let string = format!("{LAMP}count = 3\nto = {{ x_m = 200, y_m = 90, above_m = 4 }}\n");
    let scenery = made(&format!("{}{}{}{SEEDED}", names(STAR, "s"), names(&string, "t"), names(LAMP, "u")));
    let effects = scenery.effects(0.0);
    assert_eq!(effects.lights.iter().map(|light| light.id).collect::<Vec<_>>(), (0..55).collect::<Vec<_>>());
    // A string stands on the heights of its ground.
    assert_eq!(
        lamps(&effects),
        [
            (1, [100.0, 50.0, 10.0]),
            (2, [150.0, 70.0, 17.0]),
            (3, [200.0, 90.0, 24.0]),
            (4, [100.0, 50.0, 10.0])
        ]
    );
    let LightSource::Star { direction, magnitude } = effects.lights[0].source else { panic!("a star") };
    assert!(
        (direction - DVec3::new(0.0, 0.75_f64.sqrt(), 0.5)).length() < 1e-12
            && (magnitude - 2.96).abs() < 1e-12
    );
    assert!(effects.lights[5..].iter().all(|light| matches!(light.source, LightSource::Star { .. })));
}

#[test]
fn a_string_follows_uneven_ground() {
    // Heights along a line over waves, from the ground itself.
    let waves = "[landscape.generated.undulation]\nrms_height_m = 2\nhurst = 0.8\nlongest_m = 300\nshortest_m = 120\n";
    let string = format!("{LAMP}above_m = 1\ncount = 20\nto = {{ x_m = 500, y_m = 400, above_m = 1 }}\n");
    let scenario = parsed(&format!("{waves}{string}"));
    let GroundSource::Generated(relief) = &scenario.ground else { panic!("generated") };
    let ground = Landscape::new(Bank::new("t", vec![relief.build().unwrap()], None).unwrap(), 1.0);
    let effects = Scenery::of(&scenario, &ground, rate()).unwrap().effects(0.0);
    let found = lamps(&effects);
    assert_eq!(found.len(), 20);
    for (_, [x, y, up]) in found {
        assert!((up - 1.0 - ground.height(x, y).unwrap()).abs() < 1e-6, "{x} {y} {up}");
    }
}

/// From y = 330 to y = 380 along x = 300, turning from east to south.
const CART: &str = "[[object]]\nid = 'cart'\nmodel = 'marker'\nx_m = 300\ny_m = 330\nheading_deg = 90\n\
    [object.moves]\nkeyframes = [{ t_s = 2, x_m = 300, y_m = 330 }, { t_s = 4, x_m = 300, y_m = 380, heading_deg = 180 }]\n\
    [[light]]\nid = 'a'\non = 'cart'\nat_m = [2, 1, 3]\ndiameter_m = 0.4\nbeam = { half_angle_deg = 30 }\n";

#[test]
fn a_lamp_follows_the_object_that_carries_it() {
    let scenery = made(CART);
    for (time, foot, heading) in [
        (0.0, [300.0, 330.0, 30.0], 90.0),
        (3.0, [300.0, 355.0, 30.0], 135.0),
        (9.0, [300.0, 380.0, 30.0], 180.0),
    ] {
        let attitude = Attitude { heading: radians(heading), ..Attitude::default() };
        let turn = Stance { at: [0.0; 2], attitude }.to_ground();
        let [light] = scenery.effects(time).lights[..] else { panic!("one light") };
        let LightSource::Lamp { at, diameter } = light.source else { panic!("a lamp") };
        let expected = DVec3::from_array(foot) + turn * DVec3::new(2.0, 1.0, 3.0);
        assert!(at.distance(expected) < 1e-9 && diameter == 0.4, "{time}: {at} {expected}");
        assert!((light.lobe.unwrap().axis - turn * DVec3::X).length() < 1e-12, "{time}");
        // It stands as far from the object's parts as it is written.
        let body = scenery.guests(time).next().unwrap();
        assert!(((at - body.foot).length() - 14_f64.sqrt()).abs() < 1e-9);
    }
    let gone = made(&format!("{CART}[[event]]\nt_s = 3\naction = 'delete'\nobject = 'cart'\n"));
    assert!(!gone.effects(2.9).lights.is_empty() && gone.effects(3.0).lights.is_empty());
}

#[test]
fn a_lamp_comes_jumps_and_goes_with_its_object() {
    let events = "[[event]]\nt_s = 2\naction = 'add'\nobject = 'cart'\n\
        [[event]]\nt_s = 4\naction = 'move'\nobject = 'cart'\nx_m = 200\ny_m = 100\nheading_deg = 0\n\
        [[event]]\nt_s = 6\naction = 'delete'\nobject = 'cart'\n";
    let absent = CARRIED.replace("heading_deg = 90\n", "heading_deg = 90\npresent = false\nscale = 3\n");
    let scenery = made(&format!("{absent}until_s = 5.5\n{events}"));
    let at = |time: f64| lamps(&scenery.effects(time));
    assert_eq!((at(1.9), at(5.5)), (vec![], vec![]));
    // Facing east: forward is east, starboard is south. The ground is at 30 m, and at 20 m.
    assert_eq!((at(2.0), at(3.9)), (vec![(0, [299.0, 332.0, 33.0])], vec![(0, [299.0, 332.0, 33.0])]));
    assert_eq!(at(4.0), [(0, [202.0, 101.0, 23.0])]);
}

#[test]
fn a_lamp_of_its_own_moves_turns_and_flashes() {
    let moves = "above_m = 2\nmoves = { keyframes = [{ t_s = 0, x_m = 100, y_m = 50 }, \
        { t_s = 2, x_m = 200, y_m = 50, above_m = 5 }] }\n";
    let scenery = made(&format!("{LAMP}{moves}flash = {{ period_s = 0.4, duty = 0.75 }}\n"));
    assert_eq!(lamps(&scenery.effects(0.0)), [(0, [100.0, 50.0, 12.0])]);
    assert_eq!(lamps(&scenery.effects(1.0)), [(0, [150.0, 50.0, 19.5])]);
    assert!(scenery.effects(0.35).lights.is_empty());
    // A spin alone turns the beam of a lamp that stays.
    let turning = made(&format!("{LAMP}beam = {{ half_angle_deg = 9 }}\nmoves = {{ spin_deg_s = 90 }}\n"));
    for (time, axis) in [(0.0, DVec3::X), (1.0, DVec3::Y), (2.0, -DVec3::X)] {
        let effects = turning.effects(time);
        assert!((effects.lights[0].lobe.unwrap().axis - axis).length() < 1e-12, "{time}");
        assert_eq!(lamps(&effects), [(0, [100.0, 50.0, 10.0])]);
    }
}

#[test]
fn sheets_stand_on_what_their_height_says() {
    let corners = |tables: &str, time: f64| made(tables).effects(time).sheets[0].corners.clone();
    let slanted = SHEET.replace(
        "[[100, 0, 0], [100, 50, 0], [100, 50, 9], [100, 0, 9]]",
        "[[100, 7, 0], [200, 7, 0], [200, 7, 9]]",
    );
    let ups = |height: &str| {
        let found = corners(&format!("{slanted}height = '{height}'\n"), 0.0);
        found.iter().map(|corner| (1e6 * corner.z).round() / 1e6).collect::<Vec<_>>()
    };
    assert_eq!(ups("foot"), [10.0, 10.0, 19.0]);
    assert_eq!(ups("ground"), [10.0, 20.0, 29.0]);
    assert_eq!(ups("datum"), [0.0, 0.0, 9.0]);
    // Beside the ground there is a datum, and no ground.
    let far = SHEET.replace("100", "-100");
    assert_eq!(corners(&format!("{far}height = 'datum'\n"), 0.0)[0], DVec3::new(-100.0, 0.0, 0.0));
    let moves = "moves = { keyframes = [{ t_s = 0, x_m = 100, y_m = 50, heading_deg = 90 }, \
        { t_s = 2, x_m = 200, y_m = 50 }] }\n";
    let moving = SHEET.replace(
        "[[100, 0, 0], [100, 50, 0], [100, 50, 9], [100, 0, 9]]",
        "[[3, 0, 0], [3, 1, 0], [3, 1, 2]]",
    );
    let found = corners(&format!("{moving}{moves}"), 0.0);
    assert!(found[1].distance(DVec3::new(99.0, 53.0, 10.0)) < 1e-9, "{found:?}");
    let found = corners(&format!("{moving}{moves}"), 2.0);
    assert!(found[1].distance(DVec3::new(203.0, 51.0, 20.0)) < 1e-9, "{found:?}");
}

#[test]
fn what_has_no_ground_is_named() {
    let refused = |tables: &str| match placed(&parsed(tables)) {
        Ok(_) => panic!("{tables}"),
        Err(SceneryProblems(problems)) => problems,
    };
    let string = format!("{LAMP}count = 5\nto = {{ x_m = 800, y_m = 50 }}\n");
    let problems = refused(&format!("{string}{}", SHEET.replace("'a'", "'b'").replace("100", "700")));
    let named = |problem: &SceneryProblem| match problem {
        SceneryProblem::EffectOutside { what, id, x, .. } => (*what, id.clone(), *x),
        other => panic!("{other}"),
    };
    let found: Vec<_> = problems.iter().map(named).collect();
    assert_eq!(
        found,
        [("light", "a".into(), 625.0), ("light", "a".into(), 800.0), ("sheet", "b".into(), 700.0)]
    );
    assert!(problems[0].to_string().contains("light \"a\" at t = 0 s: x = 625.00 m"), "{}", problems[0]);
    let stray =
        "moves = { keyframes = [{ t_s = 0, x_m = 100, y_m = 50 }, { t_s = 7, x_m = 100, y_m = -1 }] }\n";
    for (base, what) in [(LAMP, "light"), (SHEET, "sheet")] {
        let problems = refused(&format!("{base}{stray}"));
        assert!(problems[0].to_string().contains(&format!("{what} \"a\" at t = 7 s")), "{}", problems[0]);
    }
    // Corners that follow a slope in two ways are not flat.
    let bent = SHEET.replace(
        "[[100, 0, 0], [100, 50, 0], [100, 50, 9], [100, 0, 9]]",
        "[[100, 0, 0], [200, 0, 0], [200, 50, 3], [100, 50, 0]]",
    );
    let problems = refused(&format!("{bent}height = 'ground'\n"));
    let text = problems[0].to_string();
    assert!(problems.len() == 1 && text.contains("sheet \"a\" on its ground: corner 0 is"), "{text}");
    // An object without ground is one problem, with a lamp on it or without.
    assert_eq!(refused(&CARRIED.replace("x_m = 300", "x_m = 3000")).len(), 1);
}

#[test]
fn overlays_and_sheets_keep_their_numbers() {
    let other = |table: &str, id: &str| table.replace("'a'", &format!("'{id}'"));
    let tables = [other(SHEET, "a"), other(SHEET, "b"), other(OVERLAY, "c"), other(OVERLAY, "d")].concat();
    let effects = made(&tables.replacen("tau = 0.7", "tau = 0.7\nfrom_s = 1", 1)).effects(0.0);
    assert_eq!(effects.sheets.iter().map(|sheet| sheet.id).collect::<Vec<_>>(), [1]);
    assert_eq!(effects.overlays.iter().map(|overlay| overlay.id).collect::<Vec<_>>(), [0, 1]);
    assert_eq!(effects.overlays[0].corners, [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0]]);
}

#[test]
fn the_disc_of_the_sun_is_where_the_light_comes_from() {
    let drift = "disc = true\nstep_s = 1\ndrift = [{ t_s = 2, azimuth_deg = 30, elevation_deg = 6 }]\n";
    let scenery = made(&format!("{drift}{EARTH}"));
    for time in [0.0, 0.9, 1.0, 2.5] {
        let [earth, sun] = scenery.effects(time).discs[..] else { panic!("two discs") };
        let to_sun = |time: f64| DVec3::from_array(scenery.sun(time).direction());
        assert_eq!((sun.direction, sun.face), (to_sun(time), DiscFace::Sun { colour: [1.0; 3] }));
        assert_eq!((sun.angular_diameter, earth.angular_diameter), (radians(0.533), radians(1.9)));
        assert_eq!(earth.face, DiscFace::Ball { albedo: [0.38, 0.43, 0.54], sun: to_sun(0.0) });
    }
}

const APOLLO: Place = Place { longitude: 0.537_037, latitude: 0.352_382, radius: MOON_RADIUS };

/// A scenario with a date, and a catalogue beside it, over a bank whose north is so far (rad) from true north.
fn dated(at: &str, catalogue: &str, tables: &str, true_north: f64) -> (Scenario, Scenery) {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("stars.csv"), catalogue).unwrap();
    let ground = &GOOD[GOOD.find("[landscape").unwrap()..GOOD.find("[path]").unwrap()];
    let text = GOOD.replace(ground, "[landscape]\nbank = 'valley.bank'\n");
    let text = text.replace("azimuth_deg = 10\nelevation_deg = 12", &format!("at = '{at}'"));
    let path = folder.path().join("s.toml");
    fs::write(&path, format!("{text}{tables}")).unwrap();
    let scenario = Scenario::read(&path).unwrap_or_else(|list| panic!("{list}"));
    let level = Level::new(600.0, [0.0; 2], [2, 2], vec![[0.0; 9]; 4]).unwrap();
    let Place { latitude, longitude, .. } = APOLLO;
    let place = landscape::Georeference { latitude, longitude, at: [300.0; 2], true_north: Some(true_north) };
    let ground = Landscape::new(Bank::new("", vec![level], Some(place)).unwrap(), 1.0);
    let scenery = Scenery::of(&scenario, &ground, rate()).unwrap_or_else(|problems| panic!("{problems}"));
    (scenario, scenery)
}

const HEADER: &str = "right_ascension_deg,declination_deg,magnitude,b_v\n";
const CATALOGUE: &str = "[stars]\nfile = 'stars.csv'\n";

fn directions(effects: &Effects) -> Vec<DVec3> {
    let direction = |light: &LightPoint| match light.source {
        LightSource::Star { direction, .. } => direction,
        LightSource::Lamp { .. } => panic!("a lamp"),
    };
    effects.lights.iter().map(direction).collect()
}

#[test]
fn a_star_where_the_sun_is_coincides_with_the_sun() {
    let at = "1972-12-11T22:00:00Z";
    let instant: Instant = at.parse().unwrap();
    let sun = Sky::over(APOLLO, instant).sun;
    let local = landscape::Sun { azimuth: sun.azimuth, elevation: sun.elevation }.direction();
    let icrf = icrf_to_local(APOLLO, instant).transpose() * DVec3::from_array(local);
    let (right_ascension, declination) = (libm::atan2(icrf.y, icrf.x), libm::asin(icrf.z));
    let row = format!("{:?},{:?},1,\n", degrees(right_ascension), degrees(declination));
    for true_north in [0.0, 0.4, -2.0] {
        let (_, scenery) =
            dated(at, &format!("{HEADER}{row}"), &format!("disc = true\n{CATALOGUE}[earth]\n"), true_north);
        let effects = scenery.effects(0.0);
        let to_sun = DVec3::from_array(scenery.sun(0.0).direction());
        // The radius of the bank's sphere differs by some metres from the Moon's.
        assert!((directions(&effects)[0] - to_sun).length() < 1e-6, "{true_north}");
        let [earth, disc] = effects.discs[..] else { panic!("two discs") };
        let sky = scenery.sky().unwrap();
        assert_eq!((disc.direction, disc.angular_diameter), (to_sun, sky.sky.sun.angular_diameter));
        assert_eq!(earth.angular_diameter, sky.sky.earth.angular_diameter);
        assert!((degrees(libm::asin(earth.direction.z)) - degrees(sky.sky.earth.elevation)).abs() < 1e-9);
        let azimuth = libm::atan2(earth.direction.y, earth.direction.x) - sky.sky.earth.azimuth - true_north;
        assert!(libm::sin(azimuth).abs() < 1e-9 && libm::cos(azimuth) > 0.0, "{azimuth}");
    }
}

/// At equinoxes and solstices the Sun seen from the Earth is at a known place. Seen from the Moon it is 0.15 degrees beside it
/// at most: 384 400 km over 149.6 million km. Equinox and equator of the year differ by less than 0.02 degrees from the ICRF.
#[test]
fn the_sun_of_equinoxes_and_solstices_is_where_it_is_known_to_be() {
    for (at, right_ascension, declination) in [
        ("2000-03-20T07:35:00Z", 0.0, 0.0),
        ("2000-06-21T01:48:00Z", 90.0, 23.44),
        ("2000-09-22T17:28:00Z", 180.0, 0.0),
        ("2000-12-21T13:37:00Z", 270.0, -23.44),
    ] {
        let under = Sky::over(APOLLO, at.parse().unwrap()).sub_solar;
        // Beside the place that has the sun overhead, so that azimuths count.
        let [longitude, latitude] = [degrees(under.longitude) + 30.0, degrees(under.latitude) + 20.0];
        let place = format!("place = {{ longitude_deg = {longitude}, latitude_deg = {latitude} }}\n");
        let row = format!("{HEADER}{right_ascension},{declination},1,\n");
        let (_, scenery) = dated(at, &row, &format!("{place}{CATALOGUE}"), 0.0);
        let to_sun = DVec3::from_array(scenery.sun(0.0).direction());
        let beside = degrees((directions(&scenery.effects(0.0))[0] - to_sun).length());
        assert!(beside < 0.17, "{at}: {beside}");
    }
}

#[test]
fn a_date_turns_the_sky_and_nothing_else_may() {
    let keys = "at = '1972-12-11T22:00:00Z'\nplace = { longitude_deg = 30.77, latitude_deg = 20.19 }";
    let good = GOOD.replace("azimuth_deg = 10\nelevation_deg = 12", keys);
    for (tables, line, expected) in [
        ("[stars]\nseed = 1\ncount = 2\nturn_deg = [0, 0, 0]\n", 3, "`stars.turn_deg` beside `sun.at`"),
        ("[earth]\nazimuth_deg = 3\n", 1, "`earth.azimuth_deg` beside `sun.at`"),
        ("[earth]\nelevation_deg = 3\n", 1, "`earth.elevation_deg` beside `sun.at`"),
        ("[earth]\ndiameter_deg = 3\n", 1, "`earth.diameter_deg` beside `sun.at`"),
    ] {
        let list = Scenario::parse("t.toml", &format!("{good}{tables}")).unwrap_err();
        let [problem] = &list.iter().collect::<Vec<_>>()[..] else { panic!("{list}") };
        assert!(problem.record().line == Some(MORE + line) && problem.title.contains(expected), "{list}");
    }
    assert!(Scenario::parse("t.toml", &format!("{good}[stars]\nseed = 1\ncount = 2\n[earth]\n")).is_ok());
}

#[test]
fn a_catalogue_is_read_and_listed_among_the_files() {
    let rows = format!("{HEADER}0,90,-1.5,\n90,0,2,1.5\n");
    let (scenario, scenery) =
        dated("1972-12-11T22:00:00Z", &rows, &format!("{CATALOGUE}calligraphic = true\n"), 0.0);
    assert!(scenario.files().iter().any(|file| file.ends_with("stars.csv")));
    let lights = scenery.effects(0.0).lights;
    assert_eq!(lights.len(), 2);
    assert!(lights.iter().all(|light| light.calligraphic));
    // A white star, and an orange one.
    assert!(lights[0].colour == [1.0; 3] && lights[1].colour[0] == 1.0 && lights[1].colour[2] < 0.6);
    // The Moon's pole is 1.5 degrees from that of the ecliptic, 24 degrees from the Earth's at most.
    let elevation = degrees(libm::asin(directions(&scenery.effects(0.0))[0].z));
    assert!((elevation - 20.19).abs() < 25.1, "{elevation}");
}

#[test]
fn every_broken_row_of_a_catalogue_is_told() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("stars.csv");
    let list = |text: &str| {
        fs::write(&file, text).unwrap();
        let path = folder.path().join("s.toml");
        fs::write(&path, format!("{GOOD}{CATALOGUE}")).unwrap();
        match Scenario::read(&path) {
            Ok(_) => Vec::new(),
            Err(list) => {
                list.iter().map(|problem| (problem.record().line, problem.title.clone())).collect::<Vec<_>>()
            }
        }
    };
    assert_eq!(list(&format!("{HEADER}0,90,-1.5,\n")), []);
    let found = list(&format!("{HEADER}0,91,1,\n1,2,3,4\nnan,0,0,\n5,6,inf,\n5,6,,\n5,6,7,9\n"));
    let expected =
        [(2, "declination_deg"), (4, "right_ascension_deg"), (5, "magnitude"), (6, "magnitude"), (7, "b_v")];
    assert_eq!(found.len(), expected.len(), "{found:?}");
    for ((line, column), found) in expected.into_iter().zip(&found) {
        assert!(found.0 == Some(line) && found.1.contains(column), "{line} {column}: {found:?}");
    }
    let found = list("right_ascension_deg,declination_deg\n1,2\n");
    assert!(found.len() == 1 && found[0].1.contains("magnitude"), "{found:?}");
    let found = list(&format!("{HEADER}{}", "1,2,3,\n".repeat(20_001)));
    assert!(found.len() == 1 && found[0].1.contains("more than 20000 stars; --raise stars=N"), "{found:?}");
    assert_eq!(found[0].0, Some(20_002));
    fs::remove_file(&file).unwrap();
    let found = Scenario::read(folder.path().join("s.toml")).unwrap_err();
    assert!(found.to_string().contains("stars.csv"), "{found}");
}

#[test]
fn five_thousand_stars_stand_over_the_ground() {
    let effects = made(&SEEDED.replace("50", "5000")).effects(0.0);
    let above = directions(&effects).iter().filter(|direction| direction.z > 0.0).count();
    // Half of them, within four deviations of 35.
    assert!((above as i64 - 2500).abs() < 142, "{above}");
    let magnitude = |light: &LightPoint| match light.source {
        LightSource::Star { magnitude, .. } => magnitude,
        LightSource::Lamp { .. } => panic!("a lamp"),
    };
    let brighter =
        |limit: f64| effects.lights.iter().filter(|light| magnitude(light) - 1.46 < limit).count() as f64;
    // Ten times as many for two magnitudes.
    let ratio = brighter(5.5) / brighter(3.5);
    assert!((8.0..12.5).contains(&ratio), "{ratio}");
}

#[test]
fn too_many_lamps_are_refused() {
    let string = |id: &str| {
        let lamp = LAMP.replace("'a'", &format!("'{id}'"));
        format!("{lamp}count = 60000\nto = {{ x_m = 200, y_m = 50 }}\n")
    };
    let found = faults(&format!("{}{}", string("a"), string("b")));
    assert!(found.len() == 1 && found[0].1.contains("have 120000 lamps"), "{found:?}");
    assert_eq!(found[0].0, Some(MORE + 7));
}

#[test]
fn too_many_overlays_are_told_once() {
    let twins = format!("{LAMP}{}", LAMP.replace("100", "101"));
    let overlays: String =
        (0..10_001).map(|number| OVERLAY.replace("'a'", &format!("'o{number}'"))).collect();
    let found = faults(&format!("{overlays}{twins}"));
    assert!(found.len() == 2 && found.iter().any(|fault| fault.1.contains("10001 overlays")), "{found:?}");
    // The second of the two lamps is named, whatever else there is.
    let line = MORE + 3 * 10_001 + 6;
    assert!(
        found.iter().any(|fault| fault.0 == Some(line) && fault.1.contains("are called \"a\"")),
        "{found:?}"
    );
}

/// A value of a key, good or broken.
fn value() -> impl Strategy<Value = String> {
    prop_oneof![
        (-20.0..400.0).prop_map(|number: f64| format!("{number:?}")),
        (-3i64..40).prop_map(|number| number.to_string()),
        prop_oneof![
            Just("nan"),
            Just("inf"),
            Just("-inf"),
            Just("true"),
            Just("''"),
            Just("'a'"),
            Just("'ground'"),
            Just("'cart'"),
            Just("[]"),
            Just("[1, 2, 3]"),
            Just("[0.5, 0.5, 0.5]"),
            Just("[[1, 2, 3]]"),
            Just("1e308"),
            Just("-1e308"),
            Just("[[0, 0], [1, 0], [0, 1]]"),
            Just("[[9, 9, 0], [90, 9, 0], [9, 90, 5]]"),
            Just("[[0, 0, nan]]"),
            Just("{}"),
            Just("{ x_m = 300, y_m = 300 }"),
            Just("{ half_angle_deg = 9 }"),
            Just("{ period_s = 1e-300 }"),
            Just("{ spin_deg_s = 9 }"),
            Just("{ keyframes = [{ t_s = 0, x_m = 90, y_m = 90 }] }"),
            Just("'stars.csv'"),
        ]
        .prop_map(str::to_owned),
    ]
}

/// Keys of a table with values, each key at most once.
fn table(head: &'static str, keys: &'static [&'static str]) -> impl Strategy<Value = String> {
    let lines = prop::sample::subsequence(keys, 0..=keys.len());
    lines.prop_flat_map(move |keys| {
        let count = keys.len();
        (Just(keys), prop::collection::vec(value(), count)).prop_map(move |(keys, values)| {
            let lines = keys.iter().zip(values).map(|(key, value)| format!("{key} = {value}\n"));
            format!("{head}\n{}", lines.collect::<String>())
        })
    })
}

const LIGHT_KEYS: &[&str] = &[
    "x_m",
    "y_m",
    "above_m",
    "azimuth_deg",
    "elevation_deg",
    "magnitude",
    "on",
    "at_m",
    "diameter_m",
    "intensity",
    "colour",
    "priority",
    "calligraphic",
    "beam",
    "flash",
    "from_s",
    "until_s",
    "moves",
    "count",
    "to",
];
const SHEET_KEYS: &[&str] = &[
    "corners_m",
    "height",
    "colour",
    "priority",
    "tau",
    "kappa_1_m",
    "thickness_m",
    "from_s",
    "until_s",
    "moves",
];
const OVERLAY_KEYS: &[&str] = &["corners", "colour", "priority", "tau", "from_s", "until_s"];
const STAR_KEYS: &[&str] = &["seed", "count", "brightest", "faintest", "file", "calligraphic", "turn_deg"];
const EARTH_KEYS: &[&str] = &["azimuth_deg", "elevation_deg", "diameter_deg", "albedo"];

/// Whether all numbers of effects are finite, and directions unit vectors.
fn are_sound(effects: &Effects) -> bool {
    let light = |light: &LightPoint| match light.source {
        LightSource::Lamp { at, diameter } => at.is_finite() && diameter > 0.0,
        LightSource::Star { direction, magnitude } => direction.is_normalized() && magnitude.is_finite(),
    };
    let disc = |disc: &SkyDisc| disc.direction.is_normalized() && disc.angular_diameter > 0.0;
    effects.lights.iter().all(light)
        && effects.discs.iter().all(disc)
        && effects.sheets.iter().flat_map(|sheet| &sheet.corners).all(|corner| corner.is_finite())
}

/// Whether tables are read, placed and sound at several times. Nothing panics, whatever is refused.
fn is_seen(tables: &str) -> bool {
    let Ok(scenario) = Scenario::parse("t.toml", &format!("{GOOD}{tables}")) else { return false };
    let Ok(scenery) = placed(&scenario) else { return false };
    [0.0, 0.7, 12.0].iter().all(|time| are_sound(&scenery.effects(*time)))
}

proptest! {
    #[test]
    fn random_tables_never_panic(
        light in table("[[light]]\nid = 'l'", LIGHT_KEYS),
        sheet in table("[[sheet]]\nid = 's'", SHEET_KEYS),
        overlay in table("[[overlay]]\nid = 'o'", OVERLAY_KEYS),
        stars in table("[stars]", STAR_KEYS),
        earth in table("[earth]", EARTH_KEYS),
    ) {
        for tables in [&light, &sheet, &overlay, &stars, &earth] {
            is_seen(tables);
        }
        let object = "[[object]]\nid = 'cart'\nmodel = 'marker'\nx_m = 300\ny_m = 330\n";
        is_seen(&format!("{object}{light}{sheet}{overlay}{stars}{earth}"));
    }

    #[test]
    fn random_good_tables_are_placed(
        x in 1.0..300.0, y in 1.0..300.0, diameter in 1e-3..1e4, count in 2u32..40, beam in 0.1..90.0,
        corner in 0.1..50.0, kappa in 0.0..10.0, seed in 0u64..1000, elevation in -90.0..90.0,
    ) {
        let light = format!("[[light]]\nid = 'l'\nx_m = {x:?}\ny_m = {y:?}\ndiameter_m = {diameter:?}\n");
        let string = format!("count = {count}\nto = {{ x_m = {y:?}, y_m = {x:?} }}\nbeam = {{ half_angle_deg = {beam:?} }}\n");
        let sheet = format!(
            "[[sheet]]\nid = 's'\ncorners_m = [[{x:?}, {y:?}, 0], [{x:?}, {:?}, 0], [{x:?}, {y:?}, {corner:?}]]\n\
             kappa_1_m = {kappa:?}\nthickness_m = {corner:?}\n", y + corner);
        let earth = format!("[earth]\nazimuth_deg = {x:?}\nelevation_deg = {elevation:?}\n");
        let sky = format!("[stars]\nseed = {seed}\ncount = {count}\n{earth}");
        prop_assert!(is_seen(&[light, string, sheet, sky].concat()));
    }
}
