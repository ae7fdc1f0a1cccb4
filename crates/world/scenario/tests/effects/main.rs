//! Lights, sheets, overlays, stars and discs of the sky: read, refused, placed on their ground.

mod lamps;
mod meant;
mod random;
mod refused;
mod sheets;
mod sky;
mod stars;

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

const HEADER: &str = "right_ascension_deg,declination_deg,magnitude,b_v\n";
const CATALOGUE: &str = "[stars]\nfile = 'stars.csv'\n";

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

fn directions(effects: &Effects) -> Vec<DVec3> {
    let direction = |light: &LightPoint| match light.source {
        LightSource::Star { direction, .. } => direction,
        LightSource::Lamp { .. } => panic!("a lamp"),
    };
    effects.lights.iter().map(direction).collect()
}
