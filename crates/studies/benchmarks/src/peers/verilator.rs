//! Our control plane against one in SystemVerilog, made a program by Verilator: folds, loads and queues of a frame.
//!
//! Both do the frame of `nominal-drive` on `pra-nominal`. Ours goes from event to event, the other from tick to tick. What both count
//! must be equal, or the comparison ends with an error.

mod comparison;
mod program;
mod stimuli;
mod work;

pub use comparison::table;
pub use program::{Program, Verilated};
pub use stimuli::Stimuli;
pub use work::Work;
