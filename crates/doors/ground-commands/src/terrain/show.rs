//! `lunoid terrain show`: features in numbers, effects of switches, a picture.

use std::path::PathBuf;

use clap::Args;
use picture::write_png;
use quantities::{radians, sin_cos};
use serde_json::{Value, json};
use terrain_builder::{Effect, FeatureTold, Ground, Textures, effects};
use text::{shortened, table};

use crate::terrain::{Landscape, built, expect_apart, opened, textures};
use command_line::loading::Threads;
use command_line::output::{Place, print, print_json};
use command_line::{Failure, values};

#[derive(Debug, Args)]
#[command(after_help = "Example:\n  lunoid terrain show runs/ground.toml --plot runs/ground.png")]
pub struct Show {
    #[command(flatten)]
    landscape: Landscape,
    /// Picture of the ground from above, shaded by its slopes, north at the top.
    #[arg(long, value_name = "PNG")]
    plot: Option<PathBuf>,
    /// Azimuth and elevation of the sun in the picture (degrees).
    #[arg(long, value_name = "AZIMUTH,ELEVATION", requires = "plot", value_parser = values::sun,
          default_value = "315,20")]
    sun: [f64; 2],
    /// The longer side of the picture (pixels).
    #[arg(long, requires = "plot", default_value_t = 800, value_parser = values::whole(16..=8000_usize))]
    pixels: usize,
    /// Build the landscape once more for each `as_reported` switch, and tell what the switch changes.
    #[arg(long)]
    effects: bool,
    #[command(flatten)]
    threads: Threads,
    /// Print the description as JSON.
    #[arg(long)]
    json: bool,
}

impl Show {
    /// Builds the landscape and tells of it.
    pub fn run(&self) -> Result<(), Failure> {
        let file = &self.landscape.file;
        let plot = Place::given([("--plot", &self.plot)]).into_iter().map(|place| place.ending_in(&["png"]));
        let plot: Vec<Place> = plot.collect();
        self.threads.pool()?.install(|| {
            let (description, base) = opened(file)?;
            expect_apart(&plot, file, &description)?;
            let textures = textures(file, &description)?;
            let effects = self.effects.then(|| effects(&description, &base)).transpose();
            let effects = effects.map_err(|error| Failure::input(format!("{}: {error}", file.display())))?;
            let ground = built(file, description, base)?;
            self.draw(&ground, &textures)?;
            let told = ground.told();
            if self.json {
                return print_json(&document(&ground, &told, effects.as_deref()));
            }
            print(&words(&ground, &told, effects.as_deref()))
        })
    }

    fn draw(&self, ground: &Ground, textures: &Textures) -> Result<(), Failure> {
        let Some(path) = &self.plot else { return Ok(()) };
        let [(sin, cos), (up, level)] = self.sun.map(|angle| sin_cos(radians(angle)));
        let shaded = terrain_export::shaded(ground, textures, [level * cos, level * sin, up], self.pixels);
        let picture = shaded.map_err(Failure::output)?;
        Ok(write_png(path, &picture, &[("Title", &ground.description().title)])?)
    }
}

fn words(ground: &Ground, told: &[FeatureTold], effects: Option<&[Effect]>) -> String {
    let description = ground.description();
    let [rows, columns] = description.grid.size();
    let [low, high] = ground.heights().range();
    let resolution = description.grid.north.resolution;
    let mut text = format!(
        "{}: {rows} x {columns} posts, {resolution} m apart; heights {} to {} m\n",
        description.title,
        shortened(low, 3),
        shortened(high, 3)
    );
    text += &table(&features(told));
    if let Some(effects) = effects {
        text += &format!("\n{}", table(&switches(effects)));
    }
    ground.warnings().iter().for_each(|warning| text += &format!("warning: {warning}\n"));
    text
}

fn features(told: &[FeatureTold]) -> Vec<Vec<String>> {
    let heading =
        ["feature", "kind", "north m", "east m", "volume m3", "posts", "adds m", "craters", "boulders"];
    let row = |feature: &FeatureTold| {
        let extent = |axis: usize| {
            feature.area.map_or("-".into(), |[low, high]| format!("{:.0}..{:.0}", low[axis], high[axis]))
        };
        let [low, high] = feature.range.map(|height| shortened(height, 3));
        let kind = if feature.is_enabled { feature.kind.into() } else { format!("{} (off)", feature.kind) };
        vec![
            feature.id.clone(),
            kind,
            extent(0),
            extent(1),
            format!("{:.0}", feature.volume),
            format!("{:.2} %", 100.0 * feature.share),
            format!("{low}..{high}"),
            feature.craters.to_string(),
            feature.boulders.to_string(),
        ]
    };
    [heading.map(str::to_owned).to_vec()].into_iter().chain(told.iter().map(row)).collect()
}

fn switches(effects: &[Effect]) -> Vec<Vec<String>> {
    let heading = ["as_reported switch", "heights m", "boulders m", "moved m"];
    let row = |effect: &Effect| {
        let metres = |length: f64| shortened(length, 3);
        vec![
            effect.switch.word().to_owned(),
            metres(effect.heights),
            metres(effect.boulders),
            metres(effect.moved),
        ]
    };
    [heading.map(str::to_owned).to_vec()].into_iter().chain(effects.iter().map(row)).collect()
}

fn document(ground: &Ground, told: &[FeatureTold], effects: Option<&[Effect]>) -> Value {
    let description = ground.description();
    let feature = |feature: &FeatureTold| {
        json!({
            "id": feature.id,
            "kind": feature.kind,
            "enabled": feature.is_enabled,
            "area_m": feature.area,
            "volume_m3": feature.volume,
            "share_of_posts": feature.share,
            "adds_m": feature.range,
            "mean_roughness_m": feature.mean_roughness,
            "craters": feature.craters,
            "boulders": feature.boulders,
        })
    };
    let effect = |effect: &Effect| {
        json!({
            "switch": effect.switch.word(),
            "heights_m": effect.heights,
            "boulders_m": effect.boulders,
            "moved_m": effect.moved,
        })
    };
    json!({
        "schema": "lunoid.terrain/1",
        "title": description.title,
        "posts": description.grid.size(),
        "resolution_m": description.grid.north.resolution,
        "heights_m": ground.heights().range(),
        "features": told.iter().map(feature).collect::<Vec<_>>(),
        "effects": effects.map(|effects| effects.iter().map(effect).collect::<Vec<_>>()),
        "warnings": ground.warnings().iter().map(ToString::to_string).collect::<Vec<_>>(),
    })
}
