//! Why events cannot be listed.

use quantities::Tick;

/// Why events cannot be listed, or registers not be shown.
#[derive(Debug, thiserror::Error)]
pub enum EventListError {
    /// The coarse level is asked for where there is none.
    #[error("{asked}: the scenario has one level of terrain; expected fine")]
    OneLevel {
        /// The option with its value.
        asked: String,
    },
    /// A drum is asked for where there is none.
    #[error(
        "{asked}: the machine has no drums, all words are at hand; leave it out, or give --machine a model with drums"
    )]
    NoDrums {
        /// The option with its value.
        asked: String,
    },
    /// There is no drum of that number.
    #[error("{asked}: each kind of data has drums 0..{count}; expected one of them")]
    NoSuchDrum {
        /// The option with its value.
        asked: String,
        /// Drums of a kind of data.
        count: u32,
    },
    /// The ticks that are asked for are those of no event.
    #[error("{asked}: the events are at ticks {first} to {last}; expected a tick there")]
    BeyondEvents {
        /// The option with its value.
        asked: String,
        /// Tick of the first event.
        first: u64,
        /// Tick of the last event.
        last: u64,
    },
    /// A tick of another frame.
    #[error("--at {}: frame {frame} has ticks {}..{}; expected one of them", .tick.0, .ticks[0].0, .ticks[1].0)]
    OtherFrame {
        /// Tick that was asked for.
        tick: Tick,
        /// Number of the frame that was traced.
        frame: u64,
        /// Begin and end of the frame.
        ticks: [Tick; 2],
    },
    /// A sample that the frame does not have.
    #[error(
        "--at {sweep}:{sample}: a frame has sweeps 0..{sweeps} of samples 0..{samples}; expected one of them"
    )]
    BeyondSweeps {
        /// Sweep that was asked for.
        sweep: u32,
        /// Sample that was asked for.
        sample: f64,
        /// Sweeps of a frame.
        sweeps: u32,
        /// Samples of a sweep.
        samples: u32,
    },
}
