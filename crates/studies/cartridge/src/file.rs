//! `cartridge.toml`: what it may say, and what is wrong with it.

use std::collections::BTreeSet;

use serde::Deserialize;
use toml::{Table, Value};

use crate::engine::Engine;
use crate::reading::Reading;
use crate::scene::{CartridgeScene, Case};

/// Number of the format.
const FORMAT: u32 = 2;

/// A cartridge as a file. Every key is strict: none may be added.
#[derive(Debug, Clone, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[cfg_attr(test, schemars(rename = "Cartridge"))]
#[serde(deny_unknown_fields)]
pub(crate) struct File {
    /// Version of the file format: 2.
    #[cfg_attr(test, schemars(range(min = 2, max = 2)))]
    format: u32,
    /// What it shows, for people.
    title: String,
    /// The scene that is run.
    scene: CartridgeScene,
    /// The answers, at least one.
    #[cfg_attr(test, schemars(length(min = 1)))]
    expect: Vec<Expect>,
    /// Changes under which at least one answer must not come out, at least one.
    #[cfg_attr(test, schemars(length(min = 1)))]
    must_fail: Vec<Overlay>,
}

/// A scene whose answer is known.
#[derive(Debug, Clone)]
pub struct Cartridge {
    /// Name of its folder.
    pub name: String,
    /// What the cartridge shows, for people.
    pub title: String,
    pub(crate) cases: Vec<Case>,
    pub(crate) expect: Vec<Expect>,
    pub(crate) must_fail: Vec<(Overlay, Vec<Case>)>,
}

/// One answer that the scene must give.
#[derive(Debug, Clone, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub(crate) struct Expect {
    /// What is read, and what it should be.
    pub read: Reading,
    /// How far off it may be, in the unit of the reading.
    pub tolerance: f64,
    /// Why it may be off so far.
    pub because: String,
    /// Where the answer comes from.
    pub derivation: String,
    /// What it holds for.
    pub engines: Vec<Engine>,
}

/// A change of the scene. The answers stay those of the unchanged scene.
#[derive(Debug, Clone, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub(crate) struct Overlay {
    /// The keys that change, table by table; lists are replaced as a whole.
    #[cfg_attr(test, schemars(with = "serde_json::Map<String, serde_json::Value>"))]
    pub scene: Table,
    /// What the change is.
    pub because: String,
    /// On which of them it must show.
    pub engines: Vec<Engine>,
}

/// A cartridge that cannot be run.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{place}: {message}")]
pub struct CartridgeError {
    /// Path of the file.
    pub place: String,
    /// What is wrong in it, what was expected.
    pub message: String,
}

impl Cartridge {
    /// Reads a file; `place` is how messages call it.
    ///
    /// # Errors
    /// Unknown or missing keys, another format, numbers that fit nothing, readings or engines that do not belong to the
    /// scene, no overlay to fail on.
    pub fn parse(name: &str, place: &str, text: &str) -> Result<Self, CartridgeError> {
        let refuse = |message: String| CartridgeError { place: place.to_owned(), message };
        // By hand first: a file of another format has other keys.
        let table: Table = toml::from_str(text).map_err(|error| refuse(one_line(&error)))?;
        match table.get("format") {
            Some(Value::Integer(format)) if *format == i64::from(FORMAT) => {}
            Some(other) => return Err(refuse(format!("format = {other}: expected {FORMAT}"))),
            None => return Err(refuse(format!("no key `format`: expected format = {FORMAT}"))),
        }
        finite("", &Value::Table(table.clone())).map_err(refuse)?;
        let file: File = toml::from_str(text).map_err(|error| refuse(one_line(&error)))?;
        let scene = table.get("scene").and_then(Value::as_table).cloned().unwrap_or_default();
        file.resolve(name, &scene).map_err(refuse)
    }

    /// What the answers hold for, in the order of [`Engine::all`].
    pub fn engines(&self) -> BTreeSet<Engine> {
        self.expect.iter().flat_map(|expect| expect.engines.iter().copied()).collect()
    }
}

impl File {
    fn resolve(self, name: &str, table: &Table) -> Result<Cartridge, String> {
        debug_assert_eq!(self.format, FORMAT);
        if self.expect.is_empty() || self.must_fail.is_empty() {
            return Err("expected at least one [[expect]] and one [[must_fail]]".into());
        }
        for (index, expect) in self.expect.iter().enumerate() {
            expect.check(&self.scene).map_err(|error| format!("expect {}: {error}", index + 1))?;
        }
        let cases = self.scene.cases().map_err(|error| format!("scene: {error}"))?;
        let all: BTreeSet<Engine> =
            self.expect.iter().flat_map(|expect| expect.engines.iter().copied()).collect();
        let laid = |(index, overlay): (usize, Overlay)| {
            let laid = overlay.cases(table, &cases, &all);
            laid.map(|cases| (overlay, cases)).map_err(|error| format!("must_fail {}: {error}", index + 1))
        };
        let must_fail: Result<Vec<_>, String> = self.must_fail.into_iter().enumerate().map(laid).collect();
        let must_fail = must_fail?;
        Ok(Cartridge { name: name.into(), title: self.title, cases, expect: self.expect, must_fail })
    }
}

impl Expect {
    fn check(&self, scene: &CartridgeScene) -> Result<(), String> {
        let label = self.read.label();
        if !self.read.is_for(scene) {
            return Err(format!("`{label}` cannot be read off a scene of kind \"{}\"", scene.kind()));
        }
        if self.tolerance < 0.0 {
            return Err(format!("tolerance = {}: expected 0 or more", self.tolerance));
        }
        if self.engines.is_empty() {
            return Err("engines = []: expected at least one".into());
        }
        for &engine in &self.engines {
            let has_signals = engine.has_signals() || !self.read.needs_signals();
            if !scene.is_for(engine) || !has_signals {
                return Err(format!("`{label}` cannot be read off the engine \"{}\"", engine.word()));
            }
        }
        let known = signal_plane::signals();
        match self.read.signals().into_iter().find(|name| !known.iter().any(|signal| signal.name == *name)) {
            Some(name) => Err(format!("the machine has no signal `{name}`; see lunoid signals")),
            None => Ok(()),
        }
    }
}

impl Overlay {
    /// The runs of the scene with this laid over it: as many as without.
    fn cases(&self, scene: &Table, meant: &[Case], all: &BTreeSet<Engine>) -> Result<Vec<Case>, String> {
        if self.engines.is_empty() || !self.engines.iter().all(|engine| all.contains(engine)) {
            return Err("engines: expected some of those that the answers hold for".into());
        }
        let mut table = scene.clone();
        lay(&self.scene, &mut table);
        let scene: CartridgeScene = table.try_into().map_err(|error| one_line(&error))?;
        let cases = scene.cases()?;
        if let Some((meant, changed)) =
            meant.iter().zip(&cases).find(|(meant, case)| meant.size() != case.size())
        {
            return Err(format!(
                "a picture of {:?} instead of {:?} pixels: expected the same raster",
                changed.size().unwrap_or_default(),
                meant.size().unwrap_or_default()
            ));
        }
        match cases.len() == meant.len() {
            true => Ok(cases),
            false => Err(format!(
                "{} runs instead of {}: expected the same headings and models",
                cases.len(),
                meant.len()
            )),
        }
    }
}

fn lay(overlay: &Table, table: &mut Table) {
    for (key, value) in overlay {
        match (value, table.get_mut(key)) {
            (Value::Table(overlay), Some(Value::Table(below))) => lay(overlay, below),
            _ => {
                table.insert(key.clone(), value.clone());
            }
        }
    }
}

/// TOML has words for what is no number.
fn finite(key: &str, value: &Value) -> Result<(), String> {
    match value {
        Value::Float(number) if !number.is_finite() => Err(format!("{key} = {number}: expected a number")),
        Value::Array(values) => values.iter().try_for_each(|value| finite(key, value)),
        Value::Table(table) => {
            let below = |name: &String| if key.is_empty() { name.clone() } else { format!("{key}.{name}") };
            table.iter().try_for_each(|(name, value)| finite(&below(name), value))
        }
        _ => Ok(()),
    }
}

/// The message of the reader of TOML, its drawing of the line left out.
fn one_line(error: &toml::de::Error) -> String {
    let text = error.to_string();
    let place = text.lines().next().and_then(|line| line.strip_prefix("TOML parse error at "));
    match place {
        Some(place) => format!("{place}: {}", error.message().replace('\n', "; ")),
        None => error.message().replace('\n', "; "),
    }
}
