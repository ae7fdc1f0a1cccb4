//! What frames took beside what the computer and the board have.

use generator::SizedFigure;
use timing::FrameTiming;

use super::Hardware;
use super::store::Stored;
use super::work::{self, SECOND, picture_bytes};
use crate::prepared::Prepared;
use crate::slots::fitting_order;

/// Nanoseconds in a microsecond.
const THOUSAND: f64 = 1e3;

/// What `frames` took, beside the formulas.
pub fn figures(prepared: &Prepared, hardware: &Hardware, frames: &[FrameTiming]) -> Vec<SizedFigure> {
    let begun: Vec<&FrameTiming> = frames.iter().filter(|frame| !frame.tasks.is_empty()).collect();
    let mean = |of: &dyn Fn(&FrameTiming) -> u64| {
        (!begun.is_empty())
            .then(|| begun.iter().map(|frame| of(frame)).sum::<u64>() as f64 / begun.len() as f64)
    };
    let pieces = |unit: &'static str, task: &'static str| {
        mean(&move |frame| {
            let tasks = frame.tasks.iter().filter(|found| found.unit == unit && found.task.ends_with(task));
            tasks.map(|task| task.pieces).sum()
        })
    };
    let view = &prepared.stage.view;
    let period = view.update.period_ticks(SECOND);
    let terrain = &prepared.posts.terrain;
    let stored = Stored::of(terrain, prepared.table.levels.count());
    let slots = hardware.board.uniform_slots;
    let picture = picture_bytes(view, hardware).max(1) as f64;
    let figure = |key, meaning, measured, formula, law| SizedFigure { key, meaning, measured, formula, law };
    vec![
        figure(
            "frame_us",
            "a frame, us",
            mean(&|frame| work::frame_time(&frame.tasks)).map(|ns| ns / THOUSAND),
            Some(period as f64 / THOUSAND),
            "cpu + bus + max(gpu.vertex, gpu.triangle) + capture <= 1e6 / update_hz",
        ),
        figure(
            "uniform_slots",
            "percentages in the uniform array",
            pieces("bus", "percentages"),
            slots.map(f64::from),
            "one a tile <= uniform_slots",
        ),
        figure(
            "order",
            "order of a tile",
            Some(f64::from(terrain.order())),
            slots.and_then(|slots| fitting_order(terrain, slots)).map(f64::from),
            "least n with ceil(cells / 2^n) tiles each way <= uniform_slots",
        ),
        figure(
            "triangles",
            "triangles of a frame",
            pieces("gpu.triangle", ""),
            Some(hardware.board.triangles_s as f64 / view.update.hertz()),
            "triangles_s / update_hz",
        ),
        figure(
            "document_bytes",
            "terrain as the thesis stores it, bytes",
            Some(stored.document_bytes(hardware) as f64),
            Some(hardware.board.memory_bytes as f64),
            "every level, outer faces and corners three times, a texel a post <= memory_bytes",
        ),
        figure(
            "kept_bytes",
            "terrain as it is kept here, bytes",
            Some(stored.kept_bytes() as f64),
            None,
            "16 posts",
        ),
        figure(
            "held_pictures",
            "pictures that the memory holds",
            None,
            hardware.capture.is_held.then(|| (hardware.capture.memory_bytes as f64 / picture).floor()),
            "capture.memory_bytes / (columns lines pixel_bytes)",
        ),
    ]
}
