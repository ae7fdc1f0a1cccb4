//! Keys that lights, sheets, overlays, stars and the Earth share.

use std::ops::RangeInclusive;

use diagnostics::{Placed, Problem, Reader};
use glam::DVec3;

use super::scenery::Id;
use crate::{PolygonFault, Presence, polygon};

/// The ids of the tables of a list, in its order, and what the tables mean.
pub(super) type Named<T> = (Vec<Id>, Option<Vec<T>>);

/// Ids and meanings apart; no meanings if one has a fault.
pub(super) fn apart<T>(read: Vec<(Id, Option<T>)>) -> Named<T> {
    let (ids, read): (Vec<Id>, Vec<Option<T>>) = read.into_iter().unzip();
    (ids, read.into_iter().collect())
}

/// Linear red, green and blue; white where the table names none.
pub(super) fn colour(table: &Reader) -> Option<[f64; 3]> {
    table.f64_array::<3>("colour").between(0.0, 1.0).default([1.0; 3])
}

/// Reads `from_s` and `until_s`; without them something is there for the whole mission.
pub(super) fn presence(table: &Reader) -> Option<Presence> {
    let from = table.f64("from_s").between(0.0, 1e6).unit("s").default(0.0);
    let until = table.f64("until_s").above(0.0).at_most(1e6).unit("s").placed();
    if !table.has("until_s") {
        until.optional();
        return Some(Presence { from: from?, until: f64::INFINITY });
    }
    let (from, until) = (from?, until.optional()?);
    if until.value <= from {
        let title =
            format!("`{}` = {} is not after the time from which on it is there", until.key, until.value);
        table.report(Problem::of(&until, title).expected(format!("more than {from} s")));
        return None;
    }
    Some(Presence { from, until: until.value })
}

/// Numbers of corners that a polygon may have.
pub(super) const CORNERS: RangeInclusive<usize> = 3..=16;

/// Whether no coordinate of a corner is beyond `most`, either way.
pub(super) fn lies_within<const N: usize>(most: f64) -> impl Fn(&Vec<[f64; N]>) -> bool {
    move |corners| corners.as_flattened().iter().all(|part| part.abs() <= most)
}

/// Corners of a list, if they go around a flat convex polygon.
pub(super) fn polygon<const N: usize>(
    table: &Reader,
    corners: Placed<Vec<[f64; N]>>,
    to_space: impl Fn(&[f64; N]) -> DVec3,
) -> Option<Vec<[f64; N]>> {
    let report = |fault: PolygonFault| {
        let title = format!("`{}` is no flat convex polygon: {fault}", corners.key);
        let problem = Problem::of(&corners, title);
        table.report(problem.expected("corners in their order around one").help("corners count from 0"));
    };
    let places: Vec<DVec3> = corners.value.iter().map(to_space).collect();
    polygon::check(&places).map_err(report).ok()?;
    Some(corners.value)
}

/// Whether the table has none of `keys`; reports every one that it has, since `reason`.
pub(super) fn has_none(table: &Reader, keys: &[&str], reason: &str, expected: &str) -> bool {
    let found: Vec<_> = keys.iter().filter(|key| table.has(key)).collect();
    for key in &found {
        let title = format!("`{}` {reason}", table.path(key));
        table.report(table.problem(key, title).expected(expected));
    }
    found.is_empty()
}
