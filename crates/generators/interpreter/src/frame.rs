//! What the digital side does for a whole frame, before any of its sweeps: the processor, and the drums of all kinds of data.

use crate::drums::{Arrivals, Bank, GivenKind};
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
    /// The kinds of data on each bank of drums; none where all data are at hand.
    pub banks: &'a [Vec<GivenKind>],
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
    /// Squares of features that the storage buffer has not whole when the frame begins: number and 0, and when each is whole.
    pub absent_features: Arrivals,
}

/// Follows the processor through the frame, and the drums from the first frame of the mission on.
pub fn frame(scene: &SceneData<'_>, given: &FrameGiven<'_>) -> Frame {
    let Processed { mut events, set_ups, held } = processor(scene, given);
    let mut frame = Frame { set_ups, held, ..Frame::default() };
    for kinds in given.banks {
        let mut bank = Bank::before_mission(scene, kinds);
        for earlier in 0..scene.frame {
            bank.frame(scene, earlier);
        }
        let missing = bank.frame(scene, scene.frame);
        for (store, (given, missing)) in kinds.iter().zip(missing).enumerate() {
            let level = (given.kind < 2).then_some(given.kind);
            events.extend(bank.records(store, &missing).into_iter().map(|(tick, record)| Event {
                tick,
                level,
                what: match level {
                    Some(_) => Happening::Record(record),
                    None => Happening::Square { kind: given.kind, record },
                },
            }));
            match given.kind {
                level @ (0 | 1) => frame.missing[level] = missing,
                2 => frame.absent_features = missing,
                _ => {}
            }
        }
    }
    Frame { events, ..frame }
}
