//! Deliberate breaks of the code, each of which some test must notice: `awake/breaks.toml`.

use std::path::{Path, PathBuf};

use serde::Deserialize;

/// One break: a piece of text of one file, replaced by another.
#[derive(Debug, Clone, PartialEq, Eq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Break {
    /// Short name, unlike that of any other.
    pub name: String,
    /// What is wrong with the machine then, one sentence.
    pub what: String,
    /// The file it is in, from the root of the workspace.
    pub file: PathBuf,
    /// What is replaced: it stands in the file once.
    pub find: String,
    /// What is put in its place.
    pub replace: String,
    /// Arguments of `cargo test`, a line for each run, narrowest first. No golden picture is among them.
    pub tests: Vec<String>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct List {
    #[serde(rename = "break")]
    breaks: Vec<Break>,
}

/// The root of the workspace.
pub fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// All breaks in the order of the list of the checkout at `root`; an error says what is wrong with the list.
pub fn breaks(root: &Path) -> Result<Vec<Break>, String> {
    let path = root.join("tests/awake/breaks.toml");
    let text = std::fs::read_to_string(&path).map_err(|error| format!("{}: {error}", path.display()))?;
    let List { breaks } = toml::from_str(&text).map_err(|error| format!("{}: {error}", path.display()))?;
    Ok(breaks)
}

impl Break {
    /// The text of its file in the checkout at `root`, before the break and after it.
    pub fn texts(&self, root: &Path) -> Result<[String; 2], String> {
        let at = format!("break {}: {}", self.name, self.file.display());
        let before =
            std::fs::read_to_string(root.join(&self.file)).map_err(|error| format!("{at}: {error}"))?;
        match before.matches(&self.find).count() {
            1 => {
                let after = before.replace(&self.find, &self.replace);
                Ok([before, after])
            }
            times => Err(format!("{at}: `find` stands in it {times} times, expected once; mend the list")),
        }
    }
}
