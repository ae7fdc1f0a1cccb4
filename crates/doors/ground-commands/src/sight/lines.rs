//! Lines of sight to single targets: as text, as JSON and as CSV.

use std::fmt::Write;
use std::path::Path;

use serde_json::{Value, json};
use sight::{LineOfSight, Point, Sight};

use super::ground::Site;
use super::options::point;
use super::{SightCommand, profile, refused};
use command_line::Failure;
use command_line::output::{ending, print, print_json};

/// Looks at one target.
pub fn one(command: &SightCommand, to: [f64; 2]) -> Result<(), Failure> {
    let target = point(to, command.target_height);
    let (site, found) = look(command, &[target])?;
    for out in &command.out {
        if ending(out) == "csv" {
            write_csv(out, &[target], &found)?;
        } else {
            profile::picture(command, &site, (&target, &found[0]))?.write(out)?;
        }
    }
    tell(command, &site, &[target], &found)
}

/// Looks at each target of a list.
pub fn many(command: &SightCommand, targets: &[Point]) -> Result<(), Failure> {
    let (site, found) = look(command, targets)?;
    command.out.iter().try_for_each(|out| write_csv(out, targets, &found))?;
    tell(command, &site, targets, &found)
}

fn look(command: &SightCommand, targets: &[Point]) -> Result<(Site, Vec<LineOfSight>), Failure> {
    let site = command.site(targets)?;
    let curvature = command.bending.curvature(site.radius())?;
    let found = site.along(&command.observer(), targets, curvature).map_err(refused)?;
    Ok((site, found))
}

/// Word of an answer.
pub fn word(sight: Sight) -> &'static str {
    match sight {
        Sight::Visible => "visible",
        Sight::Hidden => "hidden",
        Sight::Unknown => "unknown",
    }
}

fn tell(
    command: &SightCommand,
    site: &Site,
    targets: &[Point],
    found: &[LineOfSight],
) -> Result<(), Failure> {
    if command.json {
        return print_json(&document(command, site, targets, found));
    }
    let mut text =
        format!("{}, {}; {}\n", site.title, command.surface_word(site), command.bending.told(site.radius()));
    for (target, line) in targets.iter().zip(found) {
        let [north, east] = target.place;
        // Writing to a string cannot fail.
        let _ = writeln!(text, "{north},{east}: {}", told(line));
    }
    print(&text)
}

/// A line in words.
pub fn told(line: &LineOfSight) -> String {
    let mut text = format!("{} over {:.3} m", word(line.sight), line.distance);
    if line.clearance.is_finite() {
        text += &format!(", clearance {:.4} m", line.clearance);
    }
    if let Some(blocker) = line.blocker {
        let [north, east] = blocker.place;
        text += &format!(", first blocked at {north:.3},{east:.3} after {:.3} m", blocker.distance);
    }
    match line.least_height {
        Some(0.0) => text + ", seen from the ground up",
        Some(height) => text + &format!(", seen from {height:.4} m above the ground up"),
        None => text + ", least height unknown",
    }
}

fn document(command: &SightCommand, site: &Site, targets: &[Point], found: &[LineOfSight]) -> Value {
    let line = |(target, line): (&Point, &LineOfSight)| {
        json!({
            "to_m": target.place,
            "sight": word(line.sight),
            "distance_m": line.distance,
            "clearance_m": Some(line.clearance).filter(|clearance| clearance.is_finite()),
            "least_height_m": line.least_height,
            "blocker": line.blocker.map(|blocker| json!({
                "place_m": blocker.place,
                "distance_m": blocker.distance,
            })),
        })
    };
    let mut document = header(command, site);
    document["lines"] = targets.iter().zip(found).map(line).collect();
    document
}

/// What every document begins with.
pub fn header(command: &SightCommand, site: &Site) -> Value {
    json!({
        "schema": "lunoid.sight/1",
        "ground": command.ground.display().to_string(),
        "title": site.title,
        "surface": command.surface_word(site),
        "curvature": command.bending.told(site.radius()),
        "from_m": command.from,
        "files": command.out.iter().map(|out| out.display().to_string()).collect::<Vec<_>>(),
    })
}

fn write_csv(out: &Path, targets: &[Point], found: &[LineOfSight]) -> Result<(), Failure> {
    let mut text =
        "north_m,east_m,sight,distance_m,clearance_m,least_height_m,blocker_north_m,blocker_east_m,\
                    blocker_distance_m\n"
            .to_owned();
    for (target, line) in targets.iter().zip(found) {
        let cell = |number: Option<f64>| {
            number.filter(|number| number.is_finite()).map_or_else(String::new, |n| n.to_string())
        };
        let [north, east] = target.place;
        let blocker = [0, 1].map(|axis| cell(line.blocker.map(|blocker| blocker.place[axis])));
        let distance = cell(line.blocker.map(|blocker| blocker.distance));
        let [clearance, least] = [cell(Some(line.clearance)), cell(line.least_height)];
        let _ = writeln!(
            text,
            "{north},{east},{},{},{clearance},{least},{},{},{distance}",
            word(line.sight),
            line.distance,
            blocker[0],
            blocker[1]
        );
    }
    Ok(files::write_atomic(out, |file| file.write_all(text.as_bytes()))?)
}
