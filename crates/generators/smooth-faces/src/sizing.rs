//! What frames took beside what the machine has.

use generator::SizedFigure;
use timing::{Deadline, FrameTiming, Task};

use crate::hardware::Kind;
use crate::prepared::Prepared;
use crate::schedule::When;
use crate::work::{EDGES, GEOMETRY, RT, SECOND, TRANSFER, VIDEO};

/// Nanoseconds in a microsecond, and microseconds in a second.
const THOUSAND: f64 = 1e3;
const MILLION: f64 = 1e6;

/// What `frames` took, beside the formulas.
pub fn figures(prepared: &Prepared, frames: &[FrameTiming]) -> Vec<SizedFigure> {
    let hardware = &prepared.hardware;
    let mean = |of: &dyn Fn(&FrameTiming) -> u64| {
        (!frames.is_empty()).then(|| frames.iter().map(of).sum::<u64>() as f64 / frames.len() as f64)
    };
    let most =
        |of: &dyn Fn(&FrameTiming) -> u64| frames.iter().map(|frame| of(frame) as f64).reduce(f64::max);
    let microseconds = |unit: &'static str| mean(&move |frame| ticks(frame, unit)).map(|ns| ns / THOUSAND);
    let frame_us = prepared.stage.view.update.period_ticks(SECOND) as f64 / THOUSAND;
    let update_hz = prepared.stage.view.update.hertz();
    let figure = |key, meaning, measured, formula, law| SizedFigure { key, meaning, measured, formula, law };
    let queue = |frame: &FrameTiming| {
        let edges = frame.units.iter().find(|unit| unit.unit == EDGES);
        edges.map_or(0, |edges| u64::from(edges.longest_queue))
    };
    vec![
        figure(
            "rt_us",
            "real-time computer, us a frame",
            microseconds(RT),
            Some(hardware.rt.spare_ns as f64 / THOUSAND),
            "sequences, sun vectors, bodies, normals <= spare_us",
        ),
        figure(
            "normals_frames",
            "frames from new normals to new normals",
            normals_measured(frames),
            normals_formula(prepared),
            "ceil(V normal_us / what is left of spare_us)",
        ),
        figure(
            "channels",
            "channels that share the real-time computer",
            Some(f64::from(prepared.run.channels)),
            prepared.schedule.most_channels(&hardware.rt).map(|most| most as f64),
            "(spare_us - what is done once) / words of one channel",
        ),
        figure(
            "transfer_words",
            "words from the active data base, a frame",
            mean(&|frame| pieces(frame, TRANSFER, "words")),
            Some(hardware.transfer_words_s as f64 / update_hz),
            "words_s / update_hz",
        ),
        figure(
            "geometry_us",
            "geometry, us a frame",
            microseconds(GEOMETRY),
            Some(frame_us),
            "vertex_us vertices + face_us (faces + triangles) <= 1e6 / update_hz",
        ),
        figure(
            "crossings",
            "pieces on the fullest scan line",
            most(&queue),
            hardware.edges_line.map(f64::from),
            "edges_line",
        ),
        figure(
            "video_us",
            "samples, us a frame",
            microseconds(VIDEO),
            Some(frame_us),
            "sample_ns samples <= 1e9 / update_hz",
        ),
        figure(
            "delay_us",
            "from a pose to its picture, us",
            None,
            Some(f64::from(hardware.delay_frames) * MILLION / update_hz),
            "delay_frames / update_hz",
        ),
    ]
}

/// Mean number of frames from one with new normals to the next; `None` without two of them in frames that follow one another.
fn normals_measured(frames: &[FrameTiming]) -> Option<f64> {
    let update = Deadline::new("update");
    let is_new = |frame: &&FrameTiming| {
        let parts = frame.misses.iter().filter(|missed| missed.deadline == update);
        let mut parts = parts.filter_map(|missed| missed.part.as_deref());
        pieces(frame, RT, Kind::Normal.task()) > 0 && !parts.any(|part| part.starts_with(Kind::Normal.word()))
    };
    let follow = frames.windows(2).all(|pair| pair[1].frame == pair[0].frame + 1);
    let new: Vec<u64> = frames.iter().filter(is_new).map(|frame| frame.frame).collect();
    let [first, .., last] = new[..] else { return None };
    follow.then(|| (last - first) as f64 / (new.len() - 1) as f64)
}

/// Frames that the last of the normals takes from one time to the next; `None` without normals, or where they are never new.
fn normals_formula(prepared: &Prepared) -> Option<f64> {
    let mut items = prepared.schedule.items().iter().rev();
    match items.find(|item| item.kind == Kind::Normal)?.when {
        When::Always => Some(1.0),
        When::Every { every, .. } => Some(every as f64),
        When::Never => None,
    }
}

/// Ticks of the tasks of a unit.
fn ticks(frame: &FrameTiming, unit: &str) -> u64 {
    frame.tasks.iter().filter(|task| task.unit == unit).map(|task| task.ticks).sum()
}

/// Pieces of a task of a unit.
fn pieces(frame: &FrameTiming, unit: &str, task: &str) -> u64 {
    let is_it = |known: &&Task| (known.unit.as_str(), known.task.as_str()) == (unit, task);
    frame.tasks.iter().find(is_it).map_or(0, |task| task.pieces)
}
