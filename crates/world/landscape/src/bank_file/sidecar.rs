//! The text beside a bank, for people and for tools that only list.

use super::{FORMAT, content_hash};
use crate::map_frame::SPACING_RULE;
use crate::projection::Method;
use crate::{Bank, Georeference, Level, MapFrame};
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
    if let Some(map) = bank.map() {
        text += &describe_map(map);
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

fn describe_map(map: &MapFrame) -> String {
    let unit = map.coordinates.unit();
    let heading = format!(
        "\n[map]\nprojection = \"{}\"\nfile_coordinates = \"{unit}\"\nspacing_rule = \"{SPACING_RULE}\"\n",
        map.projection_name()
    );
    let [[origin_north, origin_east], [first_north, first_east], [step_north, step_east]] =
        [map.origin, map.first_sample, map.spacing];
    let of_projection = map.projection.map_or(Vec::new(), |projection| {
        let parameter = match projection.method {
            Method::Equirectangular { parallel } => Some(("parallel_deg", degrees(parallel))),
            Method::PolarStereographic { scale } => Some(("scale", scale)),
            Method::Orthographic => None,
        };
        let centre = [
            ("datum_radius_m", projection.radius),
            ("centre_latitude_deg", degrees(projection.latitude)),
            ("centre_longitude_deg", degrees(projection.longitude)),
            ("false_northing_m", projection.offset[0]),
            ("false_easting_m", projection.offset[1]),
        ];
        centre.into_iter().chain(parameter).collect()
    });
    let places = [
        ("origin_north_m", origin_north),
        ("origin_east_m", origin_east),
        ("south_west_sample_north_m", first_north),
        ("south_west_sample_east_m", first_east),
        ("spacing_north_m", step_north),
        ("spacing_east_m", step_east),
    ];
    table(&heading, &[of_projection, places.to_vec()].concat())
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
