//! The home of a served session: one scenario, and a folder for what was driven.

use std::path::{Path, PathBuf};

use clap::Args;
use diagnostics::{Problem, Problems};
use drive::{Drive, DriveError, Loop, Program, SavedFile, Wishes};
use front_door::Opened;
use hardware_model::{BUILT_IN, FAULTS};
use loop_protocol::{Home, Opening};
use registry::ROWS;

use command_line::Failure;
use command_line::loading::{QualityArgs, StageArgs, Threads};
use command_line::program::program;

/// What is served, and where records of it go.
#[derive(Debug, Args)]
pub struct ServedArgs {
    #[command(flatten)]
    stage: StageArgs,
    #[command(flatten)]
    quality: QualityArgs,
    #[command(flatten)]
    threads: Threads,
    /// Folder into which the request `record` writes what was driven; the client gets the files if left out.
    #[arg(long, value_name = "FOLDER")]
    record: Option<PathBuf>,
    /// Hardware model or overlay of your own that clients may name too; without it they name what ships, and what --machine, --overlay and the
    /// scenario name. May be given several times.
    #[arg(long, value_name = "FILE")]
    offer: Vec<String>,
}

impl ServedArgs {
    /// The home of these arguments, and its scenario. What is wrong is told before any ground is made.
    pub fn home(&self) -> Result<(Served, Opened), Failure> {
        let stage = self.stage.clone().drawn_by(self.quality);
        let opened = stage.load()?;
        let mut served = Served::of(&stage, &opened, self.threads.count()?);
        served.offered.extend(self.offer.iter().cloned());
        served.record = self.record.clone();
        Ok((served, opened))
    }
}

/// The scenario of the command line, with its wishes.
#[derive(Debug, Clone)]
pub struct Served {
    scenario: PathBuf,
    wishes: Wishes,
    /// What the command line and the scenario name as machines and overlays.
    offered: Vec<String>,
    /// Number of threads that draw; as many as there are processors if 0.
    threads: usize,
    /// Folder of what was driven.
    record: Option<PathBuf>,
}

impl Served {
    /// `stage`, which is read as `opened`. Clients name what ships, and what the command line and the scenario name. Nothing is kept.
    pub fn of(stage: &StageArgs, opened: &Opened, threads: usize) -> Self {
        let wishes = stage.wishes();
        let overlays = wishes.overlays.iter().map(|overlay| overlay.display().to_string());
        let named = wishes.machine.iter().cloned().chain([opened.scenario.machine.clone()]).chain(overlays);
        Self { offered: named.collect(), scenario: stage.scenario.clone(), wishes, threads, record: None }
    }

    /// The word that a request `open` has for the scenario.
    pub fn scenario(&self) -> String {
        self.scenario.display().to_string()
    }

    /// The scenario with the wishes of the command line.
    ///
    /// # Errors
    /// Every fault of the files and the wishes.
    pub fn drive(&self) -> Result<Drive, DriveError> {
        self.open_over(&self.wishes)
    }

    /// Refuses machines and overlays of a client that neither ship nor are offered: they may be any file of this computer.
    fn expect_offered(&self, asked: &Opening) -> Result<(), DriveError> {
        let problems = Problems::new();
        let machines = asked.machine.iter().map(|name| ("machine", name, machines_shipped()));
        let overlays = asked.overlays.iter().map(|name| ("overlays", name, faults_shipped()));
        for (key, name, shipped) in machines.chain(overlays) {
            if self.offered.contains(name) || shipped.contains(&name.as_str()) {
                continue;
            }
            let problem = Problem::of_file("request", format!("`{key}` names what is not offered here"));
            let problem = problem.key(key).found(format!("`{name}`"));
            let problem = problem.expected(format!("one of {}", shipped.join(", ")));
            problems.push(problem.help("start the command with `--offer FILE` for a file of your own"));
        }
        Ok(problems.into_result()?)
    }

    fn open_over(&self, wishes: &Wishes) -> Result<Drive, DriveError> {
        Drive::open(&self.scenario, wishes, self.threads)
    }
}

/// Names of all hardware models and generators that ship.
fn machines_shipped() -> Vec<&'static str> {
    BUILT_IN.iter().map(|(name, _)| *name).chain(registry::names()).collect()
}

/// Names of all overlays of one fault that ship.
fn faults_shipped() -> Vec<&'static str> {
    let of_generators = ROWS.iter().filter_map(|row| row.gear).flat_map(|gear| gear.faults);
    FAULTS.iter().chain(of_generators).map(|(name, _)| *name).collect()
}

impl Home for Served {
    fn program(&self) -> Program {
        program()
    }

    fn open(&mut self, asked: &Opening) -> Result<Drive, DriveError> {
        let own = self.scenario();
        if let Some(other) = asked.scenario.as_ref().filter(|other| **other != own) {
            let problem = Problem::of_file("request", "another scenario is not opened here").key("scenario");
            let problem = problem.found(format!("`{other}`")).expected(format!("`{own}`, or no scenario"));
            return Err(problem.help("start the command on that scenario").into());
        }
        self.expect_offered(asked)?;
        self.open_over(&asked.over(&self.wishes))
    }

    fn keep(
        &mut self,
        driven: &Loop,
        name: Option<&str>,
        more: &[SavedFile],
    ) -> Result<Option<String>, DriveError> {
        let Some(folder) = &self.record else { return Ok(None) };
        let folder = name.map_or_else(|| free(folder), |name| folder.join(name));
        driven.save_with(&folder, more)?;
        Ok(Some(folder.display().to_string()))
    }
}

/// The first of `drive`, `drive-2`, `drive-3`, ... below `folder` that nothing has as its name.
fn free(folder: &Path) -> PathBuf {
    let named = |number: u32| match number {
        1 => folder.join("drive"),
        number => folder.join(format!("drive-{number}")),
    };
    let is_free = |place: &PathBuf| place.symlink_metadata().is_err();
    (1..u32::MAX).map(named).find(is_free).unwrap_or_else(|| named(u32::MAX))
}
