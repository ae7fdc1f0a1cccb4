//! `[[ship]]`: ships on the sea, with their motion and their wakes.

use diagnostics::{Problem, Reader};
use faces::ship::{Hiding, Ship, Wedges};
use faces::{BowWake, Detail};
use quantities::radians;

use super::scenery::{Id, MAX_COORDINATE, id, report_twins};
use crate::{SeaWish, ShipWish, SternWakeWish, WaveWish};

/// White water: linear red, green, blue (chosen).
const FOAM: [f64; 3] = [0.9; 3];

/// Most ships of a scenario. Chosen: each has lists of its own.
const MOST: usize = 32;

const KINDS: [(&str, &Ship); 2] = [("lph-2", &Ship::LPH2), ("dd963", &Ship::DD963)];
const DETAILS: [(&str, Detail); 3] =
    [("add", Detail::Add), ("add-soft", Detail::AddSoft), ("replace", Detail::Replace)];

/// The ships of `[[ship]]` on `sea`; nothing is known of it if it has a fault.
pub(super) fn ships(tables: &[Reader], sea: Option<Option<&SeaWish>>) -> Option<Vec<ShipWish>> {
    if let Some(table) = tables.get(MOST) {
        let title = format!("{} ships", tables.len());
        table.report(Problem::at(table.table_place(), title).expected(format!("at most {MOST}")));
        tables.iter().for_each(Reader::ignore_rest);
        return None;
    }
    if let (Some(table), Some(None)) = (tables.first(), sea) {
        let title = "`[[ship]]` without `[sea]`: there is no water";
        table.report(Problem::at(table.table_place(), title).expected("`[sea]` with `square_m`"));
    }
    let water = sea.flatten().map_or([0.0; 3], |sea| sea.colour);
    let (ids, ships): (Vec<Id>, Vec<Option<ShipWish>>) =
        tables.iter().map(|table| ship(table, water)).unzip();
    let twins = report_twins(tables.iter().zip(&ids), "ships");
    let ships: Option<Vec<ShipWish>> = ships.into_iter().collect();
    ships.filter(|ships| !twins && (ships.is_empty() || sea != Some(None)))
}

fn ship(table: &Reader, water: [f64; 3]) -> (Id, Option<ShipWish>) {
    let id = id(table);
    let kind = table.one_of("type", &KINDS).required();
    let place = |key: &str| table.f64(key).between(-MAX_COORDINATE, MAX_COORDINATE).unit("m").required();
    let (north, east) = (place("x_m"), place("y_m"));
    let heading = table.f64("heading_deg").between(-360.0, 360.0).unit("degrees").map(radians).default(0.0);
    let speed = table.f64("speed_m_s").between(0.0, 50.0).unit("m/s").default(0.0);
    let motion = ["pitch", "roll", "heave", "sway"].map(|key| waves(table, key));
    let hiding = hiding(table, water);
    let (bow_wake, stern_wake) = (bow_wake(table, water), stern_wake(table));
    let made = || {
        let id = id.as_ref()?.value.clone();
        let (at, [pitch, roll, heave, sway]) = ([north?, east?], motion);
        let motion = [pitch?, roll?, heave?, sway?];
        let (kind, heading, speed, hiding) = (kind?, heading?, speed?, hiding?);
        let (bow_wake, stern_wake) = (bow_wake?, stern_wake?);
        Some(ShipWish { id, kind, at, heading, speed, motion, hiding, bow_wake, stern_wake })
    };
    let ship = made();
    (id, ship)
}

/// Waves of a motion: `[[ship.pitch]]` and `[[ship.roll]]` in degrees, heave and sway in metres.
fn waves(table: &Reader, key: &str) -> Option<Vec<WaveWish>> {
    let is_angle = matches!(key, "pitch" | "roll");
    let wave = |wave: &Reader| {
        let amplitude = match is_angle {
            true => wave.f64("amplitude_deg").between(0.0, 45.0).unit("degrees").map(radians).required(),
            false => wave.f64("amplitude_m").between(0.0, 50.0).unit("m").required(),
        };
        let period = wave.f64("period_s").between(0.1, 1000.0).unit("s").required();
        let phase = wave.f64("phase_deg").between(-360.0, 360.0).unit("degrees").map(radians).default(0.0);
        let period_ms = (period? * 1000.0).round() as u64;
        Some(WaveWish { amplitude: amplitude?, period_ms, phase: phase? })
    };
    table.tables(key).iter().map(wave).collect()
}

/// How a word of `hull` hides it, given the gap of a box.
fn hiding(table: &Reader, sea: [f64; 3]) -> Option<Hiding> {
    let gap = table.f64("gap_m").above(0.0).at_most(100.0).unit("m").default(1.0)?;
    let words = [
        ("waterline", Hiding::Waterline),
        ("box", Hiding::Box { gap, sea }),
        ("wedges", Hiding::Wedges(Wedges::USUAL)),
        ("exact", Hiding::Exact),
        ("sea-first", Hiding::SeaFirst),
        ("deep-hull", Hiding::DeepHull),
    ];
    table.one_of("hull", &words).default(Hiding::Waterline)
}

fn bow_wake(table: &Reader, sea: [f64; 3]) -> Option<Option<(BowWake, u64)>> {
    let Some(wake) = table.optional_table("bow_wake") else {
        return (!table.has("bow_wake")).then_some(None);
    };
    let metres = |key: &str, usual: f64| wake.f64(key).above(0.0).at_most(1000.0).unit("m").default(usual);
    let (height, length) = (metres("height_m", 4.0), metres("length_m", 30.0));
    let lean = wake.f64("lean").between(0.0, 10.0).default(0.0);
    let foam = wake.f64_array::<3>("colour").between(0.0, 1.0).default(FOAM);
    let frames = wake.u64("frames").between(1, 10_000).default(2);
    let bow = BowWake { height: height?, length: length?, lean: lean?, foam: foam?, sea };
    Some(Some((bow, frames?)))
}

fn stern_wake(table: &Reader) -> Option<Option<SternWakeWish>> {
    let Some(wake) = table.optional_table("stern_wake") else {
        return (!table.has("stern_wake")).then_some(None);
    };
    let metres = |key: &str, usual: f64| wake.f64(key).above(0.0).at_most(1e5).unit("m").default(usual);
    let (length, width) = (metres("length_m", 400.0), metres("width_m", 25.0));
    let detail = wake.one_of("detail", &DETAILS).default(Detail::Add);
    let colour = wake.f64_array::<3>("colour").between(0.0, 1.0).default(FOAM);
    Some(Some(SternWakeWish { size: [length?, width?], detail: detail?, colour: colour? }))
}
