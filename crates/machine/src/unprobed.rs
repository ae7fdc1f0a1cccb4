//! The machine without probes: what probing nothing is measured against (`crates/benchmarks`).

use generator::{FrameCounts, FrameError, Generator, Omission, Planes, PrepareError, Session, Stage};
use scenario::{Pose, Scalar};
use signal::{Probe, Real, Signal, Wire};

use crate::session::Elaborated;

/// The hybrid machine compiled without a word about probes. It has no signals, and records nothing.
#[derive(Debug, Clone, Copy, Default)]
pub struct UnprobedMachine;

struct Unprobed<S>(Elaborated<S>);

impl Generator for UnprobedMachine {
    fn name(&self) -> &'static str {
        "hybrid, without probes"
    }

    fn signals(&self) -> &'static [Signal] {
        &[]
    }

    fn is_machine(&self) -> bool {
        true
    }

    fn prepare(&self, stage: Stage) -> Result<Box<dyn Session>, PrepareError> {
        Ok(match stage.settings.scalar {
            Scalar::F32 => Box::new(Unprobed(Elaborated::<f32>::new(stage))),
            Scalar::F64 => Box::new(Unprobed(Elaborated::<f64>::new(stage))),
        })
    }
}

impl<S: Real> Session for Unprobed<S> {
    fn frame(
        &self,
        frame: u64,
        pose: &Pose,
        planes: &mut Planes,
        _probe: &mut Probe,
    ) -> Result<FrameCounts, FrameError> {
        self.0.draw(frame, pose, planes, &()).map(|(counts, _)| counts)
    }

    fn check(&self, frame: u64, pose: &Pose) -> Result<(), FrameError> {
        self.0.check(frame, pose)
    }

    fn omissions(&self) -> Vec<Omission> {
        self.0.omissions()
    }

    fn wires(&self) -> Vec<Wire> {
        Vec::new()
    }
}
