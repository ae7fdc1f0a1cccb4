//! What the places of a path file mean, and how they come into the axes of the bank.

use std::path::Path as FilePath;

use diagnostics::{LongList, Problem, Problems, Reader};
use landscape::bank_file::{Outline, read_outline};
use landscape::{FileCoordinates, MapFrame};
use quantities::degrees;

use super::points::Points;

/// Meaning of the places of a path.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Coordinates {
    /// Metres north and east of the bank's origin.
    Bank,
    /// Metres of the elevation file's own projection, north and east.
    File,
    /// Latitude and longitude, in degrees.
    LonLat,
}

const WORDS: [(&str, Coordinates); 3] =
    [("bank", Coordinates::Bank), ("file", Coordinates::File), ("lon-lat", Coordinates::LonLat)];

impl Coordinates {
    /// What `path.coordinates` says; `Some(None)` if it is left out.
    pub fn read(table: &Reader) -> Option<Option<Self>> {
        let word = table.one_of("coordinates", &WORDS).optional();
        if table.has("coordinates") { word.map(Some) } else { Some(None) }
    }

    /// As `path.coordinates` has it.
    pub fn word(self) -> &'static str {
        WORDS.iter().find(|(_, coordinates)| *coordinates == self).map_or("", |(word, _)| word)
    }
}

/// Ground that a path lies on, as far as it is known before it is read.
#[derive(Debug, Clone, Copy)]
pub(super) enum Ground<'p> {
    /// A bank in a file.
    Bank(&'p FilePath),
    /// Generated ground, which lies nowhere.
    Generated,
}

/// The points in the axes of the bank. `None` if there is no way from their coordinates to these, or if a point is not on the
/// map.
pub(super) fn in_bank(
    points: Points,
    table: &Reader,
    ground: Option<Ground>,
    problems: &Problems,
) -> Option<Points> {
    let Some(first) = points.waypoints.first().filter(|_| points.coordinates != Coordinates::Bank) else {
        return Some(points);
    };
    // A fault of the ground is told already.
    let (map, outline) = map(points.coordinates, table, ground?, problems)?;
    let name = first.place.source.name.clone();
    let mut faults = LongList::new(&name);
    let mut moved = points.clone();
    for waypoint in &mut moved.waypoints {
        let at = waypoint.value.at;
        let place = match points.coordinates {
            Coordinates::LonLat => map.of_point(at[0], at[1]),
            _ => Some([at[0] - map.origin[0], at[1] - map.origin[1]]),
        };
        let Some(place) = place else {
            let [latitude, longitude] = at.map(degrees);
            let [latitude, longitude] = [text::latitude(latitude, 9), text::longitude(longitude, 9)];
            let title = format!("the map of the bank does not show {latitude}, {longitude}");
            faults.push(Problem::of(waypoint, title).expected("a place on the map of the bank"));
            continue;
        };
        waypoint.value.at = place;
        if points.coordinates == Coordinates::LonLat
            && let (Some(heading), Some(north)) = (&mut waypoint.value.heading, map.true_north(place))
        {
            *heading += north;
        }
    }
    let moved = faults.finish(moved, problems)?;
    note_exchange(&points, &moved, &map, &outline, &name, problems);
    Some(moved)
}

/// The map of the bank, where it goes with `coordinates`.
fn map(
    coordinates: Coordinates,
    table: &Reader,
    ground: Ground,
    problems: &Problems,
) -> Option<(MapFrame, Outline)> {
    let word = coordinates.word();
    let key = if table.has("coordinates") { "coordinates" } else { "file" };
    let refuse = |title: String, expected: &str| table.report(table.problem(key, title).expected(expected));
    let Ground::Bank(bank) = ground else {
        refuse(
            format!("a path in `{word}` coordinates over generated ground, which has no place on the Moon"),
            "`landscape.bank`, or a path in x_m and y_m",
        );
        return None;
    };
    let name = bank.display().to_string();
    let outline = match read_outline(bank) {
        Ok(outline) => outline,
        Err(error) => {
            let problem = Problem::of_file(&name, error.to_string());
            problems.push(problem.help(format!("a path in `{word}` coordinates needs the bank")));
            return None;
        }
    };
    let Some(map) = outline.map else {
        refuse(
            format!("a path in `{word}` coordinates over {name}, which does not say where it came from"),
            "a bank that this version of `lunoid survey` wrote",
        );
        return None;
    };
    match coordinates {
        Coordinates::LonLat if map.projection.is_none() => refuse(
            format!(
                "a path in `lon-lat` coordinates over {name}, whose elevation file names no known projection"
            ),
            "`file` or `bank`",
        ),
        Coordinates::File if map.coordinates == FileCoordinates::Degrees => refuse(
            format!("a path in `file` coordinates over {name}, whose elevation file is in degrees"),
            "`lon-lat` or `bank`",
        ),
        _ => return Some((map, outline)),
    }
    None
}

/// Says so if no place of the file lies in the bank, but all do with their two coordinates exchanged.
fn note_exchange(
    written: &Points,
    moved: &Points,
    map: &MapFrame,
    outline: &Outline,
    name: &str,
    problems: &Problems,
) {
    let [south, west, north, east] = outline.extent;
    let is_inside = |[x, y]: [f64; 2]| (south..=north).contains(&x) && (west..=east).contains(&y);
    let exchanged = |[a, b]: [f64; 2]| match written.coordinates {
        Coordinates::LonLat => map.of_point(b, a),
        _ => Some([b - map.origin[0], a - map.origin[1]]),
    };
    let mut places = moved.waypoints.iter().map(|waypoint| waypoint.value.at);
    let mut others = written.waypoints.iter().map(|waypoint| exchanged(waypoint.value.at));
    if !places.any(is_inside) && others.all(|place| place.is_some_and(is_inside)) {
        let what = match written.coordinates {
            Coordinates::LonLat => "latitude and longitude",
            _ => "x_m (northing) and y_m (easting)",
        };
        problems.note(format!("{name}: no place lies in the bank; all do with {what} exchanged"));
    }
}
