//! The terrain database of 16.8 million posts: its size against the document's layout, and how long a first picture takes.

use std::fs;
use std::path::Path;
use std::time::Instant;

use benchmarks::peers::median;
use front_door::{Opened, Wishes, open};
use generator::{PlaneKind, Planes};
use rayon::ThreadPool;
use rayon::prelude::*;
use signal::Probe;
use terrain_builder::MOON_RADIUS;
use terrain_database::{Contents, Database, Frame, documented_bytes};

use super::SCENARIO;
use crate::guests::Sense;
use crate::row::Row;

/// Tiles along a side, and their order.
const TILES: usize = 128;
const ORDER: u32 = 5;
/// Posts along a side.
const POSTS: usize = (TILES << ORDER) + 1;
/// Step of the heights (m): what `lunoid terrain export` is asked for in the docs.
const STEP: f64 = 0.001;
/// Turns of each side.
const TURNS: usize = 5;

/// Rows of the database.
pub fn rows(pool: &ThreadPool) -> Result<Vec<Row>, String> {
    let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
    let shipped = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../../../scenarios"));
    let opened = open(&shipped.join(SCENARIO).with_extension("toml"), &Wishes::default());
    let contents = pool.install(|| contents(&opened.map_err(|error| error.to_string())?))?;
    let documented = documented_bytes(ORDER, (TILES * TILES) as u64);
    let mut rows = Vec::new();
    for (name, step) in [("steps of 1 mm", Some(STEP)), ("every bit of the heights", None)] {
        let database = Database::new(Contents { step, ..contents.clone() });
        let bytes = database.map_err(|error| error.to_string())?.bytes();
        let measured = documented as f64 / bytes.len() as f64;
        let sides = [bytes.len() as u64, documented].map(|bytes| format!("{:.1} MB", bytes as f64 / 1e6));
        rows.push(Row {
            issue: 37,
            quantity: format!("database of {POSTS} x {POSTS} posts, {name}, against the document's layout"),
            figures: [5.0, 10.0],
            measured,
            words: "times as small",
            is_met: measured >= 5.0,
            sides,
            remark: String::new(),
        });
        rows.push(first_picture(name, &bytes, (shipped, folder.path()), pool)?);
    }
    Ok(rows)
}

/// Ground of the scenario on the posts.
fn contents(opened: &Opened) -> Result<Contents, String> {
    let stage = opened.stage().map_err(|error| error.to_string())?;
    let [south, west, north, east] = stage.landscape.level().extent();
    let along = |low: f64, high: f64| -> Vec<f64> {
        (0..POSTS).map(|post| low + post as f64 * ((high - low) / (POSTS - 1) as f64)).collect()
    };
    let (to_north, to_east) = (along(south, north), along(west, east));
    let height = |index: usize| {
        let place = [to_north[index / POSTS], to_east[index % POSTS]];
        stage.landscape.height(place[0], place[1]).ok_or_else(|| format!("no ground at {place:?}"))
    };
    let heights = (0..POSTS * POSTS).into_par_iter().map(height).collect::<Result<Vec<_>, _>>()?;
    let frame = Frame { radius: MOON_RADIUS, latitude: 0.0, longitude: 0.0, origin: [0.0; 2] };
    Ok(Contents::new(frame, ORDER, [to_east, to_north], heights))
}

/// From the file to the first picture, against reading the file and hashing it.
fn first_picture(
    name: &str,
    bytes: &[u8],
    (shipped, folder): (&Path, &Path),
    pool: &ThreadPool,
) -> Result<Row, String> {
    let system = |error: std::io::Error| error.to_string();
    let database = folder.join("terrain.lod");
    fs::write(&database, bytes).map_err(system)?;
    let text = fs::read_to_string(shipped.join(SCENARIO).with_extension("toml")).map_err(system)?;
    let text = text.replacen("[landscape]\n", "[landscape]\ndatabase = \"terrain.lod\"\n", 1);
    let scenario = folder.join("opened.toml");
    fs::write(&scenario, text).map_err(system)?;
    fs::copy(shipped.join("lod-descent.csv"), folder.join("lod-descent.csv")).map_err(system)?;
    // What the scenario makes besides is not of the database.
    let opened = open(&scenario, &Wishes::default()).map_err(|error| error.to_string())?;
    let (mut ours, mut other) = (Vec::new(), Vec::new());
    for _ in 0..TURNS {
        let begin = Instant::now();
        pool.install(|| draw(&opened))?;
        ours.push(begin.elapsed().as_secs_f64());
        let begin = Instant::now();
        let read = fs::read(&database).map_err(system)?;
        let hash = blake3::hash(&read);
        other.push(begin.elapsed().as_secs_f64());
        assert_eq!(hash, blake3::hash(bytes), "the file is what was written");
    }
    let quantity =
        format!("from that database, {name}, to the first picture, against reading it and checking its hash");
    let times = [median(ours), median(other)];
    Ok(Row::of_times(
        37,
        quantity,
        (Sense::TimesTheTime, [4.0, 1.5]),
        times,
        "with the scenario's own bank".into(),
    ))
}

/// The first picture of a scenario, from its files.
fn draw(opened: &Opened) -> Result<(), String> {
    let stage = opened.stage().map_err(|error| error.to_string())?;
    let poses = opened.poses(&stage, 0..1).map_err(|problems| problems.to_string())?;
    let view = &stage.view;
    let mut planes = Planes::new(view.columns as usize, view.lines as usize, &[PlaneKind::Intensity]);
    let session = opened.generator.prepare(stage).map_err(|error| error.to_string())?;
    let drawn = session.frame(0, &poses.rows()[0].pose, &mut planes, &mut Probe::off());
    drawn.map(|_| ()).map_err(|error| error.to_string())
}
