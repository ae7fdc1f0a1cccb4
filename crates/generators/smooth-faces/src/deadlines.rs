//! Deadlines of a frame, as they are met or missed.

use std::collections::BTreeMap;

use timing::{Cause, Deadline, Missed, Slack};

use crate::drawn_lists;
use crate::hardware::Kind;
use crate::piece::Piece;
use crate::prepared::Prepared;
use crate::scan_line::TimedLine;
use crate::scene::Scene;
use crate::schedule::{Item, Target};
use crate::slots;

/// A list's sequence, sun vector, body or normals are new in this frame.
const UPDATE: Deadline = Deadline::new("update");
/// A piece that crosses a scan line finds a slot; its slack is a tick a slot.
const EDGE: Deadline = Deadline::new("edge");
/// The edges of a face find slots in the frame; its slack is a tick an edge.
const EDGE_STORE: Deadline = Deadline::new("edge-store");

/// Deadlines of a frame as they are met or missed. Ticks are nanoseconds from when the spare time of the frame before begins.
pub struct Judged<'a> {
    prepared: &'a Prepared,
    /// Slack of each kind of deadline that the machine has.
    pub deadlines: BTreeMap<Deadline, Slack>,
    /// Deadlines that were missed, in the order in which they were judged.
    pub misses: Vec<Missed>,
}

impl<'a> Judged<'a> {
    /// All deadlines that the machine has, before any is met or missed; those of slots only where they are limited.
    pub fn none_of(prepared: &'a Prepared) -> Self {
        let limited = [
            (prepared.hardware.edges_line.is_some(), EDGE),
            (prepared.hardware.edges_frame.is_some(), EDGE_STORE),
        ];
        let limited = limited.into_iter().filter_map(|(is_there, kind)| is_there.then_some(kind));
        let kinds = [Deadline::FRAME_TASKS, UPDATE].into_iter().chain(limited);
        Self { prepared, deadlines: kinds.map(|kind| (kind, Slack::default())).collect(), misses: Vec::new() }
    }

    /// Counts a deadline that was met or missed by so many ticks; `missed` tells of a miss.
    fn add(&mut self, deadline: Deadline, slack: i64, missed: impl FnOnce() -> Missed) {
        self.deadlines.entry(deadline).or_default().add(slack);
        if slack < 0 {
            self.misses.push(missed());
        }
    }

    /// Whether all work of the real-time computer fits the spare time of a frame.
    pub fn frame_tasks(&mut self) {
        let [due, came] = [self.prepared.hardware.rt.spare_ns, self.prepared.schedule.asked_ns()];
        self.add(Deadline::FRAME_TASKS, due as i64 - came as i64, || Missed {
            due: due as f64,
            came: Some(came as f64),
            ..Missed::of(Deadline::FRAME_TASKS, 0, Cause::Processor)
        });
    }

    /// Whether each list's sequence, sun vector, body and normals are new in frame `frame`, of frames of `ticks`.
    pub fn updates(&mut self, frame: u64, ticks: u64) {
        let prepared = self.prepared;
        let due = prepared.hardware.rt.spare_ns;
        for item in prepared.schedule.items() {
            let came = came(prepared, item, frame, ticks);
            // What never comes is as late as a frame is long.
            let slack =
                came.map_or(-(ticks as i64), |came| due as i64 - i64::try_from(came).unwrap_or(i64::MAX));
            self.add(UPDATE, slack, || Missed {
                part: Some(item.part()),
                due: due as f64,
                came: came.map(|came| came as f64),
                ..Missed::of(UPDATE, 0, Cause::Processor)
            });
        }
    }

    /// Whether the pieces that cross each scan line find slots, where those are limited.
    pub fn lines(&mut self, scene: &Scene, lines: &[TimedLine]) {
        let Some(slots) = scene.slots.map(u64::from) else { return };
        for (number, TimedLine { crossed: line, .. }) in (0..).zip(lines) {
            let kept = line.crossings - line.missed.len() as u64;
            let slack = self.deadlines.entry(EDGE).or_default();
            (1..=kept).for_each(|place| slack.add((slots - place) as i64));
            for (rank, piece) in (0_u64..).zip(&line.missed) {
                self.add(EDGE, -1 - rank as i64, || Missed {
                    crossing: Some((kept + rank) as u32),
                    part: Some(face(scene, &scene.pieces[*piece as usize])),
                    ..Missed::of(EDGE, number, Cause::Occupied)
                });
            }
        }
    }

    /// Whether the edges of all faces find slots in the frame, where those are limited.
    pub fn frame_edges(&mut self, scene: &Scene) {
        let Some(slots) = self.prepared.hardware.edges_frame else { return };
        let used: u64 = slots::of_lists(scene.pieces.iter(), scene.lists.len()).into_iter().sum();
        let slack = self.deadlines.entry(EDGE_STORE).or_default();
        let kept = scene.pieces.chunk_by(is_one_face).count();
        (0..kept).for_each(|_| slack.add(i64::from(slots) - used as i64));
        let lost = scene.lost.chunk_by(is_one_face);
        for (short, pieces) in (1..).zip(lost) {
            self.add(EDGE_STORE, -short, || Missed {
                part: Some(face(scene, &pieces[0])),
                ..Missed::of(EDGE_STORE, 0, Cause::Occupied)
            });
        }
    }
}

/// When work for frame `frame` is ready (ns from when the spare time of the frame before begins); `None` if never.
fn came(prepared: &Prepared, item: &Item, frame: u64, ticks: u64) -> Option<u64> {
    let behind = item.when.next(frame)? - frame + pointer_behind(prepared, item, frame);
    Some(behind.saturating_mul(ticks).saturating_add(item.ready_ns))
}

/// Frames by which the pointer of a sequence is behind in `frame`: those by which its steps are late, where it shows another member.
fn pointer_behind(prepared: &Prepared, item: &Item, frame: u64) -> u64 {
    let late = prepared.hardware.rt.late_frames;
    let Target::List(number) = item.target else { return 0 };
    if item.kind != Kind::Sequence || late == 0 {
        return 0;
    }
    let list = drawn_lists::drawn(&prepared.stage, &prepared.run)[number];
    let punctual = list.group.shown(frame, |name| list.carrier.signal(name, frame));
    let shows = drawn_lists::shown_faces(list, &list.group, frame, &prepared.hardware);
    if shows == punctual { 0 } else { u64::from(late) }
}

fn is_one_face(a: &Piece, b: &Piece) -> bool {
    (a.list, a.face) == (b.list, b.face)
}

/// A face by its list and its number in it.
fn face(scene: &Scene, piece: &Piece) -> String {
    format!("{}.face.{}", scene.lists[piece.list as usize].name, piece.face)
}
