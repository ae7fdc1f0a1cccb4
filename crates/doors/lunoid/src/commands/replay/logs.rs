//! Robot logs and OpenEXR files of a replay.

use std::path::{Path, PathBuf};

use clap::Args;
use front_door::Opened;
use machine::MachineStage;
use replay::{Control, EXR, Job, RunFolder, TruthItems};
use robot_log::{
    EXR_IN_THIS_BUILD, FinishedRun, Form, LateWords, MCAP_IN_THIS_BUILD, Outcome, TRUTH_OF_LOG,
    expect_own_log, expect_truth_of_log, write_exr, write_mcap,
};

use command_line::Failure;
use command_line::output::Place;

/// What else a finished run becomes.
#[derive(Debug, Args)]
pub struct LogArgs {
    #[arg(long, value_name = "FILE", help = mcap_help())]
    mcap: Option<PathBuf>,
    #[arg(long, help = exr_help())]
    exr: bool,
}

fn mcap_help() -> String {
    format!(
        "A robot log (MCAP) as well, for Foxglove and Rerun: picture, depth, labels, camera, transforms, path, late words. Without \
         --truth the ground truth is label,distance. docs/robot-logs.md has the topics{}",
        built(Form::Mcap, MCAP_IN_THIS_BUILD)
    )
}

fn exr_help() -> String {
    format!(
        "An OpenEXR file for each frame as well, in the folder `exr` of the run: the picture as linear light, and a layer for each \
         array of --truth{}",
        built(Form::Exr, EXR_IN_THIS_BUILD)
    )
}

fn built(form: Form, is_built: bool) -> String {
    let feature = form.feature();
    if is_built {
        String::new()
    } else {
        format!(". Not in this build: `cargo build --release --features {feature}` brings it in")
    }
}

/// How far the forms that were asked for are.
#[derive(Debug, Clone, Copy, Default)]
pub struct Logged {
    /// Frames of the robot log.
    pub mcap: Option<Outcome>,
    /// OpenEXR files of the run.
    pub exr: Option<Outcome>,
}

impl Logged {
    /// What was told to end, with its name.
    pub fn unfinished(&self) -> Option<(&'static str, Outcome)> {
        let made = [("frames of the robot log", self.mcap), ("OpenEXR files", self.exr)];
        made.into_iter().find_map(|(what, made)| Some((what, made.filter(|made| made.done < made.frames)?)))
    }
}

impl LogArgs {
    /// Whether one of the options is given.
    pub fn is_asked(&self) -> bool {
        self.mcap.is_some() || self.exr
    }

    /// Whether each option is given, with its name.
    pub fn given(&self) -> [(bool, &'static str); 2] {
        [(self.mcap.is_some(), Form::Mcap.option()), (self.exr, Form::Exr.option())]
    }

    /// The robot log as a file that the command writes.
    pub fn place(&self) -> Option<Place> {
        self.mcap.as_ref().map(|path| Place::file(Form::Mcap.option(), path))
    }

    /// The truth that is made: what was asked for, or what the robot log needs.
    pub fn truth(&self, asked: Option<&TruthItems>) -> Option<TruthItems> {
        let needed = || self.mcap.is_some().then(|| TruthItems::of(TRUTH_OF_LOG));
        asked.cloned().or_else(needed)
    }

    /// Refuses before any work what cannot be made.
    pub fn expect_possible(&self, asked: Option<&TruthItems>) -> Result<(), Failure> {
        if let Some(file) = &self.mcap {
            Form::Mcap.expect_built()?;
            asked.map_or(Ok(()), expect_truth_of_log)?;
            expect_own_log(file)?;
        }
        if self.exr { Ok(Form::Exr.expect_built()?) } else { Ok(()) }
    }

    /// What was written, for the summary of the run in `folder`.
    pub fn told(&self, logged: &Logged, folder: &Path) -> Vec<(&'static str, PathBuf, u64)> {
        let mcap =
            logged.mcap.zip(self.mcap.clone()).map(|(made, path)| (Form::Mcap.option(), path, made.frames));
        let exr = logged.exr.map(|made| (Form::Exr.option(), folder.join(EXR), made.frames));
        mcap.into_iter().chain(exr).collect()
    }

    /// Writes log and files of the run in `folder`, whose truth is `items`.
    pub fn write(
        &self,
        (job, opened): (&Job, &Opened),
        items: Option<&TruthItems>,
        folder: &RunFolder,
        control: &Control,
    ) -> Result<Logged, Failure> {
        let run = FinishedRun::read(job, folder, items)?;
        let exr = if self.exr { Some(write_exr(&run, control)?) } else { None };
        let mcap = match &self.mcap {
            None => None,
            Some(file) => {
                let late = late_words(job, opened)?;
                Some(write_mcap(&run, late.as_ref(), file, control)?)
            }
        };
        Ok(Logged { mcap, exr })
    }
}

/// The digital side of the hybrid machine, if that draws.
fn late_words(job: &Job, opened: &Opened) -> Result<Option<LateWords>, Failure> {
    if !opened.is_machine() {
        return Ok(None);
    }
    let stage = MachineStage::new(job.stage.clone(), opened.settings.clone());
    Ok(Some(LateWords::new(stage.map_err(Failure::input)?)))
}
