//! Several machines on one scenario, or several channels of one: a run of each in a folder of its own, and one page beside them.

use std::fs;
use std::path::Path;

use files::Kind;
use generator::Stage;
use hardware_model::ShadowCache;
use rayon::ThreadPool;
use replay::{HeldRun, Job, Outcome, Phases, RUN_RECORD, ReplayError, SHADOWS};
use report::{SIDE_BY_SIDE, write_side_by_side};
use serde_json::{Value, json};

use super::summary::{Summary, losses};
use super::{Replay, ended, interrupted};
use command_line::interrupt;
use command_line::loading::{QualityWord, StageArgs, channel_names, choose_frames};
use command_line::output::{print, print_json, tell};
use command_line::{Failure, Verdict};
use front_door::{Decides, Opened, decides, open};

/// Name of the phase in which the command works for other machines than the one whose times are told.
const OTHERS: &str = "others";

/// One machine or one channel of a side-by-side replay.
struct Entry {
    /// Its folder below that of the page.
    name: String,
    stage: StageArgs,
    opened: Opened,
    /// Phases of the command for this machine; what is done for others is one phase.
    phases: Phases,
}

impl Replay {
    /// Draws `machines`, and what they are held against. `phases` are those before.
    pub(super) fn machines(&self, machines: &[String], phases: &Phases) -> Result<Verdict, Failure> {
        self.expect_no_option_of_one("--machine MODEL --out FOLDER/MODEL")?;
        let entries = self.entries(machines, phases)?;
        expect_one_raster(&entries)?;
        let first = &entries[0].opened;
        if self.options.channel.is_none() && !first.scenario.channels.is_empty() {
            return Err(Failure::usage(format!(
                "{}: several machines stand side by side in one view; expected --channel with one of {}",
                first.scenario_file(),
                channel_names(first)
            )));
        }
        self.several(entries, "-side-by-side", Some(registry::judge().name))
    }

    /// Draws all channels of `stage`, which is read as `opened` without any.
    pub(super) fn channels(
        &self,
        stage: &StageArgs,
        opened: &Opened,
        phases: &Phases,
    ) -> Result<Verdict, Failure> {
        self.expect_no_option_of_one("--channel NAME --out FOLDER/NAME")?;
        let entry = |name: &String| {
            let mut phases = phases.clone();
            let mut stage = stage.clone();
            stage.options.channel = Some(name.clone());
            let opened = open(&stage.scenario, &stage.wishes())?;
            phases.mark("read");
            choose_frames(&opened, self.frames)?;
            Ok(Entry { name: name.clone(), stage, opened, phases })
        };
        let names = opened.scenario.channels.iter().map(|channel| &channel.name);
        let entries = names.map(entry).collect::<Result<Vec<_>, Failure>>()?;
        self.several(entries, "-channels", None)
    }

    /// Draws `entries` one after the other below a folder whose name ends in `of`, and holds them against the one called `judge`.
    fn several(&self, mut entries: Vec<Entry>, of: &str, judge: Option<&str>) -> Result<Verdict, Failure> {
        let out = self.out(of);
        entries.iter().try_for_each(|entry| self.expect_apart(&entry.stage, &out.join(&entry.name)))?;
        expect_no_run(&out)?;
        let pool = self.threads.pool()?;
        interrupt::listen();
        for entry in &mut entries {
            let shadows = out.join(&entry.name).join(SHADOWS);
            entry.opened.keep_shadows(ShadowCache::of_run(shadows));
        }
        let stages = stages(&mut entries, &pool)?;
        let jobs = entries.iter().zip(stages).map(|(entry, stage)| self.drawable(entry, stage, &pool));
        let jobs = jobs.collect::<Result<Vec<_>, _>>()?;
        let claim = |entry: &Entry| self.claim(&out.join(&entry.name));
        let folders = entries.iter().map(claim).collect::<Result<Vec<_>, _>>()?;
        let mut summaries = Vec::new();
        for ((Entry { name, stage, opened, phases }, job), folder) in entries.iter().zip(&jobs).zip(&folders)
        {
            let mut phases = phases.clone();
            phases.mark(OTHERS);
            if !self.saying.quiet && !self.saying.no_progress {
                tell(&format!("{name}\n"));
            }
            match self.draw(stage, opened, job, folder, (&pool, &mut phases), None)?.outcome {
                Outcome::Interrupted { done, of } => {
                    return Ok(interrupted(&format!("frames of {name}"), done, of));
                }
                Outcome::Finished { frames, drawn, limits, performance } => {
                    let losses = losses(&HeldRun::read(folder.path())?);
                    let performance = ended(performance, phases, folder)?;
                    let summary = Summary {
                        folder: folder.path(),
                        frames: [frames.start, frames.end],
                        drawn,
                        truth: None,
                        logs: Vec::new(),
                        check: None,
                        losses,
                        open: None,
                        limits: limits.iter().map(ToString::to_string).collect(),
                        performance: performance.document(),
                    };
                    summaries.push((summary.document(), summary.text()));
                }
            }
        }
        let names: Vec<String> = entries.iter().map(|entry| entry.name.clone()).collect();
        let (figures, page) = pool.install(|| write_side_by_side(&out, &names, judge))?;
        let (documents, texts): (Vec<Value>, Vec<String>) = summaries.into_iter().unzip();
        match (self.saying.json, self.saying.quiet) {
            (true, _) => print_json(&json!({
                "schema": "lunoid.replay-several/1",
                "folder": out.display().to_string(),
                "page": page.display().to_string(),
                "runs": documents,
                "side_by_side": figures,
            }))?,
            (_, true) => {}
            _ => print(&format!("{}open {}\n", texts.concat(), page.display()))?,
        }
        Ok(Verdict::Yes)
    }

    /// What `entry` is to draw, if its machine can draw all of it: none begins what another cannot do.
    fn drawable<'a>(&self, entry: &'a Entry, stage: Stage, pool: &ThreadPool) -> Result<Job<'a>, Failure> {
        let Entry { name, stage: asked, opened, .. } = entry;
        let option = if asked.options.channel.as_ref() == Some(name) { "--channel" } else { "--machine" };
        let job = self.job(opened, stage, choose_frames(opened, self.frames)?);
        let refused = |error: ReplayError| match error {
            ReplayError::Prepare(_) | ReplayError::Frame(_) => {
                Failure::input(format!("{}: {option} {name}: {error}", opened.scenario_file()))
            }
            other => other.into(),
        };
        job.expect_drawable(pool).map_err(refused)?;
        Ok(job)
    }

    /// What belongs to one run; `one` are the words that ask for it.
    fn expect_no_option_of_one(&self, one: &str) -> Result<(), Failure> {
        let given = [
            (self.y4m.is_some(), "--y4m"),
            (self.truth.is_some(), "--truth"),
            (!self.probe.is_empty(), "--probe"),
            (self.check > 0, "--check"),
            (self.no_page, "--no-page"),
            (self.sharing.shard.is_some(), "--shard"),
            (self.live.is_asked(), "--live"),
        ];
        match given.iter().chain(&self.logs.given()).find(|(is_given, _)| *is_given) {
            Some((_, option)) => Err(Failure::usage(format!(
                "{option}: this belongs to one run, and several are asked for; draw them first, then ask one of them: \
                 {one} {option} ..."
            ))),
            None => Ok(()),
        }
    }

    /// `machines` and the one that they are held against, read and found right.
    fn entries(&self, machines: &[String], phases: &Phases) -> Result<Vec<Entry>, Failure> {
        let judge = registry::judge().name.to_owned();
        let judge = (!machines.contains(&judge)).then_some(judge);
        // Parts that are set are those of the machines among them.
        let is_for_machines = machines.iter().any(|name| registry::find(name).is_none());
        let mut entries: Vec<Entry> = Vec::new();
        let (asked, mut obstacles) = (self.quality.asked(), Vec::new());
        for machine in machines.iter().cloned().chain(judge) {
            let name = folder_name(&machine)?;
            if entries.iter().any(|entry| entry.name == name) {
                return Err(Failure::usage(format!(
                    "--machine {machine}: two machines would draw into the folder `{name}`; expected each name once"
                )));
            }
            let mut stage = self.stage(Some(machine));
            if is_for_machines && stage.row().is_some() {
                stage.options.set.retain(|(key, _)| !matches!(decides(key), Decides::Model));
            }
            let mut phases = phases.clone();
            if !entries.is_empty() {
                phases.mark(OTHERS);
            }
            let mut opened = stage.load()?;
            match opened.draft_obstacle() {
                Some(obstacle) if asked == Some(QualityWord::Draft) => obstacles.push(obstacle),
                _ if asked.is_some() => {
                    stage.options.quality = asked;
                    opened = stage.load()?;
                }
                _ => {}
            }
            phases.mark("read");
            choose_frames(&opened, self.frames)?;
            entries.push(Entry { name, stage, opened, phases });
        }
        if asked.is_some() && entries.iter().all(|entry| entry.stage.options.quality.is_none()) {
            return Err(Failure::usage(format!(
                "--quality draft (--preview): none of the machines draws one: {}; leave the option out, or add a hardware model with ideal parts",
                obstacles.join("; ")
            )));
        }
        Ok(entries)
    }
}

/// The stages of `entries`, all over the ground of the first.
fn stages(entries: &mut [Entry], pool: &ThreadPool) -> Result<Vec<Stage>, Failure> {
    let mut stages: Vec<Stage> = Vec::with_capacity(entries.len());
    for Entry { opened, phases, .. } in entries {
        phases.mark(OTHERS);
        let stage = match stages.first() {
            Some(first) => opened.machine_stage_beside(first)?.stage(),
            None => pool.install(|| opened.stage())?,
        };
        phases.mark("landscape");
        stages.push(stage);
    }
    Ok(stages)
}

/// A model by its path has the name of its file.
fn folder_name(machine: &str) -> Result<String, Failure> {
    let stem = match registry::find(machine) {
        Some(row) => Some(row.name.into()),
        None => Path::new(machine).file_stem().map(|stem| stem.to_string_lossy().into_owned()),
    };
    stem.ok_or_else(|| {
        Failure::usage(format!("--machine {machine}: expected the name or the file of a model"))
    })
}

/// Pictures that stand side by side have one size and show the same instants.
fn expect_one_raster(entries: &[Entry]) -> Result<(), Failure> {
    let of = |entry: &Entry| {
        let settings = &entry.opened.settings;
        (settings.raster.columns, settings.raster.lines, settings.timebase.update)
    };
    let words = |entry: &Entry| {
        let (columns, lines, update) = of(entry);
        format!("{} draws {columns} x {lines} pixels at {update}", entry.name)
    };
    let other = entries.iter().find(|entry| of(entry) != of(&entries[0]));
    other.map_or(Ok(()), |other| {
        Err(Failure::usage(format!(
            "{}, {}: pictures side by side are of one size and of the same instants; give --sweeps and --set \
             raster.update_hz=RATE, or columns, lines and update_hz in the scenario's [raster]",
            words(&entries[0]),
            words(other)
        )))
    })
}

/// The folder of the page holds the folders of runs, and no run itself.
fn expect_no_run(out: &Path) -> Result<(), Failure> {
    let refused = |found: String| {
        Err(Failure::output(format!(
            "{}: there is `{found}` already, expected a folder of runs side by side or an empty one; name another by --out",
            out.display()
        )))
    };
    match Kind::of(out) {
        Ok(Kind::Folder | Kind::Nothing) | Err(_) => {}
        Ok(kind) => return refused(format!("{} of this name", kind.phrase())),
    }
    if out.join(RUN_RECORD).exists() || (out.join(replay::PAGE).exists() && !out.join(SIDE_BY_SIDE).exists())
    {
        return refused(replay::PAGE.into());
    }
    let journal = fs::read_dir(out)
        .into_iter()
        .flatten()
        .flatten()
        .find(|entry| entry.path().extension().is_some_and(|end| end == "journal"));
    journal.map_or(Ok(()), |entry| refused(entry.file_name().to_string_lossy().into_owned()))
}
