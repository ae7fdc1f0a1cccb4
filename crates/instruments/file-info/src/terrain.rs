//! What a landscape of features and a terrain database hold.

use std::collections::BTreeMap;
use std::path::Path;

use quantities::degrees;
use serde_json::json;
use terrain_builder::{BaseWish, Description};
use terrain_database::Database;
use text::{shortened, table};

use crate::{Held, InfoError};

/// A landscape as its file says it; nothing is built.
pub fn landscape(path: &Path) -> Result<Held, InfoError> {
    let Description { title, frame, grid, base, features, light, .. } = Description::read(path)?;
    let [rows, columns] = grid.size();
    let [south, north] = frame.latitude().map(degrees);
    let [west, east] = frame.longitude().map(degrees);
    let base = match base {
        BaseWish::Level(height) => format!("level at {} m", shortened(height, 3)),
        BaseWish::File { path, .. } => path.display().to_string(),
    };
    let mut kinds = BTreeMap::<&str, [usize; 2]>::new();
    for feature in &features {
        let [all, off] = kinds.entry(feature.kind.word()).or_default();
        *all += 1;
        *off += usize::from(!feature.is_enabled);
    }
    let listed: Vec<String> = kinds
        .iter()
        .map(|(kind, [all, off])| {
            let off = if *off > 0 { format!(" ({off} off)") } else { String::new() };
            format!("{all} {kind}{off}")
        })
        .collect();
    let listed = if listed.is_empty() { "none".to_owned() } else { listed.join(", ") };
    let resolution = shortened(grid.north.resolution, 3);
    let text = format!(
        "{}: {title}\n  latitude {south:.6} to {north:.6} deg, longitude {west:.6} to {east:.6} deg, radius {} m\n  \
         {rows} x {columns} posts, {resolution} m apart, tiles of {} cells a side\n  base {base}; light {}\n  features: {listed}\n",
        path.display(),
        shortened(frame.radius(), 3),
        grid.north.tile_cells(),
        if light.is_some() { "given" } else { "none" },
    );
    let document = json!({
        "schema": "lunoid.info.landscape/1",
        "file": path.display().to_string(),
        "title": title,
        "latitude_deg": [south, north],
        "longitude_deg": [west, east],
        "radius_m": frame.radius(),
        "posts": [rows, columns],
        "resolution_m": grid.north.resolution,
        "tile_cells": grid.north.tile_cells(),
        "base": base,
        "has_light": light.is_some(),
        "features": kinds.iter().map(|(kind, [all, off])| json!({ "kind": kind, "count": all, "off": off }))
            .collect::<Vec<_>>(),
    });
    Ok(Held { document, text })
}

/// A terrain database: every hash is checked.
pub fn database(path: &Path) -> Result<Held, InfoError> {
    let database = Database::open(path).map_err(Box::new)?;
    let contents = database.contents();
    let [columns, rows] = contents.places.each_ref().map(Vec::len);
    let [across, along] = database.counts();
    let bounds = database.tiles().iter().map(|tile| tile.bounds);
    let [low, high] = bounds.reduce(|a, b| [a[0].min(b[0]), a[1].max(b[1])]).unwrap_or_default();
    let errors: Vec<f64> = (0..=contents.order as usize).map(|level| database.error(level)).collect();
    let maps = [("light", &contents.light), ("albedo", &contents.albedo)];
    let maps = maps.iter().filter(|(_, map)| map.is_some()).map(|(name, _)| *name);
    let maps: Vec<&str> = maps.collect();
    let [latitude, longitude] = [contents.frame.latitude, contents.frame.longitude].map(degrees);
    let steps = contents.step.map_or("every bit".into(), |step| format!("steps of {step} m"));
    let ranges = contents.ranges.iter();
    let ranges: Vec<_> =
        ranges.map(|range| json!({ "end_m": range.end, "morph_share": range.share })).collect();
    let mut text = format!(
        "{}: terrain database\n  {rows} x {columns} posts in {along} x {across} tiles of order {}, heights {low:.2} to {high:.2} m, {steps}\n  \
         about latitude {latitude:.6} deg, longitude {longitude:.6} deg, radius {} m\n  maps: {}; {} boulders; {} ranges of levels\n",
        path.display(),
        contents.order,
        shortened(contents.frame.radius, 3),
        if maps.is_empty() { "none".to_owned() } else { maps.join(", ") },
        contents.boulders.len(),
        ranges.len(),
    );
    let heading = ["level", "cells of a tile", "largest error"].map(str::to_owned).to_vec();
    let row = |(level, error): (usize, &f64)| {
        vec![
            level.to_string(),
            (1_usize << (contents.order as usize - level)).to_string(),
            format!("{error:.4} m"),
        ]
    };
    text += &table(&[heading].into_iter().chain(errors.iter().enumerate().map(row)).collect::<Vec<_>>());
    let document = json!({
        "schema": "lunoid.info.terrain-database/1",
        "file": path.display().to_string(),
        "posts": [rows, columns],
        "tiles": [along, across],
        "order": contents.order,
        "heights_m": [low, high],
        "step_m": contents.step,
        "latitude_deg": latitude,
        "longitude_deg": longitude,
        "radius_m": contents.frame.radius,
        "maps": maps,
        "boulders": contents.boulders.len(),
        "ranges": ranges,
        "errors_m": errors,
    });
    Ok(Held { document, text })
}
