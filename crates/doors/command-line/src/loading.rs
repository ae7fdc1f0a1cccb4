//! From a command line to the front door: scenario, machine, wishes, threads.

use std::env;
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::thread;

use clap::{Arg, Args, ValueEnum};
use front_door::{Opened, Wishes, open};
use generator::Row;
use hardware_model::Economy;
use machine::MachineStage;
use rayon::{ThreadPool, ThreadPoolBuilder};
use registry::ROWS;
use scenario::Scalar;
use text::Span;

use crate::output::{Place, tell, warn};
use crate::{Failure, values};

/// Help of `--machine` where any generator may draw.
pub fn machine_help() -> String {
    let rows = ROWS.iter().map(|row| format!("`{}` for {}", row.name, row.about));
    let rows = rows.collect::<Vec<_>>().join(", ");
    format!("Hardware model by name or path, or {rows}. The scenario's own if left out")
}

/// Help text of the option `--set`.
fn set_help() -> String {
    let tables = ROWS.iter().flat_map(|row| row.tables()).map(|table| format!("`{table}`"));
    let tables = tables.collect::<Vec<_>>().join(", ");
    format!(
        "Set one key of the hardware model, of the tables {tables} of a generator, or of the scenario (`scenario.KEY`), over \
         the wishes of the scenario; may be given several times"
    )
}

/// The help of commands that take a hardware model alone.
pub fn of_models(argument: Arg) -> Arg {
    match argument.get_id().as_str() {
        "machine" => argument.help("Hardware model by name or path. The scenario's own if left out"),
        "set" => argument.help(
            "Set one key of the hardware model over what the scenario wishes; may be given several times",
        ),
        _ => argument,
    }
}

/// The help of commands that take a hardware model, or a generator whose frames take time.
pub fn of_timed(argument: Arg) -> Arg {
    match argument.get_id().as_str() {
        "machine" => {
            let timed = ROWS.iter().filter(|row| row.timed).map(|row| format!("`{}`", row.name));
            let timed = timed.collect::<Vec<_>>().join(", ");
            argument
                .help(format!("Hardware model by name or path, or {timed}. The scenario's own if left out"))
        }
        _ => argument,
    }
}

/// The help of commands that take a hardware model, or a generator whose frames have deadlines.
pub fn of_deadlines(argument: Arg) -> Arg {
    match argument.get_id().as_str() {
        "machine" => argument.help(
            "Hardware model by name or path, or a generator whose frames have deadlines. The scenario's own if left out",
        ),
        _ => argument,
    }
}

/// Which scenario, drawn by what.
#[derive(Debug, Default, Clone, Args)]
pub struct StageArgs {
    /// Scenario to read: a file, or the name of one in `scenarios/`.
    #[arg(value_parser = values::scenario)]
    pub scenario: PathBuf,
    /// Hardware model by name or path, or a generator by name.
    #[arg(short, long, value_name = "MODEL", help = machine_help())]
    pub machine: Option<String>,
    /// Settings over the scenario and who draws it.
    #[command(flatten)]
    pub options: StageOptions,
}

/// What a stage is made of beside its scenario and who draws it.
#[derive(Debug, Default, Clone, Args)]
pub struct StageOptions {
    /// Merge a TOML file of differences over the hardware model; may be given several times.
    #[arg(long, value_name = "FILE")]
    pub overlay: Vec<PathBuf>,
    /// Keys of hardware model, generator and scenario, with their values.
    #[arg(long, value_name = "PART.KEY=VALUE", value_parser = values::setting, help = set_help())]
    pub set: Vec<(String, String)>,
    /// Look through this channel of the scenario; through the vehicle's own camera if left out.
    #[arg(long, value_name = "NAME")]
    pub channel: Option<String>,
    /// Ground from this bank instead of the scenario's.
    #[arg(long, value_name = "FILE")]
    pub bank: Option<PathBuf>,
    /// Number of sweeps per frame.
    #[arg(long, value_parser = values::whole(1..=8192_u32))]
    pub sweeps: Option<u32>,
    /// Number of samples per sweep.
    #[arg(long, value_parser = values::whole(2..=65_536_u32))]
    pub samples: Option<u32>,
    /// Scalar type of the analog signals.
    #[arg(long, value_enum)]
    pub scalar: Option<ScalarWord>,
    /// How exact the picture is; a command that draws has the option.
    #[arg(skip)]
    pub quality: Option<QualityWord>,
    /// Leave out only what changes no bit of the picture, and nothing that is merely too small to be seen.
    #[arg(long, conflicts_with = "everything")]
    pub lossless: bool,
    /// Leave nothing out: every block for which there is a source runs, and every switch, with work or not.
    #[arg(long)]
    pub everything: bool,
    /// Keep shadow boundaries in this folder from run to run: they are found again by ground, sun and fineness. The folder that the
    /// variable LUNOID_SHADOW_CACHE names if left out, if that names one; a run keeps them in its own folder otherwise.
    #[arg(long, value_name = "FOLDER")]
    pub shadow_cache: Option<PathBuf>,
}

/// How exact the picture of a command is that draws.
#[derive(Debug, Default, Clone, Copy, Args)]
pub struct QualityArgs {
    /// How exact the picture is.
    #[arg(long, value_enum, conflicts_with_all = ["preview", "swift", "lossless", "everything"])]
    quality: Option<QualityWord>,
    /// The same as --quality draft.
    #[arg(long, conflicts_with_all = ["lossless", "everything"])]
    preview: bool,
    /// The old word for --preview.
    #[arg(long, hide = true, conflicts_with_all = ["lossless", "everything"])]
    swift: bool,
}

impl QualityArgs {
    /// The quality that is asked for; the old word works and says so.
    pub fn asked(self) -> Option<QualityWord> {
        if self.swift {
            tell("--swift is called --preview now\n");
        }
        if self.preview || self.swift { Some(QualityWord::Draft) } else { self.quality }
    }
}

/// How exact a picture is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum QualityWord {
    /// Each signal once a step of the sweep and straight in between, without craters that look less than half a line high. Edges between
    /// steps are less exact; a frame takes a sixth to a third of the time of `fine`.
    Draft,
    /// The default: as many instants a step as the scene's counts ask for, so that the picture is no worse than that of `fine`. A
    /// scene without craters and shadows, and a machine with parts that remember, are drawn as by `fine`.
    Normal,
    /// Each edge at its own instant, with only what cannot be seen left out.
    Fine,
}

impl QualityWord {
    /// What may be left out for it.
    pub fn economy(self) -> Economy {
        match self {
            Self::Draft => Economy::Instants(1),
            Self::Normal => Economy::Normal,
            Self::Fine => Economy::Bounded,
        }
    }

    /// The word on a command line.
    pub fn word(self) -> &'static str {
        match self {
            Self::Draft => "draft",
            Self::Normal => "normal",
            Self::Fine => "fine",
        }
    }
}

/// Scalar type of the analog signals.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum ScalarWord {
    /// Single precision, which is fast.
    F32,
    /// Double precision: the reference.
    F64,
}

/// Option that sets how many threads draw.
#[derive(Debug, Args)]
pub struct Threads {
    /// Threads; as many as the variable LUNOID_THREADS says if left out, or as processors. The results do not depend on it.
    #[arg(short, long, value_parser = threads)]
    pub jobs: Option<u16>,
}

/// Stands for `--shadow-cache` where that is left out. Workers of one run share a folder so, and the words of the run do not name it.
const SHADOW_CACHE: &str = "LUNOID_SHADOW_CACHE";

/// The folder that the variable names, if it is not empty.
fn shadow_cache() -> Option<PathBuf> {
    env::var_os(SHADOW_CACHE).filter(|folder| !folder.is_empty()).map(PathBuf::from)
}

/// Stands for `--jobs` where that is left out.
const THREADS: &str = "LUNOID_THREADS";

fn threads(text: &str) -> Result<u16, String> {
    values::whole(1..=1024)(text)
}

impl Threads {
    /// Number of threads that are asked for; 0 for as many as there are processors.
    pub fn count(&self) -> Result<usize, Failure> {
        Ok(self.asked()?.map_or(0, usize::from))
    }

    /// A pool of one thread, for what is timed.
    pub fn one() -> Result<ThreadPool, Failure> {
        Self { jobs: Some(1) }.pool()
    }

    /// The one pool of a command.
    pub fn pool(&self) -> Result<ThreadPool, Failure> {
        let available = || thread::available_parallelism().map_or(1, usize::from);
        let threads = self.asked()?.map_or_else(available, usize::from);
        let pool = ThreadPoolBuilder::new().num_threads(threads).build();
        pool.map_err(|error| {
            Failure::output(format!("cannot start {threads} threads: {error}; give fewer --jobs"))
        })
    }

    /// By the option, else by the variable, if that is not empty.
    fn asked(&self) -> Result<Option<u16>, Failure> {
        let variable = || env::var_os(THREADS).filter(|text| !text.is_empty());
        let Some(text) = self.jobs.is_none().then(variable).flatten() else { return Ok(self.jobs) };
        let text = text.to_string_lossy();
        let found = threads(&text).map(Some);
        found.map_err(|expected| Failure::usage(format!("{THREADS}={text}: {expected}; mend or unset it")))
    }
}

impl StageOptions {
    fn economy(&self) -> Economy {
        match self {
            Self { everything: true, .. } => Economy::Everything,
            Self { lossless: true, .. } => Economy::Lossless,
            Self { quality, .. } => quality.unwrap_or(QualityWord::Normal).economy(),
        }
    }
}

impl StageArgs {
    /// The row of the generator that `--machine` names, if it names one.
    pub fn row(&self) -> Option<&'static Row> {
        self.machine.as_deref().and_then(registry::find)
    }

    /// Refuses a generator that is no machine; `why` is what it lacks.
    pub fn expect_machine(&self, why: &str) -> Result<(), Failure> {
        match self.row() {
            Some(row) => {
                Err(Failure::usage(format!("--machine {}: {why}; expected a hardware model", row.name)))
            }
            None => Ok(()),
        }
    }

    /// The same with the quality that is asked for.
    pub fn drawn_by(mut self, quality: QualityArgs) -> Self {
        self.options.quality = quality.asked();
        self
    }

    /// A scenario as it stands.
    pub fn of(scenario: &Path) -> Self {
        Self { scenario: scenario.to_owned(), ..Self::default() }
    }

    /// What is asked for over the scenario.
    pub fn wishes(&self) -> Wishes {
        let options = &self.options;
        Wishes {
            machine: self.machine.clone(),
            overlays: options.overlay.clone(),
            set: options.set.clone(),
            channel: options.channel.clone(),
            bank: options.bank.clone(),
            sweeps: options.sweeps,
            samples: options.samples,
            scalar: options.scalar.map(|scalar| match scalar {
                ScalarWord::F32 => Scalar::F32,
                ScalarWord::F64 => Scalar::F64,
            }),
            economy: options.economy(),
            shadow_cache: options.shadow_cache.clone().or_else(shadow_cache),
        }
    }

    /// Files that the stage is made of, none of which an output may replace.
    pub fn sources(&self) -> Vec<Place> {
        let StageOptions { bank, overlay, .. } = &self.options;
        let [references, model] = Opened::sources(&self.scenario, &self.wishes());
        let mut sources = vec![Place::file("the scenario", &self.scenario)];
        sources.extend(bank.iter().map(|bank| Place::file("--bank", bank)));
        sources.extend(overlay.iter().map(|overlay| Place::file("--overlay", overlay)));
        sources.extend(references.iter().map(|file| Place::file("a file of the scenario,", file)));
        sources.extend(model.iter().map(|file| Place::file("a file of the machine,", file)));
        sources
    }

    /// Reads scenario and model, and says whose view it is where there are several.
    pub fn load(&self) -> Result<Opened, Failure> {
        let opened = self.load_any_view()?;
        if opened.scenario.channels.is_empty() || self.options.channel.is_some() {
            return Ok(opened);
        }
        let (file, names) = (opened.scenario_file(), channel_names(&opened));
        warn(&format!(
            "{file}: the view is that of the vehicle's own camera; --channel NAME looks through one of {names}"
        ));
        Ok(opened)
    }

    /// Reads scenario and model where all views are drawn.
    pub fn load_any_view(&self) -> Result<Opened, Failure> {
        let opened = open(&self.scenario, &self.wishes())?;
        opened.remarks.iter().for_each(|remark| warn(remark));
        Ok(opened)
    }
}

/// The channels of a scenario in words.
pub fn channel_names(opened: &Opened) -> String {
    let names: Vec<&str> = opened.scenario.channels.iter().map(|channel| channel.name.as_str()).collect();
    names.join(", ")
}

/// The row of the generator that the scenario names, which has levels of detail.
pub fn levelled(opened: &Opened) -> Result<&'static Row, Failure> {
    let has_levels = |row: &&Row| row.level_ladders().next().is_some();
    opened.row.filter(has_levels).ok_or_else(|| {
        let known: Vec<&str> = ROWS.iter().copied().filter(has_levels).map(|row| row.name).collect();
        Failure::usage(format!(
            "{}, --machine {}: it has no levels of detail; expected a generator that has, by --machine: {}",
            opened.scenario_file(),
            opened.drawn_by(),
            known.join(", ")
        ))
    })
}

/// Refuses a generator that is no machine, whether the command line or the scenario names it; `why` is what it lacks.
pub fn expect_machine(opened: &Opened, why: &str) -> Result<(), Failure> {
    match opened.row {
        None => Ok(()),
        Some(row) => {
            let (file, name) = (opened.scenario_file(), row.name);
            Err(Failure::usage(format!("{file}, --machine {name}: {why}; expected a hardware model")))
        }
    }
}

/// The machine on its ground, made by the threads of `pool`.
pub fn machine_stage(opened: &Opened, pool: &ThreadPool) -> Result<MachineStage, Failure> {
    Ok(pool.install(|| opened.machine_stage())?)
}

/// The frames asked for.
pub fn choose_frames(opened: &Opened, asked: Option<Span>) -> Result<Range<u64>, Failure> {
    let all = 0..opened.frames();
    let Some(span) = asked else { return Ok(all) };
    span.within(&all).ok_or_else(|| {
        let (end, last) = (all.end, all.end - 1);
        Failure::usage(format!(
            "--frames {span}: the scenario has frames 0..{end} (0 to {last}); expected a range inside"
        ))
    })
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::StageArgs;

    const SCENARIO: &str = r#"
format = 1
title = "Ground"
shows = "Nothing but a test."
frames = 4

[landscape]
bank = "gone.bank"

[sun]
azimuth_deg = 100
elevation_deg = 15

[path]
keyframes = [{ t_s = 0, x_m = 100, y_m = 200 }, { t_s = 5, x_m = 108, y_m = 205 }]
"#;

    #[test]
    fn a_scenario_whose_bank_is_not_made_says_how_to_make_it() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("real.toml");
        fs::write(&path, SCENARIO).unwrap();
        let mut stage = StageArgs::of(&path);
        let said = |stage: &StageArgs| stage.load().err().unwrap().message(false).unwrap();
        let text = said(&stage);
        let words = ["real.toml: this scenario needs a bank", "gone.bank: no such file", "`lunoid survey`"];
        assert!(words.iter().all(|word| text.contains(word)), "{text}");
        // Whoever names a bank is told of the name.
        stage.options.bank = Some(folder.path().join("other.bank"));
        assert!(said(&stage).contains("other.bank: no such file; check the spelling"), "{}", said(&stage));
    }
}
