//! `lunoid explain`: from a pixel of a frame to the wires that made it, and from late words to their pixels.

mod late;

use clap::Args;
use deadlines::Rehearsal;
use exact::Columns;
use explain::{Explanation, Inquiry, InquiryError, ReadSweep, facts};
use front_door::Opened;
use machine::Prepare;
use serde_json::json;
use text::table;

use self::late::{LateArgs, option};
use crate::commands::again::command;
use crate::frame::FrameArgs;
use command_line::loading::{QualityArgs, StageArgs, expect_machine};
use command_line::of_run::{load_of, stage_of};
use command_line::output::{print, print_json};
use command_line::values::{pixel, sampling_point};
use command_line::{Failure, Verdict};

const AFTER: &str = "Examples:
  lunoid explain scenarios/first-light.toml --frame 60 --pixel 500,300
  lunoid explain scenarios/nominal-drive.toml --frame 45 --pixel 210,260 --json
  lunoid explain runs/first-light --frame 60 --pixel 500,300
  lunoid explain scenarios/lunsim-landing.toml --machine exact --frame 3 --pixel 100,200
  lunoid explain scenarios/dust-curtain.toml --frame 40 --sample 500,300,2
  lunoid explain scenarios/nominal-drive.toml --machine pra-overloaded --frame 17 \\
    --late 500:12 --level coarse --pictures changed

A run folder stands for the scenario and the options with which it was drawn. Of the hybrid
machine the first lines say why, and the table has every signal at the sample. The last lines
are commands that go on from there: the sweep on a page of the scope, the registers at the
sample, the digital events of the sweep. Another generator has a table alone: what it knows of
the pixel.

--late goes the other way: from words that were late to the pixels that they changed, in the
frame and in every later one that can differ. The machine is drawn as it is, and again with
these words on time and nothing else changed.";

/// Explain a pixel: the sweep and sample that made it, and every block there. Or late words: the pixels that they changed.
#[derive(Debug, Args)]
#[command(after_help = AFTER)]
pub struct Explain {
    #[command(flatten)]
    chosen: FrameArgs,
    /// Pixel: column and line, from 0 at the top left.
    #[arg(long, value_name = "X,Y", value_parser = pixel)]
    pixel: Option<[usize; 2]>,
    /// Sampling point: column and line of its pixel, and its number within it, from 0. Everything that it holds is printed as JSON. Only of
    /// generators that have sampling points.
    #[arg(long, value_name = "X,Y,N", value_parser = sampling_point, conflicts_with_all = ["pixel", "late"])]
    sample: Option<[usize; 3]>,
    #[command(flatten)]
    quality: QualityArgs,
    #[command(flatten)]
    late: LateArgs,
    /// Leave the closed form out, and with it the error. Only of the hybrid machine.
    #[arg(long)]
    no_exact: bool,
    /// Print the explanation as JSON.
    #[arg(long)]
    json: bool,
}

impl Explain {
    /// Explains the chosen pixel and prints the explanation.
    pub fn run(&self) -> Result<Verdict, Failure> {
        let asked = self.chosen.stage.clone().drawn_by(self.quality);
        let stage = stage_of(&asked)?;
        let opened = load_of(&asked, &stage)?;
        self.chosen.expect_in(&opened)?;
        if let Some(sample) = self.sample {
            return self.of_a_sampling_point(&opened, sample);
        }
        match (self.late.late, self.pixel) {
            (Some(place), _) => {
                expect_machine(&opened, "it has no words that come late")?;
                self.late.explain(place, (&self.chosen, [&asked, &stage]), opened, self.json)
            }
            (None, Some(pixel)) if opened.is_machine() => self.of_the_machine(opened, &asked, pixel),
            (None, Some(pixel)) => self.of_a_guest(&opened, pixel),
            (None, None) => {
                Err(Failure::usage("--pixel X,Y, --sample X,Y,N or --late SWEEP:PLACE: expected one of them"))
            }
        }
    }

    /// What a generator beside the hybrid machine says of the pixel.
    fn of_a_guest(&self, opened: &Opened, pixel: [usize; 2]) -> Result<Verdict, Failure> {
        let name = opened.generator.name();
        if self.no_exact {
            return Err(Failure::usage(format!(
                "--no-exact: {name} is not compared with exact here; leave the option out"
            )));
        }
        let frame = self.chosen.frame;
        let pool = self.chosen.threads.pool()?;
        let told = pool.install(|| -> Result<_, Failure> {
            let stage = opened.stage()?;
            let pose = opened.poses(&stage, frame..frame + 1).map_err(Failure::input)?.rows()[0].pose;
            let view = stage.view.clone();
            let session = opened.generator.prepare(stage).map_err(Failure::input)?;
            let told = facts(&*opened.generator, &*session, &view, (frame, &pose), pixel);
            Ok((pose.time, told.map_err(failure)?))
        });
        let (time, told) = told?;
        let [x, y] = pixel;
        if self.json {
            print_json(&json!({
                "schema": "lunoid.facts/1", "generator": name, "frame": frame, "time_s": time, "pixel": [x, y], "facts": told,
            }))?;
        } else {
            let rows: Vec<_> = told.into_iter().map(|fact| vec![fact.what, fact.value]).collect();
            print(&format!("frame {frame} ({time:.3} s), pixel {x},{y}, by {name}\n\n{}", table(&rows)))?;
        }
        Ok(Verdict::Yes)
    }

    /// What one sampling point holds, as a document.
    fn of_a_sampling_point(&self, opened: &Opened, [x, y, number]: [usize; 3]) -> Result<Verdict, Failure> {
        let (frame, name) = (self.chosen.frame, opened.drawn_by());
        let pool = self.chosen.threads.pool()?;
        let found = pool.install(|| -> Result<_, Failure> {
            let stage = opened.stage()?;
            let (columns, lines) = (stage.view.columns, stage.view.lines);
            if x >= columns as usize || y >= lines as usize {
                let pixel = InquiryError::Pixel { x, y, columns, lines };
                return Err(Failure::usage(format!("--sample: {pixel}")));
            }
            let pose = opened.poses(&stage, frame..frame + 1).map_err(Failure::input)?.rows()[0].pose;
            let session = opened.generator.prepare(stage).map_err(Failure::input)?;
            session.sampling_point(frame, &pose, [x, y], number).map_err(Failure::input)
        })?;
        let Some(mut document) = found else {
            return Err(Failure::usage(format!(
                "--sample {x},{y},{number}: {name} has no such sampling point; expected a generator with sampling points, and a number \
                 below their count in a pixel"
            )));
        };
        document["schema"] = "lunoid.sampling-point/1".into();
        document["frame"] = frame.into();
        document["sample"] = json!([x, y, number]);
        print_json(&document)?;
        Ok(Verdict::Yes)
    }

    fn of_the_machine(
        &self,
        opened: Opened,
        stage: &StageArgs,
        pixel: [usize; 2],
    ) -> Result<Verdict, Failure> {
        let frame = self.chosen.frame;
        let rehearsal = Rehearsal::new(opened, self.chosen.threads.pool()?)?;
        let pose = rehearsal.poses(&[frame])?[0].pose;
        let session = rehearsal.stage.clone().prepare();
        let exact = (!self.no_exact).then(|| Columns::new(rehearsal.stage.stage()));
        let inquiry = Inquiry::new(&rehearsal.stage, session.as_ref(), &rehearsal.control, exact.as_ref());
        let told = rehearsal.pool.install(|| inquiry.explain(frame, &pose, pixel));
        let told = told.map_err(failure)?;
        if self.json {
            let mut document = serde_json::to_value(&told).map_err(Failure::input)?;
            document["schema"] = "lunoid.explain/1".into();
            print_json(&document)?;
        } else {
            print(&(told.text() + "\n" + &self.next(&told, stage)))?;
        }
        Ok(Verdict::Yes)
    }

    /// Commands that go on from the pixel: its wires on a page of the scope, its registers and what was loaded into them, and
    /// what late words in force changed elsewhere.
    fn next(&self, told: &Explanation, stage: &StageArgs) -> String {
        let (frame, sweep) = (self.chosen.frame, told.place.sweep);
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
        // The sweep with the greater part of the pixel stands first; the words that came last in it are the likeliest.
        let last = |read: &ReadSweep| {
            let mut late = read.late.iter().rev();
            late.clone()
                .find(|late| late.in_force)
                .or_else(|| late.next())
                .map(|late| option(read.sweep, late))
        };
        let words = told.read.iter().find_map(last).map(|words| ("explain", words));
        let commands = [("probe", page)]
            .into_iter()
            .chain(body)
            .chain(registers)
            .chain([("trace", format!("--sweep {sweep}"))])
            .chain(words);
        commands.map(|(name, rest)| command(name, stage, frame, &rest) + "\n").collect()
    }
}

fn failure(error: InquiryError) -> Failure {
    match error {
        InquiryError::Pixel { .. } => Failure::usage(format!("--pixel: {error}")),
        InquiryError::Frame(error) => Failure::input(error),
    }
}
