//! What a scenario file holds.

use std::path::Path;

use front_door::read_scenario;
use quantities::degrees;
use scenario::{GroundSource, Length, Scenario, SubSolarPoint, Sunlight};
use serde_json::{Value, json};

use crate::{Held, InfoError};

pub fn scenario(path: &Path) -> Result<Held, InfoError> {
    let scenario = read_scenario(path)?;
    let ground = match &scenario.ground {
        GroundSource::Bank(bank) => format!("bank {}", bank.display()),
        GroundSource::Generated(relief) => format!("generated from seed {}", relief.seed),
    };
    let length = match scenario.length {
        Length::Frames(frames) => format!("{frames} frames"),
        Length::Seconds(seconds) => format!("{seconds} s"),
    };
    let (sun, angles) = sun(&scenario.sun);
    let waypoints = scenario.way().waypoints().len();
    let document = json!({
        "schema": "lunoid.info.scenario/1",
        "file": path.display().to_string(),
        "title": scenario.title,
        "shows": scenario.shows,
        "machine": scenario.machine,
        "length": length,
        "ground": ground,
        "sun": sun,
        "sun_deg": angles,
        "waypoints": waypoints,
        "contents": contents(&scenario),
        "files": scenario.files().iter().map(|file| file.display().to_string()).collect::<Vec<_>>(),
    });
    let text = format!(
        "{}: {}\n  {}\n  {length} by machine {}; ground {ground}; {sun}; {waypoints} waypoints\n{}",
        path.display(),
        scenario.title,
        scenario.shows,
        scenario.machine,
        contained(&contents(&scenario)),
    );
    Ok(Held { document, text })
}

/// The sun in words, and its angles (deg) at the start where the scenario gives them.
fn sun(light: &Sunlight) -> (String, Option<[f64; 2]>) {
    match light {
        Sunlight::Angles { first, .. } => {
            let [azimuth, elevation] = [first.azimuth, first.elevation].map(degrees);
            (format!("sun at azimuth {azimuth:.1}, elevation {elevation:.1} deg"), Some([azimuth, elevation]))
        }
        Sunlight::Dated(date) => (format!("sun of {}", date.at), None),
        Sunlight::SubSolar(SubSolarPoint { point, .. }) => {
            let [latitude, longitude] = point.map(degrees);
            let [latitude, longitude] = [text::latitude(latitude, 4), text::longitude(longitude, 4)];
            (format!("sun overhead at {latitude}, {longitude}"), None)
        }
    }
}

/// What a scenario has beside terrain, one sun and a path.
fn contents(scenario: &Scenario) -> Value {
    json!({
        "listed_craters": scenario.features.list.as_ref().map_or(0, |list| list.craters.len()),
        "crater_populations": scenario.features.populations.len(),
        "rocks": scenario.rocks.is_some(),
        "objects": scenario.objects.len(),
        "events": scenario.events.len(),
        "tracks": scenario.tracks.is_some(),
        "remote_shadow": scenario.shadows.is_some(),
        "moving_sun": scenario.sun.moves(),
        "texture": scenario.texture.is_some(),
        "silhouettes": scenario.silhouettes.len(),
        "coarse_ground": scenario.coarse.is_some(),
        "channels": scenario.channels.len(),
    })
}

/// The same in a line, if there is anything.
fn contained(contents: &Value) -> String {
    let word = |(key, value): (&String, &Value)| match value {
        Value::Bool(true) => Some(key.replace('_', " ")),
        Value::Number(number) if number.as_u64() != Some(0) => {
            Some(format!("{number} {}", key.replace('_', " ")))
        }
        _ => None,
    };
    let words: Vec<String> = contents.as_object().into_iter().flatten().filter_map(word).collect();
    if words.is_empty() { String::new() } else { format!("  with {}\n", words.join(", ")) }
}
