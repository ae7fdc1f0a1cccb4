//! What the control plane hands to the signal plane, sweep by sweep.
//!
//! A [`SweepProgram`] is timed and complete: where the ramps start, what the registers hold, when the ramps fold
//! and when words arrive. The signal plane runs it without asking anyone; a word that comes late is late here.

mod colour;
mod fan;
mod load_line;
mod on_time;
mod program;
mod register_corners;

pub use colour::{Colour, PreloadRegister};
pub use fan::Fan;
pub use load_line::{LoadLine, LoadTiming, NoTiming, TimedLoad, last_tick, slack};
pub use program::{
    Event, Fold, Load, Miss, MissCause, NO_CORNER, Ramp, RampAxis, RegisterSet, Served, Step, StepKind, Stop,
    SweepProgram, SweepStart, Target, WordMask,
};
pub use register_corners::RegisterCorners;
