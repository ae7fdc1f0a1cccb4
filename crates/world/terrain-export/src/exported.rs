//! All that a landscape becomes, in memory.

use serde_json::Value;
use survey::{Survey, SurveyOptions, survey};
use terrain_builder::{Export, Ground, Heights, LightMap};
use terrain_database::Database;

use crate::bodies::{Object, objects};
use crate::database::database;
use crate::error::ExportError;
use crate::light::light_map;
use crate::{scenario, told};

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
    /// Text of a scenario over these files.
    pub scenario: String,
    /// Errors of all conversions: schema `lunoid.terrain-export/1`.
    pub told: Value,
    pub(crate) objects: Vec<Object>,
}

impl Exported {
    /// Exports a landscape; `text` is that of its file. `progress` hears of every step in a word.
    ///
    /// # Errors
    /// If the posts make no database, no bank can be fitted, or a boulder does not close.
    pub fn new(
        ground: &Ground,
        text: &str,
        wishes: Wishes,
        progress: &mut dyn FnMut(&'static str),
    ) -> Result<Self, ExportError> {
        progress("heights");
        let heights = ground.heights();
        progress("light");
        let light = light_map(ground, &heights);
        progress("database");
        let database = database(ground, &heights, light.as_ref(), wishes.step, text)?;
        progress("craters");
        let craters = ground.exported();
        progress("bank");
        let survey = survey(&craters.elevation, &options(ground, wishes), &mut |_| {})?;
        progress("boulders");
        let [corner, _] = ground.description().grid.extent();
        let objects = objects(ground, corner)?;
        let scenario = scenario::text(ground, &survey.bank, &craters, &objects);
        let quantised = quantised(&heights, &database);
        let told = told::document(ground, &database, quantised, &craters, &survey);
        Ok(Self { database, survey, craters, light, scenario, told, objects })
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
