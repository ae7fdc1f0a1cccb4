//! The hybrid machine as a generator.

use control_plane::{ControlPlane, MachineStage, scan};
use generator::{Along, Counter, Generator, PrepareError, Scan, Session, Stage, Timed};
use hardware_model::{MachineRecord, Settings};
use scenario::View;
use serde_json::{Value, json};
use signal::Signal;
use signal_plane::signals;

use picture_tube::{PictureTube, ScanRaster, TUBE_VIDEO};

use crate::counts::COUNTERS;
use crate::prepare::Prepare;

/// The hybrid machine of the report, made of the parts that its settings name.
#[derive(Debug, Clone, PartialEq)]
pub struct HybridMachine {
    settings: Settings,
}

impl HybridMachine {
    /// The machine of these settings.
    pub fn new(settings: Settings) -> Self {
        Self { settings }
    }
}

impl Generator for HybridMachine {
    fn name(&self) -> &'static str {
        "hybrid"
    }

    fn counters(&self) -> &'static [Counter] {
        COUNTERS
    }

    fn signals(&self) -> &'static [Signal] {
        signals()
    }

    fn scan(&self, _: &View) -> Option<Scan> {
        Some(scan(&self.settings))
    }

    fn line_signals(&self) -> &'static [Signal] {
        picture_tube::SIGNALS
    }

    fn line_scan(&self) -> Option<Scan> {
        let lines = PictureTube::of(&self.settings).lines_scanned();
        let timebase = ScanRaster::clocks(&self.settings, lines).ok()?;
        Some(Scan { line: "line", timebase, place: TUBE_VIDEO, along: Along::Raster })
    }

    fn record(&self) -> Value {
        json!(MachineRecord::of(&self.settings))
    }

    fn prepare(&self, stage: Stage) -> Result<Box<dyn Session>, PrepareError> {
        Ok(MachineStage::new(stage, self.settings.clone())?.prepare())
    }

    fn timed(&self, stage: Stage) -> Result<Option<Box<dyn Timed>>, PrepareError> {
        let stage = MachineStage::new(stage, self.settings.clone())?;
        Ok(Some(Box::new(ControlPlane::of_timing(stage))))
    }
}
