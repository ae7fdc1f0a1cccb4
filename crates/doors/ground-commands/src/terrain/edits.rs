//! `lunoid terrain new`, `import`, `remove` and `undo`.

use std::path::{Component, Path, PathBuf};

use clap::Args;
use serde_json::json;
use terrain_builder::{Base, Description, LandscapeFile};

use crate::terrain::Landscape;
use command_line::output::{print, print_json, warn};
use command_line::{Failure, values};

/// Radius of the Moon (m).
const MOON: &str = "1737400";

#[derive(Debug, Args)]
#[command(
    after_help = "Example:\n  lunoid terrain new runs/ground.toml --longitude-deg 3.0,3.1 --latitude-deg 26.0,26.1 \
    --resolution-m 50"
)]
pub struct New {
    #[command(flatten)]
    landscape: Landscape,
    /// Western and eastern edge of the area (degrees).
    #[arg(long, value_name = "W,E", value_parser = values::pair)]
    longitude_deg: [f64; 2],
    /// Southern and northern edge of the area (degrees).
    #[arg(long, value_name = "S,N", value_parser = values::pair)]
    latitude_deg: [f64; 2],
    /// Distance between posts in metres.
    #[arg(long, value_name = "METRES", value_parser = values::metres)]
    resolution_m: f64,
    /// Tiles have 2^N cells a side.
    #[arg(long, value_name = "N", default_value_t = 5, value_parser = values::whole(1..=12_u32))]
    order: u32,
    /// Radius of the body.
    #[arg(long, value_name = "METRES", default_value = MOON, value_parser = values::finite)]
    radius_m: f64,
    /// Name of the landscape, for people.
    #[arg(long, default_value = "Untitled")]
    title: String,
    /// Print what was done as JSON.
    #[arg(long)]
    json: bool,
}

#[derive(Debug, Args)]
#[command(after_help = "Example:\n  lunoid terrain import runs/ground.toml heights.tif")]
pub struct Import {
    #[command(flatten)]
    landscape: Landscape,
    /// Elevation file in any format that `lunoid survey` reads.
    elevation: PathBuf,
    /// Band with the heights, from 1.
    #[arg(long, value_parser = values::at_least(1_usize))]
    band: Option<usize>,
    /// Print what was done as JSON.
    #[arg(long)]
    json: bool,
}

#[derive(Debug, Args)]
#[command(after_help = "Example:\n  lunoid terrain remove runs/ground.toml west")]
pub struct Remove {
    #[command(flatten)]
    landscape: Landscape,
    /// Name of the feature.
    id: String,
    /// Print what was done as JSON.
    #[arg(long)]
    json: bool,
}

#[derive(Debug, Args)]
#[command(after_help = "Example:\n  lunoid terrain undo runs/ground.toml")]
pub struct Undo {
    #[command(flatten)]
    landscape: Landscape,
    /// Print what was done as JSON.
    #[arg(long)]
    json: bool,
}

impl New {
    /// Writes a landscape without features.
    pub fn run(&self) -> Result<(), Failure> {
        let title = serde_json::Value::from(self.title.as_str());
        let ([west, east], [south, north]) = (self.longitude_deg, self.latitude_deg);
        let text = format!(
            "format = 1\ntitle = {title}\n\n[area]\nradius_m = {:?}\nlongitude_deg = [{west:?}, {east:?}]\n\
             latitude_deg = [{south:?}, {north:?}]\nresolution_m = {:?}\ntile_exponent = {}\n",
            self.radius_m, self.resolution_m, self.order
        );
        LandscapeFile::new(&self.landscape.file).create(&text)?;
        done(&self.landscape.file, "new", "written", self.json)
    }
}

impl Import {
    /// Checks that the file reaches over the landscape, and makes it the base.
    pub fn run(&self) -> Result<(), Failure> {
        let file = &self.landscape.file;
        let path = from_folder(file, &self.elevation)?;
        let landscape = LandscapeFile::new(file);
        let text = terrain_builder::import(&landscape.text()?, &path, self.band)
            .map_err(|error| Failure::input(format!("{}: {error}", file.display())))?;
        let base = Base::open(&described(file, &text)?).map_err(Failure::input)?;
        base.warnings().iter().for_each(|warning| warn(&warning.to_string()));
        landscape.import(&path, self.band)?;
        done(file, "import", &format!("base {path}"), self.json)
    }
}

impl Remove {
    /// Removes the feature, which undo brings back.
    pub fn run(&self) -> Result<(), Failure> {
        LandscapeFile::new(&self.landscape.file).remove(&self.id)?;
        done(&self.landscape.file, "remove", &format!("removed {}", self.id), self.json)
    }
}

impl Undo {
    /// Undoes the last edit and tells which one it was.
    pub fn run(&self) -> Result<(), Failure> {
        let undone = LandscapeFile::new(&self.landscape.file).undo()?;
        done(&self.landscape.file, "undo", &format!("undone: {undone}"), self.json)
    }
}

/// Tells what became of a landscape file.
pub fn done(file: &Path, edit: &str, what: &str, json: bool) -> Result<(), Failure> {
    if json {
        return print_json(&json!({
            "schema": "lunoid.terrain-edit/1",
            "file": file.display().to_string(),
            "edit": edit,
            "done": what,
        }));
    }
    print(&format!("{}: {what}\n", file.display()))
}

/// What the landscape file says once it has this text.
pub fn described(file: &Path, text: &str) -> Result<Description, Failure> {
    let folder = file.parent().unwrap_or(Path::new(""));
    Ok(Description::parse(&file.display().to_string(), text, folder)?)
}

/// Path of a file from the folder of the landscape, so that both can move together.
pub fn from_folder(landscape: &Path, file: &Path) -> Result<String, Failure> {
    let whole = |path: &Path| {
        let found = path.canonicalize();
        found.map_err(|error| {
            Failure::input(format!("{}: cannot read: {error}; check the spelling", path.display()))
        })
    };
    let folder = match landscape.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => whole(folder)?,
        _ => whole(Path::new("."))?,
    };
    let file = whole(file)?;
    let common = folder.components().zip(file.components()).take_while(|(a, b)| a == b).count();
    let up = folder.components().skip(common).map(|_| Component::ParentDir);
    let path: PathBuf = up.chain(file.components().skip(common)).collect();
    let text = path.to_str().map(str::to_owned);
    text.ok_or_else(|| {
        Failure::input(format!("{}: expected a path in UTF-8; rename the file", path.display()))
    })
}
