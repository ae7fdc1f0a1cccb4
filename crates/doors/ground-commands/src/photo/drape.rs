//! `lunoid photo drape`: a map of the ground's albedo out of photographs.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use clap::{Args, ValueEnum};
use landscape::{AlbedoMap, Landscape, Texels};
use photo_drape::{Albedo, Choice, Drape, Ground};
use photograph::Photograph;
use picture::{Depth, GreyPicture, write_png};
use quantities::luminance;
use serde_json::{Value, json};

use command_line::loading::{StageArgs, StageOptions, Threads};
use command_line::output::{Place, expect_outputs, print, print_json, tell};
use command_line::{Failure, Verdict, values};

const AFTER: &str = "Examples:
  lunoid photo drape scenarios/first-light.toml --photo runs/photo/photo.png \\
    --camera runs/photo/camera.json --out runs/albedo.png
  lunoid photo drape scenarios/photo-drape.toml --spacing-m 4 --choice blend --out runs/albedo.png

The map is a picture of 16 bits. The command prints the table that lays it over a scenario's
ground: copy the picture into the scenario's folder, and the table into the scenario.
docs/photo.md describes the rules.";

/// Make a map of the ground's albedo out of photographs with their sun.
#[derive(Debug, Args)]
#[command(after_help = AFTER)]
pub struct DrapeArgs {
    /// Scenario whose ground is under the photographs: a file, or the name of one in `scenarios/`.
    #[arg(value_parser = values::scenario)]
    scenario: PathBuf,
    /// Picture of a photograph, in place of the scenario's; may be repeated, each with a --camera.
    #[arg(long, value_name = "FILE", requires = "camera")]
    photo: Vec<PathBuf>,
    /// Camera file or map file of the photograph before it.
    #[arg(long, value_name = "FILE", requires = "photo")]
    camera: Vec<PathBuf>,
    /// Picture of the map to write.
    #[arg(short, long, value_name = "PNG")]
    out: PathBuf,
    /// South, west, north, east edge of the ground that is mapped; all of its finest level if left out.
    #[arg(long, value_name = "S,W,N,E", value_parser = values::edges)]
    area_m: Option<[f64; 4]>,
    /// Distance between texels; the longer side of the area / 1024 if left out.
    #[arg(long, value_name = "METRES", value_parser = values::metres)]
    spacing_m: Option<f64>,
    /// Which photograph rules where several see the ground.
    #[arg(long, value_enum, default_value = "best")]
    choice: ChoiceWord,
    #[command(flatten)]
    threads: Threads,
    /// Say nothing but errors.
    #[arg(short, long)]
    quiet: bool,
    /// Print the record as JSON.
    #[arg(long)]
    json: bool,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum ChoiceWord {
    /// The one with most pixels on a square metre of the ground.
    Best,
    /// All, by their pixels on a square metre.
    Blend,
}

/// Texels along the longer side of the area where no spacing is asked for. Chosen.
const USUAL_TEXELS: f64 = 1024.0;

impl DrapeArgs {
    /// Reads photographs and ground, writes the map, and prints its table.
    pub fn run(&self) -> Result<Verdict, Failure> {
        let options = StageOptions::default();
        let stage_args = StageArgs { options, ..StageArgs::of(&self.scenario) };
        let inputs: Vec<Place> = stage_args.sources().into_iter().chain(self.inputs()).collect();
        expect_outputs(&[Place::file("--out", &self.out).ending_in(&["png"])], &inputs)?;
        let given = self.photographs()?;
        let opened = stage_args.load_any_view()?;
        let pool = self.threads.pool()?;
        let stage = pool.install(|| opened.stage())?;
        let landscape = match given {
            Some(given) => Arc::new((*stage.landscape).clone().with_photographs(given)),
            None => stage.landscape.clone(),
        };
        let (albedo, map) = pool.install(|| self.map(&landscape))?;
        let (picture, white) = picture(&map).map_err(Failure::input)?;
        write_png(&self.out, &picture, &[picture::SOFTWARE])?;
        let record = self.record(&albedo, &map, white);
        if self.json {
            print_json(&record)?;
        } else {
            if !self.quiet {
                tell(&told(&albedo, &map));
            }
            print(&table(&self.out, &map, white))?;
        }
        Ok(Verdict::Yes)
    }

    fn inputs(&self) -> impl Iterator<Item = Place> {
        let photos = self.photo.iter().map(|path| Place::file("--photo", path));
        photos.chain(self.camera.iter().map(|path| Place::file("--camera", path)))
    }

    /// Photographs of the command line; none where the scenario's are taken.
    fn photographs(&self) -> Result<Option<Arc<[Photograph]>>, Failure> {
        let [photos, cameras] = [self.photo.len(), self.camera.len()];
        if photos != cameras {
            let words = format!(
                "{photos} of --photo and {cameras} of --camera: expected one --camera for each --photo"
            );
            return Err(Failure::usage(words));
        }
        let read = |(photo, camera): (&PathBuf, &PathBuf)| Ok(Photograph::read(photo, camera)?);
        let read: Result<Arc<[Photograph]>, Failure> =
            self.photo.iter().zip(&self.camera).map(read).collect();
        Ok(Some(read?).filter(|given| !given.is_empty()))
    }

    fn map(&self, landscape: &Landscape) -> Result<(Albedo, AlbedoMap), Failure> {
        let area = self.area_m.unwrap_or(landscape.level().extent());
        let [south, west, north, east] = area;
        let spacing = self.spacing_m.unwrap_or((north - south).max(east - west) / USUAL_TEXELS);
        let choice = match self.choice {
            ChoiceWord::Best => Choice::Best,
            ChoiceWord::Blend => Choice::Blend,
        };
        let drape = Ground::new(landscape, area, spacing)
            .and_then(|ground| Drape::new(landscape, ground, choice))
            .map_err(Failure::input)?;
        let albedo = drape.albedo().map_err(Failure::input)?;
        let map = albedo.map(drape.ground(), landscape.albedo()).map_err(Failure::input)?;
        Ok((albedo, map))
    }

    fn record(&self, albedo: &Albedo, map: &AlbedoMap, white: f64) -> Value {
        let [columns, lines] = map.size();
        json!({
            "file": self.out.display().to_string(),
            "area_m": map.area(),
            "columns": columns,
            "lines": lines,
            "black": 0.0,
            "white": white,
            "curve": "linear",
            "texels": albedo.values.len(),
            "shadowed": albedo.shadowed,
            "inferred": albedo.inferred,
            "missing": albedo.missing,
        })
    }
}

/// The map as a picture of 16 bits, and the albedo of its white.
fn picture(map: &AlbedoMap) -> Result<(GreyPicture, f64), picture::PictureError> {
    let [columns, lines] = map.size();
    let texels: Vec<f32> = match map.texels() {
        Texels::Grey(grey) => grey.clone(),
        Texels::Colour(colour) => {
            colour.iter().map(|channels| luminance(channels.map(f64::from)) as f32).collect()
        }
    };
    let white = f64::from(texels.iter().copied().fold(0.0, f32::max)).max(1e-6);
    let full = f64::from(Depth::Sixteen.white());
    let codes = texels.iter().map(|albedo| (f64::from(*albedo) / white * full).round() as u16).collect();
    Ok((GreyPicture::new(columns, lines, Depth::Sixteen, codes)?, white))
}

fn told(albedo: &Albedo, map: &AlbedoMap) -> String {
    let [columns, lines] = map.size();
    format!(
        "{columns} x {lines} texels: {} in shadow in the photographs and {} that none sees have the albedo of those around, {} have the landscape's own\n",
        albedo.shadowed, albedo.inferred, albedo.missing
    )
}

/// The table of a scenario file.
fn table(out: &Path, map: &AlbedoMap, white: f64) -> String {
    let file = out.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
    let [south, west, north, east] = map.area();
    format!(
        "[landscape.albedo_map]\nfile = {file:?}\narea_m = [{south}, {west}, {north}, {east}]\nblack = 0\nwhite = {white}\ncurve = \"linear\"\n"
    )
}
