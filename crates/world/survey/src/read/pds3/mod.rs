//! PDS3 images with a detached or an attached label, as LOLA and LROC write them.

mod image;
mod label;
mod map;

use std::fs::File;
use std::io::Read;
use std::path::{Path, PathBuf};

use self::label::{Statement, Value};
use super::{ReadOptions, field};
use crate::elevation::Elevation;
use crate::error::SurveyError;

/// Most bytes of a label; those of the archives have some thousand.
const LABEL_BYTES: u64 = 1 << 20;

/// Whether a file begins like a label.
pub fn is_label(start: &[u8]) -> bool {
    let words = [&b"PDS_VERSION_ID"[..], b"CCSD3ZF", b"ODL_VERSION_ID", b"/*"];
    let start = start.trim_ascii_start();
    words.iter().any(|word| start.starts_with(word))
}

/// The label of the same name in the same folder, for an image without one of its own.
pub fn label_beside(path: &Path) -> Result<Option<PathBuf>, SurveyError> {
    match path.file_stem() {
        Some(stem) => in_folder(path, &format!("{}.lbl", stem.to_string_lossy())),
        None => Ok(None),
    }
}

/// A file of this name, in any case, in the folder of `beside`.
fn in_folder(beside: &Path, name: &str) -> Result<Option<PathBuf>, SurveyError> {
    let folder = beside.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let failed = |source| SurveyError::Read { path: folder.to_path_buf(), source };
    let mut found = Vec::new();
    for entry in folder.read_dir().map_err(failed)? {
        let entry = entry.map_err(failed)?;
        if entry.file_name().to_string_lossy().eq_ignore_ascii_case(name) {
            found.push(beside.with_file_name(entry.file_name()));
        }
    }
    // An exact match goes before one that differs in case; else the order is that of the names.
    found.sort_by_key(|path| (path.file_name().is_none_or(|found| found != name), path.clone()));
    Ok(found.into_iter().next())
}

/// Reads the image that a label describes.
pub fn read(path: &Path, options: &ReadOptions) -> Result<Elevation, SurveyError> {
    let failed = |source| SurveyError::Read { path: path.to_path_buf(), source };
    let mut bytes = Vec::new();
    File::open(path).map_err(failed)?.take(LABEL_BYTES).read_to_end(&mut bytes).map_err(failed)?;
    let statements = label::parse(&bytes).map_err(|fault| {
        let advice = "the label is damaged: fetch it again";
        field(path, format!("label line {}", fault.line), fault.found, fault.expected, advice)
    })?;
    let label = Label { path, statements };
    let (file, start) = image::locate(&label)?;
    let mut elevation = image::read(&label, &file, start, options)?;
    if file != path {
        elevation.sources.insert(0, path.to_path_buf());
    }
    Ok(elevation)
}

/// A label with the file it came from, for messages.
struct Label<'a> {
    path: &'a Path,
    statements: Vec<Statement>,
}

impl Label<'_> {
    /// The statement for `keyword`, in `object` if that is not empty.
    fn find(&self, object: &str, keyword: &str) -> Option<&Statement> {
        self.statements.iter().find(|s| s.keyword == keyword && (object.is_empty() || s.object == object))
    }

    fn text(&self, object: &str, keyword: &str) -> Option<&str> {
        match &self.find(object, keyword)?.value {
            Value::Plain { text, .. } => Some(text),
            Value::List(_) => None,
        }
    }

    /// A number and its unit in capitals; absent where the label says N/A or the like.
    fn number(&self, object: &str, keyword: &str) -> Result<Option<(f64, String)>, SurveyError> {
        let Some(statement) = self.find(object, keyword) else { return Ok(None) };
        let Value::Plain { text, unit } = &statement.value else {
            return Err(self.wrong(statement, "one number"));
        };
        if ["N/A", "NULL", "UNK", "NONE", ""].contains(&text.to_ascii_uppercase().as_str()) {
            return Ok(None);
        }
        let number = text.parse::<f64>().ok().filter(|number| number.is_finite());
        let unit = unit.as_deref().unwrap_or_default().to_ascii_uppercase();
        number.map(|number| Some((number, unit))).ok_or_else(|| self.wrong(statement, "a finite number"))
    }

    /// A number without regard to its unit.
    fn plain_number(&self, object: &str, keyword: &str) -> Result<Option<f64>, SurveyError> {
        Ok(self.number(object, keyword)?.map(|(number, _)| number))
    }

    /// A whole number from 0 on.
    fn count(&self, object: &str, keyword: &str) -> Result<Option<u64>, SurveyError> {
        let Some(number) = self.plain_number(object, keyword)? else { return Ok(None) };
        if (0.0..=9e15).contains(&number) && number.fract() == 0.0 {
            return Ok(Some(number as u64));
        }
        let statement = self.find(object, keyword);
        Err(statement.map_or_else(|| self.missing(keyword), |s| self.wrong(s, "a whole number, 0 or more")))
    }

    fn wrong(&self, statement: &Statement, expected: &str) -> SurveyError {
        let found = match &statement.value {
            Value::Plain { text, unit: Some(unit) } => format!("{text} <{unit}>"),
            Value::Plain { text, unit: None } => text.clone(),
            Value::List(values) => format!("a list of {}", values.len()),
        };
        let place = format!("label line {}, {}", statement.line, statement.keyword);
        field(self.path, place, found, expected, "the label is damaged or of a kind not read here")
    }

    fn missing(&self, keyword: &str) -> SurveyError {
        let advice = "the label is incomplete or of a kind not read here";
        field(self.path, format!("label, {keyword}"), "nothing", "a value", advice)
    }
}
