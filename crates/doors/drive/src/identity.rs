//! What decides the pixels of an opened scenario, as a document.

use std::collections::BTreeMap;
use std::path::Path;

use run_record::{FileRecord, Program, ViewRecord};
use serde_json::{Value, json};

use crate::Drive;

impl Drive {
    /// What decides the pixels that `program` draws of this drive. Two drives with equal documents draw equal pixels.
    ///
    /// Its keys: `program`, `title`, `drawn_by`, `channel`, `set` with each key that was set, `files` with the hashes of the scenario, of the
    /// files that it names and of those of its hardware model, each under its name, `view`, and `settings` of the generator.
    pub fn identity(&self, program: &Program) -> Value {
        let opened = &self.opened;
        let set: BTreeMap<&String, &String> =
            opened.wishes().set.iter().map(|(key, value)| (key, value)).collect();
        let inputs = &opened.inputs;
        let files = inputs.scenario.iter().chain(&inputs.references).chain(&inputs.model_files);
        json!({
            "program": program,
            "title": opened.scenario.title,
            "drawn_by": opened.drawn_by(),
            "channel": opened.wishes().channel,
            "set": set,
            "files": by_name(files),
            "view": ViewRecord::from(&self.bench.stage.view),
            "settings": opened.generator.record(),
        })
    }
}

/// Hashes of files by their names without folders: where a file lies changes no pixel.
fn by_name<'a>(files: impl Iterator<Item = &'a FileRecord>) -> BTreeMap<String, Vec<&'a str>> {
    let mut hashes: BTreeMap<String, Vec<&str>> = BTreeMap::new();
    for FileRecord { file, blake3 } in files {
        let name = Path::new(file).file_name().unwrap_or_default().to_string_lossy();
        hashes.entry(name.into_owned()).or_default().push(blake3);
    }
    hashes
}
