//! `lunoid beam`: the light points of a frame that a beam of its own draws over the raster.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use clap::Args;
use generator::BeamEntry;
use serde_json::{Value, json};
use text::table;

use crate::frame::FrameArgs;
use command_line::output::{Place, expect_outputs, print, print_json};
use command_line::{Failure, Verdict};

const AFTER: &str = "Examples:
  lunoid beam scenarios/stars.toml --frame 0
  lunoid beam scenarios/night-landing.toml --frame 70 --out runs/points.csv
  lunoid beam scenarios/night-landing.toml --frame 70 --out runs/points.json

The points stand in the order of drawing, and after them those that the beam has no time for.
Only generators with a beam have such a list.";

/// List the light points of a frame that a beam draws.
#[derive(Debug, Args)]
#[command(after_help = AFTER)]
pub struct BeamCommand {
    #[command(flatten)]
    chosen: FrameArgs,
    /// File to write: CSV, or JSON if its name ends in .json.
    #[arg(short, long, value_name = "FILE")]
    out: Option<PathBuf>,
    /// Print the list as JSON.
    #[arg(long)]
    json: bool,
}

impl BeamCommand {
    /// Works the frame out and writes or prints its list.
    pub fn run(&self) -> Result<Verdict, Failure> {
        let outputs = Place::given([("--out", &self.out)]);
        let stage = self.chosen.stage()?;
        expect_outputs(&outputs, &stage.sources())?;
        let opened = self.chosen.load(&stage)?;
        self.chosen.expect_in(&opened)?;
        let (frame, name) = (self.chosen.frame, opened.drawn_by());
        let pool = self.chosen.threads.pool()?;
        let found = pool.install(|| -> Result<_, Failure> {
            let stage = opened.stage()?;
            let pose = opened.poses(&stage, frame..frame + 1).map_err(Failure::input)?.rows()[0].pose;
            let session = opened.generator.prepare(stage).map_err(Failure::input)?;
            Ok((pose.time, session.beam_list(frame, &pose).map_err(Failure::input)?))
        })?;
        let (time, Some(points)) = found else {
            return Err(Failure::usage(format!(
                "{}: {name} has no beam for light points; name a generator that has one by --machine",
                opened.scenario_file()
            )));
        };
        let document = || document(name, frame, time, &points);
        if let Some(path) = &self.out {
            let text = if is_json(path) { format!("{:#}\n", document()) } else { csv(&points) };
            files::write_atomic(path, |out| out.write_all(text.as_bytes()))?;
        }
        match (self.json, &self.out) {
            (true, _) => print_json(&document())?,
            (false, Some(path)) => print(&format!("{}: {}\n", path.display(), counted(&points)))?,
            (false, None) => print(&told(&points))?,
        }
        Ok(Verdict::Yes)
    }
}

fn is_json(path: &Path) -> bool {
    path.extension().is_some_and(|end| end.eq_ignore_ascii_case("json"))
}

fn document(generator: &str, frame: u64, time: f64, points: &[BeamEntry]) -> Value {
    json!({ "schema": "lunoid.beam/1", "generator": generator, "frame": frame, "time_s": time, "points": points })
}

const COLUMNS: [&str; 12] = [
    "light",
    "x_px",
    "y_px",
    "red",
    "green",
    "blue",
    "diameter_px",
    "intensity",
    "aperture",
    "attenuation",
    "display_intensity",
    "is_drawn",
];

/// Numbers that read back as the same ones.
fn csv(points: &[BeamEntry]) -> String {
    let mut text = COLUMNS.join(",") + "\n";
    for point in points {
        let ([x, y], [red, green, blue]) = (point.place_px, point.colour);
        let BeamEntry {
            light,
            diameter_px,
            intensity,
            aperture,
            attenuation,
            display_intensity,
            is_drawn,
            ..
        } = point;
        writeln!(
            text,
            "{light},{x},{y},{red},{green},{blue},{diameter_px},{intensity},{aperture},{attenuation},{display_intensity},{is_drawn}"
        )
        .expect("a String takes everything");
    }
    text
}

fn counted(points: &[BeamEntry]) -> String {
    let drawn = points.iter().filter(|point| point.is_drawn).count();
    format!("{drawn} points drawn, {} left out", points.len() - drawn)
}

fn told(points: &[BeamEntry]) -> String {
    let header =
        ["light", "x", "y", "diameter", "intensity", "seen", "displayed", ""].map(String::from).to_vec();
    let row = |point: &BeamEntry| {
        let [x, y] = point.place_px.map(|place| format!("{place:.2}"));
        let seen = point.attenuation / f64::from(point.aperture.max(1));
        vec![
            point.light.to_string(),
            x,
            y,
            format!("{:.2}", point.diameter_px),
            format!("{:.4}", point.intensity),
            format!("{:.1} %", 100.0 * seen),
            format!("{:.4}", point.display_intensity),
            if point.is_drawn { String::new() } else { "left out".into() },
        ]
    };
    let rows: Vec<_> = [header].into_iter().chain(points.iter().map(row)).collect();
    format!("{}{}\n", table(&rows), counted(points))
}
