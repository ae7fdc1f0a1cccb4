//! Over an area: counts, and the area as GeoTIFF, NPY, CSV and picture.

use std::fmt::Write;
use std::path::Path;

use files::{Npy, NpyData, write_npy};
use plots::{SightLayer, SightLook, SightMap, sight_picture};
use serde_json::json;
use sight::{Height, Sight};
use survey::{PlacedRaster, RasterSamples, write_geotiff};

use super::ground::Site;
use super::lines::{header, word};
use super::options::Layer;
use super::rows::Rows;
use super::{SightCommand, refused};
use command_line::Failure;
use command_line::output::{ending, print, print_json};

/// Code of a place of which nothing is known.
const UNKNOWN: u8 = 255;
/// The longer side of the picture (pixels).
const LONGEST: u32 = 800;

/// What was found of each place.
enum Found {
    Seen(Vec<Sight>),
    LeastHeight(Vec<f64>),
}

/// Looks over the area.
pub fn over(command: &SightCommand) -> Result<(), Failure> {
    let Height::AboveGround(height) = command.target_height else {
        return Err(Failure::usage(
            "--target-height datum: over an area targets stand above the ground; expected metres above the ground",
        ));
    };
    if command.layer == Layer::LeastHeight && height != 0.0 {
        return Err(Failure::usage(
            "--target-height: the least height counts from the ground; leave it out with --layer least-height",
        ));
    }
    let site = command.site(&[])?;
    let curvature = command.bending.curvature(site.radius())?;
    let rows = Rows::new(site.targets.size[0], !command.no_progress);
    let (observer, done) = (command.observer(), || rows.hear());
    let found = match command.layer {
        Layer::Seen => site.viewshed(&observer, height, curvature, &done).map(Found::Seen),
        Layer::LeastHeight => site.least_heights(&observer, curvature, &done).map(Found::LeastHeight),
    };
    let found = found.map_err(refused)?;
    command.out.iter().try_for_each(|out| write(command, &site, &found, out))?;
    tell(command, &site, &found)
}

impl Found {
    /// Whether each place is seen; ground by its least height.
    fn seen(&self) -> Vec<Option<bool>> {
        match self {
            Self::Seen(seen) => seen.iter().map(|sight| known(*sight)).collect(),
            Self::LeastHeight(least) => {
                least.iter().map(|least| (!least.is_nan()).then_some(*least == 0.0)).collect()
            }
        }
    }
}

fn known(sight: Sight) -> Option<bool> {
    match sight {
        Sight::Visible => Some(true),
        Sight::Hidden => Some(false),
        Sight::Unknown => None,
    }
}

fn code(sight: Sight) -> u8 {
    known(sight).map_or(UNKNOWN, u8::from)
}

/// Visible, hidden and unknown places.
fn counts(found: &Found) -> [usize; 3] {
    let seen = found.seen();
    [Some(true), Some(false), None].map(|which| seen.iter().filter(|seen| **seen == which).count())
}

fn tell(command: &SightCommand, site: &Site, found: &Found) -> Result<(), Failure> {
    let [visible, hidden, unknown] = counts(found);
    let [rows, columns] = site.targets.size;
    if command.json {
        let mut document = header(command, site);
        document["area"] = json!({
            "rows": rows,
            "columns": columns,
            "north_west_m": site.targets.corner,
            "spacing_m": site.targets.spacing,
            "visible": visible,
            "hidden": hidden,
            "unknown": unknown,
        });
        return print_json(&document);
    }
    print(&format!("{}\n{}\n", site.title, fact(command, site, found)))
}

/// The counts in words.
fn fact(command: &SightCommand, site: &Site, found: &Found) -> String {
    let [visible, hidden, unknown] = counts(found);
    let [rows, columns] = site.targets.size;
    format!(
        "{rows} x {columns} places, {} m apart: {visible} visible, {hidden} hidden, {unknown} unknown; {}, {}",
        site.targets.spacing,
        command.surface_word(site),
        command.bending.told(site.radius())
    )
}

fn write(command: &SightCommand, site: &Site, found: &Found, out: &Path) -> Result<(), Failure> {
    match ending(out).as_str() {
        "npy" => Ok(write_npy(out, &array(site, found)?)?),
        "csv" => write_csv(site, found, out),
        "png" | "svg" => picture(command, site, found, out),
        _ => {
            let samples = match found {
                Found::Seen(seen) => RasterSamples::Codes(seen.iter().map(|sight| code(*sight)).collect()),
                Found::LeastHeight(least) => RasterSamples::Numbers(least.clone()),
            };
            let (affine, frame, size) = (site.affine(), site.frame, site.targets.size);
            Ok(write_geotiff(out, &PlacedRaster { size, affine, frame, samples })?)
        }
    }
}

fn array(site: &Site, found: &Found) -> Result<Npy, Failure> {
    let data = match found {
        Found::Seen(seen) => NpyData::U8(seen.iter().map(|sight| code(*sight)).collect()),
        Found::LeastHeight(least) => NpyData::F64(least.clone()),
    };
    Npy::new(site.targets.size.to_vec(), data).map_err(Failure::output)
}

fn write_csv(site: &Site, found: &Found, out: &Path) -> Result<(), Failure> {
    let columns = site.targets.size[1];
    let place = |at: usize| site.targets.place(at / columns, at % columns);
    let mut text = String::new();
    // Writing to a string cannot fail.
    match found {
        Found::Seen(seen) => {
            text += "north_m,east_m,sight\n";
            for (at, sight) in seen.iter().enumerate() {
                let [north, east] = place(at);
                let _ = writeln!(text, "{north},{east},{}", word(*sight));
            }
        }
        Found::LeastHeight(least) => {
            text += "north_m,east_m,least_height_m\n";
            for (at, least) in least.iter().enumerate() {
                let [north, east] = place(at);
                let least = if least.is_nan() { String::new() } else { least.to_string() };
                let _ = writeln!(text, "{north},{east},{least}");
            }
        }
    }
    Ok(files::write_atomic(out, |file| file.write_all(text.as_bytes()))?)
}

fn picture(command: &SightCommand, site: &Site, found: &Found, out: &Path) -> Result<(), Failure> {
    let targets = &site.targets;
    let columns = targets.size[1];
    let height = |at: usize| site.height(targets.place(at / columns, at % columns)).unwrap_or(f64::NAN);
    let heights: Vec<f64> = (0..targets.size[0] * columns).map(height).collect();
    let seen = found.seen();
    let layer = match found {
        Found::Seen(_) => SightLayer::Seen(&seen),
        Found::LeastHeight(least) => SightLayer::LeastHeight(least),
    };
    let (size, corner, spacing) = (targets.size, targets.corner, targets.spacing);
    let map = SightMap { size, corner, spacing, heights: &heights, layer, observer: command.from };
    let facts = vec![fact(command, site, found)];
    let look = SightLook { title: site.title.clone(), facts, longest: LONGEST };
    Ok(sight_picture(&map, &look)?.write(out)?)
}
