//! From a stage to a machine that holds only what the stage needs.

use generator::{Generator, Omission, PrepareError, Session, Stage};
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

    fn prepare(&self, stage: Stage) -> Result<Box<dyn Session>, PrepareError> {
        Ok(match stage.settings.scalar {
            Scalar::F32 => Box::new(Elaborated::<f32>::new(stage)),
            Scalar::F64 => Box::new(Elaborated::<f64>::new(stage)),
        })
    }
}

/// What a machine for terrain alone leaves out.
pub(crate) fn omissions(levels: usize) -> Vec<Omission> {
    let no_customer =
        |block, what| Omission::lossless(block, what, "the scenario has nothing for it to draw");
    let mut list = vec![
        no_customer("mixing-unit", "video switches VS1, VS2, VS3 and the texture adder"),
        Omission::lossless("terrain-generator", "dynamics of parts", "all parts of the model are ideal"),
        Omission::lossless("sweep-memory", "spot, exposure, residue", "all parts of the model are ideal"),
    ];
    if levels > 1 {
        let what = format!("{} coarser terrain levels", levels - 1);
        list.push(Omission::lossless("terrain-generator", what, "the machine has one terrain generator"));
    }
    list
}
