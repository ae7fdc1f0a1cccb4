//! `[path]`: keyframes, or a file of poses.

use std::path::{Path as FilePath, PathBuf};

use diagnostics::{LongList, Place, Placed, Problem, Problems, Reader};
use limits::Limit;
use quantities::radians;

use super::reference::reference;
use super::scenery::MAX_COORDINATE;
use super::{path_csv, path_tum};
use crate::{Path, PathError, Waypoint};

/// Times beyond this (s) are a mistake; recorders write seconds since 1970.
pub(super) const MAX_TIME: f64 = 1e12;

/// A waypoint and the place of its time, for what is wrong with its order.
pub(super) type PlacedWaypoint = Placed<Waypoint>;

/// The path of a `[path]` table and the file it came from.
pub(super) fn course(
    table: &Reader,
    folder: &FilePath,
    problems: &Problems,
) -> Option<(Path, Option<PathBuf>)> {
    let file = reference(table, "file", folder);
    let keyframes = table.tables("keyframes");
    match (table.has("file"), table.has("keyframes")) {
        (true, false) => file.and_then(|file| Some((read_file(&file, problems)?, Some(file)))),
        (false, true) => Some((from_keyframes(table, &keyframes, problems)?, None)),
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

fn read_file(path: &FilePath, problems: &Problems) -> Option<Path> {
    let name = path.display().to_string();
    let waypoints = match path.extension().and_then(|extension| extension.to_str()) {
        Some("csv") => path_csv::waypoints(&name, &read_text(path, &name, problems)?, problems),
        Some("tum") => path_tum::waypoints(&name, &read_text(path, &name, problems)?, problems),
        _ => {
            let problem = Problem::of_file(&name, "a path file of a kind that is not known");
            problems.push(problem.expected("a name that ends in .csv or .tum").help("rename or convert it"));
            None
        }
    };
    let waypoints = waypoints?;
    let start = waypoints.first()?.place.clone();
    join(waypoints, &start, problems)
}

fn read_text(path: &FilePath, name: &str, problems: &Problems) -> Option<String> {
    let bytes = match files::read_all(path, Limit::ListBytes) {
        Ok(bytes) => bytes,
        Err(error) => {
            problems.push(Problem::of_file(name, error.to_string()));
            return None;
        }
    };
    let not_text = |error: std::string::FromUtf8Error| {
        let title = format!("not text: byte {} is not UTF-8", error.utf8_error().valid_up_to());
        problems.push(Problem::of_file(name, title).help("save the file as UTF-8"));
    };
    String::from_utf8(bytes).map_err(not_text).ok()
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
    let path = Path::new(waypoints.into_iter().map(|waypoint| waypoint.value).collect());
    path.map(|path| path.named(&start.source.name)).map_err(refuse).ok()
}
