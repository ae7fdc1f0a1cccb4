//! The machine without probes: what probing nothing is measured against (`crates/studies/benchmarks`).

use control_plane::MachineStage;
use generator::{BeamEntry, FrameCounts, FrameError, Omission, Planes, Session};
use scenario::{Pose, Scalar};
use signal::{Probe, Real};

use crate::elaborated::Elaborated;

struct Unprobed<S>(Elaborated<S>);

/// Elaborates the machine compiled without a word about probes. It has no signals, and records nothing.
pub fn prepare_unprobed(stage: MachineStage) -> Box<dyn Session> {
    match stage.settings.scalar {
        Scalar::F32 => Box::new(Unprobed(Elaborated::<f32>::new(stage))),
        Scalar::F64 => Box::new(Unprobed(Elaborated::<f64>::new(stage))),
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

    fn repeat(&self, frame: u64, pose: &Pose, showing: u64, planes: &mut Planes) -> Result<bool, FrameError> {
        self.0.repeat(frame, pose, showing, planes)
    }

    fn beam_list(&self, frame: u64, pose: &Pose) -> Result<Option<Vec<BeamEntry>>, FrameError> {
        self.0.beam_list(frame, pose)
    }

    fn check(&self, frame: u64, pose: &Pose) -> Result<(), FrameError> {
        self.0.check(frame, pose)
    }

    fn omissions(&self) -> Vec<Omission> {
        self.0.omissions()
    }
}
