//! What lies and stands on the ground: `[rocks]`, `[tracks]`, `[[object]]`.

use std::collections::HashSet;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use diagnostics::{Placed, Problem, Problems, Reader};
use landscape::Attitude;
use limits::Limit;
use quantities::radians;
use solids::shape_files::{self, Openness};
use solids::{SizeLaw, Solid, culture};

use super::reference::reference;
use super::{area, guests, take_over};
use crate::{Group, Object, RockArea, Rocks, Stance, Tracks};

/// Places beyond this are a mistake, and would lose millimetres.
pub(super) const MAX_COORDINATE: f64 = 1e7;

pub(super) fn rocks(table: &Reader) -> Option<Rocks> {
    let seed = table.u64("seed").required();
    let density = table.f64("density_per_m2").between(0.0, 1000.0).required();
    let slope = table.f64("slope").between(0.5, 6.0).default(2.0);
    let size = |key: &str| table.f64(key).between(1e-3, 1000.0).unit("m").placed().required();
    let (smallest, largest) = (size("smallest_m"), size("largest_m"));
    let where_to = rock_area(table);
    let (smallest, largest) = (smallest?, largest?);
    if largest.value <= smallest.value {
        let title = format!("`{}` = {} is not above the smallest", largest.key, largest.value);
        table.report(Problem::of(&largest, title).expected(format!("more than {} m", smallest.value)));
        return None;
    }
    let (smallest, largest) = (smallest.value, largest.value);
    let law = SizeLaw { smallest, largest, density: density?, slope: slope? };
    Some(Rocks { seed: seed?, law, area: where_to? })
}

fn rock_area(table: &Reader) -> Option<RockArea> {
    let area = area(table);
    let radius = table.f64("radius_m").above(0.0).at_most(1e6).unit("m");
    match (table.has("area_m"), table.has("radius_m")) {
        (true, false) => area?.map(RockArea::Box),
        (false, true) => radius.optional().map(RockArea::AlongPath),
        (both, _) => {
            let title = match both {
                true => "`rocks.area_m` and `rocks.radius_m` both say where the rocks are",
                false => "missing key `rocks.area_m` or `rocks.radius_m`",
            };
            table.report(table.problem("radius_m", title).expected("one of the two"));
            None
        }
    }
}

pub(super) fn tracks(table: &Reader) -> Option<Tracks> {
    let metres = |key: &str, usual: f64| table.f64(key).between(0.01, 100.0).unit("m").default(usual);
    // Chevrons of the Lunar Roving Vehicle's wheels, 9 inches wide; length and spacing are ours.
    let (length, width) = (metres("patch_length_m", 0.15), metres("patch_width_m", 0.23));
    let spacing = metres("spacing_m", 0.3);
    Some(Tracks { length: length?, width: width?, spacing: spacing? })
}

/// The objects of `[[object]]`; no `groups` if one of these has a fault.
pub(super) fn objects(
    tables: &[Reader],
    groups: Option<&[Group]>,
    folder: &Path,
    problems: &Problems,
) -> Option<Vec<Object>> {
    expect_count(tables, Limit::Objects, "objects")?;
    let mut bodies = 0;
    let mut found = Vec::with_capacity(tables.len());
    for (number, table) in tables.iter().enumerate() {
        let read = object(table, groups, folder, problems);
        bodies += read.1.as_ref().map_or(0, |object| object.parts.len() as u64);
        found.push(read);
        if !Limit::Bodies.allows(bodies) {
            let title = format!("the first {} objects have {bodies} convex bodies", number + 1);
            report_limit(table, Limit::Bodies, title);
            tables[number + 1..].iter().for_each(Reader::ignore_rest);
            return None;
        }
    }
    let twins = report_twins(tables.iter().zip(found.iter().map(|(id, _)| id)), "objects");
    let found: Option<Vec<_>> = found.into_iter().map(|(_, object)| object).collect();
    found.filter(|_| !twins)
}

/// Reports more tables than `limit` allows, before any of them is read. `what` names them.
pub(super) fn expect_count(tables: &[Reader], limit: Limit, what: &str) -> Option<()> {
    if limit.allows(tables.len() as u64) {
        return Some(());
    }
    report_limit(&tables[limit.value() as usize], limit, format!("{} {what}", tables.len()));
    tables.iter().for_each(Reader::ignore_rest);
    None
}

/// Reports at `table` that there is more than `limit` allows.
pub(super) fn report_limit(table: &Reader, limit: Limit, title: String) {
    let problem = Problem::at(table.table_place(), title);
    table.report(problem.expected(format!("at most {}", limit.value())).help(limit.to_string()));
}

/// An id and its place; `None` where it is wrong.
pub(super) type Id = Option<Placed<String>>;

/// Reports every id that something of an earlier table has: they could not be told apart. `what` names them.
pub(super) fn report_twins<'t, 'r: 't>(
    named: impl Iterator<Item = (&'t Reader<'r>, &'t Id)>,
    what: &str,
) -> bool {
    let mut earlier = HashSet::new();
    let mut twins = false;
    for (table, id) in named {
        let Some(id) = id else { continue };
        if !earlier.insert(&id.value) {
            let title = format!("two {what} are called \"{}\"", id.value);
            table.report(Problem::of(id, title).expected("an id of its own"));
            twins = true;
        }
    }
    twins
}

/// Reads the key `id`.
pub(super) fn id(table: &Reader) -> Id {
    id_in(table, "id")
}

/// Reads `key` as an id.
pub(super) fn id_in(table: &Reader, key: &str) -> Id {
    let is_id = |id: &String| id.chars().all(|c| c.is_ascii_alphanumeric() || c == '-' || c == '_');
    table.string(key).must("letters, digits and dashes", is_id).placed().required()
}

fn object(
    table: &Reader,
    groups: Option<&[Group]>,
    folder: &Path,
    problems: &Problems,
) -> (Id, Option<Object>) {
    let id = id(table);
    let open = table.bool("open").default(false);
    let shape = shape(table, open.unwrap_or_default(), folder, problems);
    let shape = guests::reflecting(table, guests::coloured(table, shape));
    let scale = table.f64("scale").above(0.0).at_most(1000.0).default(1.0);
    let stance = stance(table);
    let present = table.bool("present").default(true);
    let moves = guests::moves(table, stance.as_ref());
    let (group, priority) = (guests::group_of(table, groups), guests::priority(table));
    let made = || {
        let (files, parts) = shape?;
        let id = id.as_ref()?.value.clone();
        let (scale, stance, present) = (scale?, stance?, present?);
        let (moves, group, priority) = (moves?, group?, priority?);
        Some(Object { id, files, open: open?, parts, scale, stance, present, moves, group, priority })
    };
    let object = made();
    (id, object)
}

/// Files of a shape, and its parts.
pub(super) type Shape = (Vec<PathBuf>, Vec<Arc<Solid>>);

/// A model that the program carries, or a file; `Some(None)` where the table names neither.
pub(super) fn optional_shape(table: &Reader, folder: &Path, problems: &Problems) -> Option<Option<Shape>> {
    shape_of(table, Openness::Closed, folder, problems)
}

fn shape_of(table: &Reader, openness: Openness, folder: &Path, problems: &Problems) -> Option<Option<Shape>> {
    let models: Vec<(&str, &str)> = culture::NAMES.iter().map(|&name| (name, name)).collect();
    let model = table.one_of("model", &models).optional();
    let file = reference(table, "file", folder);
    let shared = |solids: Vec<Solid>| solids.into_iter().map(Arc::new).collect();
    match (table.has("model"), table.has("file")) {
        (false, false) => Some(None),
        (true, false) => Some(Some((Vec::new(), shared(culture::model(model?)?)))),
        (false, true) => {
            let file = file?;
            let read = take_over(shape_files::read(&file, openness), problems)?;
            read.notes.into_iter().for_each(|note| problems.note(note));
            Some(Some(([vec![file], read.beside].concat(), shared(read.solids))))
        }
        (true, true) => {
            let [model, file] = [table.path("model"), table.path("file")];
            let title = format!("`{model}` and `{file}` both say what it is");
            table.report(table.problem("model", title).expected("one of the two"));
            None
        }
    }
}

/// The same of what must have a shape.
fn shape(table: &Reader, is_open: bool, folder: &Path, problems: &Problems) -> Option<Shape> {
    let openness = if is_open { Openness::Any } else { Openness::Closed };
    let shape = shape_of(table, openness, folder, problems)?;
    if shape.is_none() {
        let title = format!("missing key `{}` or `{}`", table.path("model"), table.path("file"));
        table.report(table.problem("model", title).expected("one of the two"));
    }
    shape
}

pub(super) fn stance(table: &Reader) -> Option<Stance> {
    let degrees = |key: &str| table.f64(key).between(-360.0, 360.0).unit("degrees").map(radians).default(0.0);
    let at = place(table);
    let (heading, pitch, roll) = (degrees("heading_deg"), degrees("pitch_deg"), degrees("roll_deg"));
    Some(Stance { at: at?, attitude: Attitude { roll: roll?, pitch: pitch?, heading: heading? } })
}

/// Reads the keys `x_m` and `y_m`: a place, north and east (m).
pub(super) fn place(table: &Reader) -> Option<[f64; 2]> {
    let metres = |key: &str| table.f64(key).between(-MAX_COORDINATE, MAX_COORDINATE).unit("m").required();
    let (x, y) = (metres("x_m"), metres("y_m"));
    Some([x?, y?])
}
