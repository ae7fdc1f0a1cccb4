//! Analog parts: what the blocks of a machine that is not ideal are built from (hardware-1969, sections 3 and 6).
//!
//! ```text
//!  word ─▶ converter ─▶ second order ─▶ function generator ─▶ lag ─┐
//!            D/A          smoother          broken line            ├▶ multiplier ─▶ lag ─▶ amplifier ─▶ ...
//!  word ─▶ multiplying converter ──────────────────────────────────┘                       slew, clip
//!
//!  ... ─▶ driver: lag and slew over whole sweeps with breaks ─▶ wire
//!  ... ─▶ differentiator ─▶ comparator ─▶ sample-and-hold, switch
//! ```
//!
//! **Law.** Every part has its own page. A linear part is advanced by its exact solution over a step, for an input
//! that is a straight line between samples (first-order hold) or jumps at a known share of the step. A nonlinear
//! part is a chain of such solutions, split at the instants at which its law changes; those instants are roots in
//! closed form, or bracketed where there is none. No part has a step that it must not exceed.
//! **Parameters.** Seconds, hertz, radians a second. Values of a signal are shares of full scale (1 = the machine
//! unit); percent and volts exist at the edge of a file only. Coefficients are worked out once, in f64, and held in
//! the scalar of the run.
//! **State and timing.** State is plain data and belongs to the caller. Instants are [`quantities::SweepTime`]:
//! steps since the first sample of the sweep. A delay longer than a step is whole steps, read from the caller's
//! buffer, and a [`Delay::share`].
//! **Elaboration.** A part that is not there is not built. No `step` asks whether its part is present.
//! **Sameness.** Lanes do not see one another: a lane has the same bits alone and in a group. Randomness is by
//! address ([`NoiseSource`], [`Spread`]), so order and threads cannot change it.
//! **Not modelled.** Drift and temperature; the charge a switch injects.
//! **Domain.** Times, slew, saturation and damping are not negative and may be 0; times, bandwidths, slew and saturation
//! may be infinite; nothing is NaN. Hardware models are checked before they come here.

mod amplifier;
mod broken;
mod comparator;
mod converter;
mod delay;
mod differentiator;
mod driver;
mod fade;
mod function_bank;
mod function_generator;
mod high_pass;
mod lag;
mod loop_lag;
mod multiplier;
mod multiplying_converter;
mod noise;
mod overload;
mod quiet;
mod sample_hold;
mod second_order;
mod slew;
mod spot;
mod spread;
mod switch;
mod watch;
mod whole;
mod wire;

pub use amplifier::{Amplifier, AmplifierLaw, AmplifierState, summing_time_constant};
pub use broken::{Jump, NearJumps, straight_at};
pub use comparator::{Comparator, ComparatorLaw, ComparatorState, GateEdge, Trip};
pub use converter::{Converter, ConverterLanes, ConverterLaw};
pub use delay::Delay;
pub use differentiator::{Differentiator, differentiated_noise};
pub use driver::{Driver, Jumps};
pub use fade::{Fade, NearFade};
pub use function_bank::{BANK, BankPlace, FunctionBank};
pub use function_generator::{Ends, FunctionGenerator, FunctionLaw};
pub use high_pass::HighPass;
pub use lag::{LagStep, LagSteps, SplitLag, impulse, settling_time_constant, time_constant};
pub use loop_lag::LoopLag;
pub use multiplier::{Feedthrough, Multiplier, MultiplierLaw};
pub use multiplying_converter::MultiplyingConverter;
pub use noise::{BandNoise, GroupNoise, NoiseSource};
pub use quiet::QuietAmplifiers;
pub use sample_hold::{SampleHold, SampleHoldLaw};
pub use second_order::{SecondOrder, SecondOrderState, SecondOrderStep};
pub use spot::{Spot, spot_sigma};
pub use spread::{Spread, Tolerance, relative_sigma};
pub use switch::{Switch, SwitchLaw};
pub use watch::Watch;
pub use wire::Wire;
