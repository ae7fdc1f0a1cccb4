//! The generator: what it is called, what it counts, and what its pictures follow from.

use generator::{
    Counter, Generator, Joined, PlaneKind, PrepareError, Scan, Session as GeneratorSession, Stage, Timed,
};
use scenario::View;
use scene_sampler::{PLANES, pixel_scan};
use serde_json::Value;
use signal::Signal;

use crate::name::NAME;
use crate::parameters::{Clock, Parameters};
use crate::session::Session;
use crate::signals::{COLUMN, SIGNALS};
use crate::time::{Hardware, Job};

/// The generator of tiles; see the crate's data sheet.
#[derive(Debug, Clone, PartialEq)]
pub struct LodMesh {
    /// Run parameters that decide its pictures.
    pub parameters: Parameters,
    /// Computer and graphics board that it runs on: how long frames take, and how many slots there are.
    pub hardware: Hardware,
}

const fn counter(name: &'static str) -> Counter {
    Counter { name, joined: Joined::Sum }
}

/// What a frame took and lost.
const COUNTERS: [Counter; 13] = [
    counter("tiles"),
    counter("visits"),
    counter("vertices"),
    counter("morphing"),
    counter("ground_triangles"),
    counter("cracked_edges"),
    counter("repeated"),
    counter("faces"),
    counter("triangles"),
    counter("entries"),
    counter("lights"),
    counter("lost_surfaces"),
    counter("lost_lights"),
];

impl Generator for LodMesh {
    fn name(&self) -> &'static str {
        NAME
    }

    fn counters(&self) -> &'static [Counter] {
        &COUNTERS
    }

    fn planes(&self) -> &'static [PlaneKind] {
        &PLANES
    }

    fn signals(&self) -> &'static [Signal] {
        &SIGNALS
    }

    fn scan(&self, view: &View) -> Option<Scan> {
        pixel_scan(view, COLUMN)
    }

    fn draws_colour(&self, stage: &Stage) -> bool {
        stage.is_colourful() || self.parameters.show != crate::Show::Light
    }

    fn remembers_frames(&self) -> bool {
        self.parameters.clock == Clock::RealTime
    }

    fn timing_remembers_frames(&self) -> bool {
        true
    }

    fn has_deadlines(&self) -> bool {
        true
    }

    fn record(&self) -> Value {
        let mut record = self.parameters.record();
        record["uniform_slots"] = self.hardware.board.uniform_slots.into();
        if self.remembers_frames() {
            record["viewer"] = self.hardware.record();
        }
        record
    }

    fn prepare(&self, stage: Stage) -> Result<Box<dyn GeneratorSession>, PrepareError> {
        Ok(Box::new(Session::new(stage, self.parameters.clone(), self.hardware)?))
    }

    fn timed(&self, stage: Stage) -> Result<Option<Box<dyn Timed>>, PrepareError> {
        Ok(Some(Box::new(Job::new(stage, self.parameters.clone(), self.hardware)?)))
    }
}
