//! `lunoid terrain export`: files for every generator.

use std::path::PathBuf;

use clap::Args;
use terrain_builder::LandscapeFile;
use terrain_export::{Exported, FILES, Wishes, expect_folder, write_folder};
use text::shortened;

use crate::terrain::{Landscape, built, expect_apart, opened, textures};
use command_line::loading::Threads;
use command_line::output::{Place, print, print_json, tell, warn};
use command_line::{Failure, values};

const AFTER: &str = "Example:
  lunoid terrain export runs/ground.toml --out runs/ground

Writes terrain.lod (terrain database), ground.bank and residuals.npy (fit of the ground without
the listed craters), craters.csv, boulders/ (shape files), light.npy (with [light]), albedo.png
(with textures), scenario.toml, and export.json with the error of every crater and region. An
earlier export in the folder is replaced whole.";

#[derive(Debug, Args)]
#[command(after_help = AFTER)]
pub struct Export {
    #[command(flatten)]
    landscape: Landscape,
    /// Folder to write the files into.
    #[arg(short, long, value_name = "FOLDER")]
    out: PathBuf,
    /// Step of the heights in the database. Every bit is kept if left out.
    #[arg(long, value_name = "METRES", value_parser = values::positive)]
    step_m: Option<f64>,
    /// Side of a region of the bank; four posts if left out.
    #[arg(long, value_name = "METRES", value_parser = values::metres)]
    region_size_m: Option<f64>,
    /// Do not show any progress.
    #[arg(long)]
    no_progress: bool,
    #[command(flatten)]
    threads: Threads,
    /// Print the errors of the conversions as JSON.
    #[arg(long)]
    json: bool,
}

/// Whether a name in the folder is of an export.
fn is_ours(name: &str) -> bool {
    FILES.contains(&name.split('/').next().unwrap_or_default())
}

impl Export {
    /// Builds the landscape and writes the folder.
    pub fn run(&self) -> Result<(), Failure> {
        let file = &self.landscape.file;
        self.threads.pool()?.install(|| {
            let text = LandscapeFile::new(file).text()?;
            let (description, base) = opened(file)?;
            expect_apart(&[Place::folder("--out", &self.out, is_ours)], file, &description)?;
            expect_folder(&self.out)?;
            let ground = built(file, description, base)?;
            let wishes = Wishes { step: self.step_m, region_size: self.region_size_m };
            let mut progress = |step: &str| {
                if !self.no_progress {
                    tell(&format!("export: {step}\n"));
                }
            };
            let textures = textures(file, ground.description())?;
            let exported = Exported::new(&ground, &textures, &text, wishes, &mut progress)?;
            write_folder(&exported, &self.out)?;
            ground.warnings().iter().for_each(|warning| warn(&warning.to_string()));
            if self.json { print_json(&exported.told) } else { print(&self.words(&exported)) }
        })
    }

    fn words(&self, exported: &Exported) -> String {
        let Exported { database, survey, craters, .. } = exported;
        let [columns, rows] = database.counts();
        let finest = &survey.report.levels[0];
        let kept = craters.kept.iter().map(|(id, reason)| format!("  {id} stays in the bank: {reason}\n"));
        format!(
            "{}: {columns} x {rows} tiles of order {}\nbank: regions of {} m, residual {} m rms, {} m at most\n\
             craters: {} listed, {} m from the landscape at most\n{}boulders: {}\n",
            self.out.display(),
            database.contents().order,
            finest.region_size,
            shortened(finest.rms, 4),
            shortened(finest.worst.residual.abs(), 4),
            craters.craters.len(),
            shortened(craters.largest_difference(), 4),
            kept.collect::<String>(),
            database.contents().boulders.len()
        )
    }
}
