//! `[[group]]`, and `moves`, `group`, `priority`, `colour` and `photometry` of an `[[object]]`.

use std::collections::HashSet;
use std::num::NonZeroU16;
use std::sync::Arc;

use diagnostics::{Problem, Reader};
use landscape::{Attitude, Sun};
use quantities::radians;
use solids::Solid;

use super::scenery::{Shape, place};
use super::{all, light};
use crate::{Group, GroupSun, MoveStation, Moves, Stance};

/// Most groups of a scenario.
const MOST_GROUPS: usize = 1000;

/// The groups of `[[group]]`; their names differ.
pub(super) fn groups(tables: &[Reader]) -> Option<Vec<Group>> {
    let groups = all(tables.iter().map(group))?;
    if groups.len() > MOST_GROUPS {
        let title = format!("{} groups", groups.len());
        tables[0].report(tables[0].problem("name", title).expected(format!("at most {MOST_GROUPS}")));
        return None;
    }
    let mut earlier = HashSet::new();
    for (index, Group { name, .. }) in groups.iter().enumerate() {
        if !earlier.insert(name) {
            let problem = tables[index].problem("name", format!("two groups are called \"{name}\""));
            tables[index].report(problem.expected("a name of its own"));
            return None;
        }
    }
    Some(groups)
}

fn group(table: &Reader) -> Option<Group> {
    let name = table.string("name").required();
    let sun = match table.optional_table("sun") {
        Some(sun) => group_sun(&sun).map(Some),
        None => (!table.has("sun")).then_some(None),
    };
    Some(Group { name: name?, sun: sun? })
}

fn group_sun(table: &Reader) -> Option<GroupSun> {
    let degrees = |key: &str, most: f64| table.f64(key).between(-most, most).unit("degrees").map(radians);
    let azimuth = degrees("azimuth_deg", 360.0).required();
    let elevation = degrees("elevation_deg", 90.0).required();
    let rate = table.f64("rate_deg_s").between(-3600.0, 3600.0).unit("degrees/s").map(radians).default(0.0);
    Some(GroupSun { first: Sun { azimuth: azimuth?, elevation: elevation? }, rate: rate? })
}

/// Number, from 1, of the group that an object names, if it names one. Where a group has a fault of its own, nothing is said
/// about names of groups.
pub(super) fn group_of(table: &Reader, groups: Option<&[Group]>) -> Option<Option<NonZeroU16>> {
    if !table.has("group") {
        return Some(None);
    }
    let Some(groups) = groups else {
        table.string("group").optional();
        return None;
    };
    if groups.is_empty() {
        let problem = table.problem("group", "an object of a group, and no group");
        table.report(problem.expected("a [[group]] of this name"));
        table.string("group").optional();
        return None;
    }
    let numbers = groups.iter().zip(1..).map(|(group, number)| (group.name.as_str(), number));
    let numbers: Vec<(&str, u16)> = numbers.collect();
    table.one_of("group", &numbers).required().map(NonZeroU16::new)
}

pub(super) fn priority(table: &Reader) -> Option<i8> {
    let priority = table.i64("priority").between(-100, 100).default(0)?;
    i8::try_from(priority).ok()
}

/// A shape in the object's colour.
pub(super) fn coloured(table: &Reader, shape: Option<Shape>) -> Option<Shape> {
    let colour = table.f64_array::<3>("colour").between(0.0, 1.0).optional();
    if !table.has("colour") {
        return shape;
    }
    let ((files, parts), colour) = (shape?, colour?);
    let coloured = |part: Arc<Solid>| Solid::clone(&part).coloured(colour).map(Arc::new).ok();
    Some((files, parts.into_iter().map(coloured).collect::<Option<_>>()?))
}

/// A shape whose faces return light by the object's own law.
pub(super) fn reflecting(table: &Reader, shape: Option<Shape>) -> Option<Shape> {
    let law = table.optional_table("photometry").map(|law| light::photometry(&law));
    if !table.has("photometry") {
        return shape;
    }
    let ((files, parts), law) = (shape?, law??);
    let reflecting = |part: Arc<Solid>| Arc::new(Solid::clone(&part).reflecting(law));
    Some((files, parts.into_iter().map(reflecting).collect()))
}

/// How an object moves; what its stations leave open is as in its stance.
pub(super) fn moves(table: &Reader, stance: Option<&Stance>) -> Option<Option<Moves>> {
    let Some(moves) = table.optional_table("moves") else { return (!table.has("moves")).then_some(None) };
    let spin = moves.f64("spin_deg_s").between(-3600.0, 3600.0).unit("degrees/s").map(radians).default(0.0);
    let tables = moves.tables("keyframes");
    let usual = stance.map(|stance| stance.attitude).unwrap_or_default();
    let stations = all(tables.iter().map(|table| station(table, usual)));
    if !moves.has("keyframes") && !moves.has("spin_deg_s") {
        let title = format!("`{}` says nothing", table.path("moves"));
        table.report(table.problem("moves", title).expected("`keyframes`, `spin_deg_s` or both"));
        return None;
    }
    let stations = ascending(&tables, stations?)?;
    Some(Some(Moves { stations, spin: spin? }))
}

fn station(table: &Reader, usual: Attitude) -> Option<MoveStation> {
    let time = table.f64("t_s").at_least(0.0).at_most(1e6).unit("s").required();
    let at = place(table);
    let above = table.f64("above_m").between(-1e6, 1e6).unit("m").default(0.0);
    let angle = |key: &str, usual: f64| {
        table.f64(key).between(-3600.0, 3600.0).unit("degrees").map(radians).default(usual)
    };
    let heading = angle("heading_deg", usual.heading);
    let (pitch, roll) = (angle("pitch_deg", usual.pitch), angle("roll_deg", usual.roll));
    let attitude = Attitude { roll: roll?, pitch: pitch?, heading: heading? };
    Some(MoveStation { time: time?, stance: Stance { at: at?, attitude }, above: above? })
}

/// Returns the stations if their times ascend, and reports the first time that does not.
fn ascending(tables: &[Reader], stations: Vec<MoveStation>) -> Option<Vec<MoveStation>> {
    let Some(at) = stations.windows(2).position(|pair| pair[1].time <= pair[0].time) else {
        return Some(stations);
    };
    let title = format!("t = {} s is not after the keyframe before it", stations[at + 1].time);
    let problem: Problem = tables[at + 1].problem("t_s", title);
    tables[at + 1].report(problem.expected(format!("more than {} s", stations[at].time)));
    None
}
