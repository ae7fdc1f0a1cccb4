//! The generator: what it is called, what it counts, and what its pictures follow from.

use generator::{
    Along, Counter, Generator, Joined, PlaneKind, PrepareError, Scan, Session as GeneratorSession, Stage,
    Timed,
};
use scenario::View;
use serde_json::{Value, json};
use signal::Signal;

use crate::hardware::Hardware;
use crate::parameters::Parameters;
use crate::row::NAME;
use crate::rows;
use crate::session::Session;
use crate::timed::Clocked;

/// The sampled generator; see the crate's data sheet.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sampled {
    /// Run parameters that decide its pictures.
    pub parameters: Parameters,
    /// What it runs on.
    pub hardware: Hardware,
}

const fn counter(name: &'static str) -> Counter {
    Counter { name, joined: Joined::Sum }
}

/// Those of the picture, and the map of what was lost.
const PLANES: [PlaneKind; 8] = {
    let [a, b, c, d, e, f, g] = scene_sampler::PLANES;
    [a, b, c, d, e, f, g, PlaneKind::Overload]
};

/// What a frame took and lost.
const COUNTERS: [Counter; 14] = [
    Counter { name: "ground_cells", joined: Joined::Largest },
    counter("faces"),
    counter("triangles"),
    counter("entries"),
    counter("lights"),
    counter("calligraphic"),
    counter("lost_surfaces"),
    counter("lost_lights"),
    counter("lost_entries"),
    counter("lost_points"),
    counter("beam_dropped"),
    counter("late_sub_areas"),
    counter("repeated"),
    Counter { name: "loss_bound_ppm", joined: Joined::Largest },
];

impl Generator for Sampled {
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
        &rows::SIGNALS
    }

    fn scan(&self, view: &View) -> Option<Scan> {
        let timebase = rows::timebase(view)?;
        Some(Scan { line: "row", timebase, place: rows::ACROSS, along: Along::Across { ahead: rows::AHEAD } })
    }

    fn draws_colour(&self, stage: &Stage) -> bool {
        stage.is_colourful()
    }

    fn remembers_frames(&self) -> bool {
        self.parameters.overload.shows_earlier_frames()
    }

    fn has_deadlines(&self) -> bool {
        true
    }

    fn record(&self) -> Value {
        let Self { parameters: run, hardware: Hardware { memory, beam, .. } } = self;
        let mut record = run.sampling.record();
        let own = [
            ("ground_half_side_m", json!(run.ground_half_side)),
            ("ground_cells", json!(run.ground_cells)),
            ("ground_error_px", json!(run.ground_error)),
            ("overload", json!(run.overload.word())),
            ("list_entries", json!(memory.list_entries)),
            ("list_depth", json!(memory.list_depth)),
            ("points", json!(memory.points)),
            ("jump_us", json!(beam.jump_ns as f64 / 1e3)),
            ("dwell_us", json!(beam.dwell_ns as f64 / 1e3)),
        ];
        own.into_iter().for_each(|(key, value)| record[key] = value);
        if self.remembers_frames() {
            record["sampler"] = self.hardware.sampler_record();
        }
        record
    }

    fn prepare(&self, stage: Stage) -> Result<Box<dyn GeneratorSession>, PrepareError> {
        Ok(Box::new(Session::new(stage, self.parameters, self.hardware)?))
    }

    fn timed(&self, stage: Stage) -> Result<Option<Box<dyn Timed>>, PrepareError> {
        Ok(Some(Box::new(Clocked::new(stage, self.parameters, self.hardware)?)))
    }
}
