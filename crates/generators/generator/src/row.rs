//! The row of a generator in the registry: everything that is known of it before it draws.

use std::sync::Arc;

use diagnostics::Reader;
use signal::Signal;

use crate::Generator;

/// What a generator is for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Role {
    /// It draws by closed form: the pictures of the others are judged by its own.
    Judge,
    /// It draws in a way of its own.
    Guest,
}

/// The machine on which a generator's program ran, as a file of figures.
#[derive(Debug, Clone, Copy)]
pub struct Gear {
    /// Tables of the file.
    pub tables: &'static [&'static str],
    /// Name of the file that ships, for messages.
    pub file: &'static str,
    /// Text of that file.
    pub text: &'static str,
    /// Overlays of one fault each, over run parameters and figures: name and text.
    pub faults: &'static [(&'static str, &'static str)],
}

/// A run parameter over which the error of a generator's pictures is measured, rung by rung.
#[derive(Debug, Clone, Copy)]
pub struct ErrorLadder {
    /// Name of the ladder.
    pub name: &'static str,
    /// What the rungs are, for a heading.
    pub what: &'static str,
    /// Dotted key of the parameter.
    pub key: &'static str,
    /// Its values with how fine each is, the coarsest first; steps are the inverses of that.
    pub rungs: &'static [(&'static str, f64)],
    /// Other keys, each with the value that it has on all rungs.
    pub fixed: &'static [(&'static str, &'static str)],
    /// What the pictures are held against.
    pub against: Against,
    /// Order at which the mean error falls, as theory says, and why; `None` where it says nothing.
    pub order: Option<(f64, &'static str)>,
}

/// What the error of a picture is told against.
#[derive(Debug, Clone, Copy)]
pub enum Against {
    /// The judge, over its own landscape: the whole error.
    Judge,
    /// The generator's own faces, drawn by area: what sampling alone does.
    OwnFaces,
    /// The generator itself with these keys set: what its limits alone do.
    Itself(&'static [(&'static str, &'static str)]),
}

/// A way in which a generator treats levels of detail.
#[derive(Debug, Clone, Copy)]
pub struct DetailWay {
    /// Name of the way.
    pub name: &'static str,
    /// Keys of run parameters, each with the value that makes this way.
    pub sets: &'static [(&'static str, &'static str)],
    /// Whether it differs from another way in the light of the ground alone, so that its distances are those of that way.
    pub is_of_light: bool,
}

/// A way in which a generator draws lamps.
#[derive(Debug, Clone, Copy)]
pub struct LampWay {
    /// Name of the way.
    pub name: &'static str,
    /// Whether a beam of its own draws them, instead of the raster.
    pub is_calligraphic: bool,
    /// Keys of run parameters, each with the value that makes this way.
    pub sets: &'static [(&'static str, &'static str)],
}

/// A generator that is chosen by its own name. The hybrid machine has none: the name of a hardware model chooses it.
#[derive(Debug, Clone, Copy)]
pub struct Row {
    /// Name, as `--machine` says it.
    pub name: &'static str,
    /// What it draws, in one line.
    pub about: &'static str,
    /// What it is for.
    pub role: Role,
    /// The signals that its sessions can record.
    pub signals: &'static [Signal],
    /// Whether its frames take time on a machine of their own, so that they have timing records.
    pub timed: bool,
    /// Table of its run parameters in a scenario and in `--set`, where it has any.
    pub parameters: Option<&'static str>,
    /// What it ran on, where that has figures.
    pub gear: Option<Gear>,
    /// The run parameters that a study of errors varies, ladder by ladder.
    pub ladders: &'static [ErrorLadder],
    /// Its ways with levels of detail, the finest ground alone first; none where it has no levels.
    pub details: &'static [DetailWay],
    /// Its ways to draw lamps; none where it has one alone, or draws none.
    pub lamps: &'static [LampWay],
    /// Reads run parameters and gear, both as tables of one root, into a generator. A missing table is an empty one;
    /// faults are reported to the reader.
    pub configure: fn(&Reader) -> Option<Arc<dyn Generator>>,
}

/// Rows are told apart by their names.
impl PartialEq for Row {
    fn eq(&self, other: &Self) -> bool {
        self.name == other.name
    }
}

impl Eq for Row {}

impl Row {
    /// Whether `key`, a dotted key of `--set`, is of this generator.
    pub fn owns(&self, key: &str) -> bool {
        let Some((table, _)) = key.split_once('.') else { return false };
        self.tables().any(|own| own == table)
    }

    /// The text of the overlay of one fault that is called `name`.
    pub fn fault(&self, name: &str) -> Option<&'static str> {
        let faults = self.gear.map_or(&[][..], |gear| gear.faults);
        faults.iter().find(|(known, _)| *known == name).map(|(_, text)| *text)
    }

    /// The ladders whose pictures are held against the finest ground alone: what levels of detail lose.
    pub fn level_ladders(&self) -> impl Iterator<Item = &'static ErrorLadder> + use<> {
        let finest = self.details.first().map(|way| way.sets);
        let is_of_levels = move |ladder: &&ErrorLadder| match ladder.against {
            Against::Itself(sets) => finest == Some(sets),
            Against::Judge | Against::OwnFaces => false,
        };
        self.ladders.iter().filter(is_of_levels)
    }

    /// Tables of run parameters and gear.
    pub fn tables(&self) -> impl Iterator<Item = &'static str> + use<> {
        let gear = self.gear.map_or(&[][..], |gear| gear.tables);
        self.parameters.into_iter().chain(gear.iter().copied())
    }
}
