//! `[[sheet]]`: translucent polygons of the scene.

use diagnostics::Reader;
use glam::DVec3;
use limits::Limit;

use super::effect_keys::{CORNERS, Named, apart, colour, has_none, lies_within, polygon, presence};
use super::guests::{moves, priority};
use super::scenery::{Id, MAX_COORDINATE, expect_count, id};
use crate::{Medium, SheetPlace, SheetWish};

pub(super) fn sheets(tables: &[Reader]) -> Named<SheetWish> {
    match expect_count(tables, Limit::Sheets, "sheets") {
        Some(()) => apart(tables.iter().map(sheet).collect()),
        None => (Vec::new(), None),
    }
}

fn sheet(table: &Reader) -> (Id, Option<SheetWish>) {
    let id = id(table);
    let place = place(table);
    let corners = corners(table, place.as_ref());
    let (medium, colour) = (medium(table), colour(table));
    let (priority, presence) = (priority(table), presence(table));
    let made = || {
        let id = id.as_ref()?.value.clone();
        let (corners, place, colour, medium) = (corners?, place?, colour?, medium?);
        Some(SheetWish { id, corners, place, colour, medium, priority: priority?, presence: presence? })
    };
    let sheet = made();
    (id, sheet)
}

/// Corners as they are written; those that follow the ground are judged on it.
fn corners(table: &Reader, place: Option<&SheetPlace>) -> Option<Vec<DVec3>> {
    let field =
        table.f64_triples("corners_m").must("3 to 16 of them", |corners| CORNERS.contains(&corners.len()));
    let field = field.must("each of three lengths from -1e7 to 1e7 m", lies_within(MAX_COORDINATE));
    let corners = field.placed().required()?;
    let corners = match place? {
        SheetPlace::Ground => corners.value,
        _ => polygon(table, corners, |corner| DVec3::from_array(*corner))?,
    };
    Some(corners.into_iter().map(DVec3::from_array).collect())
}

fn place(table: &Reader) -> Option<SheetPlace> {
    let heights = [("foot", SheetPlace::Foot), ("ground", SheetPlace::Ground), ("datum", SheetPlace::Datum)];
    let height = table.one_of("height", &heights).default(SheetPlace::Foot);
    let Some(moves) = moves(table, None)? else { return height };
    let reason = "beside `moves`: its corners count from a foot point that moves";
    let is_alone = has_none(table, &["height"], reason, "one of the two");
    if moves.stations.is_empty() {
        let title =
            format!("`{}` of a sheet without `keyframes`: nothing says where it turns", table.path("moves"));
        table.report(table.problem("moves", title).expected("`keyframes`, one or more"));
        return None;
    }
    is_alone.then_some(SheetPlace::Moving(moves))
}

/// A share, or dust of a thickness.
fn medium(table: &Reader) -> Option<Medium> {
    let share = table.f64("tau").between(0.0, 1.0).optional();
    let kappa = table.f64("kappa_1_m").between(0.0, 1e6).unit("1/m");
    let thickness = table.f64("thickness_m").above(0.0).at_most(1e6).unit("m");
    match (table.has("tau"), table.has("kappa_1_m")) {
        (true, false) => {
            thickness.optional();
            kappa.optional();
            let reason = "beside `tau`, which is the same at every thickness";
            has_none(table, &["thickness_m"], reason, "no thickness, or `kappa_1_m` instead of `tau`")
                .then_some(Medium::Share(share?))
        }
        (false, true) => {
            let (kappa, thickness) = (kappa.optional(), thickness.required());
            Some(Medium::Dust { kappa: kappa?, thickness: thickness? })
        }
        (both, _) => {
            kappa.optional();
            thickness.optional();
            let [tau, kappa] = ["tau", "kappa_1_m"].map(|key| table.path(key));
            let title = match both {
                true => format!("`{tau}` and `{kappa}` both say how much light goes through"),
                false => format!("missing key `{tau}` or `{kappa}`"),
            };
            table.report(table.problem("kappa_1_m", title).expected("one of the two"));
            None
        }
    }
}
