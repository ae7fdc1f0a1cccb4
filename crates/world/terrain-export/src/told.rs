//! Errors of the conversions of an export, as a document.

use picture::AnyPicture;
use serde_json::{Value, json};
use survey::{Grid, Survey};
use terrain_builder::{Export, Ground};
use terrain_database::{Database, documented_bytes};

/// Schema of the document of an export.
pub(crate) const SCHEMA: &str = "lunoid.terrain-export/1";

/// A document of schema `lunoid.terrain-export/1`. `quantised` is the largest change of a height in the database (m), `albedo` its
/// picture from above.
pub(crate) fn document(
    ground: &Ground,
    database: &Database,
    quantised: f64,
    export: &Export,
    survey: &Survey,
    albedo: Option<&AnyPicture>,
) -> Value {
    let description = ground.description();
    json!({
        "schema": SCHEMA,
        "title": description.title,
        "database": of_database(database, quantised),
        "craters": craters(ground, export),
        "bank": bank(survey),
        "boulders": ground.boulders().len(),
        "albedo": albedo.map(|picture| of_albedo(ground, picture)),
        "warnings": ground.warnings().iter().map(ToString::to_string).collect::<Vec<_>>(),
    })
}

fn of_database(database: &Database, quantised: f64) -> Value {
    let (contents, counts) = (database.contents(), database.counts());
    let levels = 0..=contents.order as usize;
    json!({
        "tiles": counts,
        "order": contents.order,
        "posts": contents.heights.len(),
        "step_m": contents.step,
        "largest_change_m": quantised,
        "level_errors_m": levels.map(|level| database.error(level)).collect::<Vec<_>>(),
        "documented_bytes": documented_bytes(contents.order, (counts[0] * counts[1]) as u64),
    })
}

/// Size of the picture, and what a pixel of it stands for. A code of 16 bits is 1/65535 of the albedo.
fn of_albedo(ground: &Ground, picture: &AnyPicture) -> Value {
    let east = &ground.description().grid.east;
    json!({
        "columns": picture.columns(),
        "lines": picture.lines(),
        "pixel_m": east.resolution * east.cells as f64 / picture.columns() as f64,
        "colour": picture.is_colour(),
    })
}

fn craters(ground: &Ground, export: &Export) -> Value {
    let id = |feature: &u32| &ground.description().features[*feature as usize].id;
    let listed = export.craters.iter().zip(&export.features).map(|(nearest, feature)| {
        let [x, y] = nearest.crater.centre();
        json!({ "feature": id(feature), "x_m": x, "y_m": y, "largest_difference_m": nearest.largest_difference })
    });
    let kept = export
        .kept
        .iter()
        .map(|(feature, reason)| json!({ "feature": feature, "reason": reason.to_string() }));
    json!({
        "listed": listed.collect::<Vec<_>>(),
        "kept_in_bank": kept.collect::<Vec<_>>(),
        "largest_difference_m": export.largest_difference(),
    })
}

fn bank(survey: &Survey) -> Value {
    let finest = &survey.report.levels[0];
    json!({
        "region_size_m": finest.region_size,
        "rms_m": finest.rms,
        "largest_residual_m": finest.worst.residual.abs(),
        "largest_residual_at_m": finest.worst.place,
        "region_residuals_m": regions(&survey.residuals, finest.region_size),
        "warnings": survey.report.warnings,
    })
}

/// Largest residual of each region (m): rows from the south, each from the west. A sample on an edge belongs to the region north or
/// east of it.
fn regions(residuals: &Grid, size: f64) -> Vec<Vec<f64>> {
    let region = |axis: usize, index: usize| {
        ((residuals.first[axis] + index as f64 * residuals.step[axis]) / size + 1e-9).floor().max(0.0)
            as usize
    };
    let (rows, columns) = (region(0, residuals.lines - 1) + 1, region(1, residuals.columns - 1) + 1);
    let mut largest = vec![vec![0.0_f64; columns]; rows];
    for (index, value) in residuals.values.iter().enumerate().filter(|(_, value)| value.is_finite()) {
        let place = &mut largest[region(0, index / residuals.columns)][region(1, index % residuals.columns)];
        *place = place.max(value.abs());
    }
    largest
}
