//! What frames took beside what the machine has: the condition for a full frame, and the other units.

use generator::SizedFigure;
use timing::{FrameTiming, Task};

use crate::session::Session;
use crate::work::{BEAM, GEOMETRY, LIGHT_POINTS, LISTS, PIXELS, SAMPLER, STACK};

const FULL: &str = "sum over sub-areas of max(entries, least) + calligraphic <= sampler_hz / update_hz";

/// Figures of `frames`; those that are never begun do not count.
pub fn figures(session: &Session, frames: &[FrameTiming]) -> Vec<SizedFigure> {
    let frames: Vec<&FrameTiming> = frames.iter().filter(|frame| !frame.tasks.is_empty()).collect();
    let mean = |of: &dyn Fn(&FrameTiming) -> u64| {
        (!frames.is_empty())
            .then(|| frames.iter().map(|frame| of(frame)).sum::<u64>() as f64 / frames.len() as f64)
    };
    let sampler = |frame: &FrameTiming| ticks(frame, &[SAMPLER, STACK, LIGHT_POINTS]);
    let frame = session.field_ticks() as f64;
    let areas = session.screen.sub_areas() as f64;
    let entries = mean(&|frame| pieces(frame, SAMPLER, "entries")).map(|entries| entries / areas);
    let pixels = session.screen.size().into_iter().map(u64::from).product::<u64>();
    let points = |frame: &FrameTiming| {
        let beam = frame.units.iter().find(|unit| unit.unit == BEAM);
        beam.map_or(0, |beam| u64::from(beam.longest_queue))
    };
    let field = 1e9 / session.stage.view.update.hertz();
    let figure = |key, meaning, measured, formula, law| SizedFigure {
        key,
        meaning,
        measured,
        formula: Some(formula),
        law,
    };
    vec![
        figure("sampler_ticks", "ticks of the sampler a frame, mean", mean(&sampler), frame, FULL),
        figure(
            "sampler_ticks_most",
            "  most",
            frames.iter().map(|frame| sampler(frame) as f64).reduce(f64::max),
            frame,
            "the same",
        ),
        figure("entries", "entries a sub-area", entries, frame / areas, "sampler_hz / (update_hz sub-areas)"),
        figure(
            "frame_tasks_ticks",
            "ticks of geometry and lists a frame",
            mean(&|frame| ticks(frame, &[GEOMETRY, LISTS])),
            frame,
            "feature_ticks features + corner_ticks corners + pairs <= sampler_hz / update_hz",
        ),
        figure(
            "pixel_ticks",
            "ticks of the pixel writer a frame",
            mean(&|frame| ticks(frame, &[PIXELS])),
            (pixels as f64 / session.hardware.pixels_tick as f64).ceil(),
            "pixels / pixels_tick",
        ),
        figure(
            "beam_points",
            "points for the beam a frame",
            mean(&points),
            session.hardware.beam.most(field as u64) as f64,
            "points <= 1 / (update_hz (jump + dwell))",
        ),
    ]
}

/// Ticks of the tasks of some units.
fn ticks(frame: &FrameTiming, units: &[&str]) -> u64 {
    let ours = frame.tasks.iter().filter(|task| units.contains(&task.unit.as_str()));
    ours.map(|task| task.ticks).sum()
}

/// Pieces of a task of a unit.
fn pieces(frame: &FrameTiming, unit: &str, task: &str) -> u64 {
    let is_it = |known: &&Task| (known.unit.as_str(), known.task.as_str()) == (unit, task);
    frame.tasks.iter().find(is_it).map_or(0, |task| task.pieces)
}

#[cfg(test)]
mod tests {
    use generator::{SizedFigure, Timed};

    use crate::{Clocked, scenes};

    /// At 10 frames a second and 1 kHz a frame has 100 ticks, 25 a sub-area. The pane and two stars have lists of 2, 1, 2 and 0
    /// entries, six corners, three features of the sky and one point for the beam.
    #[test]
    fn figures_are_the_works_of_the_frames() {
        let (generator, update) = scenes::slow(10);
        let clocked = Clocked::new(
            scenes::stage(scenes::pane_and_stars(), update),
            generator.parameters,
            generator.hardware,
        )
        .unwrap();
        let frame = Timed::frame(&clocked, 0, &scenes::pose()).unwrap();
        let before = frame.tasks.iter().filter(|task| ["geometry", "lists"].contains(&task.unit.as_str()));
        let before = before.map(|task| task.ticks).sum::<u64>() as f64;
        let told = |figure: SizedFigure| (figure.key, figure.measured, figure.formula);
        let figures: Vec<_> = clocked.sizing(&[frame]).into_iter().map(told).collect();
        let expected = [
            ("sampler_ticks", Some(7.0), Some(100.0)),
            ("sampler_ticks_most", Some(7.0), Some(100.0)),
            ("entries", Some(1.25), Some(25.0)),
            ("frame_tasks_ticks", Some(before), Some(100.0)),
            ("pixel_ticks", Some(4.0), Some(4.0)),
            ("beam_points", Some(1.0), Some(10_000.0)),
        ];
        assert_eq!(figures, expected);
    }
}
