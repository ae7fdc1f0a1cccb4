//! `[[channel]]`: views from one vehicle.

use diagnostics::Reader;
use landscape::Attitude;
use quantities::radians;

use super::scenery::{Id, id_in, report_twins};
use super::{all, raster};
use crate::Channel;

/// Most channels of a scenario. Chosen: each is drawn side by side with the others.
const MOST_CHANNELS: usize = 16;

/// The channels of `[[channel]]`; `raster` is the table of the picture that all of them have.
pub(super) fn channels(tables: &[Reader], raster: &Reader) -> Option<Vec<Channel>> {
    let read: Vec<(Id, Option<Channel>)> = tables.iter().map(|table| channel(table, raster)).collect();
    if tables.len() > MOST_CHANNELS {
        let title = format!("{} channels", tables.len());
        tables[0].report(tables[0].problem("name", title).expected(format!("at most {MOST_CHANNELS}")));
        return None;
    }
    // Names are names of folders, and some systems take no notice of capitals.
    let (names, channels): (Vec<Id>, Vec<Option<Channel>>) = read.into_iter().unzip();
    let lower = |name: Id| {
        name.map(|mut name| {
            name.value.make_ascii_lowercase();
            name
        })
    };
    let names: Vec<Id> = names.into_iter().map(lower).collect();
    let twins = report_twins(tables.iter().zip(&names), "channels");
    if twins { None } else { all(channels.into_iter()) }
}

fn channel(table: &Reader, raster: &Reader) -> (Id, Option<Channel>) {
    let name = id_in(table, "name");
    let degrees = |key: &str, most: f64| table.f64(key).between(-most, most).unit("degrees").map(radians);
    let (heading, pitch) =
        (degrees("heading_deg", 180.0).default(0.0), degrees("pitch_deg", 90.0).default(0.0));
    let roll = degrees("roll_deg", 180.0).default(0.0);
    let field = match table.has("field_of_view_deg") {
        true => raster::field_of_view(table, raster).map(Some),
        false => Some(None),
    };
    let of = name.as_ref().map(|name| name.value.clone());
    let read = || {
        let mount = Attitude { heading: heading?, pitch: pitch?, roll: roll? };
        Some(Channel { name: of?, mount, field: field? })
    };
    (name, read())
}
