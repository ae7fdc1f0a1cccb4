//! `lunoid study`: the three promises as numbers.

mod economy;
mod error;
mod judge;
mod level_ladders;
mod levels;
mod lights;
mod outputs;
mod pops;
mod sea;
mod shadow;
mod stability;
mod tracks;

use clap::{Args, Subcommand};

use command_line::{Failure, Verdict};

const AFTER: &str = "Examples:
  lunoid study error scenarios/first-light.toml --quick
  lunoid study economy scenarios/showpiece.toml --quick
  lunoid study shadow scenarios/vehicle-shadow.toml
  lunoid study pops scenarios/lod-descent.toml
  lunoid study judge scenarios/lod-descent.toml --every 60
  lunoid study levels scenarios/lod-landing.toml
  lunoid study tracks scenarios/lod-descent.toml --only one-level
  lunoid study lights scenarios/night-landing.toml --light ridge-beacon
  lunoid study sea scenarios/sea-waves.toml --every 15
  lunoid study error --help";

/// Measure error against run time, what a scene does not need, what flat ground costs a shadow, what pops, what levels lose, what a generator is off the judge, how a lamp shines, and how a sea looks beside true waves.
#[derive(Debug, Args)]
#[command(after_help = AFTER)]
pub struct StudyCommand {
    #[command(subcommand)]
    study: Study,
    /// Refused, with the reason.
    #[arg(long, value_name = "K/N|auto", global = true, hide = true)]
    shard: Option<String>,
}

#[derive(Debug, Subcommand)]
enum Study {
    /// Error against run time, one factor at a time.
    Error(error::ErrorStudy),
    /// What is left out, what that saves, and what is still wasted.
    Economy(economy::EconomyStudy),
    /// Stiff parts and extreme scenes, each by every method.
    Stability(stability::StabilityStudy),
    /// Distances along the view axis frame by frame, and what levels of detail do to them.
    Pops(pops::PopStudy),
    /// Pictures of a generator against those of exact, frame by frame.
    Judge(judge::JudgeStudy),
    /// Levels of detail against what is lost: triangles, error, time, and what nothing beats.
    Levels(levels::LevelStudy),
    /// Corners that are followed over frames while levels of detail change.
    Tracks(tracks::TrackStudy),
    /// The light of a lamp over a mission, in each way of drawing it.
    Lights(lights::LightStudy),
    /// Contrast and spectrum of a sea of false normals beside a sea of true waves.
    Sea(sea::SeaStudy),
    /// The vehicle's shadow on flat ground against that on true ground.
    Shadow(shadow::ShadowStudy),
}

impl StudyCommand {
    /// Runs the chosen study and prints its result.
    pub fn run(&self) -> Result<Verdict, Failure> {
        if let Some(shard) = &self.shard {
            return Err(self.study.without_shards(shard));
        }
        match &self.study {
            Study::Error(study) => study.run(),
            Study::Economy(study) => study.run(),
            Study::Stability(study) => study.run(),
            Study::Pops(study) => study.run(),
            Study::Judge(study) => study.run(),
            Study::Levels(study) => study.run(),
            Study::Tracks(study) => study.run(),
            Study::Lights(study) => study.run(),
            Study::Sea(study) => study.run(),
            Study::Shadow(study) => study.run(),
        }
    }
}

impl Study {
    /// Why a study is done by one worker, and what several of them may share out.
    fn without_shards(&self, shard: &str) -> Failure {
        let (name, why) = match self {
            Self::Error(_) => (
                "error",
                "it holds times against one another, and times of two workers cannot be; give each worker a scenario, or \
                 ladders by --only",
            ),
            Self::Economy(_) => (
                "economy",
                "it holds times against one another, and times of two workers cannot be; give each worker a scenario",
            ),
            Self::Stability(_) => {
                ("stability", "its table has the time of each method; give each worker rows by --only")
            }
            Self::Pops(_) => (
                "pops",
                "a pop lies between two frames, and a cut would lose one; give each worker --frames, each with the first frame of the next",
            ),
            Self::Judge(_) => ("judge", "it has one table of all frames; give each worker --frames"),
            Self::Levels(_) => (
                "levels",
                "it holds times against one another, and times of two workers cannot be; give each worker a scenario",
            ),
            Self::Tracks(_) => {
                ("tracks", "a track goes through all frames; give each worker a ladder by --only")
            }
            Self::Lights(_) => {
                ("lights", "it has one table of all frames; give each worker a light by --light")
            }
            Self::Sea(_) => ("sea", "a spectrum goes through all frames; give each worker a scenario"),
            Self::Shadow(_) => (
                "shadow",
                "its largest error is over all places, and --laws has times; give each worker a sun by --sun",
            ),
        };
        Failure::usage(format!("study {name} --shard {shard}: this study has no shards: {why}"))
    }
}
