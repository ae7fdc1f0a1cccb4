//! `[[effect]]` and `[[plume]]`: effects of files, and dust.

use std::path::Path;

use diagnostics::{Problem, Reader};
use faces::{Flight, MOON};
use quantities::radians;

use super::all;
use super::reference::reference;
use super::scenery::MAX_COORDINATE;
use crate::{EffectFileWish, FacePlace, Object, PlumeWish};

/// Most effects, and most plumes, of a scenario. Chosen.
const MOST: usize = 256;

/// Dust of the Moon in the sun: linear red, green, blue (chosen).
const DUST: [f64; 3] = [0.45, 0.43, 0.40];

/// The effects of `[[effect]]`.
pub(super) fn effects(
    tables: &[Reader],
    objects: Option<&[Object]>,
    folder: &Path,
) -> Option<Vec<EffectFileWish>> {
    expect_few(tables, "effects")?;
    all(tables.iter().map(|table| {
        if !table.has("file") {
            let title = format!("missing key `{}`", table.path("file"));
            table.report(table.problem("file", title).expected("an effect file in the scenario's folder"));
        }
        let (file, place) = (reference(table, "file", folder), place(table, objects));
        Some(EffectFileWish { file: file?, place: place? })
    }))
}

/// The plumes of `[[plume]]`.
pub(super) fn plumes(tables: &[Reader], objects: Option<&[Object]>) -> Option<Vec<PlumeWish>> {
    expect_few(tables, "plumes")?;
    all(tables.iter().map(|table| plume(table, objects)))
}

fn plume(table: &Reader, objects: Option<&[Object]>) -> Option<PlumeWish> {
    let place = place(table, objects);
    let speed = table.f64("speed_m_s").between(0.01, 1000.0).unit("m/s").required();
    let degrees = |key: &str| table.f64(key).unit("degrees").map(radians);
    let launch =
        table.f64("launch_deg").between(1.0, 90.0).unit("degrees").map(radians).default(radians(60.0));
    let spread = table.f64("spread_deg").above(0.0).at_most(90.0).unit("degrees").map(radians);
    let spread = spread.default(radians(8.0));
    let azimuth = degrees("azimuth_deg").default(radians(180.0));
    let faces = table.usize("faces").between(1, 1000).default(28);
    let frames = table.u64("frames").between(1, 10_000).default(2);
    let copies = table.u64("copies").between(1, 64).default(4);
    let colour = table.f64_array::<3>("colour").between(0.0, 1.0).default(DUST);
    let (speed, launch) = (speed?, launch?);
    let flight = match Flight::new(speed, launch, MOON) {
        Ok(flight) => flight,
        Err(error) => {
            table.report(table.problem("speed_m_s", error.to_string()));
            return None;
        }
    };
    Some(PlumeWish {
        place: place?,
        flight,
        spread: spread?,
        azimuth: azimuth?,
        faces: faces?,
        frames: frames?,
        copies: copies?,
        colour: colour?,
    })
}

/// Where a table says that something stands: on the ground, on the vehicle, or on an object. Nothing is said about names of objects if
/// one of them has a fault.
fn place(table: &Reader, objects: Option<&[Object]>) -> Option<FacePlace> {
    if table.has("on") { carried(table, objects) } else { on_ground(table) }
}

/// Keys of a place on the ground.
const GROUND: [&str; 4] = ["x_m", "y_m", "above_m", "heading_deg"];

fn carried(table: &Reader, objects: Option<&[Object]>) -> Option<FacePlace> {
    let on = table.string("on").optional();
    let at = table.f64_list("at_m").between(-1000.0, 1000.0).unit("m");
    let at = at.must("two or three numbers", |at| (2..=3).contains(&at.len())).default(vec![0.0; 2]);
    if let Some(key) = GROUND.into_iter().find(|key| table.has(key)) {
        GROUND.iter().for_each(|key| table.know(key));
        let title = format!("`{}` beside `on`: it stands in two places", table.path(key));
        table.report(table.problem(key, title).expected("`on` with `at_m`, or `x_m` and `y_m`"));
        return None;
    }
    let (on, at) = (on?, at?);
    if on == "vehicle" {
        return Some(FacePlace::Vehicle([at[0], at[1]]));
    }
    let number = objects?.iter().position(|object| object.id == on);
    if number.is_none() {
        let title = format!("`{}` = \"{on}\" is no object of the scenario", table.path("on"));
        table.report(table.problem("on", title).expected("\"vehicle\", or the `id` of an `[[object]]`"));
    }
    number.map(|number| FacePlace::Object(number, [at[0], at[1], at.get(2).copied().unwrap_or(0.0)]))
}

fn on_ground(table: &Reader) -> Option<FacePlace> {
    let far = |key: &str| table.f64(key).between(-MAX_COORDINATE, MAX_COORDINATE).unit("m");
    let (north, east) = (far("x_m").required(), far("y_m").required());
    let above = table.f64("above_m").between(-1e5, 1e5).unit("m").default(0.0);
    let heading = table.f64("heading_deg").between(-360.0, 360.0).unit("degrees").map(radians).default(0.0);
    Some(FacePlace::Ground([north?, east?, above?], heading?))
}

fn expect_few(tables: &[Reader], what: &str) -> Option<()> {
    let Some(table) = tables.get(MOST) else { return Some(()) };
    let title = format!("{} {what}", tables.len());
    table.report(Problem::at(table.table_place(), title).expected(format!("at most {MOST}")));
    tables.iter().for_each(Reader::ignore_rest);
    None
}
