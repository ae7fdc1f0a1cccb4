//! The text beside a bank, for people and for tools that only list.

use super::{FORMAT, content_hash};
use crate::{Bank, Georeference, Level};
use quantities::degrees;
use std::fmt::Write;
use std::path::{Path, PathBuf};

/// Returns the path of the text beside a bank: `NAME.bank.toml` for `NAME.bank`.
pub fn sidecar_path(bank: &Path) -> PathBuf {
    bank.with_extension("bank.toml")
}

/// What a bank holds, as TOML.
pub fn describe(bank: &Bank) -> String {
    let hash: String = content_hash(bank).iter().map(|byte| format!("{byte:02x}")).collect();
    let mut text =
        String::from("# Written beside a landscape bank; the bank itself does not depend on it.\n");
    let title = toml::Value::from(bank.title());
    text += &format!("format = {FORMAT}\ntitle = {title}\ncontent_blake3 = \"{hash}\"\n");
    text += "axes = \"x north, y east, h up; words d^(p+q) h_(x^p y^q), index 3p+q; all metres\"\n";
    if let Some(place) = bank.georeference() {
        text += &describe_place(&place);
    }
    for level in bank.levels() {
        text += &describe_level(level);
    }
    text
}

fn describe_place(place: &Georeference) -> String {
    let north = place.true_north.map(|north| ("true_north_deg", degrees(north)));
    let keys = [
        ("latitude_deg", degrees(place.latitude)),
        ("longitude_deg", degrees(place.longitude)),
        ("tangent_north_m", place.at[0]),
        ("tangent_east_m", place.at[1]),
    ];
    let keys: Vec<_> = keys.into_iter().chain(north).collect();
    table("\n[place]\n", &keys)
}

fn describe_level(level: &Level) -> String {
    let [south, west, north, east] = level.extent();
    let [rows, columns] = level.corners();
    let heights = level.words().iter().map(|words| words[0]);
    let heading = format!("\n[[levels]]\ncorners_north = {rows}\ncorners_east = {columns}\n");
    let keys = [
        ("region_size_m", level.region_size()),
        ("south_m", south),
        ("west_m", west),
        ("north_m", north),
        ("east_m", east),
        ("lowest_corner_m", heights.clone().fold(f64::INFINITY, f64::min)),
        ("highest_corner_m", heights.fold(f64::NEG_INFINITY, f64::max)),
    ];
    table(&heading, &keys)
}

fn table(heading: &str, keys: &[(&str, f64)]) -> String {
    keys.iter().fold(heading.to_owned(), |mut text, (key, value)| {
        // Writing to a string cannot fail. `{:?}` keeps the point that makes a TOML float.
        let _ = writeln!(text, "{key} = {value:?}");
        text
    })
}
