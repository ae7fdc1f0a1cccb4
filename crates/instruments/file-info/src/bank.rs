//! A bank in words and as a document.

use std::path::Path;

use landscape::{Bank, Level, bank_file};
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
            "  touches the Moon at {latitude:.6} N, {longitude:.6} E (x = {} m, y = {} m)\n",
            shortened(north, 3),
            shortened(east, 3)
        );
        let north = place.true_north.map(|north| shortened(degrees(north), 3));
        text += &match north {
            Some(north) => format!("  true north: {north} deg clockwise from the x axis\n"),
            None => "  true north: not kept in this bank\n".into(),
        };
    }
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
        "levels": levels.collect::<Vec<_>>(),
    })
}

/// Lowest and highest corner (m).
fn heights(level: &Level) -> [f64; 2] {
    let start = [f64::INFINITY, f64::NEG_INFINITY];
    level.words().iter().fold(start, |[low, high], words| [low.min(words[0]), high.max(words[0])])
}
