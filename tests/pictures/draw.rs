//! Draws the cases of one scenario and hashes their pictures.

use std::path::PathBuf;
use std::sync::LazyLock;

use front_door::{Opened, Wishes, open};
use generator::{PlaneKind, Planes, Stage};
use hardware_model::Economy;
use lunoid_tests::shipped::folder;
use signal::Probe;
use tempfile::TempDir;

use crate::Record;
use crate::cases::{By, Case};

/// Shadow boundaries, which all machines on one scenario share.
static SHADOWS: LazyLock<TempDir> = LazyLock::new(|| tempfile::tempdir().expect("a folder for shadows"));

/// Hashes of all pictures of `cases`, which are of one scenario.
pub fn hashes(cases: &[Case]) -> Result<Record, String> {
    let mut first: Option<Stage> = None;
    let mut record = Record::new();
    for case in cases {
        let opened = open(&case.file(), &wishes(case)).map_err(|error| error.to_string())?;
        let stage = match &first {
            Some(first) => opened.machine_stage_beside(first).map_err(|error| error.to_string())?.stage(),
            None => opened.stage().map_err(|error| error.to_string())?,
        };
        record.extend(of_case(case, &opened, &stage)?);
        first.get_or_insert(stage);
    }
    Ok(record)
}

/// What is asked for over the scenario.
fn wishes(case: &Case) -> Wishes {
    let fault = |name| PathBuf::from(format!("../hardware-models/faults/{name}.toml"));
    Wishes {
        machine: match case.by {
            By::Model(name) => Some(name.to_owned()),
            By::Guest(row) => Some(row.name.to_owned()),
            By::Economy(_) | By::Fault(_) => None,
        },
        overlays: if let By::Fault(name) = case.by { vec![folder().join(fault(name))] } else { Vec::new() },
        economy: if let By::Economy(economy) = case.by { economy } else { Economy::Bounded },
        shadow_cache: Some(SHADOWS.path().to_owned()),
        ..Wishes::default()
    }
}

/// Hashes of the frames of `case`, by their names.
fn of_case(case: &Case, opened: &Opened, stage: &Stage) -> Result<Record, String> {
    let session = match opened.generator.prepare(stage.clone()) {
        Ok(session) => session,
        Err(error) => return Ok(Record::from([(case.name(), format!("refused: {error}"))])),
    };
    let [columns, lines] = [stage.view.columns, stage.view.lines].map(|count| count as usize);
    let mut record = Record::new();
    for frame in case.frames(opened.frames()) {
        let table = opened.poses(stage, frame..frame + 1).map_err(|error| error.to_string())?;
        let mut planes = Planes::new(columns, lines, &[PlaneKind::Intensity]);
        let drawn = session.frame(frame, &table.rows()[0].pose, &mut planes, &mut Probe::off());
        let found = match drawn {
            Ok(_) => hash(planes.get(PlaneKind::Intensity).unwrap_or_default()),
            Err(error) => format!("refused: {error}"),
        };
        record.insert(format!("{}, frame {frame}", case.name()), found);
    }
    Ok(record)
}

/// Hash of the bits of a plane.
fn hash(values: &[f32]) -> String {
    let mut hasher = blake3::Hasher::new();
    for value in values {
        hasher.update(&value.to_bits().to_le_bytes());
    }
    hasher.finalize().to_hex()[..32].to_owned()
}
