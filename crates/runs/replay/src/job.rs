//! What is to be drawn, and under whose control.

use std::ops::Range;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use generator::{Generator, Stage};
use picture::Depth;
use rayon::ThreadPool;
use run_record::{Inputs, PicturesRecord, Program, ShardRecord};
use scenario::Scenario;

/// How frames become files.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Pictures {
    /// Bits of a code.
    pub depth: Depth,
    /// RGB from the planes red, green and blue, which the generator must fill, instead of grey from the intensity.
    pub colour: bool,
    /// One file for each picture that the tube shows, instead of one for each that the machine computes.
    pub refresh: bool,
    /// An animated PNG as well.
    pub film: bool,
}

impl Pictures {
    /// As a record has it. It does not say whether there is a film.
    pub fn of_record(record: &PicturesRecord) -> Self {
        Self {
            depth: if record.depth == Depth::Sixteen.bits() { Depth::Sixteen } else { Depth::Eight },
            colour: record.kind == COLOUR,
            refresh: record.one_file_for_each == REFRESH,
            film: false,
        }
    }
}

/// Kind of pictures in colour, in records.
pub(crate) const COLOUR: &str = "RGB PNG";
/// Clock of pictures that are kept for each showing, in records.
pub(crate) const REFRESH: &str = "refresh";

/// A run to be made.
#[derive(Clone)]
pub struct Job<'a> {
    /// Program that draws, with its version and commit.
    pub program: Program,
    /// Files that the run is made from.
    pub inputs: Inputs,
    /// Scenario of the mission.
    pub scenario: &'a Scenario,
    /// Image generator that draws the frames.
    pub generator: Arc<dyn Generator>,
    /// World and view that are drawn.
    pub stage: Stage,
    /// Frames to draw, counted at the update rate.
    pub frames: Range<u64>,
    /// The part of a larger run that `frames` are, where a worker draws a shard.
    pub shard: Option<ShardRecord>,
    /// How frames become files.
    pub pictures: Pictures,
    /// Sweeps that are checked against `exact` when all frames are there; at 0 none, and a check that was made of the same
    /// frames stays.
    pub check: u32,
}

/// What a running job tells.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Progress {
    /// Frames that are there already are read again.
    Verifying {
        /// Number of frames to be read.
        frames: u64,
    },
    /// Drawing of frames or truth begins.
    Begins {
        /// What is made: "frames" or "truth".
        what: &'static str,
        /// Frames of the run.
        frames: u64,
        /// Of these there already.
        kept: u64,
    },
    /// One more frame is on the disk.
    Frame {
        /// Number of frames on the disk.
        done: u64,
    },
    /// Contact sheet, film and record are made.
    Finishing,
}

/// Under whose control a job runs; none of this changes a bit of the result.
pub struct Control<'a> {
    /// Threads that draw the frames.
    pub pool: &'a ThreadPool,
    /// Set to true, the run ends with whole frames only.
    pub cancel: &'a AtomicBool,
    /// Hears of every frame.
    pub progress: &'a (dyn Fn(Progress) + Sync),
}
