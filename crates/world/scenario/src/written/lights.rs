//! `[[light]]`: lamps, strings of lamps, single stars.

use diagnostics::Reader;
use glam::DVec3;
use landscape::{Attitude, Sun};
use limits::Limit;
use quantities::radians;

use super::effect_keys::{Named, apart, colour, has_none, presence};
use super::guests::{moves, priority};
use super::object_ids::Ids;
use super::scenery::{Id, expect_count, id, place, report_limit};
use crate::{Flash, LightPlace, LightWish, Lobe, Moves, Object, Spot, Stance};

/// Lights of `[[light]]`; nothing is known of `objects` if one of them has a fault.
pub(super) fn lights(tables: &[Reader], objects: Option<&[Object]>) -> Named<LightWish> {
    if expect_count(tables, Limit::Lights, "lights").is_none() {
        return (Vec::new(), None);
    }
    let objects = objects.map(Ids::of);
    let (ids, lights) = apart(tables.iter().map(|table| light(table, objects.as_ref())).collect());
    (ids, lights.filter(|lights| lamps_are_few(tables, lights)))
}

/// Whether there are no more lamps than allowed, those of strings counted; reports the table that is one too many.
fn lamps_are_few(tables: &[Reader], lights: &[LightWish]) -> bool {
    let mut lamps = 0;
    for (table, light) in tables.iter().zip(lights) {
        lamps += u64::from(light.lamps());
        if !Limit::Lights.allows(lamps) {
            report_limit(table, Limit::Lights, format!("the lights up to this one have {lamps} lamps"));
            return false;
        }
    }
    true
}

fn light(table: &Reader, objects: Option<&Ids>) -> (Id, Option<LightWish>) {
    let id = id(table);
    let place = light_place(table, objects);
    let intensity = table.f64("intensity").between(0.0, 1000.0).default(1.0);
    let (colour, priority) = (colour(table), priority(table));
    let calligraphic = table.bool("calligraphic").default(false);
    let (beam, flash, presence) = (beam(table), flash(table), presence(table));
    let made = || {
        let id = id.as_ref()?.value.clone();
        let (place, colour, intensity, priority) = (place?, colour?, intensity?, priority?);
        let (calligraphic, beam, flash, presence) = (calligraphic?, beam?, flash?, presence?);
        Some(LightWish { id, place, colour, intensity, priority, calligraphic, beam, flash, presence })
    };
    let light = made();
    (id, light)
}

/// Keys of a place on the ground, on an object, and in the sky.
const PLACES: [&[&str]; 3] =
    [&["x_m", "y_m", "above_m"], &["on", "at_m"], &["azimuth_deg", "elevation_deg", "magnitude"]];

/// The place that the keys of a light name: on the ground, on an object, or in the sky.
fn light_place(table: &Reader, objects: Option<&Ids>) -> Option<LightPlace> {
    PLACES.iter().copied().flatten().for_each(|key| table.know(key));
    let named = PLACES.map(|keys| keys.iter().any(|key| table.has(key)));
    match named {
        [true, false, false] => on_ground(table),
        [false, true, false] => on_object(table, objects),
        [false, false, true] => in_sky(table),
        _ => {
            let title = if named == [false; 3] {
                format!("`{}` is nowhere", table.path("id"))
            } else {
                format!("`{}` is in more than one place", table.path("id"))
            };
            let expected = "one of `x_m` and `y_m`, `on` and `at_m`, `azimuth_deg` and `elevation_deg`";
            table.report(table.problem("id", title).expected(expected));
            pass_over_ground(table);
            None
        }
    }
}

/// Leaves keys unjudged that only a lamp over the ground has.
fn pass_over_ground(table: &Reader) {
    ["diameter_m", "count"].into_iter().for_each(|key| table.know(key));
    let tables = ["moves", "to"].into_iter().filter_map(|key| table.optional_table(key));
    tables.for_each(|below| below.ignore_rest());
}

fn diameter(table: &Reader) -> Option<f64> {
    table.f64("diameter_m").above(0.0).at_most(1e4).unit("m").required()
}

fn on_ground(table: &Reader) -> Option<LightPlace> {
    let (spot, diameter) = (spot(table), diameter(table));
    let stance = spot.map(|spot| Stance { at: spot.at, attitude: Attitude::default() });
    let moves = moves(table, stance.as_ref());
    let count = table.u32("count").between(2, most_lamps()).help(Limit::Lights.to_string()).optional();
    let end = table.optional_table("to").map(|to| self::spot(&to));
    match (table.has("count"), table.has("to")) {
        (false, false) => Some(LightPlace::Ground { spot: spot?, diameter: diameter?, moves: moves? }),
        (true, true) => string([spot, end.flatten()], count, diameter, moves, table),
        (has_count, _) => {
            let [there, missing] = if has_count { ["count", "to"] } else { ["to", "count"] };
            let title = format!("`{}` without `{}`", table.path(there), table.path(missing));
            table.report(table.problem(there, title).expected("both, for a string of lamps, or neither"));
            None
        }
    }
}

fn string(
    ends: [Option<Spot>; 2],
    count: Option<u32>,
    diameter: Option<f64>,
    moves: Option<Option<Moves>>,
    table: &Reader,
) -> Option<LightPlace> {
    let stands =
        has_none(table, &["moves"], "of a string of lamps, which stands still", "no `moves`, or no `count`");
    let [from, to] = ends;
    let string = LightPlace::String { ends: [from?, to?], count: count?, diameter: diameter? };
    moves.filter(|_| stands).map(|_| string)
}

fn most_lamps() -> u32 {
    u32::try_from(Limit::Lights.value()).unwrap_or(u32::MAX)
}

/// Reads `x_m`, `y_m` and `above_m`.
fn spot(table: &Reader) -> Option<Spot> {
    let at = place(table);
    let above = table.f64("above_m").between(0.0, 1e6).unit("m").default(0.0);
    Some(Spot { at: at?, above: above? })
}

fn on_object(table: &Reader, objects: Option<&Ids>) -> Option<LightPlace> {
    let none = format!("`{}` without an object that it could name", table.path("on"));
    // Without the ids of all objects nothing can be said about `on`.
    let object = objects.and_then(|objects| objects.object(table, "on", &none));
    let at = table.f64_array::<3>("at_m").between(-1e6, 1e6).unit("m").map(DVec3::from_array).required();
    let diameter = diameter(table);
    let reason = "of a lamp on an object, which says where it is";
    let is_alone = has_nothing_else(table, &["moves", "to", "count"], reason);
    let place = LightPlace::Object { object: object?, at: at?, diameter: diameter? };
    is_alone.then_some(place)
}

fn in_sky(table: &Reader) -> Option<LightPlace> {
    let azimuth = table.f64("azimuth_deg").between(-360.0, 360.0).unit("degrees").map(radians).required();
    let elevation = table.f64("elevation_deg").between(-90.0, 90.0).unit("degrees").map(radians).required();
    let magnitude = table.f64("magnitude").between(-50.0, 50.0).required();
    let refused = ["diameter_m", "beam", "moves", "to", "count"];
    let is_alone = has_nothing_else(table, &refused, "of a star, which is infinitely far");
    let direction = DVec3::from_array(Sun { azimuth: azimuth?, elevation: elevation? }.direction());
    let place = LightPlace::Sky { direction, magnitude: magnitude? };
    is_alone.then_some(place)
}

/// Whether none of the keys stands there that have no meaning beside this place; reports those that do.
fn has_nothing_else(table: &Reader, keys: &[&str], reason: &str) -> bool {
    pass_over_ground(table);
    has_none(table, keys, reason, "nothing, or a place `x_m` and `y_m`")
}

/// To which side a light shines, where it has a beam.
fn beam(table: &Reader) -> Option<Option<Lobe>> {
    let Some(beam) = table.optional_table("beam") else { return (!table.has("beam")).then_some(None) };
    let degrees = |key: &str, most: f64| beam.f64(key).between(-most, most).unit("degrees").map(radians);
    let (heading, pitch) =
        (degrees("heading_deg", 360.0).default(0.0), degrees("pitch_deg", 90.0).default(0.0));
    let half_angle =
        beam.f64("half_angle_deg").above(0.0).at_most(90.0).unit("degrees").map(radians).required();
    let power = beam.f64("power").between(0.0, 1e4).default(1.0);
    let attitude = Attitude { roll: 0.0, pitch: pitch?, heading: heading? };
    let axis = Stance { at: [0.0; 2], attitude }.to_ground() * DVec3::X;
    Some(Some(Lobe { axis, half_angle: half_angle?, power: power? }))
}

/// When a light is lit, where it flashes.
fn flash(table: &Reader) -> Option<Option<Flash>> {
    let Some(flash) = table.optional_table("flash") else { return (!table.has("flash")).then_some(None) };
    let period = flash.f64("period_s").above(0.0).at_most(1e6).unit("s").required();
    let duty = flash.f64("duty").between(0.0, 1.0).default(0.5);
    let phase = flash.f64("phase").at_least(0.0).below(1.0).default(0.0);
    Some(Some(Flash { period: period?, duty: duty?, phase: phase? }))
}
