//! The generator: what it is called, what it counts, and what its pictures follow from.

use generator::{
    Counter, Generator, Joined, PlaneKind, PrepareError, Scan, Session as GeneratorSession, Stage, Timed,
};
use scenario::View;
use serde_json::{Value, json};
use signal::Signal;

use crate::hardware::Hardware;
use crate::parameters::Parameters;
use crate::picture::PLANES;
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
        PLANES
    }

    fn signals(&self) -> &'static [Signal] {
        &rows::SIGNALS
    }

    fn scan(&self, view: &View) -> Option<Scan> {
        let timebase = rows::timebase(view)?;
        Some(Scan { line: "row", timebase, place: rows::ACROSS, ahead: Some(rows::AHEAD) })
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
        let mut record = json!({
            "pattern": run.pattern.name(),
            "rotate": run.rotate,
            "filter": format!("{:?}", run.filter).to_lowercase(),
            "translucent": run.translucent,
            "lights": run.lights,
            "shared_stack": run.shared_stack,
            "least_diameter_px": run.least_diameter,
            "normalise": run.normalise,
            "blending": format!("{:?}", run.blending).to_lowercase(),
            "veil": format!("{:?}", run.veil).to_lowercase(),
            "spot_px": run.spot,
            "beam_order": format!("{:?}", run.beam_order).to_lowercase(),
            "beam_layer": format!("{:?}", run.beam_layer).to_lowercase(),
            "ground_half_side_m": run.ground_half_side,
            "ground_cells": run.ground_cells,
            "ground_error_px": run.ground_error,
            "overload": run.overload.word(),
            "list_entries": memory.list_entries,
            "list_depth": memory.list_depth,
            "points": memory.points,
            "jump_us": beam.jump_ns as f64 / 1e3,
            "dwell_us": beam.dwell_ns as f64 / 1e3,
        });
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
