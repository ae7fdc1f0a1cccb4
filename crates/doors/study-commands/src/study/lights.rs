//! `lunoid study lights`: how the light of a lamp goes with distance, over sampling points, and behind ground.

use std::ops::Range;
use std::sync::Arc;

use clap::Args;
use front_door::Opened;
use generator::{Generator, LampWay, Stage};
use machine::MachineStage;
use scenario::{EffectWishes, LightWish, Pose};
use study::lights::{ClosedForm, LightCurve, closed_form, light_curve, not_modelled};
use study::report::{LightReport, is_of};

use super::outputs::Outputs;
use command_line::loading::{StageArgs, Threads, choose_frames};
use command_line::program::COMMIT;
use command_line::{Failure, Verdict};
use text::Span;

const AFTER: &str = "Examples:
  lunoid study lights scenarios/night-landing.toml --light ridge-beacon --out studies/beacon
  lunoid study lights scenarios/night-landing.toml --light runway-west --frames 0..20 --json
  lunoid study lights scenarios/lamp-row.toml --machine exact --frames 0..5

The light of a lamp in a frame is the picture with it less the picture without, added up over
all pixels. It is held against the closed form of its disc with nothing in front. A generator
that has several ways to draw lamps, as sampled has, draws each of them. --out gets lights.json,
lights.csv with every frame, lights.md and a plot.";

/// The light of a lamp over a mission, in each way of drawing it.
#[derive(Debug, Args)]
#[command(after_help = AFTER)]
pub struct LightStudy {
    #[command(flatten)]
    stage: StageArgs,
    #[command(flatten)]
    threads: Threads,
    /// The light to look at, by its id. May be left out where the scenario has one.
    #[arg(long, value_name = "ID")]
    light: Option<String>,
    /// Frames to look at: A..B, A.., ..B or one number. All if left out.
    #[arg(long, value_name = "A..B")]
    frames: Option<Span>,
    #[command(flatten)]
    outputs: Outputs,
}

/// One way to draw the lamp.
struct Way {
    name: String,
    generator: Arc<dyn Generator>,
    /// As the scenario has it, if that is left open.
    is_calligraphic: Option<bool>,
}

impl LightStudy {
    /// Runs the study and prints its result.
    pub fn run(&self) -> Result<Verdict, Failure> {
        self.outputs.expect_apart(|file| is_of("lights", file), &self.stage.sources())?;
        let opened = self.stage.load()?;
        expect_open(&opened)?;
        let index = self.chosen(&opened.scenario.effects.lights)?;
        let frames = choose_frames(&opened, self.frames)?;
        let report = self.threads.pool()?.install(|| -> Result<LightReport, Failure> {
            let base = opened.machine_stage()?;
            let table = opened.poses(&base.clone().stage(), frames.clone()).map_err(Failure::input)?;
            let poses: Vec<Pose> = table.rows().iter().map(|row| row.pose).collect();
            let alone = with_effects(&opened, &base, |effects| {
                let lights = vec![effects.lights.swap_remove(index)];
                let white_magnitude = effects.white_magnitude;
                *effects = EffectWishes { lights, white_magnitude, ..EffectWishes::default() };
            })?;
            let whole = closed_form(&alone, &poses);
            expect_lit(&whole, &frames)?;
            Ok(LightReport {
                commit: COMMIT.into(),
                title: opened.scenario.title.clone(),
                machine: opened.drawn_by().to_owned(),
                light: opened.scenario.effects.lights[index].id.clone(),
                first: frames.start,
                times: poses.iter().map(|pose| pose.time).collect(),
                whole,
                curves: self.curves(&opened, &base, index, (frames.start, &poses))?,
                not_modelled: not_modelled(&*opened.generator, &alone).map_err(Failure::input)?,
            })
        })?;
        if let Some(folder) = &self.outputs.out {
            report.leave(folder)?;
        }
        self.outputs.print(&report.json(), &report.text())?;
        Ok(Verdict::Yes)
    }

    /// Number of the light that is asked for.
    fn chosen(&self, lights: &[LightWish]) -> Result<usize, Failure> {
        let names = || lights.iter().map(|light| light.id.as_str()).collect::<Vec<_>>().join(", ");
        match (&self.light, lights.len()) {
            (_, 0) => Err(Failure::input(
                "the scenario has no [[light]]; give a scenario that has one: [stars] are none",
            )),
            (None, 1) => Ok(0),
            (None, count) => Err(Failure::usage(format!(
                "the scenario has {count} lights: choose one by --light: {}",
                names()
            ))),
            (Some(id), _) => lights.iter().position(|light| light.id == *id).ok_or_else(|| {
                Failure::usage(format!("--light {id}: no such light; expected one of {}", names()))
            }),
        }
    }

    /// Curves of all ways of the generator.
    fn curves(
        &self,
        opened: &Opened,
        base: &MachineStage,
        index: usize,
        (first, poses): (u64, &[Pose]),
    ) -> Result<Vec<LightCurve>, Failure> {
        let without = with_effects(opened, base, |effects| drop(effects.lights.remove(index)))?;
        let curve = |way: Way| -> Result<LightCurve, Failure> {
            self.outputs.say(&way.name);
            let with = with_effects(opened, base, |effects| {
                let own = &mut effects.lights[index];
                own.calligraphic = way.is_calligraphic.unwrap_or(own.calligraphic);
            })?;
            let stages = [&with, &without];
            light_curve(&way.name, &*way.generator, stages, first, poses).map_err(Failure::input)
        };
        ways(opened)?.into_iter().map(curve).collect()
    }
}

/// No key is set that the ways set.
fn expect_open(opened: &Opened) -> Result<(), Failure> {
    let ways = opened.row.map_or(&[][..], |row| row.lamps);
    let set = |key: &str| opened.wishes().set.iter().any(|(wished, _)| wished == key);
    match ways.iter().flat_map(|way| way.sets).find(|(key, _)| set(key)) {
        Some((key, _)) => {
            Err(Failure::usage(format!("--set {key}: the ways of this study set it; leave the option out")))
        }
        None => Ok(()),
    }
}

/// The lamp shines on the eye in one frame at least.
fn expect_lit(whole: &ClosedForm, frames: &Range<u64>) -> Result<(), Failure> {
    match whole.light.iter().any(|light| *light > 0.0) {
        true => Ok(()),
        false => Err(Failure::input(format!(
            "the light sends the eye nothing in frames {}..{}: it is dark, or its beam points elsewhere; choose other frames or another light",
            frames.start, frames.end
        ))),
    }
}

/// The ways of the generator to draw lamps: its own as the scenario has it, where its row names none.
fn ways(opened: &Opened) -> Result<Vec<Way>, Failure> {
    let named = opened.row.map_or(&[][..], |row| row.lamps);
    if named.is_empty() {
        let (name, generator) = (opened.drawn_by().to_owned(), opened.generator.clone());
        return Ok(vec![Way { name, generator, is_calligraphic: None }]);
    }
    let way = |way: &LampWay| {
        let generator = opened.configure_with(way.sets)?;
        Ok(Way { name: way.name.into(), generator, is_calligraphic: Some(way.is_calligraphic) })
    };
    named.iter().map(way).collect()
}

/// The stage with other effects, on the same ground.
fn with_effects(
    opened: &Opened,
    base: &MachineStage,
    change: impl FnOnce(&mut EffectWishes),
) -> Result<Stage, Failure> {
    let mut other = opened.clone();
    change(&mut other.scenario.effects);
    Ok(other.machine_stage_upon(opened, base)?.stage())
}
