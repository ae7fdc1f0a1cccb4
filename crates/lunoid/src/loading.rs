//! From a command line to a stage: scenario, machine, ground.

use std::env;
use std::fs;
use std::path::{Path, PathBuf};
use std::thread;
use std::time::Instant;

use clap::{Arg, Args, ValueEnum};
use diagnostics::{Problem, ProblemList, Problems};
use exact::Exact;
use generator::{Generator, Stage};
use hardware_model::{Asked, Economy, HardwareModel, LoadedModel, Settings};
use lunsim::{Hardware, Lunsim};
use machine::HybridMachine;
use rayon::{ThreadPool, ThreadPoolBuilder};
use replay::{FileRecord, Inputs, Phase, file_hash};
use scenario::{Ground, PathProblems, RasterWishes, Scenario};
use stage::StageError;

use crate::kind::{read_model, read_scenario};
use crate::lunsim_keys::{hardware, is_of_gear, run_key};
use crate::output::Place;
use crate::{Failure, values};

/// Generators that are no machine, each with what it is: their names stand where that of a hardware model would.
pub const OTHERS: [(&'static dyn Generator, &str); 2] = [
    (&Exact, "the same picture by closed form and root finding"),
    (&Lunsim, "the report's program: a ground grid onto the positions of a film recorder"),
];

/// The generator of that name, if it is no machine.
pub fn other(name: &str) -> Option<&'static dyn Generator> {
    OTHERS.iter().map(|(generator, _)| *generator).find(|generator| generator.name() == name)
}

/// Names of those.
pub fn other_names() -> [&'static str; OTHERS.len()] {
    OTHERS.map(|(generator, _)| generator.name())
}

/// The hardware model that a scenario names; raster, range and laws of a scenario for a generator that has none are
/// those of the ideal machine.
pub fn hardware_model(named: &str) -> &str {
    if other(named).is_some() { "ideal" } else { named }
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

/// The help of commands that take a hardware model or LUNSIM.
pub fn of_models_and_lunsim(argument: Arg) -> Arg {
    match argument.get_id().as_str() {
        "machine" => argument.help(
            "Hardware model by name or path, or `lunsim` for the report's program. The scenario's own if left out",
        ),
        _ => argument,
    }
}

/// Which scenario, drawn by what.
#[derive(Debug, Default, Args)]
pub struct StageArgs {
    /// Scenario file.
    pub scenario: PathBuf,
    /// Hardware model by name or path, `exact` for the closed form without any machine, or `lunsim` for the report's
    /// program. The scenario's own if left out.
    #[arg(short, long, value_name = "MODEL")]
    pub machine: Option<String>,
    #[command(flatten)]
    pub options: StageOptions,
}

/// What a stage is made of beside its scenario and who draws it.
#[derive(Debug, Default, Clone, Args)]
pub struct StageOptions {
    /// Merge a TOML file of differences over the hardware model; may be given several times.
    #[arg(long, value_name = "FILE")]
    pub overlay: Vec<PathBuf>,
    /// Set one key of the hardware model, or of `lunsim`, its `computer` or its `recorder`, over what the scenario wishes;
    /// may be given several times.
    #[arg(long, value_name = "PART.KEY=VALUE", value_parser = values::setting)]
    pub set: Vec<(String, String)>,
    /// Ground from this bank instead of the scenario's.
    #[arg(long, value_name = "FILE")]
    pub bank: Option<PathBuf>,
    /// Sweeps a frame.
    #[arg(long, value_parser = values::whole(1..=8192_u32))]
    pub sweeps: Option<u32>,
    /// Samples a sweep.
    #[arg(long, value_parser = values::whole(2..=65_536_u32))]
    pub samples: Option<u32>,
    /// Scalar type of the analog signals.
    #[arg(long, value_enum)]
    pub scalar: Option<ScalarWord>,
    /// Draw swiftly: signals at the samples alone and straight between them, and no crater that looks smaller than a part of
    /// a line. Several times as fast, for a picture that differs by little.
    #[arg(long, conflicts_with_all = ["lossless", "everything"])]
    pub swift: bool,
    /// Leave out only what changes no bit of the picture, and nothing that is merely too small to be seen.
    #[arg(long, conflicts_with = "everything")]
    pub lossless: bool,
    /// Leave nothing out: every block for which there is a source runs, and every switch, with work or not.
    #[arg(long)]
    pub everything: bool,
    /// Keep shadow boundaries in this folder from run to run: they are found again by ground, sun and fineness.
    #[arg(long, value_name = "FOLDER")]
    pub shadow_cache: Option<PathBuf>,
}

/// Scalar type of the analog signals.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum ScalarWord {
    /// Single precision: fast.
    F32,
    /// Double precision: the reference.
    F64,
}

/// Threads that draw.
#[derive(Debug, Args)]
pub struct Threads {
    /// Threads; as many as the variable LUNOID_THREADS says if left out, or as processors. The results do not depend on it.
    #[arg(short, long, value_parser = threads)]
    pub jobs: Option<u16>,
}

/// Stands for `--jobs` where that is left out.
const THREADS: &str = "LUNOID_THREADS";

fn threads(text: &str) -> Result<u16, String> {
    values::whole(1..=1024)(text)
}

impl Threads {
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

/// What is read before there is ground: everything that can be wrong in files that people write.
pub struct Loaded {
    /// The scenario, with the wishes of the command line.
    pub scenario: Scenario,
    /// The hardware model, without the wishes of scenario and command line for raster, range and laws.
    pub model: HardwareModel,
    /// What the run comes to.
    pub settings: Settings,
    /// Who draws.
    pub generator: &'static dyn Generator,
    /// What LUNSIM ran on, where it draws.
    pub program: Option<Hardware>,
    /// For the record.
    pub inputs: Inputs,
    /// How long it took.
    pub phases: Vec<Phase>,
}

impl StageArgs {
    /// Refuses a generator that is no machine; `why` is what it lacks.
    pub fn expect_machine(&self, why: &str) -> Result<(), Failure> {
        match self.machine.as_deref().filter(|name| other(name).is_some()) {
            Some(name) => Err(Failure::usage(format!("--machine {name}: {why}; expected a hardware model"))),
            None => Ok(()),
        }
    }

    /// A scenario as it stands.
    pub fn of(scenario: &Path) -> Self {
        Self { scenario: scenario.to_owned(), ..Self::default() }
    }

    /// Files that the stage is made of, none of which an output may replace. Of what cannot be read there are none:
    /// `load` says why.
    pub fn sources(&self) -> Vec<Place> {
        let StageOptions { bank, overlay, .. } = &self.options;
        let mut sources = vec![Place::file("the scenario", &self.scenario)];
        sources.extend(bank.iter().map(|bank| Place::file("--bank", bank)));
        sources.extend(overlay.iter().map(|overlay| Place::file("--overlay", overlay)));
        if let Ok(scenario) = read_scenario(&self.scenario) {
            let model = self.model(&scenario).map_or(Vec::new(), |model| model.files);
            let files = scenario.files().into_iter();
            sources.extend(files.map(|file| Place::file("a file of the scenario,", file)));
            sources.extend(model.into_iter().map(|file| Place::file("a file of the machine,", file)));
        }
        sources
    }

    /// Reads scenario and model.
    pub fn load(&self) -> Result<Loaded, Failure> {
        let start = Instant::now();
        let mut scenario = read_scenario(&self.scenario)?;
        if let Some(bank) = &self.options.bank {
            scenario.ground = Ground::Bank(bank.clone());
        }
        self.expect_bank(&scenario)?;
        let model = self.model(&scenario)?;
        self.wish(&mut scenario)?;
        let settings = stage::settings(&scenario, &model.model).map_err(|error| self.refused(&error))?;
        let settings = Settings { economy: self.economy(), shadow_cache: self.shadow_cache()?, ..settings };
        let inputs = self.inputs(&scenario, &model)?;
        let generator = self.machine.as_deref().map_or_else(|| other(&scenario.machine), other);
        let generator = generator.unwrap_or(&HybridMachine);
        self.expect_parts(generator)?;
        let program = self.draws_lunsim(&scenario).then(|| hardware(&self.options.set)).transpose()?;
        let phases = vec![Phase::since("read", start)];
        Ok(Loaded { scenario, model: model.model, settings, generator, program, inputs, phases })
    }

    /// Banks are made and not kept with the scenarios, so a first replay may find none.
    fn expect_bank(&self, scenario: &Scenario) -> Result<(), Failure> {
        match &scenario.ground {
            Ground::Bank(bank) if self.options.bank.is_none() && !bank.exists() => {
                let scenario = self.scenario.display();
                Err(Failure::input(format!(
                    "{scenario}: this scenario needs a bank; {}: no such file; `lunoid survey` or `lunoid bank import` \
                     makes one (see docs/real-ground.md)",
                    bank.display()
                )))
            }
            _ => Ok(()),
        }
    }

    fn model(&self, scenario: &Scenario) -> Result<LoadedModel, Failure> {
        let asked = self.machine.as_deref().filter(|name| other(name).is_none());
        let name = asked.unwrap_or(hardware_model(&scenario.machine));
        let folder = self.scenario.parent().unwrap_or(Path::new(""));
        let file = self.scenario.display().to_string();
        let place = if asked.is_some() { "--machine" } else { &file };
        let draws_lunsim = self.draws_lunsim(scenario);
        let is_of_model = |key: &str| run_key(key).is_none() && !(draws_lunsim && is_of_gear(key));
        let of_model: Vec<_> = self.options.set.iter().filter(|(key, _)| is_of_model(key)).cloned().collect();
        read_model(Asked { place, others: &other_names() }, name, folder, &self.options.overlay, &of_model)
    }

    /// Refuses to set parts that no machine has: raster, range and laws are those of any generator.
    fn expect_parts(&self, generator: &dyn Generator) -> Result<(), Failure> {
        if generator.is_machine() {
            return Ok(());
        }
        match self.options.set.iter().find(|(key, _)| is_of_parts(key)) {
            None => Ok(()),
            Some((key, _)) => Err(Failure::usage(format!(
                "--set {key}: {} has no such part; leave it out, or give --machine a hardware model",
                generator.name()
            ))),
        }
    }

    fn draws_lunsim(&self, scenario: &Scenario) -> bool {
        self.machine.as_ref().unwrap_or(&scenario.machine) == lunsim::NAME
    }

    /// The command line is over the scenario.
    fn wish(&self, scenario: &mut Scenario) -> Result<(), Failure> {
        for (key, value) in &self.options.set {
            match run_key(key) {
                Some(key) => scenario.lunsim = scenario.lunsim.with("--set", &format!("{key} = {value}"))?,
                None => drop_wish(scenario, key),
            }
        }
        let wishes = RasterWishes {
            sweeps: self.options.sweeps,
            samples: self.options.samples,
            ..RasterWishes::default()
        };
        scenario.raster = wishes.or(scenario.raster);
        if let Some(scalar) = self.options.scalar {
            scenario.scalar = match scalar {
                ScalarWord::F32 => scenario::Scalar::F32,
                ScalarWord::F64 => scenario::Scalar::F64,
            };
        }
        Ok(())
    }

    /// The folder for shadow boundaries, made if it is not there.
    fn shadow_cache(&self) -> Result<Option<PathBuf>, Failure> {
        let Some(folder) = &self.options.shadow_cache else { return Ok(None) };
        fs::create_dir_all(folder).map_err(|error| {
            let folder = folder.display();
            Failure::output(format!("--shadow-cache {folder}: {error}; name a folder that can be written"))
        })?;
        Ok(Some(folder.clone()))
    }

    fn economy(&self) -> Economy {
        match self.options {
            StageOptions { everything: true, .. } => Economy::Everything,
            StageOptions { lossless: true, .. } => Economy::Lossless,
            StageOptions { swift: true, .. } => Economy::Swift,
            _ => Economy::Bounded,
        }
    }

    fn refused(&self, error: &hardware_model::SettingsError) -> Failure {
        let place = self.scenario.display().to_string();
        let title = format!("scenario, machine and command line do not fit together: {error}");
        Failure::Problems(Problem::of_file(place, title).into())
    }

    fn inputs(&self, scenario: &Scenario, model: &LoadedModel) -> Result<Inputs, Failure> {
        let record = |path: &Path| -> Result<FileRecord, Failure> {
            Ok(FileRecord { file: path.display().to_string(), blake3: file_hash(path)? })
        };
        Ok(Inputs {
            scenario: Some(record(&self.scenario)?),
            references: scenario.files().into_iter().map(record).collect::<Result<_, _>>()?,
            model: model.model.name.clone(),
            model_files: model.files.iter().map(|path| record(path)).collect::<Result<_, _>>()?,
            model_values: model.values.clone(),
        })
    }
}

/// Whether a key of `--set` is of a part that only machines have. Poses go by the yoke, whatever draws.
pub fn is_of_parts(key: &str) -> bool {
    let is_of_program = run_key(key).is_some() || is_of_gear(key);
    !is_of_program && !key.starts_with("yoke.") && wish(key).is_none()
}

/// What `--set` says the scenario no longer wishes.
fn drop_wish(scenario: &mut Scenario, key: &str) {
    if let Some(drop) = wish(key) {
        drop(scenario);
    }
}

/// How a scenario comes to wish no longer what a key of a model sets, if it is one that a scenario can wish.
fn wish(key: &str) -> Option<fn(&mut Scenario)> {
    let drop: fn(&mut Scenario) = match key {
        "raster.sweeps" => |scenario| scenario.raster.sweeps = None,
        "raster.samples_per_sweep" => |scenario| scenario.raster.samples = None,
        "raster.update_hz" => |scenario| scenario.raster.update = None,
        "raster.refresh_hz" => |scenario| scenario.raster.refresh = None,
        "dpp.projection" => |scenario| scenario.laws.projection = None,
        "dpp.curvature" => |scenario| scenario.laws.curvature = None,
        "dpp.occlusion" => |scenario| scenario.laws.occlusion = None,
        "sweep_memory.pixel_rule" => |scenario| scenario.laws.pixel_rule = None,
        "feature_generator.light" => |scenario| scenario.laws.feature_light = None,
        "polyhedron_generator.visibility" => |scenario| scenario.laws.body_visibility = None,
        "polyhedron_generator.shadowed_bodies" => |scenario| scenario.laws.shadowed_bodies = None,
        "mixing_unit.texture_in_shadow" => |scenario| scenario.laws.texture_in_shadow = None,
        _ if key.starts_with("range.") => |scenario| scenario.range = None,
        _ => return None,
    };
    Some(drop)
}

/// Everything that `error` says of the scenario in `file`.
pub fn stage_problems(file: &str, error: &StageError) -> ProblemList {
    if let StageError::Path(error) = error {
        return path_problems(error);
    }
    let problems = Problems::new();
    error.to_string().lines().for_each(|line| problems.push(Problem::of_file(file, line)));
    problems.into_result().err().unwrap_or_else(|| Problem::of_file(file, "no stage").into())
}

/// Why a path cannot be driven, one problem a stretch of frames.
pub fn path_problems(error: &PathProblems) -> ProblemList {
    let problems = Problems::new();
    error.iter().for_each(|problem| problems.push(Problem::of_file(error.path(), problem.to_string())));
    problems.into_result().expect_err("there is a stretch")
}

impl Loaded {
    /// Refuses a generator that is no machine, whether the command line or the scenario names it; `why` is what it lacks.
    pub fn expect_machine(&self, why: &str) -> Result<(), Failure> {
        if self.generator.is_machine() {
            return Ok(());
        }
        let (file, name) = (self.scenario_file(), self.generator.name());
        Err(Failure::usage(format!("{file}, --machine {name}: {why}; expected a hardware model")))
    }

    /// The stage, its ground made by the threads of `pool`.
    pub fn stage(&mut self, pool: &ThreadPool) -> Result<Stage, Failure> {
        let start = Instant::now();
        let stage = pool.install(|| stage::build(&self.scenario, self.settings.clone()));
        let stage = stage.map_err(|error| match error {
            StageError::BankFile(error) => error.into(),
            other => Failure::Problems(stage_problems(self.scenario_file(), &other)),
        })?;
        self.phases.push(Phase::since("landscape", start));
        Ok(stage)
    }

    /// The stage over the ground of `first`, a stage of the same scenario for another machine.
    pub fn stage_beside(&mut self, first: &Stage) -> Result<Stage, Failure> {
        let start = Instant::now();
        let stage = stage::under(first, &self.scenario, self.settings.clone())?;
        self.phases.push(Phase::since("landscape", start));
        Ok(stage)
    }

    /// Name of who draws: the hardware model, or the generator that is no machine.
    pub fn drawn_by(&self) -> &str {
        if self.generator.is_machine() { &self.inputs.model } else { self.generator.name() }
    }

    /// Name of the scenario's file.
    pub fn scenario_file(&self) -> &str {
        self.inputs.scenario.as_ref().map_or("scenario", |record| &record.file)
    }

    /// Frames of the scenario.
    pub fn frames(&self) -> u64 {
        self.scenario.frames(self.settings.timebase.update)
    }

    /// The frames asked for.
    pub fn choose(&self, asked: Option<values::Span>) -> Result<std::ops::Range<u64>, Failure> {
        let all = 0..self.frames();
        let Some(span) = asked else { return Ok(all) };
        span.within(&all).ok_or_else(|| {
            let (end, last) = (all.end, all.end - 1);
            Failure::usage(format!(
                "--frames {span}: the scenario has frames 0..{end} (0 to {last}); expected a range inside"
            ))
        })
    }
}

#[cfg(test)]
mod tests {
    use std::fs;

    use scenario::Scenario;

    use super::{StageArgs, drop_wish};

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

    #[test]
    fn a_key_that_is_set_is_no_longer_wished() {
        let laws = "[laws]\nfeature_light = 'combined'\nbody_visibility = 'depth'\nshadowed_bodies = 'dark'\n\
                    texture_in_shadow = 'off'\nprojection = 'exact'\n";
        let mut scenario = Scenario::parse("t.toml", &format!("{SCENARIO}\n{laws}")).unwrap();
        for key in [
            "feature_generator.light",
            "polyhedron_generator.visibility",
            "polyhedron_generator.shadowed_bodies",
            "mixing_unit.texture_in_shadow",
            "dpp.projection",
        ] {
            let before = scenario.laws;
            drop_wish(&mut scenario, key);
            assert_ne!(scenario.laws, before, "{key}");
        }
        assert_eq!(scenario.laws, scenario::LawWishes::default());
    }
}
