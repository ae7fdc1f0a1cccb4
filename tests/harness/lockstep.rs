//! A scene by hand on machine and interpreter.

use ::lockstep::{Engines, Report, Seen, drawn};
use interpreter::{FrameGiven, Given, Record, interpret, range_programme};

use crate::ComparedScene;

/// All sweeps of a frame on both engines.
#[derive(Debug, Clone, PartialEq)]
pub struct Lockstep {
    /// What was seen of each sweep, in order.
    pub sweeps: Vec<Seen>,
    /// Of all sweeps together.
    pub report: Report,
}

impl Lockstep {
    /// Runs frame `frame` of a scene on both.
    ///
    /// # Panics
    /// If the machine cannot draw the scene.
    pub fn run(scene: &ComparedScene, frame: u64) -> Self {
        let engines = Engines::new(scene.stage());
        let sweeps = engines.run(frame, &scene.pose(), 0..scene.sweeps, &|_| {});
        let sweeps = sweeps.expect("a pose that can be drawn");
        let mut report = Report::default();
        sweeps.iter().for_each(|seen| report.add(seen.report.clone()));
        Self { sweeps, report }
    }

    /// What the machine recorded of a signal in a sweep.
    ///
    /// # Panics
    /// If it has no such signal.
    pub fn machine(&self, sweep: usize, signal: &str) -> &[f64] {
        let mut waves = self.sweeps[sweep].machine.iter();
        &waves.find(|wave| wave.signal.name == signal).expect("a signal of the machine").values
    }
}

/// The interpreter alone: sweep 0 of frame 0, along its own range programme.
pub fn walk(scene: &ComparedScene) -> Record {
    let stage = scene.stage();
    let scene = interpreter::SceneData {
        landscape: &stage.landscape,
        settings: &stage.settings,
        sun: scene.sun,
        eye: scene.eye,
        heading: scene.heading,
        pitch: scene.pitch,
        frame: 0,
        course: &[],
    };
    let frame = interpreter::frame(&scene, &FrameGiven { crossings: &[], vertices: 0, banks: &[] });
    let ranges = range_programme(&stage.settings.range, stage.settings.raster.samples);
    interpret(
        &scene,
        0,
        &Given {
            ranges: &ranges,
            frame: &frame,
            draw: |_, _| 0.0,
            lines: &[],
            shadow_edges: (false, &[]),
            shadow: &[],
            parts: drawn(0, &[]),
            between: 1,
            full_scales: &[],
        },
    )
}
