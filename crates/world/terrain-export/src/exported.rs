//! All that a landscape becomes, in memory.

use picture::AnyPicture;
use serde_json::Value;
use survey::{Survey, SurveyOptions, survey};
use terrain_builder::{Export, Ground, Heights, LightMap, Textures};
use terrain_database::Database;

use crate::bodies::{Object, objects};
use crate::database::database;
use crate::error::ExportError;
use crate::light::light_map;
use crate::{albedo, scenario, told};

/// Posts a region along each axis unless asked otherwise: 16 samples for nine words.
const POSTS_A_REGION: f64 = 4.0;

/// How a landscape is exported.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Wishes {
    /// Step of the heights in the database (m); none keeps every bit.
    pub step: Option<f64>,
    /// Side of a region of the bank (m); four posts if none.
    pub region_size: Option<f64>,
}

/// A landscape as other programs read it.
#[derive(Debug)]
pub struct Exported {
    /// Tiles, light, boulders and text.
    pub database: Database,
    /// Bank without the listed craters, with its residuals.
    pub survey: Survey,
    /// Craters of the list, and those that stay in the bank.
    pub craters: Export,
    /// Light on every post, where the landscape has a sun.
    pub light: Option<LightMap>,
    /// Albedo of the ground from above, where the landscape has textures.
    pub albedo: Option<AnyPicture>,
    /// Text of a scenario over these files.
    pub scenario: String,
    /// Errors of all conversions: schema `lunoid.terrain-export/1`.
    pub told: Value,
    pub(crate) objects: Vec<Object>,
}

impl Exported {
    /// Exports a landscape under its textures; `text` is that of its file. `progress` hears of every step in a word.
    ///
    /// # Errors
    /// If the posts make no database, no bank can be fitted, or a boulder does not close.
    pub fn new(
        ground: &Ground,
        textures: &Textures,
        text: &str,
        wishes: Wishes,
        progress: &mut dyn FnMut(&'static str),
    ) -> Result<Self, ExportError> {
        progress("heights");
        let heights = ground.heights();
        progress("light");
        let light = light_map(ground, &heights);
        progress("albedo");
        let grid = &ground.description().grid;
        let has_albedo = !textures.is_empty();
        let albedo = has_albedo.then(|| albedo::picture(textures, grid)).transpose()?;
        let on_posts = has_albedo.then(|| albedo::posts(textures, grid));
        progress("database");
        let database = database(ground, &heights, (light.as_ref(), on_posts), wishes.step, text)?;
        progress("craters");
        let craters = ground.exported();
        progress("bank");
        let survey = survey(&craters.elevation, &options(ground, wishes), &mut |_| {})?;
        progress("boulders");
        let [corner, _] = ground.description().grid.extent();
        let objects = objects(ground, corner)?;
        let scenario = scenario::text(ground, &survey.bank, &craters, &objects, has_albedo);
        let quantised = quantised(&heights, &database);
        let told = told::document(ground, &database, quantised, &craters, &survey, albedo.as_ref());
        Ok(Self { database, survey, craters, light, albedo, scenario, told, objects })
    }
}

fn options(ground: &Ground, wishes: Wishes) -> SurveyOptions {
    let resolution = ground.description().grid.north.resolution;
    let mut options = SurveyOptions::new(wishes.region_size.unwrap_or(POSTS_A_REGION * resolution));
    options.held_out = 0.0;
    options
}

/// Largest change of a height by the step of the database (m).
fn quantised(heights: &Heights, database: &Database) -> f64 {
    let stored = &database.contents().heights;
    heights.values().iter().zip(stored).map(|(height, stored)| (height - stored).abs()).fold(0.0, f64::max)
}
