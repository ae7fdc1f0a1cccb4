//! `[[overlay]]`: polygons that are fixed to the eye.

use diagnostics::Reader;
use glam::DVec3;
use limits::Limit;

use super::effect_keys::{CORNERS, Named, apart, colour, lies_within, polygon, presence};
use super::guests::priority;
use super::scenery::{Id, expect_count, id};
use crate::OverlayWish;

/// How far from the middle a corner may be, in halves of the picture: more is nowhere near it.
const FARTHEST: f64 = 4.0;

pub(super) fn overlays(tables: &[Reader]) -> Named<OverlayWish> {
    match expect_count(tables, Limit::Sheets, "overlays") {
        Some(()) => apart(tables.iter().map(overlay).collect()),
        None => (Vec::new(), None),
    }
}

fn overlay(table: &Reader) -> (Id, Option<OverlayWish>) {
    let id = id(table);
    let corners = corners(table);
    let share = table.f64("tau").between(0.0, 1.0).default(0.0);
    let (colour, priority, presence) = (colour(table), priority(table), presence(table));
    let made = || {
        let id = id.as_ref()?.value.clone();
        let (corners, colour, share) = (corners?, colour?, share?);
        Some(OverlayWish { id, corners, colour, share, priority: priority?, presence: presence? })
    };
    let overlay = made();
    (id, overlay)
}

fn corners(table: &Reader) -> Option<Vec<[f64; 2]>> {
    let field =
        table.f64_pairs("corners").must("3 to 16 of them", |corners| CORNERS.contains(&corners.len()));
    let field = field.must("each of x and y from -4 to 4", lies_within(FARTHEST));
    polygon(table, field.placed().required()?, |&[x, y]| DVec3::new(x, y, 0.0))
}
