//! Waveforms of sweeps into the files that waveform tools read.
//!
//! ```text
//! Session::frame ─▶ waveforms of a sweep ─▶ Sink ┬▶ csv   a row a sample
//!                        │                       ├▶ vcd   changes, text        ┐ + .gtkw
//!                        ▼                       ├▶ fst   changes, binary      ┘
//!                    estimate                    ├▶ npz   an array a signal
//!                    (bytes, before writing)     ├▶ json  an object a sweep
//!                                                ├▶ raw   vectors of ngspice, volts
//!                                                └▶ sr    channels of sigrok, volts
//! ```
//!
//! A [`Sink`] takes a frame sweep by sweep and keeps none. What it writes has a temporary name until
//! [`Sink::finish`] gives it its own; a sink that is dropped before leaves nothing.
//!
//! **Law.** Sample n of sweep s lies (s * samples of a sweep + n) periods of the sample clock after the start of the
//! frame, retrace counted; in VCD and FST that instant in whole picoseconds. A signal of the display axis has its line
//! k of `lines` at k / `lines` of the active sweep. Signals told when they change keep their own instants where the
//! format has instants, and hold or pulse at samples where it has samples.
//! **Errors.** [`WaveformError`]. A value that is not finite is refused.
//! **Our choices.** Units of the signal in CSV, VCD, FST, NPZ and JSON; volts of the wire in raw and sr, which know
//! nothing else. The page `docs/waveform-files.md` says what each file holds.
//! **Not modelled.** Reading: other programs do that.

mod changes;
mod clock;
mod csv_file;
mod encoder;
mod error;
mod format;
mod fst_file;
mod gtkwave;
mod header;
mod held;
mod json_file;
#[cfg(not(target_family = "wasm"))]
mod npz_file;
mod output;
mod raw_file;
mod record;
#[cfg(not(target_family = "wasm"))]
mod sigrok_file;
mod sink;
mod tree;
mod vcd_file;
#[cfg(not(target_family = "wasm"))]
mod zipped;

pub use error::WaveformError;
pub use format::Format;
pub use header::{Header, SweepTraces};
pub use record::wire_record;
pub use sink::{Sink, companions, estimate, open};
