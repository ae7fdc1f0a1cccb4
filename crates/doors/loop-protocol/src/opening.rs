//! What is asked for when a scenario is opened, and who opens it.

use std::collections::BTreeMap;

use diagnostics::Problem;
use drive::{Drive, DriveError, Loop, Program, SavedFile, Wishes};
use serde_json::{Map, Value, json};

use crate::Plane;
use crate::keys::NAME;

/// A scenario and the wishes over it, as a request names them.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Opening {
    /// Path of the scenario; what the host of the session has, if left out.
    pub scenario: Option<String>,
    /// Hardware model or generator; the host's or the scenario's own, if left out.
    pub machine: Option<String>,
    /// Overlays over the hardware model, behind those of the host.
    pub overlays: Vec<String>,
    /// Channel that is looked through; the host's if left out.
    pub channel: Option<String>,
    /// Keys and their values as TOML, over everything else.
    pub set: BTreeMap<String, String>,
}

impl Opening {
    /// The wishes of this opening over `base`, those of the host.
    pub fn over(&self, base: &Wishes) -> Wishes {
        let mut wishes = base.clone();
        wishes.machine = self.machine.clone().or(wishes.machine);
        wishes.channel = self.channel.clone().or(wishes.channel);
        wishes.overlays.extend(self.overlays.iter().map(Into::into));
        wishes.set.retain(|(key, _)| !self.set.contains_key(key));
        wishes.set.extend(self.set.clone());
        wishes
    }

    /// The opening as JSON.
    pub(crate) fn json(&self) -> Value {
        let Self { scenario, machine, overlays, channel, set } = self;
        json!({ "scenario": scenario, "machine": machine, "overlays": overlays, "channel": channel, "set": set })
    }

    /// The opening of [`json`](Self::json); `None` if it is none.
    pub(crate) fn of_json(value: &Value) -> Option<Self> {
        let map = value.as_object().filter(|map| map.len() == 5)?;
        let text = |value: &Value| value.as_str().map(str::to_owned);
        let optional = |key: &str| match map.get(key)? {
            Value::Null => Some(None),
            value => text(value).map(Some),
        };
        let set: &Map<String, Value> = map.get("set")?.as_object()?;
        Some(Self {
            scenario: optional("scenario")?,
            machine: optional("machine")?,
            overlays: map.get("overlays")?.as_array()?.iter().map(text).collect::<Option<_>>()?,
            channel: optional("channel")?,
            set: set.iter().map(|(key, value)| Some((key.clone(), text(value)?))).collect::<Option<_>>()?,
        })
    }
}

/// Where a session lives: who opens scenarios and keeps records for it.
pub trait Home {
    /// The program that draws: a state of another one is not taken up. A host that does not say otherwise is known by its version alone.
    fn program(&self) -> Program {
        let [commit, result_family] = ["unknown"; 2].map(str::to_owned);
        Program { name: "lunoid".into(), version: env!("CARGO_PKG_VERSION").into(), commit, result_family }
    }

    /// Takes the files that a request `open` has as planes: name and bytes of each. They stay for later openings. A host that does not say
    /// otherwise refuses them.
    ///
    /// # Errors
    /// If the host takes no such files.
    fn give(&mut self, files: &[Plane]) -> Result<(), DriveError> {
        let Some(file) = files.first() else { return Ok(()) };
        let problem = Problem::of_file(NAME, "files are not taken here").found(format!("`{}`", file.name()));
        Err(problem.expected("no planes").help("name a scenario by its path").into())
    }

    /// Opens what is asked for.
    ///
    /// # Errors
    /// Every fault of the files and the wishes; or if the host does not open such a scenario.
    fn open(&mut self, asked: &Opening) -> Result<Drive, DriveError>;

    /// Keeps what was driven, with `more` files, under `name`, or under a name that is free if it is left out. Returns where it is; `None` if the
    /// host keeps nothing: then the client gets the files.
    ///
    /// # Errors
    /// If it cannot be kept.
    fn keep(
        &mut self,
        _driven: &Loop,
        _name: Option<&str>,
        _more: &[SavedFile],
    ) -> Result<Option<String>, DriveError> {
        Ok(None)
    }
}
