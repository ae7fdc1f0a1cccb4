//! What runs a scene.

use serde::de::Error;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

/// What runs a scene.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Engine {
    /// The hybrid machine, its analog signals in f64.
    MachineF64,
    /// The hybrid machine, its analog signals in f32.
    MachineF32,
    /// A generator of the registry, by name.
    Generator(&'static str),
    /// A part by itself, in f64: scenes that show no picture.
    Part,
}

impl Engine {
    /// All engines, the machine first.
    pub fn all() -> Vec<Self> {
        let generators = registry::names().into_iter().map(Self::Generator);
        [Self::MachineF64, Self::MachineF32].into_iter().chain(generators).chain([Self::Part]).collect()
    }

    /// Its word in files.
    pub fn word(self) -> &'static str {
        match self {
            Self::MachineF64 => "machine-f64",
            Self::MachineF32 => "machine-f32",
            Self::Generator(name) => name,
            Self::Part => "part",
        }
    }

    /// Whether its signals can be read: those of the hybrid machine.
    pub fn has_signals(self) -> bool {
        matches!(self, Self::MachineF64 | Self::MachineF32)
    }

    /// Whether it is the generator that the pictures of the others are judged by.
    pub fn is_judge(self) -> bool {
        self == Self::Generator(registry::judge().name)
    }
}

impl<'de> Deserialize<'de> for Engine {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let (word, known) = (String::deserialize(deserializer)?, Self::all());
        known.iter().copied().find(|engine| engine.word() == word).ok_or_else(|| {
            let words: Vec<&str> = known.iter().map(|engine| engine.word()).collect();
            D::Error::custom(format!("unknown engine `{word}`, expected one of {}", words.join(", ")))
        })
    }
}

impl Serialize for Engine {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.word())
    }
}

#[cfg(test)]
impl schemars::JsonSchema for Engine {
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "Engine".into()
    }

    fn json_schema(_: &mut schemars::SchemaGenerator) -> schemars::Schema {
        let words: Vec<&str> = Self::all().into_iter().map(Self::word).collect();
        schemars::json_schema!({
            "description": "What runs a scene: the hybrid machine by scalar, a generator by name, or a part by itself.",
            "type": "string",
            "enum": words,
        })
    }
}
