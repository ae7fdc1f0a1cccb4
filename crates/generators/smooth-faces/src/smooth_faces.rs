//! The generator: what it is called, what it counts, and what its pictures follow from.

use generator::{
    Counter, Generator, Joined, PlaneKind, PrepareError, Scan, Session as GeneratorSession, Stage, Timed,
};
use scenario::View;
use serde_json::Value;
use signal::Signal;

use crate::hardware::Hardware;
use crate::name::NAME;
use crate::parameters::Parameters;
use crate::planes::PLANES;
use crate::session::Session;
use crate::signals::{self, SIGNALS};
use crate::timed::Clocked;

/// The generator of smooth-shaded faces; see the crate's data sheet.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SmoothFaces {
    /// Run parameters that decide its pictures.
    pub parameters: Parameters,
    /// What it runs on.
    pub hardware: Hardware,
}

const fn sum(name: &'static str) -> Counter {
    Counter { name, joined: Joined::Sum }
}

/// What a frame took and lost.
const COUNTERS: [Counter; 13] = [
    sum("lists"),
    sum("faces"),
    sum("pieces"),
    sum("crossings"),
    Counter { name: "most_crossings", joined: Joined::Largest },
    sum("missed"),
    sum("fallen_levels"),
    sum("lost_faces"),
    sum("late"),
    sum("suns"),
    sum("words"),
    sum("clamped"),
    sum("disagreements"),
];

impl Generator for SmoothFaces {
    fn name(&self) -> &'static str {
        NAME
    }

    fn counters(&self) -> &'static [Counter] {
        &COUNTERS
    }

    fn planes(&self) -> &'static [PlaneKind] {
        &PLANES
    }

    fn draws_colour(&self, stage: &Stage) -> bool {
        stage.is_colourful() || !stage.scenery.face_lists().is_empty()
    }

    fn signals(&self) -> &'static [Signal] {
        &SIGNALS
    }

    fn scan(&self, view: &View) -> Option<Scan> {
        signals::scan(view, self.parameters.scan)
    }

    /// A delayed picture is of a pose before its own.
    fn remembers_frames(&self) -> bool {
        self.parameters.delayed && self.hardware.delay_frames > 0
    }

    fn has_deadlines(&self) -> bool {
        true
    }

    fn record(&self) -> Value {
        let mut record = self.parameters.record();
        record["gear"] = self.hardware.record();
        record
    }

    fn prepare(&self, stage: Stage) -> Result<Box<dyn GeneratorSession>, PrepareError> {
        Ok(Box::new(Session::new(stage, self.parameters, self.hardware)?))
    }

    fn timed(&self, stage: Stage) -> Result<Option<Box<dyn Timed>>, PrepareError> {
        Ok(Some(Box::new(Clocked::new(stage, self.parameters, self.hardware)?)))
    }
}
