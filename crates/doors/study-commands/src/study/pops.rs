//! `lunoid study pops`: the test of chapter 6 of a thesis on levels of detail.

use clap::Args;
use front_door::Opened;
use generator::DetailWay;
use report::{DescentPage, DescentWay};
use scenario::Pose;
use study::descent::{DescentWays, shot_frames};
use study::pops::{PopCurve, curve, curve_of_pictures};
use study::report::{PopReport, is_of};

use super::outputs::Outputs;
use command_line::loading::{StageArgs, Threads, choose_frames};
use command_line::program::COMMIT;
use command_line::{Failure, Verdict, values};
use text::Span;

const AFTER: &str = "Examples:
  lunoid study pops scenarios/lod-descent.toml
  lunoid study pops scenarios/lod-descent.toml --frames 0..300 --out studies/pops \\
    --set lod.morph_percent=[20]
  lunoid study pops scenarios/lod-landing.toml --at-most 1e-9 --json
  lunoid study pops scenarios/lod-descent.toml --out studies/pops --pictures 24
  lunoid study pops scenarios/lod-descent.toml --machine sampled --frames 0..30

A curve is the distance along the view axis to the ground as it is drawn, frame by frame. A pop
is what it changes by for a camera that stands while the levels of detail go on to the next
frame. Curves are held against the finest ground alone; those of a generator without levels
against exact, and they have no pops. --out gets pops.json, pops.csv with every frame, pops.md
and a plot. With --pictures it gets a page too, index.html: all ways but the first side by side,
curves below. A click on a jump leads to the tiles that made it, a click on the ground to its
place.";

/// Distances frame by frame, and what levels of detail do to them.
#[derive(Debug, Args)]
#[command(after_help = AFTER)]
pub struct PopStudy {
    #[command(flatten)]
    stage: StageArgs,
    #[command(flatten)]
    threads: Threads,
    /// Frames to look at: A..B, A.., ..B or one number. All if left out.
    #[arg(long, value_name = "A..B")]
    frames: Option<Span>,
    /// Exit with status 1 if a pop of the way that the scenario has is above this.
    #[arg(long, value_name = "METRES", value_parser = least)]
    at_most: Option<f64>,
    /// Draw so many pictures of each way but the first, spread evenly, and those at jumps; leaves a page.
    #[arg(long, value_name = "COUNT", requires = "out", value_parser = clap::value_parser!(u16).range(2..=1000))]
    pictures: Option<u16>,
    #[command(flatten)]
    outputs: Outputs,
}

fn least(text: &str) -> Result<f64, String> {
    let found = values::finite(text).ok().filter(|metres| *metres >= 0.0);
    found.ok_or_else(|| "expected metres, 0 or more".into())
}

impl PopStudy {
    /// Runs the study and prints its result.
    pub fn run(&self) -> Result<Verdict, Failure> {
        let leaves = |file: &str| is_of("pops", file) || DescentPage::leaves(file);
        self.outputs.expect_apart(leaves, &self.stage.sources())?;
        let opened = self.stage.load()?;
        if self.pictures.is_some() && opened.row.is_none_or(|row| row.details.is_empty()) {
            let told = "this generator has no ways with levels of detail; leave it out";
            return Err(Failure::usage(format!("--pictures: {told}")));
        }
        let frames = choose_frames(&opened, self.frames)?;
        let pool = self.threads.pool()?;
        let report = pool.install(|| -> Result<PopReport, Failure> {
            let table = opened.poses(&opened.stage()?, frames.clone()).map_err(Failure::input)?;
            let poses: Vec<Pose> = table.rows().iter().map(|row| row.pose).collect();
            Ok(PopReport {
                commit: COMMIT.into(),
                title: opened.scenario.title.clone(),
                machine: opened.drawn_by().to_owned(),
                first: frames.start,
                times: poses.iter().map(|pose| pose.time).collect(),
                curves: self.curves(&opened, frames.start, &poses)?,
            })
        })?;
        if !report.curves.iter().all(PopCurve::meets_ground) {
            let title = format!("frames {}..{}: the view axis meets no ground", frames.start, frames.end);
            return Err(Failure::input(format!("{title}; look down, or choose other --frames")));
        }
        if let Some(folder) = &self.outputs.out {
            report.leave(folder)?;
            if let Some(pictures) = self.pictures {
                let page = pool.install(|| self.page(&opened, &report, pictures.into()))?;
                let path = page.leave(folder)?;
                self.outputs.say(&format!("open {}", path.display()));
            }
        }
        self.outputs.print(&report.json(), &report.text())?;
        let own = self.own(&opened, &report);
        Ok(match (self.at_most, own) {
            (Some(most), Some(pop)) if pop > most => Verdict::No,
            _ => Verdict::Yes,
        })
    }

    /// Curves of all ways of the generator, the truth first.
    fn curves(&self, opened: &Opened, first: u64, poses: &[Pose]) -> Result<Vec<PopCurve>, Failure> {
        let stage = opened.stage()?;
        let ways = ways(opened);
        if ways.is_empty() {
            let judge = registry::configure_with(registry::judge(), &[])?;
            let both = [judge, opened.generator.clone()];
            let curves = both.iter().map(|generator| curve_of_pictures(&**generator, &stage, first, poses));
            return curves.collect::<Result<_, _>>().map_err(Failure::input);
        }
        let mut curves = Vec::new();
        for way in ways {
            self.outputs.say(way.name);
            let session = opened.configure_with(way.sets)?.prepare(stage.clone()).map_err(Failure::input)?;
            curves.extend(curve(way.name, &*session, first, poses).map_err(Failure::input)?);
        }
        Ok(curves)
    }

    /// The page of all ways but the first.
    fn page(&self, opened: &Opened, report: &PopReport, pictures: usize) -> Result<DescentPage, Failure> {
        let stage = opened.stage()?;
        let shown = ways(opened).into_iter().skip(1);
        let generators: Vec<_> =
            shown.map(|way| opened.configure_with(way.sets)).collect::<Result<_, _>>()?;
        let generators: Vec<_> = generators.iter().map(|generator| &**generator).collect();
        let ways = DescentWays::new(&stage, &generators).map_err(Failure::input)?;
        let curves = &report.curves[1..];
        let frames = shot_frames(curves, report.first, pictures);
        let table = opened.poses(&stage, report.frames()).map_err(Failure::input)?;
        let mut shots = Vec::with_capacity(frames.len());
        for frame in frames {
            self.outputs.say(&format!("frame {frame}"));
            let pose = &table.rows()[(frame - report.first) as usize].pose;
            shots.push(ways.shot(frame, pose).map_err(Failure::input)?);
        }
        let way = |curve: &PopCurve| DescentWay {
            name: curve.name.clone(),
            off: curve.off(&report.curves[0]),
            pops: curve.pops.clone(),
        };
        Ok(DescentPage {
            title: report.title.clone(),
            facts: report.facts(),
            raster: [stage.view.columns, stage.view.lines].map(|pixels| pixels as usize),
            first: report.first,
            times: report.times.clone(),
            ways: curves.iter().map(way).collect(),
            shots,
        })
    }

    /// Largest pop (m) of the way that the scenario has.
    fn own(&self, opened: &Opened, report: &PopReport) -> Option<f64> {
        let record = opened.generator.record();
        let own = ways(opened).iter().position(|way| {
            opened.configure_with(way.sets).is_ok_and(|generator| generator.record() == record)
        })?;
        report.figures()[own].largest_pop.map(|pop| pop.metres)
    }
}

/// The ways of the generator that differ in distances.
fn ways(opened: &Opened) -> Vec<&'static DetailWay> {
    let ways = opened.row.map_or(&[][..], |row| row.details);
    ways.iter().filter(|way| !way.is_of_light).collect()
}
