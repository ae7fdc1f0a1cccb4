//! `lunoid photo import`: a picture that lies in a georeferenced raster, as a photograph.

use std::path::PathBuf;

use clap::Args;
use photo_camera::Light;
use photo_make::{IMPORTED_FILES, Imported, import, write_imported};
use quantities::radians;

use crate::elevation::{ElevationArgs, sources};
use command_line::output::{Place, expect_outputs, print};
use command_line::{Failure, Verdict, values};

const AFTER: &str = "Examples:
  lunoid photo import image.tif --out runs/image
  lunoid photo import image.tif --white 400 --sun 341,5 --out runs/image

Reads every raster that `lunoid survey` reads, values of 32 or 64 bits among them. The folder
gets photo.png, 16 bits, and camera.json, its map file. Lines and columns without a value at the
edges are left out. docs/photo.md describes the files.";

/// Make a photograph with its map file out of a georeferenced raster of light.
#[derive(Debug, Args)]
#[command(after_help = AFTER)]
pub struct Import {
    /// Raster to read; its values are light.
    raster: PathBuf,
    /// Folder that gets the two files of the photograph.
    #[arg(short, long, value_name = "FOLDER")]
    out: PathBuf,
    /// Value that is shown white; the largest if left out.
    #[arg(long, value_name = "VALUE", value_parser = values::positive)]
    white: Option<f64>,
    /// Azimuth, from true north, and elevation of the photograph's sun (degrees).
    #[arg(long, value_name = "AZIMUTH,ELEVATION", value_parser = values::sun)]
    sun: Option<[f64; 2]>,
    /// Light that white stands for: albedo times the cosine of the sun's angle from the ground's normal.
    #[arg(long, value_name = "LIGHT", value_parser = values::positive, default_value = "1")]
    light: f64,
    #[command(flatten)]
    reading: ElevationArgs,
}

impl Import {
    /// Reads the raster and writes the photograph.
    pub fn run(&self) -> Result<Verdict, Failure> {
        let is_ours = |name: &str| IMPORTED_FILES.contains(&name);
        expect_outputs(&[Place::folder("--out", &self.out, is_ours)], &sources(&self.raster))?;
        let raster = survey::read(&self.raster, &self.reading.options())?;
        let light = Light::new(self.sun.map(|sun| sun.map(radians)), Some([self.light, 1.0]))
            .map_err(|(_, error)| Failure::usage(error.to_string()))?;
        let imported = import(&raster, self.white, &light)
            .map_err(|error| Failure::input(format!("{}: {error}", self.raster.display())))?;
        write_imported(&self.out, &imported)?;
        print(&self.told(&imported))?;
        Ok(Verdict::Yes)
    }

    fn told(&self, imported: &Imported) -> String {
        let Imported { picture, white, cut, left_out: [above, below, left, right], .. } = imported;
        format!(
            "{}: {} files\n{} x {} pixels, white is {white}; {cut} values lie beyond white or black\n\
             left out at the edges: {above} first and {below} last lines, {left} first and {right} last columns\n",
            self.out.display(),
            IMPORTED_FILES.len(),
            picture.columns(),
            picture.lines(),
        )
    }
}
