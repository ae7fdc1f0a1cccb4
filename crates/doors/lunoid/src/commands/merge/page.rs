//! The page of a joined run.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use front_door::Opened;
use rayon::ThreadPool;
use replay::{HeldRun, Job, PAGE_DATA, Phases, Pictures, RunFolder, expect_run_of};
use run_page::{Making, gather};

use command_line::Failure;
use command_line::loading::StageArgs;
use command_line::of_run::stage_of;
use command_line::program::program;
use command_line::words::words;

/// A page is made from the scenario, which may not be here.
fn without_page(failure: Failure) -> Failure {
    let added = |message: String| format!("{message}; or leave the page out with --no-page");
    match failure {
        Failure::Input(message) => Failure::Input(added(message)),
        other => other,
    }
}

/// What a page is made from.
pub struct Page {
    stage: StageArgs,
    opened: Opened,
}

impl Page {
    /// What the page is made from, if a folder has a page.
    pub fn of(folders: &[PathBuf]) -> Result<Option<Self>, Failure> {
        let mut with_page: Vec<(u64, &PathBuf)> = Vec::new();
        for folder in folders.iter().filter(|folder| folder.join(PAGE_DATA).is_file()) {
            // A run that is not finished says so when it is joined.
            let Ok(run) = HeldRun::read(folder) else { continue };
            with_page.push((run.range[0], folder));
        }
        let Some((_, folder)) = with_page.into_iter().min() else { return Ok(None) };
        let stage = stage_of(&StageArgs::of(folder)).map_err(without_page)?;
        let opened = stage.load_any_view().map_err(without_page)?;
        Ok(Some(Self { stage, opened }))
    }

    /// Writes the page of the joined run, with the sweeps that were recorded in its parts.
    pub fn write(
        &self,
        from: &[PathBuf],
        folder: &RunFolder,
        pool: &ThreadPool,
        phases: &mut Phases,
    ) -> Result<(), Failure> {
        let run = HeldRun::read(folder.path())?;
        let [start, end] = run.range;
        let job = Job {
            program: program(),
            inputs: self.opened.inputs.clone(),
            scenario: &self.opened.scenario,
            generator: Arc::clone(&self.opened.generator),
            stage: pool.install(|| self.opened.stage())?,
            frames: start..end,
            shard: None,
            pictures: Pictures::of_record(&run.pictures),
            check: 0,
        };
        expect_run_of(&job, folder)?;
        gather(from.iter().map(PathBuf::as_path).collect::<Vec<&Path>>(), folder)?;
        let words = words(&self.stage);
        Ok(Making { job: &job, words, opened: &self.opened, requests: &[], pool }.write(folder, phases)?)
    }
}
