//! What the digital side does for a whole frame, before any of its sweeps: the processor, and the drums of both levels.

use crate::drums::{Arrivals, Bank, DrumFigures};
use crate::event::{Event, Happening};
use crate::processor::{Processed, processor};
use crate::scene::SceneData;

/// What the interpreter does not work out of a frame and takes as the machine has it.
#[derive(Debug, Clone, Copy)]
pub struct FrameGiven<'a> {
    /// Ticks that the crossings of each sweep take of the processor; empty if they take nothing.
    pub crossings: &'a [u64],
    /// Vertices of polyhedra that the processor is to transform.
    pub vertices: u64,
    /// The drums of each level as the seed drew them; none where all words are at hand.
    pub drums: [&'a [DrumFigures]; 2],
}

/// The digital side of one frame.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Frame {
    /// Set-ups, tables and records from the drums.
    pub events: Vec<Event>,
    /// The sweep whose set-up each sweep is drawn with.
    pub set_ups: Vec<u32>,
    /// Ticks of each sweep, from its start, in which crossings wait for a set-up; empty if they never wait.
    pub held: Vec<i64>,
    /// Corners that the storage buffer of each level has not when the frame begins.
    pub missing: [Arrivals; 2],
}

/// Follows the processor through the frame, and the drums from the first frame of the mission on.
pub fn frame(scene: &SceneData<'_>, given: &FrameGiven<'_>) -> Frame {
    let Processed { mut events, set_ups, held } = processor(scene, given);
    let mut missing = [Arrivals::new(), Arrivals::new()];
    for (number, drums) in given.drums.iter().enumerate().filter(|(_, drums)| !drums.is_empty()) {
        let mut bank = Bank::before_mission(scene, number, drums);
        for earlier in 0..scene.frame {
            bank.frame(scene, earlier);
        }
        missing[number] = bank.frame(scene, scene.frame);
        events.extend(bank.records(&missing[number]).into_iter().map(|(tick, record)| Event {
            tick,
            level: Some(number),
            what: Happening::Record(record),
        }));
    }
    Frame { events, set_ups, held, missing }
}
