//! From a stage to a machine made ready for it.

use control_plane::MachineStage;
use generator::Session;
use scenario::Scalar;

use crate::elaborated::Elaborated;

/// Makes the machine of a stage ready. `control-plane` holds the stage, on a floor below: it knows no machine.
pub trait Prepare {
    /// Elaborates the machine: the scalar is chosen, tables over the sweep are made, blocks without work are left out.
    fn prepare(self) -> Box<dyn Session>;
}

impl Prepare for MachineStage {
    fn prepare(self) -> Box<dyn Session> {
        match self.settings.scalar {
            Scalar::F32 => Box::new(Elaborated::<f32>::new(self)),
            Scalar::F64 => Box::new(Elaborated::<f64>::new(self)),
        }
    }
}
