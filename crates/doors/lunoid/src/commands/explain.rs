//! `lunoid explain`: from a pixel of a frame to the wires that made it.

use clap::Args;
use exact::Columns;
use explain::{Explanation, Inquiry, InquiryError};
use machine::Prepare;

use crate::commands::again::command;
use crate::frame::FrameArgs;
use crate::loading::of_models;
use crate::output::{print, print_json};
use crate::values::pixel;
use crate::{Failure, Verdict};

const AFTER: &str = "Examples:
  lunoid explain scenarios/first-light.toml --frame 60 --pixel 500,300
  lunoid explain scenarios/nominal-drive.toml --frame 45 --pixel 210,260 --json

The first lines say why, the table has every wire at the sample, the last lines are commands that go on from there: the sweep
on a page of the scope, the registers at the sample, the digital events of the sweep.";

/// Say which sweep and sample made a pixel, and what every block did there.
#[derive(Debug, Args)]
#[command(after_help = AFTER, mut_args(of_models))]
pub struct Explain {
    #[command(flatten)]
    chosen: FrameArgs,
    /// Pixel: column and line, from 0 at the top left.
    #[arg(long, value_name = "X,Y", value_parser = pixel, allow_hyphen_values = true)]
    pixel: [usize; 2],
    /// Leave the closed form out, and with it the error.
    #[arg(long)]
    no_exact: bool,
    /// Print as JSON.
    #[arg(long)]
    json: bool,
}

impl Explain {
    /// Explains.
    pub fn run(&self) -> Result<Verdict, Failure> {
        let frame = self.chosen.frame;
        let rehearsal = self.chosen.rehearse(|_| Ok(()))?;
        let pose = rehearsal.poses(&[frame])?[0].pose;
        let session = rehearsal.stage.clone().prepare();
        let exact = (!self.no_exact).then(|| Columns::new(rehearsal.stage.stage()));
        let inquiry = Inquiry::new(&rehearsal.stage, session.as_ref(), &rehearsal.control, exact.as_ref());
        let told = rehearsal.pool.install(|| inquiry.explain(frame, &pose, self.pixel));
        let told = told.map_err(|error| match error {
            InquiryError::Pixel { .. } => Failure::usage(format!("--pixel: {error}")),
            InquiryError::Frame(error) => Failure::input(error),
        })?;
        if self.json {
            let mut document = serde_json::to_value(&told).map_err(Failure::input)?;
            document["schema"] = "lunoid.explain/1".into();
            print_json(&document)?;
        } else {
            print(&(told.text() + "\n" + &self.next(&told)))?;
        }
        Ok(Verdict::Yes)
    }

    /// Commands that go on from the pixel: its wires on a page of the scope, its registers and what was loaded into them.
    fn next(&self, told: &Explanation) -> String {
        let (stage, frame, sweep) = (&self.chosen.stage, self.chosen.frame, told.place.sweep);
        let cursor = told.ground.as_ref().map(|ground| format!(" --cursor {:.4}", ground.range_m));
        let page = format!(
            "--sweep {sweep} --signals 'tg.reflectivity,mu.*,sc.gate,dpp.*,sm.video'{} --out sweep.png",
            cursor.unwrap_or_default()
        );
        // Polyhedra join along the line of the display, not along the sweep: a table, not a page.
        let body =
            told.body.map(|_| ("probe", format!("--sweep {sweep} --signals 'pg.*,sm.write' --out body.csv")));
        let registers =
            told.ground.as_ref().map(|ground| ("trace", format!("--at {sweep}:{}", ground.sample)));
        let commands = [("probe", page)]
            .into_iter()
            .chain(body)
            .chain(registers)
            .chain([("trace", format!("--sweep {sweep}"))]);
        commands.map(|(name, rest)| command(name, stage, frame, &rest) + "\n").collect()
    }
}
