//! A run folder in place of a scenario: what made the run makes its frames again.

use clap::Parser;
use front_door::Opened;
use hardware_model::ShadowCache;
use replay::{HeldRun, SHADOWS};
use report::{BESIDE, Beside};
use run_record::FileRecord;

use crate::Failure;
use crate::loading::{QualityArgs, StageArgs};
use crate::words::words;

/// Words of a command line that choose a stage.
#[derive(Debug, Parser)]
struct Line {
    #[command(flatten)]
    stage: StageArgs,
    #[command(flatten)]
    quality: QualityArgs,
}

/// What `stage` comes to, which [`stage_of`] makes of what is `asked`. Shadow boundaries that a run folder keeps are read; nothing in the
/// folder changes.
///
/// # Errors
/// Every fault of scenario and model.
pub fn load_of(asked: &StageArgs, stage: &StageArgs) -> Result<Opened, Failure> {
    let mut opened = stage.load()?;
    if asked.scenario.is_dir() {
        opened.keep_shadows(ShadowCache::only_read(asked.scenario.join(SHADOWS)));
    }
    Ok(opened)
}

/// The stage that is asked for: of a run folder that with which the run was made.
///
/// # Errors
/// If the folder is no finished run, other options stand beside it, or its scenario is another file now.
pub fn stage_of(asked: &StageArgs) -> Result<StageArgs, Failure> {
    let folder = &asked.scenario;
    if !folder.is_dir() {
        return Ok(asked.clone());
    }
    let shown = folder.display();
    if words(asked).len() > 1 {
        return Err(Failure::usage(format!(
            "{shown}: a run has its own machine and settings; leave the other options out, or give the scenario"
        )));
    }
    let held = HeldRun::read(folder)?;
    if !folder.join(BESIDE).is_file() {
        return Err(Failure::input(format!(
            "{shown}: the run has no {BESIDE}, which says how it was asked for, and which --no-page leaves out; give the scenario and its \
             options"
        )));
    }
    let beside = Beside::read(folder, &held.fingerprint)?;
    let line = Line::try_parse_from(["lunoid".to_owned()].into_iter().chain(beside.stage));
    let line = line.map_err(|_| {
        Failure::input(format!(
            "{shown}/{BESIDE}: found no words that make the run again; give the scenario and its options"
        ))
    })?;
    let stage = line.stage.drawn_by(line.quality);
    let now = FileRecord::of(&stage.scenario).map_err(|error| {
        Failure::input(format!(
            "{shown}: its scenario cannot be read: {error}; run this where the run was made"
        ))
    })?;
    if held.scenario.file.as_ref().is_none_or(|then| then.blake3 != now.blake3) {
        return Err(Failure::input(format!(
            "{}: it is another file than when {shown} was drawn; put the old one back, or draw the run again",
            stage.scenario.display()
        )));
    }
    Ok(stage)
}
