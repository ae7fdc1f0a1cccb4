//! `albedo` and `albedo_map` of `[landscape]`: what the ground returns.

use std::path::Path;

use diagnostics::Reader;

use super::area;
use super::reference::reference;
use crate::{AlbedoMapWish, MapCurve};

/// Albedo of the ground, and the map over it.
pub(super) fn albedo(table: &Reader, folder: &Path) -> Option<(f64, Option<AlbedoMapWish>)> {
    let albedo = table.f64("albedo").above(0.0).at_most(1.0).default(1.0);
    let map = match table.optional_table("albedo_map") {
        Some(written) => map(&written, folder).map(Some),
        // What is there and no table has been reported.
        None => (!table.has("albedo_map")).then_some(None),
    };
    Some((albedo?, map?))
}

fn map(table: &Reader, folder: &Path) -> Option<AlbedoMapWish> {
    if !table.has("file") {
        let title = format!("missing key `{}`", table.path("file"));
        table.report(table.problem("file", title).expected("a picture in the scenario's folder"));
    }
    let file = reference(table, "file", folder);
    let area = area(table);
    let end = |key: &str, usual: f64| table.f64(key).between(0.0, 1.0).default(usual);
    let (black, white) = (end("black", 0.0), end("white", 1.0));
    let curves = [("srgb", MapCurve::Srgb), ("linear", MapCurve::Linear)];
    let curve = table.one_of("curve", &curves).default(MapCurve::Srgb);
    Some(AlbedoMapWish { file: file?, area: area?, ends: [black?, white?], curve: curve? })
}
