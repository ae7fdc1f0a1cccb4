//! What a loop has drawn: the hash of each frame, and with which settings.

use drive::{Drive, Economy, Scalar, Wishes};
use serde_json::{Value, json};

use crate::Opening;

/// Frames that were drawn with the same settings.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Stretch {
    /// The first of the frames.
    pub from: u64,
    /// As it was asked for.
    pub opening: Opening,
    /// Options of `lunoid replay` that ask for the same.
    pub options: Vec<String>,
}

/// The frames of a loop.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct Log {
    /// Hash of the pixels of each frame.
    pub hashes: Vec<String>,
    /// Stretches in the order of frames, each up to the next.
    pub stretches: Vec<Stretch>,
}

impl Log {
    /// The next frame was drawn by `drive`, which `opening` asked for.
    pub fn step(&mut self, drive: &Drive, opening: &Opening, hash: String) {
        if self.stretches.last().is_none_or(|stretch| stretch.opening != *opening) {
            let (from, options) = (self.hashes.len() as u64, options(drive.wishes()));
            self.stretches.push(Stretch { from, opening: opening.clone(), options });
        }
        self.hashes.push(hash);
    }

    /// The record of what was driven: schema `lunoid.loop.record/1`.
    pub fn record(&self) -> Value {
        let ends = self.stretches.iter().skip(1).map(|stretch| stretch.from);
        let ends = ends.chain([self.hashes.len() as u64]);
        let row = |(stretch, end): (&Stretch, u64)| {
            let frames = format!("{}..{end}", stretch.from);
            let mut words = vec!["lunoid".to_owned(), "replay".into(), "scenario.toml".into()];
            words.extend(stretch.options.iter().cloned());
            words.extend(["--frames".into(), frames]);
            json!({ "frames": [stretch.from, end], "replay": words })
        };
        let stretches: Vec<Value> = self.stretches.iter().zip(ends).map(row).collect();
        json!({ "schema": "lunoid.loop.record/1", "frames": self.hashes.len(), "stretches": stretches,
                "pixels_blake3": self.hashes })
    }
}

/// Options of `lunoid replay` for `wishes`.
fn options(wishes: &Wishes) -> Vec<String> {
    let mut words = Vec::new();
    let mut add = |name: &str, value: String| words.extend([name.to_owned(), value]);
    wishes.machine.iter().for_each(|machine| add("--machine", machine.clone()));
    wishes.overlays.iter().for_each(|overlay| add("--overlay", overlay.display().to_string()));
    wishes.channel.iter().for_each(|channel| add("--channel", channel.clone()));
    wishes.bank.iter().for_each(|bank| add("--bank", bank.display().to_string()));
    wishes.sweeps.iter().for_each(|sweeps| add("--sweeps", sweeps.to_string()));
    wishes.samples.iter().for_each(|samples| add("--samples", samples.to_string()));
    wishes.scalar.iter().for_each(|scalar| add("--scalar", word(*scalar).into()));
    wishes.set.iter().for_each(|(key, value)| add("--set", format!("{key}={value}")));
    words.extend(economy(wishes.economy).map(str::to_owned));
    words
}

/// The word of `lunoid replay` for a scalar type.
fn word(scalar: Scalar) -> &'static str {
    match scalar {
        Scalar::F32 => "f32",
        Scalar::F64 => "f64",
    }
}

/// The option of `lunoid replay` for what may be left out.
fn economy(economy: Economy) -> Option<&'static str> {
    match economy {
        // The default, and what is chosen for a measurement and has no option.
        Economy::Normal | Economy::LosslessBut(_) => None,
        Economy::Bounded => Some("--quality=fine"),
        Economy::Instants(1) => Some("--quality=draft"),
        Economy::Instants(_) => None,
        Economy::Lossless => Some("--lossless"),
        Economy::Everything => Some("--everything"),
    }
}
