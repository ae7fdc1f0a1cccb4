//! `lunoid terrain add`: features from a file or from options.

use std::path::PathBuf;

use clap::{Args, ValueEnum};
use files::read_all;
use limits::Limit;
use terrain_builder::LandscapeFile;

use crate::terrain::edits::{described, done, from_folder};
use crate::terrain::{Landscape, textures};
use command_line::{Failure, values};

const AFTER: &str = "Examples:
  lunoid terrain add runs/ground.toml --id west --crater 3.03,26.05,400 --wall-percent 4 \\
    --depth-percent 20
  lunoid terrain add runs/ground.toml --id stone --boulder 3.05,26.05,4 --shape rock
  lunoid terrain add runs/ground.toml --id soil --texture soil.png
  lunoid terrain add runs/ground.toml --block field.toml

A block is a file with one or more [[feature]] tables: craters, growth from control points,
boulders, distributions, roughness, textures (docs/terrain.md).";

#[derive(Debug, Args)]
#[command(after_help = AFTER)]
pub struct Add {
    #[command(flatten)]
    landscape: Landscape,
    /// File with `[[feature]]` tables.
    #[arg(long, value_name = "TOML", required_unless_present_any = ["crater", "boulder", "texture"])]
    block: Option<PathBuf>,
    /// Name of the feature: letters, digits and hyphens.
    #[arg(long, conflicts_with = "block")]
    id: Option<String>,
    /// Centre of a crater (degrees), and the radius of its wall.
    #[arg(long, value_name = "LON,LAT,RADIUS_M", value_parser = three, conflicts_with_all = ["block", "boulder"],
          requires_all = ["id", "wall_percent", "depth_percent"])]
    crater: Option<[f64; 3]>,
    /// Height of the wall in per cent of the radius.
    #[arg(long, value_name = "PERCENT", requires = "crater", value_parser = values::percent)]
    wall_percent: Option<f64>,
    /// Depth of the middle in per cent of the radius.
    #[arg(long, value_name = "PERCENT", requires = "crater", value_parser = values::percent)]
    depth_percent: Option<f64>,
    /// How the wall falls off outside; exponential if left out.
    #[arg(long, value_enum, requires = "crater")]
    decay: Option<DecayWord>,
    /// Elevation of the impact; 90 is straight down.
    #[arg(long, value_name = "DEGREES", requires = "crater", value_parser = values::finite)]
    impact_elevation_deg: Option<f64>,
    /// Azimuth to which the impactor travels, from north towards east.
    #[arg(long, value_name = "DEGREES", requires = "crater", value_parser = values::finite)]
    impact_direction_deg: Option<f64>,
    /// Place of a boulder (degrees), and its radius.
    #[arg(long, value_name = "LON,LAT,RADIUS_M", value_parser = three, conflicts_with = "block", requires = "id")]
    boulder: Option<[f64; 3]>,
    /// Form of the boulder; rock if left out.
    #[arg(long, value_enum, requires = "boulder")]
    shape: Option<ShapeWord>,
    /// Share of the boulder's height below the ground, 0 to 0.9.
    #[arg(long, value_name = "SHARE", requires = "boulder", value_parser = values::not_negative)]
    burial: Option<f64>,
    /// Seed of the boulder: it turns the boulder and forms a rock.
    #[arg(long, requires = "boulder", value_parser = values::at_least(0_u64))]
    seed: Option<u64>,
    /// Picture whose light is the albedo of the ground: PNG, JPEG or TIFF.
    #[arg(long, value_name = "PICTURE", conflicts_with_all = ["block", "crater", "boulder"], requires = "id")]
    texture: Option<PathBuf>,
    /// Tile that the texture covers, from the south-western one; the whole ground if left out.
    #[arg(long, value_name = "ROW,COLUMN", requires = "texture", value_parser = tile)]
    tile: Option<[usize; 2]>,
    /// Print what was done as JSON.
    #[arg(long)]
    json: bool,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum DecayWord {
    /// Steep at the wall, flat outside.
    Exponential,
    /// One slope from the wall to the end.
    Linear,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum ShapeWord {
    /// A sphere of the radius.
    Sphere,
    /// A cube whose side is the radius.
    Cube,
    /// A convex polyhedron of 14 faces.
    Rock,
}

fn three(text: &str) -> Result<[f64; 3], String> {
    let numbers: Result<Vec<f64>, _> = text.split(',').map(values::finite).collect();
    let numbers = numbers.ok().and_then(|numbers| numbers.try_into().ok());
    numbers.ok_or_else(|| "expected longitude, latitude and radius, as 3.03,26.05,400".into())
}

fn tile(text: &str) -> Result<[usize; 2], String> {
    let numbers: Option<Vec<usize>> = text.split(',').map(|number| number.trim().parse().ok()).collect();
    let numbers = numbers.and_then(|numbers| numbers.try_into().ok());
    numbers.ok_or_else(|| "expected row and column, as 0,3".into())
}

impl Add {
    /// Adds the features; the file must then still be a landscape, and its pictures readable.
    pub fn run(&self) -> Result<(), Failure> {
        if let Some((option, kind)) = self.stray() {
            return Err(Failure::usage(format!(
                "{option}: only with {kind}; leave it out, or add that feature by itself"
            )));
        }
        let file = &self.landscape.file;
        let block = match (&self.block, &self.texture) {
            (Some(block), _) => text_of(block)?,
            (None, Some(picture)) => self.of_texture(&from_folder(file, picture)?),
            (None, None) => self.feature(),
        };
        let landscape = LandscapeFile::new(file);
        let text = terrain_builder::add(&landscape.text()?, &block)
            .map_err(|error| Failure::input(format!("{}: {error}", file.display())))?;
        textures(file, &described(file, &text)?)?;
        landscape.add(&block)?;
        let what = self.id.as_ref().map_or("features".into(), |id| format!("feature {id}"));
        done(&self.landscape.file, "add", &format!("added {what}"), self.json)
    }

    /// The first option that belongs to a feature of another kind, and to which.
    fn stray(&self) -> Option<(&'static str, &'static str)> {
        let of_crater = [
            ("--wall-percent", self.wall_percent.is_some()),
            ("--depth-percent", self.depth_percent.is_some()),
            ("--decay", self.decay.is_some()),
            ("--impact-elevation-deg", self.impact_elevation_deg.is_some()),
            ("--impact-direction-deg", self.impact_direction_deg.is_some()),
        ];
        let of_boulder = [
            ("--shape", self.shape.is_some()),
            ("--burial", self.burial.is_some()),
            ("--seed", self.seed.is_some()),
        ];
        let of_texture = [("--tile", self.tile.is_some())];
        let of = |kind, is_asked: bool, options: &[(&'static str, bool)]| {
            let stray = options.iter().find(|(_, is_given)| *is_given && !is_asked);
            stray.map(|(option, _)| (*option, kind))
        };
        of("--crater", self.crater.is_some(), &of_crater)
            .or_else(|| of("--boulder", self.boulder.is_some(), &of_boulder))
            .or_else(|| of("--texture", self.texture.is_some(), &of_texture))
    }

    /// A texture as a block of text; `picture` is its path from the folder of the landscape.
    fn of_texture(&self, picture: &str) -> String {
        let [id, picture] = [self.id.as_deref().unwrap_or_default(), picture].map(serde_json::Value::from);
        let tile = self.tile.map_or(String::new(), |[row, column]| format!("tile = [{row}, {column}]\n"));
        format!("[[feature]]\nid = {id}\nkind = \"texture\"\nfile = {picture}\n{tile}")
    }

    /// The feature of the options as a block of text.
    fn feature(&self) -> String {
        let id = serde_json::Value::from(self.id.as_deref().unwrap_or_default());
        let (kind, [longitude, latitude, radius], rest) = match (self.crater, self.boulder) {
            (Some(crater), _) => ("crater", crater, self.of_crater()),
            (None, boulder) => ("boulder", boulder.unwrap_or_default(), self.of_boulder()),
        };
        let lines = rest.into_iter().map(|(key, value)| format!("{key} = {value}\n"));
        format!(
            "[[feature]]\nid = {id}\nkind = \"{kind}\"\nlongitude_deg = {longitude:?}\nlatitude_deg = {latitude:?}\n\
             radius_m = {radius:?}\n{}",
            lines.collect::<String>()
        )
    }

    fn of_crater(&self) -> Vec<(&'static str, String)> {
        let number = |key, value: Option<f64>| value.map(|value| (key, format!("{value:?}")));
        let decay = (self.decay == Some(DecayWord::Linear)).then(|| ("decay", "\"linear\"".to_owned()));
        [
            number("wall_percent", self.wall_percent),
            number("depth_percent", self.depth_percent),
            decay,
            number("impact_elevation_deg", self.impact_elevation_deg),
            number("impact_direction_deg", self.impact_direction_deg),
        ]
        .into_iter()
        .flatten()
        .collect()
    }

    fn of_boulder(&self) -> Vec<(&'static str, String)> {
        let shape = match self.shape {
            Some(ShapeWord::Sphere) => "sphere",
            Some(ShapeWord::Cube) => "cube",
            Some(ShapeWord::Rock) | None => "rock",
        };
        let burial = self.burial.map(|burial| ("burial", format!("{burial:?}")));
        let seed = self.seed.map(|seed| ("seed", seed.to_string()));
        [Some(("shape", format!("\"{shape}\""))), burial, seed].into_iter().flatten().collect()
    }
}

fn text_of(file: &PathBuf) -> Result<String, Failure> {
    let text = String::from_utf8(read_all(file, Limit::TextBytes)?);
    text.map_err(|error| {
        let byte = error.utf8_error().valid_up_to();
        Failure::input(format!("{}: byte {byte} is not UTF-8; save the file as UTF-8", file.display()))
    })
}
