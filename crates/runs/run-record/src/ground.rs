//! The ground of a run.

use landscape::relief::Relief;
use landscape::{AlbedoMap, Landscape, Level, Posts, Texels, bank_file};
use photograph::Photograph;
use quantities::degrees;
use scenario::GroundSource;
use serde::{Deserialize, Serialize};
use serde_json::{Value, json};

use crate::hash;

/// The ground of a run: where it came from, and the hash of its words.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct GroundRecord {
    /// Where the ground came from: "bank" or "generated".
    pub source: String,
    /// Title of the bank.
    pub title: String,
    /// BLAKE3 of its words, hexadecimal.
    pub content_blake3: String,
    /// Albedo of the soil, 0..=1.
    pub albedo: f64,
    /// Map of the albedo, where there is one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub albedo_map: Option<AlbedoMapRecord>,
    /// BLAKE3 of the posts of a terrain database, where there is one, hexadecimal.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub posts_blake3: Option<String>,
    /// Photographs of the ground, in the order of the scenario.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub photographs: Vec<PhotographRecord>,
    /// Levels, the finest first.
    pub levels: Vec<LevelRecord>,
    /// Parameters of a generated landscape, in the keys of a scenario file.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub generator: Option<Value>,
}

/// A map of the albedo.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct AlbedoMapRecord {
    /// South, west, north, east edge (m).
    pub area_m: [f64; 4],
    /// Texels from west to east.
    pub columns: usize,
    /// Texels from north to south.
    pub lines: usize,
    /// Whether it has colours.
    pub colour: bool,
    /// BLAKE3 of its albedos, f32 each, line by line, hexadecimal.
    pub blake3: String,
}

impl From<&AlbedoMap> for AlbedoMapRecord {
    fn from(map: &AlbedoMap) -> Self {
        let [columns, lines] = map.size();
        let bytes: Vec<u8> = match map.texels() {
            Texels::Grey(grey) => grey.iter().flat_map(|albedo| albedo.to_le_bytes()).collect(),
            Texels::Colour(colour) => {
                colour.iter().flatten().flat_map(|albedo| albedo.to_le_bytes()).collect()
            }
        };
        let colour = matches!(map.texels(), Texels::Colour(_));
        Self { area_m: map.area(), columns, lines, colour, blake3: hash(&bytes) }
    }
}

/// Hash of everything that a terrain database says of the ground.
fn posts_hash(posts: &Posts) -> String {
    let places = posts.places.iter().flatten();
    let numbers = places.chain(posts.heights.iter()).chain(posts.ranges.iter().flatten());
    let mut bytes: Vec<u8> = posts.order.to_le_bytes().into();
    posts.places.iter().for_each(|places| bytes.extend((places.len() as u64).to_le_bytes()));
    bytes.extend(numbers.flat_map(|number| number.to_le_bytes()));
    hash(&bytes)
}

/// A photograph of the ground.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct PhotographRecord {
    /// Columns of the picture.
    pub columns: usize,
    /// Lines of the picture.
    pub lines: usize,
    /// BLAKE3 of its codes, u16 each, line by line, and of everything that its camera file says, hexadecimal.
    pub blake3: String,
}

impl From<&Photograph> for PhotographRecord {
    fn from(photograph: &Photograph) -> Self {
        let picture = photograph.picture();
        let mut bytes: Vec<u8> = picture.codes().iter().flat_map(|code| code.to_le_bytes()).collect();
        let camera = (photograph.placement(), photograph.sun(), photograph.transfer(), picture.depth());
        bytes.extend(format!("{camera:?}").into_bytes());
        Self { columns: picture.columns(), lines: picture.lines(), blake3: hash(&bytes) }
    }
}

/// A level of the ground.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct LevelRecord {
    /// Side of a region (m).
    pub region_size_m: f64,
    /// South-western corner: north, east (m).
    pub origin_m: [f64; 2],
    /// Corners to the north and to the east.
    pub corners: [usize; 2],
}

impl From<&Level> for LevelRecord {
    fn from(level: &Level) -> Self {
        Self { region_size_m: level.region_size(), origin_m: level.origin(), corners: level.corners() }
    }
}

impl GroundRecord {
    /// The record of `landscape`; `ground` says where it came from.
    pub fn new(ground: &GroundSource, landscape: &Landscape) -> Self {
        let bank = landscape.bank();
        let (source, generator) = match ground {
            GroundSource::Bank(_) => ("bank", None),
            GroundSource::Generated(relief) => ("generated", Some(generated(relief))),
        };
        Self {
            source: source.into(),
            title: bank.title().into(),
            content_blake3: bank_file::content_hash(bank).iter().map(|byte| format!("{byte:02x}")).collect(),
            albedo: landscape.albedo(),
            albedo_map: landscape.albedo_map().map(AlbedoMapRecord::from),
            posts_blake3: landscape.posts().map(posts_hash),
            photographs: landscape.photographs().iter().map(PhotographRecord::from).collect(),
            levels: bank.levels().iter().map(LevelRecord::from).collect(),
            generator,
        }
    }

    /// What decides the ground as a document: its words, wherever they came from and whatever they are called.
    pub fn content(&self) -> Value {
        let mut ground = json!(self);
        if let Some(keys) = ground.as_object_mut() {
            for key in ["source", "title", "generator"] {
                keys.remove(key);
            }
        }
        ground
    }
}

/// Parameters of a generated landscape, in the keys of a scenario file.
fn generated(relief: &Relief) -> Value {
    let undulation = relief.undulation.as_ref().map(|part| {
        json!({ "rms_height_m": part.rms_height, "hurst": part.hurst, "longest_m": part.longest,
                "shortest_m": part.shortest, "waves": part.waves })
    });
    let craters = relief.craters.as_ref().map(|part| {
        json!({ "smallest_radius_m": part.smallest_radius, "largest_radius_m": part.largest_radius,
                "density": part.density, "subdued_depth_ratio": part.subdued,
                "fresh_depth_ratio": part.fresh })
    });
    let massifs: Vec<Value> = relief
        .massifs
        .iter()
        .map(|part| {
            json!({ "at_m": part.at, "height_m": part.height, "radius_m": part.radius,
                    "detail_m": part.detail, "ruggedness": part.ruggedness })
        })
        .collect();
    let rilles: Vec<Value> = relief
        .rilles
        .iter()
        .map(|part| {
            let meander =
                part.meander.as_ref().map(|bend| json!({ "swing_m": bend.swing, "length_m": bend.length }));
            json!({ "through_m": part.through, "azimuth_deg": degrees(part.azimuth), "width_m": part.width,
                    "depth_m": part.depth, "meander": meander })
        })
        .collect();
    json!({ "seed": relief.seed, "extent_m": relief.extent, "region_size_m": relief.region_size,
            "tilt_m_per_m": relief.tilt, "undulation": undulation, "craters": craters,
            "massif": massifs, "rille": rilles })
}
