//! `lunoid photo brief`: the film of a run with the map beside each frame.

use std::io;
use std::path::PathBuf;

use briefing::Briefing;
use clap::Args;
use picture::{AnyPicture, Limits, read_any_png};
use replay::{HeldRun, write_apng};
use serde_json::json;

use command_line::loading::{StageArgs, Threads};
use command_line::of_run::{load_of, stage_of};
use command_line::output::{Place, expect_outputs, print, print_json};
use command_line::{Failure, Verdict};

const AFTER: &str = "Examples:
  lunoid replay scenarios/photo-flight.toml --out runs/photo-flight
  lunoid photo brief runs/photo-flight --out runs/briefing.png

The run is one with a page, which has the words that make it again. The film is an animated PNG,
which every browser plays. Its map has north up: the photographs of the scenario over its
ground, or, without photographs, the ground under its sun. The line is the course, bright where
it is flown; the rays are the edges of the view.";

/// Put the map beside each frame of a run: the course, the eye's place and the angle of view.
#[derive(Debug, Args)]
#[command(after_help = AFTER)]
pub struct Brief {
    /// Folder of a finished run of `lunoid replay`.
    #[arg(value_name = "FOLDER")]
    run: PathBuf,
    /// Animated PNG to write.
    #[arg(short, long, value_name = "PNG")]
    out: PathBuf,
    #[command(flatten)]
    threads: Threads,
    /// Print what was written as JSON.
    #[arg(long)]
    json: bool,
}

impl Brief {
    /// Reads the run, draws the map, and writes the film.
    pub fn run(&self) -> Result<Verdict, Failure> {
        let held = HeldRun::read(&self.run)?;
        let asked = StageArgs::of(&self.run);
        let stage_args = stage_of(&asked)?;
        let files: Vec<(PathBuf, u64)> = held
            .frames
            .iter()
            .flat_map(|frame| frame.files.iter().map(|file| (self.run.join(&file.file), frame.frame)))
            .collect();
        let frames = files.iter().map(|(path, _)| Place::file("a frame of the run", path));
        let inputs: Vec<Place> = stage_args.sources().into_iter().chain(frames).collect();
        expect_outputs(&[Place::file("--out", &self.out).ending_in(&["png"])], &inputs)?;
        let opened = load_of(&asked, &stage_args)?;
        let pool = self.threads.pool()?;
        let (briefing, view) = pool.install(|| -> Result<_, Failure> {
            let stage = opened.stage()?;
            let table = opened.poses(&stage, 0..opened.frames()).map_err(Failure::input)?;
            let course = table.rows().iter().map(|row| row.pose).collect();
            Ok((Briefing::new(&stage, course)?, stage.view))
        })?;
        let rate = if files.len() > held.frames.len() { view.refresh } else { view.update };
        let page = |(path, frame): &(PathBuf, u64)| -> io::Result<AnyPicture> {
            let picture = read_any_png(path, &Limits::default()).map_err(io::Error::other)?;
            Ok(briefing.page(&picture, *frame as usize).map_err(io::Error::other)?.into())
        };
        files::write_atomic(&self.out, |out| write_apng(out, files.len(), rate, files.iter().map(page)))?;
        let out = self.out.display().to_string();
        match self.json {
            true => print_json(&json!({
                "schema": "lunoid.briefing/1",
                "film": out,
                "pictures": files.len(),
                "metres_a_pixel": briefing.place().scale(),
            }))?,
            false => print(&format!(
                "{out}: {} pictures, map of {:.2} m a pixel\n",
                files.len(),
                briefing.place().scale()
            ))?,
        }
        Ok(Verdict::Yes)
    }
}
