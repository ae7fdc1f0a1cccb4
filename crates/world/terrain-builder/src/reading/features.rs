//! `[[feature]]`: one table a feature.

use std::f64::consts::FRAC_PI_2;
use std::path::Path;

use diagnostics::Reader;
use quantities::radians;

use super::{checked, distributions, growth, range, texture};
use crate::boulder::{Boulder, Shape, USUAL_BURIAL, USUAL_FACES};
use crate::crater::{Crater, CraterForm, Decay, USUAL_CONSTANT, USUAL_EXTENT};
use crate::description::{BoulderLook, Feature, Kind};
use crate::frame::Frame;
use crate::grid::Grid;
use crate::height_grid::Area;
use crate::roughness::Roughness;

/// Kinds of features that a file can have.
#[derive(Clone, Copy)]
enum Word {
    Crater,
    Growth,
    Area,
    Texture,
    Boulder,
    Craters,
    Boulders,
}

const WORDS: [(&str, Word); 7] = [
    ("crater", Word::Crater),
    ("growth", Word::Growth),
    ("area", Word::Area),
    ("texture", Word::Texture),
    ("boulder", Word::Boulder),
    ("craters", Word::Craters),
    ("boulders", Word::Boulders),
];

/// Reads the table of one feature. Files that it names lie in `folder`.
pub fn feature(table: &Reader, frame: &Frame, grid: &Grid, folder: &Path) -> Option<Feature> {
    let is_name =
        |name: &String| name.len() <= 64 && name.chars().all(|c| c.is_ascii_alphanumeric() || c == '-');
    let id = table.string("id").must("letters, digits and hyphens, at most 64", is_name).required();
    let is_enabled = table.bool("enabled").default(true);
    let Some(word) = table.one_of("kind", &WORDS).required() else {
        table.ignore_rest();
        return None;
    };
    let kind = match word {
        Word::Crater => crater(table, frame),
        Word::Growth => growth::growth(table, frame, grid),
        Word::Area => area(table, frame).map(Kind::Area),
        Word::Texture => texture::texture(table, grid, folder).map(Kind::Texture),
        Word::Boulder => boulder(table, frame),
        Word::Craters => distributions::craters(table, frame),
        Word::Boulders => distributions::boulders(table, frame),
    };
    let can_be_rough = !matches!(word, Word::Boulder | Word::Boulders | Word::Texture);
    let rough = if can_be_rough { table.optional_table("roughness") } else { None };
    let roughness = match rough {
        Some(table) => Some(roughness(&table, kind.as_ref(), grid)?),
        None => None,
    };
    Some(Feature { id: id?, is_enabled: is_enabled?, kind: kind?, roughness })
}

/// Place of a feature: north, east (m).
fn centre(table: &Reader, frame: &Frame) -> Option<[f64; 2]> {
    let angle = |key, most: f64| table.f64(key).between(-most, most).map(radians).required();
    let (longitude, latitude) = (angle("longitude_deg", 360.0), angle("latitude_deg", 90.0));
    Some(frame.forward(latitude?, longitude?))
}

/// Box between two longitudes and two latitudes (m).
pub fn area(table: &Reader, frame: &Frame) -> Option<Area> {
    let (longitude, latitude) = (range(table, "longitude_deg"), range(table, "latitude_deg"));
    // A frame of the range refuses what is no range.
    let of_range = checked(table, Frame::new(frame.radius(), longitude?, latitude?))?;
    let ([west, east], [south, north]) = (of_range.longitude(), of_range.latitude());
    let low = frame.forward(south, west);
    let [_, width] = frame.forward(south, frame.centre()[1] + (east - west));
    Some([low, [frame.forward(north, west)[0], low[1] + width]])
}

fn crater(table: &Reader, frame: &Frame) -> Option<Kind> {
    let centre = centre(table, frame);
    let radius = table.f64("radius_m").required();
    let share = |key| table.f64(key).map(|percent| 0.01 * percent).required();
    let (wall, depth) = (share("wall_percent"), share("depth_percent"));
    let constant = table.f64("decay_constant").default(USUAL_CONSTANT);
    let is_linear = table.one_of("decay", &[("exponential", false), ("linear", true)]).default(false);
    let extent = table.f64("extent").default(USUAL_EXTENT);
    let elevation = table.f64("impact_elevation_deg").map(radians).default(FRAC_PI_2);
    let direction = table.f64("impact_direction_deg").map(radians).default(0.0);
    let form = CraterForm {
        centre: centre?,
        radius: radius?,
        wall: wall?,
        depth: depth?,
        decay: if is_linear? { Decay::Linear } else { Decay::Exponential(constant?) },
        extent: extent?,
        impact_elevation: elevation?,
        impact_direction: direction?,
    };
    checked(table, Crater::new(form))?;
    Some(Kind::Crater(form))
}

fn boulder(table: &Reader, frame: &Frame) -> Option<Kind> {
    let (at, radius, seed) = (centre(table, frame), table.f64("radius_m").required(), seed(table));
    let look = look(table);
    let (at, radius, look, seed) = (at?, radius?, look?, seed?);
    checked(table, Boulder::new(at, radius, look.shape, look.burial, [seed, 0]))?;
    Some(Kind::Boulder { at, radius, look, seed })
}

/// Seed of a feature; 0 unless the file has one.
pub fn seed(table: &Reader) -> Option<u64> {
    table.u64("seed").default(0)
}

/// Form and burial of boulders.
pub fn look(table: &Reader) -> Option<BoulderLook> {
    let faces = table.u32("faces").default(USUAL_FACES);
    let words = [("sphere", Shape::Sphere), ("cube", Shape::Cube), ("rock", Shape::Rock(USUAL_FACES))];
    let shape = table.one_of("shape", &words).required();
    let burial = table.f64("burial").default(USUAL_BURIAL);
    let shape = match shape? {
        Shape::Rock(_) => Shape::Rock(faces?),
        other => other,
    };
    Some(BoulderLook { shape, burial: burial? })
}

/// Passes over the extent of a feature. They are checked on a box of one cell: the feature's own is known when it is built.
fn roughness(table: &Reader, kind: Option<&Kind>, grid: &Grid) -> Option<Roughness> {
    let seeds = table.u64_list("seeds").required();
    let scale = table.f64("scale_m").required();
    let spacing = table.f64("spacing_m").default(grid.north.resolution);
    let smoothing = table.f64("smoothing_m").default(0.0);
    let roughness = Roughness { seeds: seeds?, scale: scale?, spacing: spacing?, smoothing: smoothing? };
    let side = match kind {
        Some(Kind::Area(area)) => *area,
        _ => [[0.0; 2], [roughness.spacing; 2]],
    };
    checked(table, roughness.check(side))?;
    Some(roughness)
}
