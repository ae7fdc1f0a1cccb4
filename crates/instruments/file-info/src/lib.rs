//! What a file or the folder of a run holds, in words and as a document.
//!
//! [`Held::of`] knows banks, states of a machine, elevation files, scenarios, hardware models, landscapes, terrain databases, pictures (PNG, JPEG),
//! and run folders. Banks and models are also told by themselves ([`bank_text`], [`model_document_with`] and others).

mod bank;
mod elevation;
mod error;
mod model;
mod run;
mod scenario;
mod terrain;

use std::io::Read;
use std::path::Path;

use front_door::{KNOWN, Kind};
use hardware_model::HardwareModel;
use landscape::bank_file;
use serde_json::Value;
use state::State;

use crate::model::model_document;

pub use bank::{bank_document, bank_text};
pub use error::InfoError;
pub use model::{can_be_built, findings_document, findings_text, model_document_with};

/// What a file or a run folder holds.
pub struct Held {
    /// For programs; its `schema` says what it is.
    pub document: Value,
    /// The same facts as text for people.
    pub text: String,
}

impl Held {
    /// Looks into `path`.
    ///
    /// # Errors
    /// If it cannot be read, or is of a kind that says nothing by itself.
    pub fn of(path: &Path) -> Result<Self, InfoError> {
        if path.is_dir() {
            return run::run(path);
        }
        let start = first_bytes(path)?;
        match start.as_slice() {
            [b'L', b'U', b'N', b'O', b'B', b'A', b'N', b'K', ..] => {
                let bank = bank_file::read(path)?;
                Ok(Self { document: bank_document(path, &bank), text: bank_text(&bank) })
            }
            [b'L', b'U', b'N', b'O', b'S', b'T', b'A', b'T', ..] => state(path),
            [0x89, b'L', b'O', b'D', b'G', b'R', b'N', b'D'] => terrain::database(path),
            [0x89, b'P', b'N', b'G', ..] | [0xFF, 0xD8, 0xFF, ..] => run::picture(path),
            _ if path.extension().is_some_and(|extension| extension == "toml") => toml(path),
            _ => elevation::elevation(path),
        }
    }
}

/// A state of a machine, whatever machine it is of.
fn state(path: &Path) -> Result<Held, InfoError> {
    let state = State::read(path)?;
    let mut document = state.json();
    document["schema"] = "lunoid.info.state/1".into();
    document["file"] = path.display().to_string().into();
    Ok(Held { document, text: state.text() })
}

/// A file that people write: a scenario or a model; what else there is says who reads it.
fn toml(path: &Path) -> Result<Held, InfoError> {
    let file = path.display();
    let other = match Kind::of(path) {
        Kind::Scenario => return scenario::scenario(path),
        Kind::Model => {
            let loaded = HardwareModel::read(path, &[], &[])?;
            return Ok(Held { document: model_document(&loaded), text: loaded.effective() });
        }
        Kind::Terrain => return terrain::landscape(path),
        Kind::Sidecar => {
            "the description of a bank; expected the bank itself, the same name without .toml".to_owned()
        }
        Kind::Overlay => format!(
            "differences from a hardware model; expected a model. `lunoid model show ideal --overlay {file}` has them"
        ),
        Kind::Gear(row) => format!(
            "what {} ran on; `lunoid check` reads it, docs/blocks/{}.md describes it",
            row.name, row.name
        ),
        Kind::GeneratorOverlay(row) => format!(
            "differences from what {} draws by; `lunoid check` reads them, docs/blocks/{}.md describes its keys",
            row.name, row.name
        ),
        Kind::Cartridge => {
            "a cartridge; `lunoid cartridge run --folder` runs it with those beside its folder".to_owned()
        }
        Kind::Unknown => format!("a file of no known kind; expected {KNOWN}"),
    };
    Err(InfoError::Other(format!("{file}: {other}")))
}

fn first_bytes(path: &Path) -> Result<Vec<u8>, InfoError> {
    let mut start = Vec::new();
    match files::open(path)?.take(8).read_to_end(&mut start) {
        Ok(_) => Ok(start),
        // The reader of whole files has the words for what can go wrong.
        Err(_) => Ok(files::read_all(path, 8)?),
    }
}
