//! Effect files: lists of faces with normals, sequences, sun programmes and colours; data only.
//!
//! ```toml
//! format = 1
//! title = "Beacon"
//! about = "A lamp that turns"
//!
//! [[group]]
//! name = "lamp"
//! priority = 4
//! vertices = [[0, 0, 0], [0, 1, 0], [1, 0, 0]]   # north, east, up (m)
//! normals = [[0, 0, 1], [0, 1, 1], [1, 0, 1]]    # any length; left out: averaged
//! sun = { elevation_deg = 40, turns = 1, seconds = 2 }
//!
//! [[group.face]]
//! corners = [0, 1, 2]
//! colour = [1, 0.8, 0.2]
//! shading = "smooth"
//! ```
//!
//! `docs/effects.md` lists all keys. Unknown keys are refused.

mod faces;
mod list;
mod pattern;
mod sequence;
mod sun;

use std::path::Path;

use diagnostics::{Problem, ProblemList, Problems, Reader, TomlFile};
use limits::Limit;
use quantities::Rate;

use crate::group::Group;
use crate::priority::check_priorities;
use crate::warning::Warning;

/// Format number of effect files that this code reads.
const FORMAT: u64 = 1;

/// What an effect file is read for.
#[derive(Debug, Clone, Copy)]
pub struct Setting<'a> {
    /// Frames of a second: suns must not turn more than half a turn a frame.
    pub frames: Rate,
    /// Names of the signals that may drive sequences.
    pub signals: &'a [&'a str],
    /// Largest number of faces in one list.
    pub most: usize,
}

/// An effect: lists of faces, each with its priority.
#[derive(Debug, Clone, PartialEq)]
pub struct Effect {
    /// Title of one line.
    pub title: String,
    /// What it shows, in one line.
    pub about: String,
    /// Its lists, no two of the same priority.
    pub groups: Vec<Group>,
    /// What the user should know of it.
    pub warnings: Vec<Warning>,
}

impl Effect {
    /// Reads the effect file at `path`.
    ///
    /// # Errors
    /// Every fault with its place.
    pub fn read(path: &Path, setting: Setting) -> Result<Self, ProblemList> {
        let name = path.display().to_string();
        let bytes = files::read_all(path, Limit::TextBytes)
            .map_err(|error| Problem::of_file(&name, error.to_string()))?;
        Self::parse(&name, &bytes, setting)
    }

    /// The same of bytes in hand; `name` is the path as the user gave it.
    ///
    /// # Errors
    /// As [`Effect::read`].
    pub fn parse(name: &str, bytes: &[u8], setting: Setting) -> Result<Self, ProblemList> {
        let problems = Problems::new();
        let file = TomlFile::parse_bytes(name, bytes, &problems);
        let effect = file.as_ref().and_then(|file| read(&file.root(&problems), setting));
        problems.resolve(effect)
    }
}

fn read(root: &Reader, setting: Setting) -> Option<Effect> {
    if !root.format_version(FORMAT) {
        return None;
    }
    let (title, about) = (root.string("title").required(), root.string("about").required());
    let tables = root.tables("group");
    if tables.is_empty() && !root.has("group") {
        root.report(root.problem("group", "an effect without a list").expected("a table [[group]] or more"));
    }
    let mut warnings = Vec::new();
    let read = |table: &Reader| list::group(table, setting, &mut warnings);
    let groups: Vec<Option<Group>> = tables.iter().map(read).collect();
    root.finish();
    let groups = groups.into_iter().collect::<Option<Vec<Group>>>()?;
    let priorities = groups.iter().map(|group| (group.name.as_str(), group.priority));
    if let Err(error) = check_priorities(priorities) {
        root.report(root.problem("group", error.to_string()));
    }
    Some(Effect { title: title?, about: about?, groups, warnings })
}
