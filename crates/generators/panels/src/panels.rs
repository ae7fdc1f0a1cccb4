//! The generator: what it is called, what it counts, and what its pictures follow from.

use generator::{
    Counter, Generator, Joined, PlaneKind, PrepareError, Scan, Session as GeneratorSession, Stage, Timed,
};
use scenario::View;
use scene_sampler::PLANES;
use serde_json::Value;
use signal::Signal;

use crate::name::NAME;
use crate::parameters::Parameters;
use crate::program::{PLANES as PROGRAM_PLANES, ProgramSession};
use crate::session::Session;
use crate::signals::{self, SIGNALS};
use crate::time::{Hardware, Job};

/// The generator of panels; see the crate's data sheet.
#[derive(Debug, Clone, PartialEq)]
pub struct Panels {
    /// Run parameters that decide its pictures.
    pub parameters: Parameters,
    /// The computer that the program of the thesis ran on.
    pub hardware: Hardware,
}

const fn counter(name: &'static str) -> Counter {
    Counter { name, joined: Joined::Sum }
}

/// What a frame took and lost.
const COUNTERS: [Counter; 8] = [
    counter("panels"),
    counter("faces"),
    counter("triangles"),
    counter("entries"),
    counter("lights"),
    counter("lost_surfaces"),
    counter("lost_lights"),
    counter("unseen_panels"),
];

/// What a frame of the program took and lost.
const PROGRAM_COUNTERS: [Counter; 4] =
    [counter("panels"), counter("triangles"), counter("discarded_panels"), counter("lost_panels")];

impl Generator for Panels {
    fn name(&self) -> &'static str {
        NAME
    }

    fn counters(&self) -> &'static [Counter] {
        if self.parameters.program.draws() { &PROGRAM_COUNTERS } else { &COUNTERS }
    }

    fn planes(&self) -> &'static [PlaneKind] {
        if self.parameters.program.draws() { &PROGRAM_PLANES } else { &PLANES }
    }

    fn draws_colour(&self, stage: &Stage) -> bool {
        stage.is_colourful() && !self.parameters.program.draws()
    }

    fn signals(&self) -> &'static [Signal] {
        &SIGNALS
    }

    fn scan(&self, view: &View) -> Option<Scan> {
        signals::scan(view)
    }

    fn record(&self) -> Value {
        self.parameters.record()
    }

    fn prepare(&self, stage: Stage) -> Result<Box<dyn GeneratorSession>, PrepareError> {
        if self.parameters.program.draws() {
            return Ok(Box::new(ProgramSession::new(stage, &self.parameters)?));
        }
        Ok(Box::new(Session::new(stage, self.parameters.clone())?))
    }

    /// The fill of the listing takes time; no other way to draw does.
    fn timed(&self, stage: Stage) -> Result<Option<Box<dyn Timed>>, PrepareError> {
        if !self.parameters.program.restrictions.both_ends {
            return Ok(None);
        }
        Ok(Some(Box::new(Job::new(stage, self.parameters.clone(), self.hardware)?)))
    }
}
