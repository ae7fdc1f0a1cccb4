//! Draws the cases of one scenario and hashes their pictures.

use std::sync::LazyLock;

use exact::Exact;
use generator::{Generator, PlaneKind, Planes, Stage};
use hardware_model::{HardwareModel, LoadedModel, ModelSource, Settings};
use lunoid_tests::shipped::folder;
use lunsim::Lunsim;
use machine::HybridMachine;
use scenario::{PoseTable, Scenario};
use signal::Probe;
use tempfile::TempDir;

use crate::Record;
use crate::cases::{By, Case};

/// Shadow boundaries, which all machines on one scenario share.
static SHADOWS: LazyLock<TempDir> = LazyLock::new(|| tempfile::tempdir().expect("a folder for shadows"));

/// Hashes of all pictures of `cases`, which are of one scenario.
pub fn hashes(cases: &[Case]) -> Result<Record, String> {
    let scenario = Scenario::read(cases[0].file()).map_err(|error| error.to_string())?;
    let own = model(&scenario, By::Exact)?;
    let settings = stage::settings(&scenario, &own.model).map_err(|error| error.to_string())?;
    let first = stage::build(&scenario, settings).map_err(|error| error.to_string())?;
    let mut record = Record::new();
    for case in cases {
        record.extend(of_case(case, &scenario, &first)?);
    }
    Ok(record)
}

/// Hashes of the frames of `case`, by their names. `first` is a stage of the same scenario.
fn of_case(case: &Case, scenario: &Scenario, first: &Stage) -> Result<Record, String> {
    let model = model(scenario, case.by)?.model;
    let settings = match stage::settings(scenario, &model) {
        Ok(settings) => settings,
        Err(error) => return Ok(Record::from([(case.name(), format!("refused: {error}"))])),
    };
    let settings = Settings {
        shadow_cache: Some(SHADOWS.path().to_owned()),
        economy: if let By::Economy(economy) = case.by { economy } else { settings.economy },
        ..settings
    };
    let stage = stage::under(first, scenario, settings).map_err(|error| error.to_string())?;
    let generator: &dyn Generator = match case.by {
        By::Lunsim => &Lunsim,
        By::Exact => &Exact,
        By::Model(_) | By::Economy(_) | By::Fault(_) => &HybridMachine,
    };
    let session = match generator.prepare(stage.clone()) {
        Ok(session) => session,
        Err(error) => return Ok(Record::from([(case.name(), format!("refused: {error}"))])),
    };
    let (update, yoke, raster) = (stage.settings.timebase.update, stage.settings.yoke, stage.settings.raster);
    let count = scenario.frames(update);
    let frames = if case.by == By::Exact { vec![0] } else { vec![0, count / 2, count - 1] };
    let mut record = Record::new();
    for frame in frames {
        let table = PoseTable::resolve(scenario, &stage.landscape, update, yoke, frame..frame + 1);
        let pose = table.map_err(|error| error.to_string())?.rows()[0].pose;
        let mut planes = Planes::new(raster.columns as usize, raster.lines as usize, &[PlaneKind::Intensity]);
        let drawn = session.frame(frame, &pose, &mut planes, &mut Probe::off());
        let found = match drawn {
            Ok(_) => hash(planes.get(PlaneKind::Intensity).expect("asked for")),
            Err(error) => format!("refused: {error}"),
        };
        record.insert(format!("{}, frame {frame}", case.name()), found);
    }
    Ok(record)
}

/// The hardware model of a case: by its name, or the scenario's own.
fn model(scenario: &Scenario, by: By) -> Result<LoadedModel, String> {
    // LUNSIM has no hardware model: raster, range and laws are over those of the ideal one.
    let own = if scenario.machine == lunsim::NAME { "ideal" } else { &scenario.machine };
    let name = if let By::Model(name) = by { name } else { own };
    let source = ModelSource::find(name, &folder()).map_err(|error| error.to_string())?;
    let overlays = match by {
        By::Fault(name) => vec![folder().join(format!("../hardware-models/faults/{name}.toml"))],
        _ => Vec::new(),
    };
    HardwareModel::load(&source, &overlays, &[]).map_err(|error| error.to_string())
}

/// Hash of the bits of a plane.
fn hash(values: &[f32]) -> String {
    let mut hasher = blake3::Hasher::new();
    for value in values {
        hasher.update(&value.to_bits().to_le_bytes());
    }
    hasher.finalize().to_hex()[..32].to_owned()
}
