//! From files and wishes to everything that is known before there is ground.

use std::path::Path;
use std::sync::Arc;

use control_plane::instants_obstacle;
use diagnostics::{Origin, Problem, Problems, TomlFile};
use files::{is_file, is_there, make_folder};
use generator::Row;
use hardware_model::{Asked, Economy, EffectiveValue, LoadedModel, Settings, SettingsError, ShadowCache};
use limits::Limit;
use machine::HybridMachine;
use registry::Configured;
use run_record::{FileRecord, Inputs};
use scenario::{GroundSource, RasterWishes, Scenario};

use crate::keys::{Decides, decides, drop_wish, of_scenario};
use crate::kind::read_scenario_over;
use crate::overlays;
use crate::together::together;
use crate::{OpenError, Opened, Wishes, expect_drawable, read_model};

/// The hardware model of a scenario whose `machine` is `named`: raster, range and laws under a generator that has no
/// hardware model are over those of the ideal machine.
pub fn base_model(named: &str) -> &str {
    if registry::find(named).is_some() { "ideal" } else { named }
}

/// Reads the scenario at `path` with `wishes`.
///
/// # Errors
/// Everything that is wrong in files and wishes, before any ground is made.
pub fn open(path: &Path, wishes: &Wishes) -> Result<Opened, OpenError> {
    expect_tables_of_scenarios(&wishes.set)?;
    let scenario = read_scenario_over(path, wishes);
    let scenario = scenario.map_err(|error| together(error, faults_of_tables(path, None, wishes)))?;
    let mut scenario = seen_through(path, scenario, wishes)?;
    if let Some(bank) = &wishes.bank {
        scenario.ground = GroundSource::Bank(bank.clone());
    }
    expect_bank(path, &scenario, wishes)?;
    let asked = wishes.machine.as_deref();
    let row = registry::find(asked.unwrap_or(&scenario.machine));
    let mut tables = faults_of_tables(path, row, wishes).into_iter();
    let model = model(path, &scenario, row, wishes).map_err(|error| together(error, tables.by_ref()))?;
    overlays::expect_of(row, row.map_or(model.model.name.as_str(), |row| row.name), wishes)?;
    row.map_or(Ok(()), |row| overlays::expect_no_parts(row, &model, wishes))?;
    wish(&mut scenario, wishes);
    let settings = crate::settings(&scenario, &model.model).map_err(|error| unfit(path, &error))?;
    expect_pixels(path, &settings)?;
    let shadow_cache = shadow_cache(wishes)?;
    let settings = Settings { economy: wishes.economy, shadow_cache, ..settings };
    if matches!(wishes.economy, Economy::Instants(_))
        && let Some(obstacle) = obstacle(&model.model.name, row, &settings)
    {
        let remedy = "leave the option out, or give --machine a hardware model with ideal parts";
        return Err(OpenError::Wish(format!("--quality draft (--preview): {obstacle}; {remedy}")));
    }
    let inputs = inputs(path, &scenario, &model, wishes)?;
    if let Some(first) = tables.next() {
        return Err(together(first, tables));
    }
    let Configured { generator, values } = match row {
        Some(row) => guest(path, row, wishes)?,
        None => Configured { generator: Arc::new(HybridMachine::new(settings.clone())), values: Vec::new() },
    };
    let values = values.into_iter().map(effective).chain(of_view(&model.values, row)).collect();
    let pauses = scenario.path_beside_mission(settings.timebase.update);
    let remarks = model.remarks.into_iter().chain(scenario.notes.iter().cloned()).chain(pauses).collect();
    Ok(Opened {
        scenario,
        model: model.model,
        settings,
        row,
        generator,
        values,
        remarks,
        inputs,
        path: path.to_owned(),
        wishes: wishes.clone(),
    })
}

/// The scenario through the channel that is asked for, if one is.
fn seen_through(path: &Path, scenario: Scenario, wishes: &Wishes) -> Result<Scenario, OpenError> {
    let Some(name) = &wishes.channel else { return Ok(scenario) };
    let names: Vec<&str> = scenario.channels.iter().map(|channel| channel.name.as_str()).collect();
    let expected = match names[..] {
        [] => "the scenario has no [[channel]]; leave the option out".into(),
        _ => format!("expected one of the scenario's channels {}", names.join(", ")),
    };
    let refused =
        OpenError::Wish(format!("--channel {name}: {}: no such channel; {expected}", path.display()));
    scenario.through(name).ok_or(refused)
}

/// A generator reads its table from the file alone; its keys are set by their own names.
fn expect_tables_of_scenarios(sets: &[(String, String)]) -> Result<(), OpenError> {
    let tables = registry::parameter_tables();
    let is_of_generator = |key: &str| tables.iter().any(|table| key.split('.').next() == Some(*table));
    match sets.iter().find_map(|(key, _)| of_scenario(key).filter(|key| is_of_generator(key))) {
        None => Ok(()),
        Some(key) => Err(OpenError::Wish(format!(
            "--set scenario.{key}: a generator reads this table; expected --set {key}"
        ))),
    }
}

/// Banks are made and not kept with the scenarios, so a first replay may find none.
fn expect_bank(path: &Path, scenario: &Scenario, wishes: &Wishes) -> Result<(), OpenError> {
    match &scenario.ground {
        GroundSource::Bank(bank) if wishes.bank.is_none() && !is_there(bank) => {
            Err(OpenError::Input(format!(
                "{}: this scenario needs a bank; {}: no such file; `lunoid survey` or `lunoid bank import` makes one \
             (see docs/real-ground.md)",
                path.display(),
                bank.display()
            )))
        }
        _ => Ok(()),
    }
}

/// The hardware model: that of the wishes, or the scenario's own.
pub(crate) fn model(
    path: &Path,
    scenario: &Scenario,
    row: Option<&Row>,
    wishes: &Wishes,
) -> Result<LoadedModel, OpenError> {
    let asked = wishes.machine.as_deref().filter(|name| registry::find(name).is_none());
    let name = asked.unwrap_or(base_model(&scenario.machine));
    let folder = path.parent().unwrap_or(Path::new(""));
    let file = path.display().to_string();
    let place = if asked.is_some() { "--machine" } else { &file };
    let is_of_model = |key: &str| match decides(key) {
        // Run parameters are known whatever draws; gear is only the drawing generator's own.
        Decides::Generator(own) => !is_parameter(own, key) && row != Some(own),
        Decides::View | Decides::Model => true,
        Decides::Scenario => false,
    };
    let of_model: Vec<_> = wishes.set.iter().filter(|(key, _)| is_of_model(key)).cloned().collect();
    if let Some(row) = row {
        expect_no_parts(row, &of_model)?;
    }
    let asked = Asked { place, others: &registry::names() };
    let loaded = read_model(asked, name, folder, &overlays::of_model(wishes)?, &of_model)?;
    expect_drawable(&loaded)?;
    Ok(loaded)
}

fn is_parameter(row: &Row, key: &str) -> bool {
    row.parameters.is_some_and(|table| key.split_once('.').is_some_and(|(found, _)| found == table))
}

/// Refuses to set parts that no machine has: raster, range and laws are those of any generator.
fn expect_no_parts(row: &Row, sets: &[(String, String)]) -> Result<(), OpenError> {
    match sets.iter().find(|(key, _)| matches!(decides(key), Decides::Model)) {
        None => Ok(()),
        Some((key, _)) => Err(OpenError::Wish(format!(
            "--set {key}: {} has no such part; leave it out, or give --machine a hardware model",
            row.name
        ))),
    }
}

/// What keeps a generator from drawing a preview, in words; `None` if nothing does.
pub(crate) fn obstacle(model: &str, row: Option<&Row>, settings: &Settings) -> Option<String> {
    match row {
        Some(row) => Some(format!("{} draws no preview", row.name)),
        None => {
            instants_obstacle(settings).map(|what| format!("{model} has {what}, which a preview leaves out"))
        }
    }
}

/// Wishes are over the scenario.
fn wish(scenario: &mut Scenario, wishes: &Wishes) {
    wishes.set.iter().for_each(|(key, _)| drop_wish(scenario, key));
    let raster = RasterWishes { sweeps: wishes.sweeps, samples: wishes.samples, ..RasterWishes::default() };
    scenario.raster = raster.or(scenario.raster);
    scenario.scalar = wishes.scalar.unwrap_or(scenario.scalar);
}

fn effective((key, origin): (String, Origin)) -> EffectiveValue {
    EffectiveValue { key, origin: origin.to_string(), value: origin.text }
}

/// What of the values of the hardware model the drawing generator takes: those of the view alone where it is that of a row.
fn of_view(values: &[EffectiveValue], row: Option<&Row>) -> impl Iterator<Item = EffectiveValue> {
    let is_taken =
        move |value: &&EffectiveValue| row.is_none() || matches!(decides(&value.key), Decides::View);
    values.iter().filter(is_taken).cloned()
}

/// The generator of a row, with the tables of the scenario and the keys that are set; and the values of its tables.
pub(crate) fn guest(path: &Path, row: &'static Row, wishes: &Wishes) -> Result<Configured, OpenError> {
    let problems = Problems::new();
    let name = path.display().to_string();
    let text = files::read_all(path, Limit::TextBytes)?;
    let file = row.parameters.and_then(|_| TomlFile::parse_bytes(&name, &text, &problems));
    let sets = wishes.set.iter().filter(|(key, _)| row.owns(key));
    let sets: Vec<_> = sets.filter_map(|(key, value)| registry::set_line(key, value, &problems)).collect();
    problems.into_result()?;
    let overlays = overlays::of_generators(wishes)?.into_iter().filter(|overlay| overlay.row == row);
    let overlays = overlays.map(|overlay| overlay.file);
    Ok(registry::configure_told(row, file.into_iter().chain(overlays).chain(sets))?)
}

/// What is wrong with the tables of generators, first those of `drawing`, which draws. Run parameters of the others must be right all the same.
fn faults_of_tables(path: &Path, drawing: Option<&'static Row>, wishes: &Wishes) -> Vec<OpenError> {
    let check = |row: &'static Row| {
        let set = wishes.set.iter().filter(|(key, _)| is_parameter(row, key)).cloned().collect();
        guest(path, row, &Wishes { set, ..Wishes::default() })
    };
    let drawing_faults = drawing.into_iter().map(|row| guest(path, row, wishes));
    let others = registry::ROWS.iter().copied().filter(|row| Some(*row) != drawing);
    drawing_faults.chain(others.map(check)).filter_map(Result::err).collect()
}

/// Refuses pictures that are too large to be drawn.
fn expect_pixels(path: &Path, settings: &Settings) -> Result<(), OpenError> {
    let (columns, lines) = (settings.raster.columns, settings.raster.lines);
    let pixels = u64::from(columns) * u64::from(lines);
    if Limit::Pixels.allows(pixels) {
        return Ok(());
    }
    let title = format!("pictures of {columns} x {lines} pixels");
    let problem = Problem::of_file(path.display().to_string(), title).key("raster.columns");
    let most = format!("at most {} pixels", Limit::Pixels.value());
    Err(OpenError::Problems(problem.expected(most).help(Limit::Pixels.to_string()).into()))
}

/// The folder for shadow boundaries, made if it is not there.
fn shadow_cache(wishes: &Wishes) -> Result<Option<ShadowCache>, OpenError> {
    let Some(folder) = &wishes.shadow_cache else { return Ok(None) };
    make_folder(folder).map_err(|error| {
        OpenError::Output(format!("--shadow-cache {error}; name a folder that can be written"))
    })?;
    Ok(Some(ShadowCache::shared(folder)))
}

fn unfit(path: &Path, error: &SettingsError) -> OpenError {
    let title = format!("scenario, machine and command line do not fit together: {error}");
    OpenError::Problems(Problem::of_file(path.display().to_string(), title).into())
}

fn inputs(
    path: &Path,
    scenario: &Scenario,
    model: &LoadedModel,
    wishes: &Wishes,
) -> Result<Inputs, OpenError> {
    let overlays = overlays::of_generators(wishes)?.into_iter().map(|overlay| overlay.asked);
    let files = model.files.iter().cloned().chain(overlays.filter(|asked| is_file(asked)));
    Ok(Inputs {
        scenario: Some(FileRecord::of(path)?),
        references: scenario.files().into_iter().map(FileRecord::of).collect::<Result<_, _>>()?,
        model: model.model.name.clone(),
        model_files: files.map(|path| FileRecord::of(&path)).collect::<Result<_, _>>()?,
        model_values: model.values.clone(),
    })
}
