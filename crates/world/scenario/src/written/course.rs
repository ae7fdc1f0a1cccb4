//! `[path]`: keyframes, or a file of poses.

use std::path::{Path as FilePath, PathBuf};

use diagnostics::{LongList, Place, Placed, Problem, Problems, Reader};
use quantities::radians;

use super::coordinates::{Coordinates, Ground, in_bank};
use super::doubts::{heading_across, turns_by_angles};
use super::path_gpx::{self, TrackWishes};
use super::path_table;
use super::points::{PlacedWaypoint, Points};
use super::reference::reference;
use super::scenery::MAX_COORDINATE;
use crate::{HeightOver, Path, Waypoint};

/// Times of keyframes beyond this (s) are a mistake.
const MAX_TIME: f64 = 1e12;

/// Kinds of path files.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum FileKind {
    Csv,
    Tum,
    Gpx,
}

impl FileKind {
    /// By the ending of the name; a fault where that is none of a path file.
    fn of(path: &FilePath, problems: &Problems) -> Option<Self> {
        let ending = path.extension().and_then(|ending| ending.to_str()).map(str::to_ascii_lowercase);
        match ending.as_deref() {
            Some("csv" | "tsv") => Some(Self::Csv),
            Some("tum") => Some(Self::Tum),
            Some("gpx") => Some(Self::Gpx),
            _ => {
                let problem =
                    Problem::of_file(path.display().to_string(), "a path file of a kind that is not known");
                let problem = problem.expected("a name that ends in .csv, .tsv, .tum or .gpx");
                problems.push(problem.help("rename or convert it"));
                None
            }
        }
    }

    /// What to do about times that do not ascend.
    fn help_with_times(self) -> &'static str {
        match self {
            Self::Csv | Self::Tum => "sort the rows by time; two drives need two files",
            Self::Gpx => {
                "remove the point; or begin a segment of its own (`<trkseg>`) there, and choose one with `path.segment`"
            }
        }
    }
}

/// What a `[path]` table says.
pub(super) struct Course {
    /// The path that the table says.
    pub path: Path,
    /// File that it came from, where it did.
    pub path_file: Option<PathBuf>,
    /// Poses that a closed loop has driven, with their file.
    pub driven: Option<(Path, PathBuf)>,
}

/// The `[path]` table; `ground` is what the path lies on.
pub(super) fn course(
    table: &Reader,
    folder: &FilePath,
    ground: Option<Ground>,
    problems: &Problems,
) -> Option<Course> {
    let path = path(table, folder, ground, problems);
    let driven = match reference(table, "driven", folder) {
        Some(file) => driven(&file, problems).map(|path| Some((path, file))),
        None => (!table.has("driven")).then_some(None),
    };
    let ((path, path_file), driven) = (path?, driven?);
    Some(Course { path, path_file, driven })
}

/// Poses of a closed loop, in the axes of the bank.
fn driven(file: &FilePath, problems: &Problems) -> Option<Path> {
    let points = path_table::csv(file, Some(Coordinates::Bank), problems)?;
    let start = points.waypoints.first()?.place.clone();
    join(points, &start, FileKind::Csv.help_with_times(), problems)
}

/// The path and the file it came from.
fn path(
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
            let kind = FileKind::of(&file, problems)?;
            let points = read_file(table, &file, kind, coordinates, &track, problems)?;
            let points = in_bank(points, table, ground, problems)?;
            let start = points.waypoints.first()?.place.clone();
            Some((join(points, &start, kind.help_with_times(), problems)?, Some(file)))
        }
        (false, true) => {
            only_of_files(table, &["track", "segment", "heights"], "path.file");
            let points = from_keyframes(&keyframes, coordinates?.unwrap_or(Coordinates::Bank))?;
            let points = in_bank(points, table, ground, problems)?;
            Some((join(points, &table.place("keyframes"), "sort the keyframes by time", problems)?, None))
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

fn from_keyframes(keyframes: &[Reader], coordinates: Coordinates) -> Option<Points> {
    let waypoints: Vec<_> = keyframes.iter().map(|table| keyframe(table, coordinates)).collect();
    let waypoints = waypoints.into_iter().collect::<Option<Vec<_>>>()?;
    Some(Points { waypoints, coordinates, height_over: HeightOver::Datum })
}

fn keyframe(table: &Reader, coordinates: Coordinates) -> Option<PlacedWaypoint> {
    let time = table.f64("t_s").between(0.0, MAX_TIME).unit("s").placed().required();
    let angle = |key: &str, most: f64| table.f64(key).between(-most, most).unit("degrees").map(radians);
    let at = match coordinates {
        Coordinates::LonLat => [angle("lat_deg", 90.0).required(), angle("lon_deg", 360.0).required()],
        in_plane => {
            let far = path_table::farthest(in_plane);
            ["x_m", "y_m"].map(|key| table.f64(key).between(-far, far).unit("m").required())
        }
    };
    let [heading, pitch, roll] =
        ["heading_deg", "pitch_deg", "roll_deg"].map(|key| angle(key, 360.0).optional());
    let eye_height = table.f64("z_m").between(-MAX_COORDINATE, MAX_COORDINATE).unit("m").optional();
    let (Placed { value: time, place, key }, [x, y]) = (time?, at);
    let open = Waypoint { time, at: [x?, y?], heading, eye_height, pitch, roll };
    Some(Placed { value: open, place, key })
}

fn read_file(
    table: &Reader,
    path: &FilePath,
    kind: FileKind,
    coordinates: Option<Coordinates>,
    track: &TrackWishes,
    problems: &Problems,
) -> Option<Points> {
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

/// The path of all points; every time that does not rise is a problem at its place, with `help`. A point that stands there
/// several times in a row, at the same time and place, counts once.
fn join(points: Points, start: &Place, help: &str, problems: &Problems) -> Option<Path> {
    let Points { mut waypoints, height_over, .. } = points;
    let name = &start.source.name;
    let count = waypoints.len();
    waypoints.dedup_by(|later, first| later.value == first.value);
    if waypoints.len() < count {
        let repeated = count - waypoints.len();
        problems.note(format!(
            "{name}: {repeated} points repeat the one before, time and place: they are left out"
        ));
    }
    let mut faults = LongList::new(name);
    for pair in waypoints.windows(2).filter(|pair| pair[1].value.time <= pair[0].value.time) {
        let (before, time) = (pair[0].value.time, pair[1].value.time);
        let title = format!("t = {time} s after t = {before} s: times must ascend");
        faults.push(Problem::of(&pair[1], title).expected(format!("more than {before}")).help(help));
    }
    faults.finish((), problems)?;
    let waypoints: Vec<Waypoint> = waypoints.into_iter().map(|waypoint| waypoint.value).collect();
    for doubt in [heading_across(&waypoints), turns_by_angles(&waypoints)].into_iter().flatten() {
        problems.note(format!("{name}: {doubt}"));
    }
    let path = Path::new(waypoints).map_err(|error| problems.push(Problem::at(start, error.to_string())));
    path.map(|path| path.named(name).with_heights_over(height_over)).ok()
}
