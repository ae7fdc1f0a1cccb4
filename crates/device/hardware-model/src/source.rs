//! Where a model is: a file, or one that the program carries with it.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use diagnostics::{Problem, ProblemList, Problems, TomlFile};
use files::{FileError, is_file, is_there, names_in};
use limits::Limit;

use crate::faults::FAULTS;

/// Models that the program carries, with their text.
pub const BUILT_IN: [(&str, &str); 7] = [
    ("ideal", include_str!("../../../../hardware-models/ideal.toml")),
    ("pra-wires", include_str!("../../../../hardware-models/pra-wires.toml")),
    ("pra-parts", include_str!("../../../../hardware-models/pra-parts.toml")),
    ("pra-nominal", include_str!("../../../../hardware-models/pra-nominal.toml")),
    ("pra-frugal", include_str!("../../../../hardware-models/pra-frugal.toml")),
    ("pra-overloaded", include_str!("../../../../hardware-models/pra-overloaded.toml")),
    ("modern-analog", include_str!("../../../../hardware-models/modern-analog.toml")),
];

/// Name of the folder that holds models.
const FOLDER: &str = "hardware-models";

/// Where a model is.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub enum ModelSource {
    /// A file at this path.
    File(PathBuf),
    /// One of [`BUILT_IN`], by name.
    BuiltIn(String),
    /// One of [`FAULTS`], by name.
    Fault(String),
}

/// Where the name of a model stands, for messages.
#[derive(Debug, Clone, Copy)]
pub struct Asked<'a> {
    /// A file or an option.
    pub place: &'a str,
    /// Names that could have been meant and are no model's.
    pub others: &'a [&'a str],
}

impl ModelSource {
    /// The model that a user means. What ends in `.toml` or has a separator is a path. A name is looked for in
    /// `hardware-models/` of `folder` (that of the scenario), of the folder above, and of the current folder, and
    /// then among those that the program carries.
    ///
    /// # Errors
    /// An unknown name; the message lists the known ones and the nearest.
    pub fn find(name_or_path: &str, folder: &Path) -> Result<Self, ProblemList> {
        Self::find_as(Asked { place: "machine", others: &[] }, name_or_path, folder)
    }

    /// The same with what is known of who asks.
    ///
    /// # Errors
    /// As [`find`](Self::find).
    pub fn find_as(asked: Asked<'_>, name_or_path: &str, folder: &Path) -> Result<Self, ProblemList> {
        if name_or_path.ends_with(".toml") || name_or_path.contains(['/', '\\']) {
            return Ok(Self::File(name_or_path.into()));
        }
        let folders = [folder.join(FOLDER), folder.join("..").join(FOLDER), FOLDER.into()];
        let files = folders.iter().map(|folder| folder.join(format!("{name_or_path}.toml")));
        if let Some(file) = files.into_iter().find(|file| is_file(file)) {
            return Ok(Self::File(file));
        }
        if let Some(built_in) = Self::built_in(name_or_path) {
            return Ok(built_in);
        }
        let mut known = known_names(&folders);
        known.extend(asked.others.iter().map(|&name| name.to_owned()));
        let title = format!("unknown machine `{name_or_path}`; a file of your own is named by its path");
        let problem = Problem::of_file(asked.place, title).found(name_or_path);
        Err(advise(problem, name_or_path, &known).into())
    }

    /// The overlay that a user means: a file, or the name of one of [`FAULTS`] where there is no such file.
    pub fn overlay(path: &Path) -> Self {
        let name = path.to_string_lossy();
        let is_fault = FAULTS.iter().any(|(known, _)| *known == name);
        if is_fault && !is_file(path) { Self::Fault(name.into_owned()) } else { Self::File(path.to_owned()) }
    }

    /// This overlay, if it is there; of one that is not, names that are like its own are told.
    pub(crate) fn found(&self, problems: &Problems) -> Option<&Self> {
        match self {
            Self::File(path) if !is_there(path) => {
                let missing = FileError::Missing { path: path.clone() };
                let problem = Problem::of_file(self.name(), missing.to_string());
                let name = path.file_stem().unwrap_or_default().to_string_lossy();
                let known = FAULTS.iter().map(|(known, _)| (*known).to_owned()).collect();
                problems.push(advise(problem, &name, &known));
                None
            }
            _ => Some(self),
        }
    }

    /// The built-in model of a name.
    pub(crate) fn built_in(name: &str) -> Option<Self> {
        BUILT_IN.iter().any(|(known, _)| *known == name).then(|| Self::BuiltIn(name.into()))
    }

    /// The base of this name: beside this model, or built in.
    pub(crate) fn base(&self, name: &str) -> Option<Self> {
        let beside = match self {
            Self::File(path) => Some(path.with_file_name(format!("{name}.toml"))),
            Self::BuiltIn(_) | Self::Fault(_) => None,
        };
        let file = beside.filter(|path| is_file(path)).map(Self::File);
        file.or_else(|| Self::built_in(name))
    }

    /// Names that [`base`](Self::base) finds.
    pub(crate) fn known_bases(&self) -> BTreeSet<String> {
        let folder = match self {
            Self::File(path) => path.parent().map(Path::to_owned),
            Self::BuiltIn(_) | Self::Fault(_) => None,
        };
        known_names(folder.as_slice())
    }

    /// How messages call it.
    pub fn name(&self) -> String {
        match self {
            Self::File(path) => path.display().to_string(),
            Self::BuiltIn(name) => format!("built-in {name}.toml"),
            Self::Fault(name) => format!("built-in faults/{name}.toml"),
        }
    }

    /// The parsed file; whatever is wrong is recorded.
    pub(crate) fn parse(&self, problems: &Problems) -> Option<TomlFile> {
        match self {
            Self::File(path) => {
                let refuse = |error: FileError| {
                    problems.push(Problem::of_file(self.name(), error.to_string()));
                };
                let bytes = files::read_all(path, Limit::TextBytes).map_err(refuse).ok()?;
                TomlFile::parse_bytes(&self.name(), &bytes, problems)
            }
            Self::BuiltIn(name) => self.parse_carried(&BUILT_IN, name, problems),
            Self::Fault(name) => self.parse_carried(&FAULTS, name, problems),
        }
    }

    fn parse_carried(&self, carried: &[(&str, &str)], name: &str, problems: &Problems) -> Option<TomlFile> {
        let Some((_, text)) = carried.iter().find(|(known, _)| *known == name) else {
            problems.push(Problem::of_file(self.name(), format!("unknown built-in model `{name}`")));
            return None;
        };
        TomlFile::parse(&self.name(), text, problems)
    }
}

fn known_names(folders: &[PathBuf]) -> BTreeSet<String> {
    let names = folders.iter().flat_map(names_in);
    let models = names.filter_map(|name| name.strip_suffix(".toml").map(str::to_owned));
    models.chain(BUILT_IN.iter().map(|(name, _)| (*name).to_owned())).collect()
}

/// Adds the nearest of what is known, and all of it, to a problem.
pub(crate) fn advise(problem: Problem, name: &str, known: &BTreeSet<String>) -> Problem {
    let list: Vec<&str> = known.iter().map(String::as_str).collect();
    let alike = list.iter().map(|known| (strsim::jaro(name, known), known));
    // The likeness from which clap, too, offers a suggestion.
    let nearest = alike.filter(|(likeness, _)| *likeness > 0.7).max_by(|a, b| a.0.total_cmp(&b.0));
    let question = nearest.map_or(String::new(), |(_, nearest)| format!("did you mean `{nearest}`? "));
    problem.help(format!("{question}known: {}", list.join(", ")))
}
