//! `[path]`: keyframes, or a file of poses.

use std::path::{Path as FilePath, PathBuf};

use diagnostics::{LongList, Place, Placed, Problem, Problems, Reader};
use quantities::radians;

use super::coordinates::{Coordinates, Ground, in_bank};
use super::doubts::heading_across;
use super::path_gpx::{self, TrackWishes};
use super::path_table;
use super::reference::reference;
use super::scenery::MAX_COORDINATE;
use crate::{HeightOver, Path, PathError, Waypoint};

/// Times of keyframes beyond this (s) are a mistake.
const MAX_TIME: f64 = 1e12;

/// A waypoint and the place of its time, for what is wrong with its order.
pub(super) type PlacedWaypoint = Placed<Waypoint>;

/// The points of a path file, before they are in the axes of the bank.
#[derive(Debug, Clone)]
pub(super) struct Points {
    /// Waypoints whose places are in `coordinates`: metres north and east, or latitude and longitude (rad).
    pub waypoints: Vec<PlacedWaypoint>,
    pub coordinates: Coordinates,
    pub height_over: HeightOver,
}

/// Kinds of path files.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum FileKind {
    Csv,
    Tum,
    Gpx,
}

/// The path of a `[path]` table and the file it came from; `ground` is what it lies on.
pub(super) fn course(
    table: &Reader,
    folder: &FilePath,
    ground: Option<Ground>,
    problems: &Problems,
) -> Option<(Path, Option<PathBuf>)> {
    let file = reference(table, "file", folder);
    let keyframes = table.tables("keyframes");
    let (coordinates, track) = (Coordinates::read(table), TrackWishes::read(table));
    match (table.has("file"), table.has("keyframes")) {
        (true, false) => {
            let (file, coordinates, track) = (file?, coordinates?, track?);
            let points = read_file(table, &file, coordinates, &track, problems)?;
            let points = in_bank(points, table, ground, problems)?;
            let start = points.waypoints.first()?.place.clone();
            let over = points.height_over;
            Some((join(points.waypoints, &start, problems)?.with_heights_over(over), Some(file)))
        }
        (false, true) => {
            only_of_files(table, &["coordinates", "track", "segment", "heights"], "path.file");
            Some((from_keyframes(table, &keyframes, problems)?, None))
        }
        (both, _) => {
            let title = match both {
                true => "`path.keyframes` and `path.file` both say where the vehicle drives",
                false => "missing key `path.keyframes` or `path.file`",
            };
            table.report(table.problem("file", title).expected("one of the two"));
            None
        }
    }
}

/// Refuses keys that have a meaning beside `beside` only.
fn only_of_files(table: &Reader, keys: &[&str], beside: &str) {
    for key in keys.iter().filter(|key| table.has(key)) {
        let title = format!("`{}` without {beside}", table.path(key));
        table.report(table.problem(key, title).expected(format!("the key beside {beside} alone")));
    }
}

fn from_keyframes(table: &Reader, keyframes: &[Reader], problems: &Problems) -> Option<Path> {
    let waypoints: Vec<_> = keyframes.iter().map(keyframe).collect();
    let waypoints = waypoints.into_iter().collect::<Option<Vec<_>>>()?;
    join(waypoints, &table.place("keyframes"), problems)
}

fn keyframe(table: &Reader) -> Option<PlacedWaypoint> {
    let metres = |key: &str| table.f64(key).between(-MAX_COORDINATE, MAX_COORDINATE).unit("m").required();
    let time = table.f64("t_s").between(0.0, MAX_TIME).unit("s").placed().required();
    let (x, y) = (metres("x_m"), metres("y_m"));
    let heading = table.f64("heading_deg").between(-360.0, 360.0).unit("degrees").map(radians).optional();
    let Placed { value: time, place, key } = time?;
    let open = Waypoint { time, at: [x?, y?], heading, eye_height: None, pitch: None, roll: None };
    Some(Placed { value: open, place, key })
}

fn read_file(
    table: &Reader,
    path: &FilePath,
    coordinates: Option<Coordinates>,
    track: &TrackWishes,
    problems: &Problems,
) -> Option<Points> {
    let ending = path.extension().and_then(|ending| ending.to_str()).map(str::to_ascii_lowercase);
    let kind = match ending.as_deref() {
        Some("csv" | "tsv") => FileKind::Csv,
        Some("tum") => FileKind::Tum,
        Some("gpx") => FileKind::Gpx,
        _ => {
            let problem =
                Problem::of_file(path.display().to_string(), "a path file of a kind that is not known");
            let problem = problem.expected("a name that ends in .csv, .tsv, .tum or .gpx");
            problems.push(problem.help("rename or convert it"));
            return None;
        }
    };
    if kind != FileKind::Gpx {
        only_of_files(table, &["track", "segment", "heights"], "a GPX file");
    }
    let (refused, instead) = match (kind, coordinates) {
        (FileKind::Tum, Some(Coordinates::LonLat)) => ("a TUM file has places in metres", "`file` or `bank`"),
        (FileKind::Gpx, Some(Coordinates::Bank | Coordinates::File)) => {
            ("a GPX file has latitudes and longitudes", "`lon-lat`")
        }
        (FileKind::Csv, _) => return path_table::csv(path, coordinates, problems),
        (FileKind::Tum, _) => return path_table::tum(path, coordinates, problems),
        (FileKind::Gpx, _) => return path_gpx::read(path, track, problems),
    };
    table.report(table.problem("coordinates", refused).expected(instead));
    None
}

/// The path of all waypoints; every time that does not rise is a problem at its place.
fn join(waypoints: Vec<PlacedWaypoint>, start: &Place, problems: &Problems) -> Option<Path> {
    let falling = waypoints.windows(2).filter(|pair| pair[1].value.time <= pair[0].value.time);
    let mut faults = LongList::new(&start.source.name);
    for pair in falling {
        let (before, time) = (pair[0].value.time, pair[1].value.time);
        let title = format!("t = {time} s after t = {before} s: times must ascend");
        faults.push(Problem::of(&pair[1], title).expected(format!("more than {before}")));
    }
    faults.finish((), problems)?;
    let refuse = |error: PathError| problems.push(Problem::at(start, error.to_string()));
    let waypoints: Vec<Waypoint> = waypoints.into_iter().map(|waypoint| waypoint.value).collect();
    if let Some(doubt) = heading_across(&waypoints) {
        problems.note(format!("{}: {doubt}", start.source.name));
    }
    let path = Path::new(waypoints);
    path.map(|path| path.named(&start.source.name)).map_err(refuse).ok()
}
