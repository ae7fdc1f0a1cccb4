//! A bank in words and as a document.

use std::path::Path;

use landscape::projection::Method;
use landscape::{Bank, Level, MapFrame, SPACING_RULE, bank_file};
use quantities::degrees;
use serde_json::{Value, json};
use text::{shortened, table};

/// A bank in words: title, place on the Moon, a row a level.
pub fn bank_text(bank: &Bank) -> String {
    let mut text = format!("{}\n", bank.title());
    if let Some(place) = bank.georeference() {
        let [latitude, longitude] = [place.latitude, place.longitude].map(degrees);
        let [north, east] = place.at;
        text += &format!(
            "  touches the Moon at {}, {} (x = {} m, y = {} m)\n",
            text::latitude(latitude, 6),
            text::longitude(longitude, 6),
            shortened(north, 3),
            shortened(east, 3)
        );
        let north = place.true_north.map(|north| shortened(degrees(north), 3));
        text += &match north {
            Some(north) => format!("  true north: {north} deg clockwise from the x axis\n"),
            None => "  true north: not kept in this bank\n".into(),
        };
    }
    text.extend(bank.map().map(map_text));
    let heading = ["level", "regions", "region size", "south, west", "north, east", "corner heights"];
    let rows = bank.levels().iter().enumerate().map(|(index, level)| {
        let [south, west, north, east] = level.extent().map(|edge| shortened(edge, 3));
        let [m, n] = level.corners();
        let [low, high] = heights(level);
        vec![
            index.to_string(),
            format!("{} x {}", m - 1, n - 1),
            format!("{} m", shortened(level.region_size(), 3)),
            format!("{south}, {west} m"),
            format!("{north}, {east} m"),
            format!("{low:.2} to {high:.2} m"),
        ]
    });
    text + &table(&[heading.map(str::to_owned).to_vec()].into_iter().chain(rows).collect::<Vec<_>>())
}

/// The bank in the file `path` as a document of schema `lunoid.bank/1`.
pub fn bank_document(path: &Path, bank: &Bank) -> Value {
    let place = bank.georeference().map(|place| {
        json!({ "latitude_deg": degrees(place.latitude), "longitude_deg": degrees(place.longitude),
                "at_m": place.at, "true_north_deg": place.true_north.map(degrees) })
    });
    let map = bank.map().map(map_document);
    let levels = bank.levels().iter().map(|level| {
        json!({ "region_size_m": level.region_size(), "origin_m": level.origin(), "corners": level.corners(),
                "extent_m": level.extent(), "corner_heights_m": heights(level) })
    });
    let hash: String = bank_file::content_hash(bank).iter().map(|byte| format!("{byte:02x}")).collect();
    json!({
        "schema": "lunoid.bank/1",
        "file": path.display().to_string(),
        "title": bank.title(),
        "content_blake3": hash,
        "place": place,
        "map": map,
        "levels": levels.collect::<Vec<_>>(),
    })
}

/// Where the bank came from, in words: a line for the map, a line for the samples.
fn map_text(map: &MapFrame) -> String {
    let [north, east] = map.origin.map(|place| shortened(place, 3));
    let [first, spacing] =
        [map.first_sample, map.spacing].map(|pair| pair.map(|length| shortened(length, 4)));
    let datum = map.projection.map_or("datum unknown".into(), |projection| {
        format!("heights above a sphere of {} m", shortened(projection.radius, 3))
    });
    format!(
        "  map: {}, {datum}; the file has {}; bank (0, 0) lies at north {north} m, east {east} m of the map\n  \
         samples: points at their centres; the south-west one at x = {} m, y = {} m of the bank, then every {} m \
         north, {} m east\n",
        map.projection_name(),
        map.coordinates.unit(),
        first[0],
        first[1],
        spacing[0],
        spacing[1],
    )
}

/// The same as a document.
fn map_document(map: &MapFrame) -> Value {
    let projection = map.projection.map(|projection| {
        json!({ "datum_radius_m": projection.radius,
                "centre_deg": [degrees(projection.latitude), degrees(projection.longitude)],
                "false_origin_m": projection.offset })
    });
    let parameter = map.projection.and_then(|projection| match projection.method {
        Method::Equirectangular { parallel } => Some(json!({ "parallel_deg": degrees(parallel) })),
        Method::PolarStereographic { scale } => Some(json!({ "scale": scale })),
        Method::Orthographic => None,
    });
    json!({
        "projection": map.projection_name(),
        "sphere": projection,
        "parameter": parameter,
        "file_coordinates": map.coordinates.unit(),
        "origin_m": map.origin,
        "south_west_sample_m": map.first_sample,
        "spacing_m": map.spacing,
        "spacing_rule": SPACING_RULE,
    })
}

/// Lowest and highest corner (m).
fn heights(level: &Level) -> [f64; 2] {
    let start = [f64::INFINITY, f64::NEG_INFINITY];
    level.words().iter().fold(start, |[low, high], words| [low.min(words[0]), high.max(words[0])])
}
