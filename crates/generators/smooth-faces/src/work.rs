//! What the units of a frame are busy with.

use faces::Group;
use timing::{Task, UnitUse};

use crate::drawn_lists;
use crate::hardware::{Hardware, Kind};
use crate::prepared::Prepared;
use crate::scan_line::TimedLine;
use crate::schedule::{Item, Target};
use crate::shown::Geometry;

/// The units, in the order in which a list meets them.
pub const RT: &str = "rt";
pub const TRANSFER: &str = "transfer";
pub const GEOMETRY: &str = "geometry";
pub const EDGES: &str = "edges";
pub const VIDEO: &str = "video";
/// The ramp generators, which work beside the samples.
pub const RAMPS: &str = "video.ramps";

/// Nanoseconds in a second.
pub const SECOND: u64 = 1_000_000_000;

/// Words of a face in the active data base: number of its corners, three of its colour (chosen).
const FACE_WORDS: u64 = 4;
/// Words of a corner there: three of its place, three of its normal (chosen).
const CORNER_WORDS: u64 = 6;

/// Pieces of a frame's work.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Work {
    /// Words of lists that go from the active data base.
    pub words: u64,
    /// Pieces that geometry works on.
    pub geometry: Geometry,
    /// Most pieces that cross one scan line.
    pub most_crossings: u64,
    /// Samples of the picture.
    pub samples: u64,
    /// Ramps that are started.
    pub ramps: u64,
}

impl Work {
    /// The work of frame `frame`, whose picture has `lines`.
    pub fn of(prepared: &Prepared, frame: u64, geometry: Geometry, lines: &[TimedLine]) -> Self {
        Self {
            words: words(prepared, frame),
            geometry,
            most_crossings: lines.iter().map(|line| line.crossed.crossings).max().unwrap_or(0),
            samples: prepared.size().into_iter().product::<usize>() as u64,
            ramps: lines.iter().map(|line| line.ramps).sum(),
        }
    }

    /// Tasks that have something to do, in the order of the units; the real-time computer has all that a frame asks for.
    pub fn tasks(&self, prepared: &Prepared) -> Vec<Task> {
        let Hardware { transfer_words_s, vertex_ns, face_ns, sample_ns, .. } = prepared.hardware;
        let of_kind = |kind: Kind| {
            let ours = prepared.schedule.items().iter().filter(|item| item.kind == kind);
            let [pieces, ns] = ours.fold([0, 0], |[pieces, ns], item| [pieces + item.pieces, ns + item.ns]);
            (RT, kind.task(), pieces, ns)
        };
        let transfer = (self.words * SECOND).div_ceil(transfer_words_s);
        let Geometry { vertices, faces, triangles } = self.geometry;
        let others = [
            (TRANSFER, "words", self.words, transfer),
            (GEOMETRY, "vertices", vertices, vertices * vertex_ns),
            (GEOMETRY, "faces", faces, faces * face_ns),
            (GEOMETRY, "triangles", triangles, triangles * face_ns),
            (VIDEO, "samples", self.samples, self.samples * sample_ns),
            (RAMPS, "ramps", self.ramps, self.ramps * sample_ns),
        ];
        let all = Kind::ALL.map(of_kind).into_iter().chain(others);
        all.filter(|(_, _, pieces, ticks)| *pieces > 0 && *ticks > 0)
            .map(|(unit, task, pieces, ticks)| Task { unit: unit.into(), task: task.into(), pieces, ticks })
            .collect()
    }

    /// Use of all units: each is busy for its `tasks`. Edge slots take no time; their queue is the fullest scan line.
    pub fn units(&self, tasks: &[Task]) -> Vec<UnitUse> {
        let busy = |unit: &str| {
            let ours = tasks.iter().filter(|task| task.unit == unit);
            ours.map(|task| task.ticks).sum::<u64>()
        };
        let queue = |unit: &str| if unit == EDGES { self.most_crossings as u32 } else { 0 };
        [RT, TRANSFER, GEOMETRY, EDGES, VIDEO, RAMPS]
            .map(|unit| UnitUse { unit: unit.into(), busy: busy(unit), longest_queue: queue(unit) })
            .into()
    }
}

/// Words of the lists of which a sequence shows another member than in the frame before; the lists of frame 0 are there before it.
fn words(prepared: &Prepared, frame: u64) -> u64 {
    let Some(before) = frame.checked_sub(1) else { return 0 };
    let lists = drawn_lists::drawn(&prepared.stage, &prepared.run);
    let of_item = |item: &Item| {
        let Target::List(number) = item.target else { return 0 };
        let list = lists[number];
        let [now, then] = [frame, before].map(|frame| {
            drawn_lists::shown_faces(list, &list.group, item.when.shown(frame), &prepared.hardware)
        });
        if now == then { 0 } else { list_words(&list.group, &now) }
    };
    let sequences = prepared.schedule.items().iter().filter(|item| item.kind == Kind::Sequence);
    sequences.map(of_item).sum()
}

/// Words of those faces of a list.
fn list_words(group: &Group, faces: &[usize]) -> u64 {
    let corners = |face: &usize| group.mesh.faces()[*face].corners.len() as u64;
    faces.iter().map(|face| FACE_WORDS + CORNER_WORDS * corners(face)).sum()
}
