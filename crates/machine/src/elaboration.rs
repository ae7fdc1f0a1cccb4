//! From a stage to a machine that holds only what the stage needs.

use generator::{Generator, PrepareError, Session, Stage};
use scenario::Scalar;
use signal::Signal;

use crate::record::signals;
use crate::session::Elaborated;

/// The hybrid machine of the report.
#[derive(Debug, Clone, Copy, Default)]
pub struct HybridMachine;

impl Generator for HybridMachine {
    fn name(&self) -> &'static str {
        "hybrid"
    }

    fn signals(&self) -> &'static [Signal] {
        signals()
    }

    fn is_machine(&self) -> bool {
        true
    }

    fn prepare(&self, stage: Stage) -> Result<Box<dyn Session>, PrepareError> {
        Ok(match stage.settings.scalar {
            Scalar::F32 => Box::new(Elaborated::<f32>::new(stage)),
            Scalar::F64 => Box::new(Elaborated::<f64>::new(stage)),
        })
    }
}
