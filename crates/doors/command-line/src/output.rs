//! Standard output: results, and nothing else.

use std::env;
use std::fs;
use std::io::{self, IsTerminal, Write};
use std::path::{self, Path, PathBuf};

use clap::ValueEnum;
use files::{Kind, Temporary, expect_output, remove_leftovers_of};
use serde_json::Value;
use text::{visible, visible_json};

use crate::Failure;

/// When messages have colour.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Colour {
    /// On a terminal that can.
    Auto,
    /// Always colour messages, even in a pipe.
    Always,
    /// Never colour messages, not even on a terminal.
    Never,
}

impl Colour {
    /// Whether messages on standard error have colour.
    pub fn on_stderr(self) -> bool {
        let is_set = |name| env::var_os(name).is_some_and(|value| !value.is_empty());
        match self {
            Self::Always => true,
            Self::Never => false,
            Self::Auto if is_set("CLICOLOR_FORCE") => true,
            Self::Auto if is_set("NO_COLOR") || env::var_os("TERM").is_some_and(|term| term == "dumb") => {
                false
            }
            Self::Auto => io::stderr().is_terminal(),
        }
    }
}

/// Writes a result, with control characters made visible. A reader that has gone ends the command quietly.
pub fn print(text: &str) -> Result<(), Failure> {
    write(&visible(text))
}

fn write(text: &str) -> Result<(), Failure> {
    let mut out = io::stdout().lock();
    out.write_all(text.as_bytes()).and_then(|()| out.flush()).map_err(Failure::stdout)
}

/// Says something that is no result. Nobody need listen.
pub fn tell(text: &str) {
    let _ = io::stderr().lock().write_all(text.as_bytes());
}

/// Says what is odd, though the command goes on.
pub fn warn(text: &str) {
    tell(&format!("warning: {}\n", visible(text)));
}

/// Writes a JSON document to standard output.
pub fn print_json(document: &Value) -> Result<(), Failure> {
    write(&visible_json(&format!("{document:#}\n")))
}

/// A file that a command reads or writes, or what it has in a folder, and the words for it.
#[derive(Debug, Clone)]
pub struct Place {
    /// The option that names it, or what it is.
    what: &'static str,
    path: PathBuf,
    /// Which names are meant, where it is a folder.
    holds: Option<fn(&str) -> bool>,
    /// What its name may end in, if not in anything.
    endings: &'static [&'static str],
}

/// The kinds of pictures that are drawn.
const DRAWN: [&str; 2] = ["png", "svg"];

impl Place {
    /// A single file that a command reads or writes.
    pub fn file(what: &'static str, path: impl Into<PathBuf>) -> Self {
        Self { what, path: path.into(), holds: None, endings: &[] }
    }

    /// Files in a folder: those whose names, from the folder on and with `/`, are such that `holds`.
    pub fn folder(what: &'static str, path: impl Into<PathBuf>, holds: fn(&str) -> bool) -> Self {
        Self { holds: Some(holds), ..Self::file(what, path) }
    }

    /// The files of those options that are given.
    pub fn given<const N: usize>(options: [(&'static str, &Option<PathBuf>); N]) -> Vec<Self> {
        let file = |(what, path): (&'static str, &Option<PathBuf>)| Some(Self::file(what, path.as_ref()?));
        options.into_iter().filter_map(file).collect()
    }

    /// The pictures of those options that are given: PNG or SVG, as their names end.
    pub fn pictures<const N: usize>(options: [(&'static str, &Option<PathBuf>); N]) -> Vec<Self> {
        Self::given(options).into_iter().map(|place| place.ending_in(&DRAWN)).collect()
    }

    /// A file whose name must end in one of `endings`: nobody would know it by another.
    pub fn ending_in(self, endings: &'static [&'static str]) -> Self {
        Self { endings, ..self }
    }

    /// Whether the name says the kind; a device has none.
    fn expect_ending(&self) -> Result<(), Failure> {
        let (what, path, ending) = (self.what, self.path.display(), ending(&self.path));
        let is_device = || Kind::of(&self.path).is_ok_and(|kind| kind == Kind::Stream);
        if self.endings.is_empty() || is_device() || self.endings.contains(&ending.as_str()) {
            return Ok(());
        }
        let known: Vec<String> = self.endings.iter().map(|known| format!(".{known}")).collect();
        Err(Failure::usage(format!("{what} {path}: expected a name that ends in {}", known.join(" or "))))
    }

    /// Whether one file is in both. A device holds nothing that could be lost.
    fn meets(&self, other: &Self) -> bool {
        match (self.holds, other.holds) {
            (Some(_), Some(_)) => false,
            (None, Some(_)) => other.meets(self),
            _ if other.path.exists() && !other.path.is_file() => false,
            (None, None) => resolved(&self.path) == resolved(&other.path),
            (Some(holds), None) => {
                let (folder, file) = (resolved(&self.path), resolved(&other.path));
                // A file cannot stand where the folder is to be.
                folder.starts_with(&file)
                    || file.strip_prefix(&folder).is_ok_and(|name| holds(&with_slashes(name)))
            }
        }
    }
}

/// What a name ends in, in small letters.
pub fn ending(path: &Path) -> String {
    path.extension().map_or_else(String::new, |ending| ending.to_string_lossy().to_lowercase())
}

/// Where a path leads, whether or not there is something already.
fn resolved(path: &Path) -> PathBuf {
    let path = path::absolute(path).unwrap_or_else(|_| path.to_owned());
    match (fs::canonicalize(&path), path.parent(), path.file_name()) {
        (Ok(found), ..) => found,
        (Err(_), Some(folder), Some(name)) => resolved(folder).join(name),
        _ => path,
    }
}

fn with_slashes(path: &Path) -> String {
    path.iter().map(|part| part.to_string_lossy()).collect::<Vec<_>>().join("/")
}

/// Sees before any work that `outputs` replace none of `inputs` and not one another, that their names say what they are,
/// and that they can be written.
pub fn expect_outputs(outputs: &[Place], inputs: &[Place]) -> Result<(), Failure> {
    inputs.iter().filter(|input| input.holds.is_none()).try_for_each(|input| expect_readable(&input.path))?;
    for (index, output) in outputs.iter().enumerate() {
        let replaced = inputs.iter().chain(&outputs[..index]).find(|other| output.meets(other));
        replaced.map_or(Ok(()), |other| Err(replacement(output, other)))?;
    }
    let mut files = outputs.iter().filter(|output| output.holds.is_none());
    files.try_for_each(|output| expect_writable(&output.path).and_then(|()| output.expect_ending()))
}

fn replacement(output: &Place, other: &Place) -> Failure {
    let [path, replaced] = [output, other].map(|place| place.path.display());
    let part = if other.holds.is_some() { "a file of " } else { "" };
    let kind = if output.holds.is_some() { "folder" } else { "file" };
    let (what, of) = (output.what, other.what);
    Failure::usage(format!("{what} {path}: would replace {part}{of} {replaced}; name another {kind}"))
}

/// What is read is a file, so that no command waits for a pipe that nobody writes. A file that is missing has words of its reader.
fn expect_readable(path: &Path) -> Result<(), Failure> {
    if !path.exists() || path.is_dir() {
        return Ok(());
    }
    Ok(files::open(path).map(drop)?)
}

/// Sees before any work that what stands in a folder under names such that `writes` can be replaced, all of it.
pub fn expect_replaceable(folder: &Path, writes: fn(&str) -> bool) -> Result<(), Failure> {
    if folder.exists() && !folder.is_dir() {
        let why = "this is a file, expected a folder; name another";
        return Err(Failure::output(format!("--out {}: {why}", folder.display())));
    }
    let entries = fs::read_dir(folder).into_iter().flatten().flatten();
    let mut ours: Vec<PathBuf> = entries
        .filter(|entry| entry.file_name().to_str().is_some_and(writes))
        .map(|entry| entry.path())
        .collect();
    ours.sort();
    ours.iter().try_for_each(|path| expect_writable(path))
}

fn expect_writable(path: &Path) -> Result<(), Failure> {
    let refused = |why: String| Err(Failure::output(format!("{}: {why}", path.display())));
    if path == Path::new("-") {
        return Err(Failure::usage(
            "-: expected a file name; standard output is /dev/stdout, a file of this name ./-",
        ));
    }
    if path.is_dir() && !path.is_symlink() {
        return refused("this is a folder, expected a file name; name a file inside it".into());
    }
    if expect_output(path)? == Kind::Stream {
        return Ok(());
    }
    if let Err(error) = Temporary::beside(path).map(drop) {
        return refused(format!("cannot write here: {error}; make the folder or choose another place"));
    }
    // What a killed command left of this file goes; whoever may not list the folder leaves it.
    let _ = remove_leftovers_of(path);
    Ok(())
}
