//! Light, bodies and tracks of a scenario, on its ground and over time.

use std::collections::BTreeSet;

use ephemeris::{Instant, MOON_RADIUS, Place, Sky};
use landscape::{Bank, Georeference, Landscape, Level};
use quantities::{Rate, degrees, radians};
use scenario::{GroundSource, Scenario, Scenery, SceneryProblem, SceneryProblems};
use solids::Kind;

const GOOD: &str = r#"format = 1
title = "t"
shows = "s"
frames = 90
[landscape.generated]
seed = 1
extent_m = [600, 640]
region_size_m = 40
tilt_m_per_m = [0.1, 0.0]
[sun]
azimuth_deg = 10
elevation_deg = 12
[path]
keyframes = [{ t_s = 0, x_m = 100, y_m = 300 }, { t_s = 100, x_m = 500, y_m = 300 }]
"#;

const ROCKS: &str = "[rocks]\nseed = 4\ndensity_per_m2 = 0.01\nsmallest_m = 0.2\nlargest_m = 3\n";

fn scenery(tables: &str) -> Result<(Scenario, Scenery), SceneryProblems> {
    let scenario =
        Scenario::parse("t.toml", &format!("{GOOD}\n{tables}")).unwrap_or_else(|list| panic!("{list}"));
    let GroundSource::Generated(relief) = &scenario.ground else { panic!("generated") };
    let bank = Bank::new("t", vec![relief.build().unwrap()], None).unwrap();
    let scenery = Scenery::of(&scenario, &Landscape::new(bank, 1.0), rate())?;
    Ok((scenario, scenery))
}

fn rate() -> Rate {
    Rate::new(30, 1).unwrap()
}

fn made(tables: &str) -> Scenery {
    scenery(tables).unwrap_or_else(|problems| panic!("{problems}")).1
}

fn object(id: &str, x: f64, y: f64) -> String {
    format!("[[object]]\nid = '{id}'\nmodel = 'marker'\nx_m = {x:?}\ny_m = {y:?}\n")
}

#[test]
fn a_plain_scenario_has_nothing_on_the_ground() {
    let (scenario, plain) = scenery("").unwrap();
    let start = plain.start().copied();
    assert!(start.is_some(), "the pose of frame 0");
    assert_eq!(plain, Scenery::still(scenario.sun.first().unwrap()).with_start(start));
}

#[test]
fn objects_stand_on_the_ground_in_their_time() {
    let events = "[[event]]\nt_s = 2\naction = 'move'\nobject = 'a'\nx_m = 200\ny_m = 50\n\
                  [[event]]\nt_s = 4\naction = 'delete'\nobject = 'a'\n";
    let scenery = made(&(object("a", 300.0, 40.0) + &object("b", 20.0, 20.0) + events));
    let feet = |time: f64| {
        let feet = scenery.bodies(time).map(|body| (body.object, body.foot.to_array()));
        feet.map(|(object, foot)| (object, foot.map(|part| (1e6 * part).round() as i64)))
            .collect::<BTreeSet<_>>()
    };
    let at = |object, x: i64, y: i64| (object, [1_000_000 * x, 1_000_000 * y, 100_000 * x]);
    assert_eq!(feet(0.0), BTreeSet::from([at(0, 300, 40), at(1, 20, 20)]));
    assert_eq!(feet(1.999), feet(0.0));
    assert_eq!(feet(2.0), BTreeSet::from([at(0, 200, 50), at(1, 20, 20)]));
    assert_eq!(feet(4.0), BTreeSet::from([at(1, 20, 20)]));
    assert!(scenery.bodies(0.0).all(|body| body.kind == Kind::Culture));
}

#[test]
fn objects_beside_the_ground_are_named() {
    let tables = object("far", 700.0, 40.0) + &object("near", 20.0, 20.0) + &object("west", 20.0, -1.0);
    let SceneryProblems(problems) = scenery(&tables).unwrap_err();
    let named = |problem: &SceneryProblem| match problem {
        SceneryProblem::ObjectOutside { id, .. } => id.clone(),
        other => panic!("{other}"),
    };
    assert_eq!(problems.iter().map(named).collect::<Vec<_>>(), ["far", "west"]);
    let text = problems[0].to_string();
    assert!(text.contains("object \"far\"") && text.contains("x 0..600 m, y 0..640 m"), "{text}");
}

#[test]
fn rocks_lie_on_the_ground_beside_what_drives_and_stands() {
    let stand = object("a", 300.0, 330.0);
    let scenery = made(&format!("{ROCKS}radius_m = 20\n{stand}"));
    let rocks: Vec<_> = scenery.bodies(0.0).filter(|body| body.kind == Kind::Rock).collect();
    assert!(rocks.len() > 500, "{}", rocks.len());
    let numbers: BTreeSet<u32> = rocks.iter().map(|body| body.object).collect();
    assert!(
        numbers.len() == rocks.len() && numbers.first() == Some(&1),
        "one number each, after the objects"
    );
    let marker: Vec<_> = scenery.bodies(0.0).filter(|body| body.kind == Kind::Culture).collect();
    for rock in &rocks {
        assert!((rock.foot.z - 0.1 * rock.foot.x).abs() < 1e-9);
        for part in &marker {
            assert!((rock.foot - part.centre).truncate().length() > part.radius);
        }
    }
    // The path runs along y = 300: nothing large in the lane, nothing at all under the wheels, small ones between.
    let in_lane = |rock: &&&solids::Body| {
        (100.0..500.0).contains(&rock.foot.x) && (rock.foot.y - 300.0).abs() < 0.5 * 1.83
    };
    let width = |body: &solids::Body| {
        let across = body.vertices().map(|vertex| vertex.y);
        across.clone().fold(f64::NEG_INFINITY, f64::max) - across.fold(f64::INFINITY, f64::min)
    };
    let lane: Vec<_> = rocks.iter().filter(in_lane).collect();
    assert!(!lane.is_empty() && lane.iter().all(|rock| width(rock) < 0.36 * 1.42), "{}", lane.len());
    let under = |rock: &&&solids::Body| ((rock.foot.y - 300.0).abs() - 0.915).abs() < 0.1;
    assert_eq!(rocks.iter().filter(under).filter(in_lane).count(), 0);
}

/// From y = 330 to y = 380 along x = 300, then up.
const CART: &str = "[[object]]\nid = 'cart'\nmodel = 'marker'\nx_m = 300\ny_m = 330\nheading_deg = 8\n\
    [object.moves]\nkeyframes = [{ t_s = 2, x_m = 300, y_m = 330 }, \
    { t_s = 4, x_m = 300, y_m = 380, heading_deg = 20, pitch_deg = 6, roll_deg = -4 }, \
    { t_s = 8, x_m = 400, y_m = 380, above_m = 50 }]\n";

#[test]
fn what_moves_is_between_its_stations() {
    let scenery = made(CART);
    assert_eq!((scenery.bodies(3.0).count(), scenery.standing().len()), (0, 0));
    // The ground rises by 0.1 to the north.
    for (time, foot, heading, pitch, roll) in [
        (0.0, [300.0, 330.0, 30.0], 8.0, 0.0, 0.0),
        (3.0, [300.0, 355.0, 30.0], 14.0, 3.0, -2.0),
        (4.0, [300.0, 380.0, 30.0], 20.0, 6.0, -4.0),
        (5.0, [325.0, 380.0, 45.0], 17.0, 4.5, -3.0),
        (99.0, [400.0, 380.0, 90.0], 8.0, 0.0, 0.0),
    ] {
        let [heading, pitch, roll] = [heading, pitch, roll].map(radians);
        let attitude = landscape::Attitude { heading, pitch, roll };
        let turn = scenario::Stance { at: [0.0; 2], attitude }.to_ground();
        for body in scenery.guests(time) {
            assert!(body.foot.distance(foot.into()) < 1e-9, "{time}: {}", body.foot);
            assert!(body.to_ground().0.abs_diff_eq(turn, 1e-12), "{time}");
        }
        assert!(scenery.guests(time).count() > 0);
    }
    let event = "[[event]]\nt_s = 3\naction = 'delete'\nobject = 'cart'\n";
    let gone = made(&format!("{CART}{event}"));
    assert!(gone.guests(2.9).count() > 0 && gone.guests(3.0).count() == 0);
    // One station and no spin: it hangs there, and is listed as an object of `moves`.
    let hung = CART.replace("[{ t_s = 2, x_m = 300, y_m = 330 }, ", "[");
    let hung =
        made(&hung[..hung.find(", { t_s = 8").unwrap()].replace("roll_deg = -4 }", "roll_deg = -4 }]"));
    assert!(!hung.all_guests().is_empty() && hung.all_guests().iter().all(scenario::Guest::moves));
}

#[test]
fn rocks_keep_clear_of_what_moves() {
    let strewn = format!("{}area_m = [280, 320, 420, 400]\n", ROCKS.replace("0.01", "0.05"));
    let way = |rock: &solids::Body| {
        let [north, east] =
            [rock.foot.x - 300.0, (rock.foot.y - 330.0).clamp(0.0, 50.0) + 330.0 - rock.foot.y];
        libm::hypot(north, east) - rock.radius
    };
    let near = |scenery: &Scenery| scenery.bodies(0.0).filter(|rock| way(rock) < 0.1).count();
    let (bare, clear) = (made(&strewn), made(&format!("{strewn}{CART}")));
    assert!(near(&bare) > 5 && near(&clear) == 0, "{} {}", near(&bare), near(&clear));
    // It leaves what it flies over.
    let below = |scenery: &Scenery| {
        scenery.bodies(0.0).filter(|rock| rock.foot.x > 340.0 && (rock.foot.y - 380.0).abs() < 1.0).count()
    };
    assert!(below(&bare) > 3 && below(&clear) == below(&bare), "{} {}", below(&bare), below(&clear));
}

#[test]
fn large_rocks_lie_as_far_as_they_are_large() {
    let scenery = made(&format!("{ROCKS}radius_m = 10\n"));
    let way = |body: &solids::Body| {
        let north = (100.0 - body.foot.x).max(body.foot.x - 500.0).max(0.0);
        let east = body.foot.y - 300.0;
        (north * north + east * east).sqrt()
    };
    let farthest = |low: f64, high: f64| {
        let sized = scenery.bodies(0.0).filter(|body| (low..high).contains(&(2.0 * body.radius)));
        sized.map(way).fold(0.0, f64::max)
    };
    let (small, large) = (farthest(0.0, 0.25), farthest(2.0, 9.0));
    assert!(small < 20.0 && large > 60.0, "{small} {large}");
}

#[test]
fn too_many_rocks_are_refused_before_they_are_made() {
    let crowd = ROCKS.replace("0.01", "500").replace("smallest_m = 0.2", "smallest_m = 0.8");
    for area in ["radius_m = 1000", "area_m = [0, 0, 600, 600]"] {
        let SceneryProblems(problems) = scenery(&format!("{crowd}{area}\n")).unwrap_err();
        let text = problems[0].to_string();
        assert!(problems.len() == 1 && text.contains("expected at most 100000"), "{text}");
    }
}

#[test]
fn the_sun_goes_step_by_step() {
    let text = GOOD.replace(
        "elevation_deg = 12",
        "elevation_deg = 12\nstep_s = 2\ndrift = [{ t_s = 8, azimuth_deg = 10, elevation_deg = 8 }]",
    );
    let scenario = Scenario::parse("t.toml", &text).unwrap_or_else(|list| panic!("{list}"));
    let level = Level::new(600.0, [0.0; 2], [2, 2], vec![[0.0; 9]; 4]).unwrap();
    let landscape = Landscape::new(Bank::new("", vec![level], None).unwrap(), 1.0);
    let scenery = Scenery::of(&scenario, &landscape, rate()).unwrap();
    for (time, elevation) in [(0.0, 12.0), (1.9, 12.0), (2.0, 11.0), (5.0, 10.0), (8.0, 8.0), (80.0, 8.0)] {
        let found = degrees(scenery.sun(time).elevation);
        assert!((found - elevation).abs() < 1e-12, "t = {time}: {found}");
    }
    assert_eq!(scenery.suns().len(), 5);
}

/// Level ground with its middle at the landing site of Apollo 17, true north so far (rad) from its x axis.
fn valley(true_north: Option<f64>) -> Landscape {
    let level = Level::new(600.0, [0.0; 2], [2, 2], vec![[0.0; 9]; 4]).unwrap();
    let [latitude, longitude] = [20.19, 30.77].map(radians);
    let place = Georeference { latitude, longitude, at: [300.0; 2], true_north };
    Landscape::new(Bank::new("", vec![level], Some(place)).unwrap(), 1.0)
}

fn dated(keys: &str) -> Scenario {
    let ground = "[landscape.generated]\nseed = 1\nextent_m = [600, 640]\nregion_size_m = 40\ntilt_m_per_m = [0.1, 0.0]";
    let text = GOOD.replace(ground, "[landscape]\nbank = 'valley.bank'");
    let text =
        text.replace("azimuth_deg = 10\nelevation_deg = 12", keys).replace("frames = 90", "duration_s = 150");
    Scenario::parse("t.toml", &text).unwrap_or_else(|list| panic!("{list}"))
}

const AT: &str = "at = '1972-12-11T22:00:00Z'";

#[test]
fn a_date_has_the_sun_of_its_place() {
    let of = |keys: &str, north: f64| Scenery::of(&dated(keys), &valley(Some(north)), rate()).unwrap();
    let scenery = of(AT, 0.0);
    let sky = scenery.sky().unwrap();
    assert_eq!(sky.at.to_string(), "1972-12-11T22:00:00Z");
    // Elevation about 14.3 degrees two hours after the landing at 13.3, in the east.
    let sun = scenery.sun(0.0);
    assert!((degrees(sun.elevation) - 14.3).abs() < 0.3, "{}", degrees(sun.elevation));
    assert!((degrees(sun.azimuth) - 95.0).abs() < 3.0, "{}", degrees(sun.azimuth));
    assert_eq!((sun.azimuth, sun.elevation), (sky.sky.sun.azimuth, sky.sky.sun.elevation));
    // 150 s are three steps of 60 s; the sun climbs half a degree an hour.
    assert_eq!(scenery.suns().iter().map(|sun| sun.0).collect::<Vec<_>>(), [0.0, 60.0, 120.0]);
    let climbed = degrees(scenery.sun(149.0).elevation - sun.elevation);
    assert!((climbed - 0.48 * 120.0 / 3600.0).abs() < 1e-3, "{climbed}");
    assert_eq!(of(&format!("{AT}\nstep_s = 200"), 0.0).suns().len(), 1);
    // A place of the scenario is over that of the bank.
    let other = of(&format!("{AT}\nplace = {{ longitude_deg = 60, latitude_deg = 0 }}"), 0.0);
    assert!(degrees(other.sun(0.0).elevation) > 40.0);
    // Where true north is 30 degrees to the right of the x axis, so is everything else; across 360 too.
    for north in [30.0, -100.0, 359.0] {
        let turned = of(AT, radians(north)).sun(0.0);
        let turn = degrees(turned.azimuth - sun.azimuth) - north;
        assert!(
            (turn - 360.0 * (turn / 360.0).round()).abs() < 1e-9 && turned.elevation == sun.elevation,
            "{north}"
        );
        assert!((0.0..std::f64::consts::TAU).contains(&turned.azimuth));
    }
}

#[test]
fn dates_without_a_sun_are_refused() {
    let said = |keys: &str, ground: &Landscape| match Scenery::of(&dated(keys), ground, rate()) {
        Ok(_) => panic!("{keys}"),
        Err(problems) => problems.to_string(),
    };
    let plain = Landscape::new(Bank::new("", valley(None).bank().levels().to_vec(), None).unwrap(), 1.0);
    assert!(said(AT, &plain).contains("`at` needs a place on the Moon"));
    assert!(said(AT, &valley(None)).contains("make it again with `lunoid survey`"));
    let night = said("at = '1972-12-25T22:00:00Z'", &valley(Some(0.0)));
    assert!(
        night.contains("at 1972-12-25T22:00:00Z, t = 0 s") && night.contains("expected above 0"),
        "{night}"
    );
    // The sun sets while the mission lasts: at its last step.
    let place = Place { longitude: radians(30.77), latitude: radians(20.19), radius: MOON_RADIUS };
    let noon: Instant = "1972-12-17T12:00:00Z".parse().unwrap();
    let minute = (0..20_000)
        .find(|minute| Sky::over(place, noon.later(60.0 * f64::from(*minute))).sun.elevation < 0.0);
    let before = noon.later(60.0 * f64::from(minute.unwrap() - 2));
    let evening = said(&format!("at = '{before}'"), &valley(Some(0.0)));
    assert!(evening.contains("t = 120 s, the sun stands at an elevation of -0.0"), "{evening}");
    let steps = said(&format!("{AT}\nstep_s = 1e-3"), &valley(Some(0.0)));
    assert!(steps.contains("150000 steps of 0.001 s") && steps.contains("sun-steps"), "{steps}");
    // A mission that goes on beyond what is measured, with the sun up.
    let beyond = "place = { longitude_deg = -103, latitude_deg = 0 }";
    let beyond = said(&format!("at = '2050-12-31T23:58:59Z'\n{beyond}"), &valley(Some(0.0)));
    assert!(
        beyond.contains("at 2051-01-01T00:00:59Z, t = 120 s, the error of the sun is not measured"),
        "{beyond}"
    );
    // Imported ground has its x axis to the north.
    let placed = dated(&format!("{AT}\nplace = {{ longitude_deg = 30.77, latitude_deg = 20.19 }}"));
    assert_eq!(Scenery::of(&placed, &plain, rate()).unwrap().sky().unwrap().true_north, 0.0);
}

/// Check values of the terrain builder's specification (its table 9.1); the same from the bank's own place, and turned with true north.
#[test]
fn a_sub_solar_point_has_the_sun_of_the_place() {
    let under = "sub_solar_deg = [1.5, 80]";
    let placed = format!("{under}\nplace = {{ longitude_deg = 3.63386, latitude_deg = 26.13222 }}");
    let of = |keys: &str, ground: &Landscape| Scenery::of(&dated(keys), ground, rate());
    let scenery = of(&placed, &valley(Some(0.0))).unwrap();
    let sun = scenery.sun(0.0);
    assert!((degrees(sun.elevation) - 12.889_913_105_841).abs() < 1e-10, "{}", degrees(sun.elevation));
    assert!((degrees(sun.azimuth) - 94.724_151_559_080).abs() < 1e-10, "{}", degrees(sun.azimuth));
    assert_eq!((scenery.suns().len(), scenery.sky()), (1, None), "it stands, and the sky has no date");
    let turned = of(&placed, &valley(Some(radians(300.0)))).unwrap().sun(0.0);
    assert!((degrees(turned.azimuth) - 34.724_151_559_080).abs() < 1e-9, "{}", degrees(turned.azimuth));
    // Overhead at the bank's own place.
    let overhead = of("sub_solar_deg = [20.19, 30.77]", &valley(Some(0.0))).unwrap().sun(0.0);
    assert!((degrees(overhead.elevation) - 90.0).abs() < 1e-6);
    let said = |keys: &str, ground: &Landscape| match of(keys, ground) {
        Ok(_) => panic!("{keys}"),
        Err(problems) => problems.to_string(),
    };
    let down = said("sub_solar_deg = [1.5, -80]", &valley(Some(0.0)));
    assert!(
        down.contains(
            "over latitude 20.1900, longitude 30.7700 deg the sun of `sub_solar_deg` = [1.5000, -80.0000]"
        ),
        "{down}"
    );
    assert!(down.contains("expected above 0; choose a sub-solar point less than 90 deg away"), "{down}");
    let plain = Landscape::new(Bank::new("", valley(None).bank().levels().to_vec(), None).unwrap(), 1.0);
    assert!(said(under, &plain).contains("`sub_solar_deg` needs a place on the Moon"));
    assert!(said(under, &valley(None)).contains("`sub_solar_deg` needs the direction of true north"));
}

#[test]
fn tracks_grow_with_time() {
    let scenery = made("[shadows]\n[tracks]\n");
    // 4 m/s, patches of 0.15 m every 0.3 m, two wheels.
    assert_eq!(scenery.patches(0.03).len(), 0);
    let laid = |time: f64| scenery.patches(time).len();
    assert_eq!((laid(0.04), laid(1.0)), (2, 26));
    for (length, expected) in [(6e3, "more than 1000000 patches"), (4e5, "too long")] {
        let SceneryProblems(problems) =
            there_and_back("[shadows]\n[tracks]\nspacing_m = 0.01\n", length).unwrap_err();
        assert!(problems[0].to_string().contains(expected), "{}", problems[0]);
    }
}

/// The same ride, there and back until it is `length` (m) long.
fn there_and_back(tables: &str, length: f64) -> Result<Scenery, SceneryProblems> {
    let rides = (length / 400.0) as usize;
    let waypoint = |index: usize| scenario::Waypoint {
        time: index as f64,
        at: [if index.is_multiple_of(2) { 100.0 } else { 500.0 }, 300.0],
        heading: Some(0.0),
        eye_height: None,
        pitch: None,
        roll: None,
    };
    let path = scenario::Path::new((0..=rides).map(waypoint).collect()).unwrap();
    let wishes = Scenario::parse("t.toml", &format!("{GOOD}{tables}")).unwrap();
    let GroundSource::Generated(relief) = &wishes.ground else { panic!("generated") };
    let bank = Bank::new("t", vec![relief.build().unwrap()], None).unwrap();
    Scenery::of(&Scenario { path, ..wishes }, &Landscape::new(bank, 1.0), rate())
}
