//! Both engines, set for one stage.

use std::collections::HashSet;

use control_plane::{ControlPlane, DigitalUnit, FrameSweeps, MachineStage};
use data_bank::DrumUnit;
use generator::{FrameError, Planes, Session};
use interpreter::parts::Drawn;
use interpreter::{
    DrumFigures, Event, Frame, FrameGiven, Given, Happening, Outcome, Part, Record, SceneData, Unknown,
    interpret,
};
use machine::Prepare;
use parts::{NoiseSource, Spread};
use quantities::unit_interval;
use rayon::iter::{IntoParallelIterator, ParallelIterator};
use scenario::Pose;
use signal::{Axis, Probe, Waveform};
use terrain_generator::broken_lines;

use crate::compare::{Sides, compare, compare_frame};
use crate::report::Report;

/// Changes the machine's waveforms before they are compared: how a comparison is seen to be awake.
pub type Tamper<'a> = &'a (dyn Fn(&mut Waveform) + Sync);

/// Both engines, set for one stage.
pub struct Engines {
    stage: MachineStage,
    session: Box<dyn Session>,
    control: ControlPlane,
    broken_lines: Vec<Vec<f64>>,
}

/// One sweep on both.
#[derive(Debug, Clone, PartialEq)]
pub struct Seen {
    /// What the machine recorded.
    pub machine: Vec<Waveform>,
    /// What the interpreter did.
    pub interpreter: Record,
    /// What a comparison of the two comes to.
    pub report: Report,
}

impl Engines {
    /// Elaborates the machine for `stage`.
    pub fn new(stage: MachineStage) -> Self {
        let session = stage.clone().prepare();
        let broken_lines = broken_lines(&stage.settings.analog);
        Self { control: ControlPlane::new(stage.clone()), stage, session, broken_lines }
    }

    /// Sweeps `sweeps` of frame `frame` seen from `pose`, on both; the report of the first has the events of the frame.
    ///
    /// # Errors
    /// If the pose cannot be drawn.
    pub fn run(
        &self,
        frame: u64,
        pose: &Pose,
        sweeps: impl IntoIterator<Item = u32>,
        tamper: Tamper<'_>,
    ) -> Result<Vec<Seen>, FrameError> {
        let digital = self.control.sweeps_with_gates(frame, pose)?;
        let lines = self.control.shadow_lines(&digital, pose.time);
        let scene = SceneData {
            landscape: &self.stage.landscape,
            settings: &self.stage.settings,
            sun: self.stage.scenery.sun(pose.time),
            eye: pose.eye,
            heading: pose.attitude.heading,
            pitch: pose.attitude.pitch,
            frame,
            course: self.stage.scenery.course(),
        };
        let own = self.frame(&scene, &digital);
        let of_frame = compare_frame(frame, &digital.frame_events(), &own.events);
        let wires = self.session.wires();
        let full_scales: Vec<_> = wires.iter().map(|wire| (wire.signal.name, wire.full_scale)).collect();
        let there: HashSet<&str> = wires.iter().map(|wire| wire.signal.name).collect();
        let one = |sweep: u32| {
            let mut probe = Probe::new(vec!["*".into()], sweep..sweep + 1);
            let counts = self.session.frame(frame, pose, &mut Planes::new(0, 0, &[]), &mut probe)?;
            let mut events = digital.events(sweep);
            if own.set_ups[sweep as usize] != sweep {
                events.retain(|event| event.unit != DigitalUnit::ShadowController);
            }
            let mut machine = probe.waveforms;
            machine.retain(|wave| wave.signal.axis != Axis::Changes && there.contains(wave.signal.name));
            machine.iter_mut().for_each(tamper);
            let values = |name: &str| {
                let wave = machine.iter().find(|wave| wave.signal.name == name);
                wave.map_or(&[][..], |wave| wave.values.as_slice())
            };
            let given = Given {
                ranges: values("sweep.range"),
                frame: &own,
                draw: |seed, words| unit_interval(seed, &words),
                lines: &lines,
                shadow: values("sc.or"),
                parts: drawn(self.stage.settings.seed, &self.broken_lines),
                full_scales: &full_scales,
            };
            let record = interpret(&scene, sweep, &given);
            let unknown =
                Unknown { craters: record.events.iter().any(has_lost_a_crater), breaks: record.has_breaks };
            let sides = Sides {
                scene: &scene,
                wires: &wires,
                sweep,
                unknown,
                machine: &machine,
                events: &events,
                record: &record,
            };
            let mut report = compare(&sides);
            report.counts = counts;
            Ok(Seen { machine, interpreter: record, report })
        };
        let seen: Result<Vec<Seen>, FrameError> =
            sweeps.into_iter().collect::<Vec<_>>().into_par_iter().map(one).collect();
        let mut seen = seen?;
        if let Some(first) = seen.first_mut() {
            first.report.add(of_frame);
        }
        Ok(seen)
    }

    /// The digital side of a frame as the interpreter sees it.
    fn frame(&self, scene: &SceneData<'_>, digital: &FrameSweeps<'_>) -> Frame {
        let drums =
            [0, 1].map(|level| self.control.drums(level).into_iter().map(figures).collect::<Vec<_>>());
        let given = FrameGiven {
            crossings: &digital.crossing_ticks(),
            vertices: digital.vertices_asked(),
            drums: [&drums[0], &drums[1]],
        };
        interpreter::frame(scene, &given)
    }

    /// The reports of [`run`](Self::run) in one.
    ///
    /// # Errors
    /// If the pose cannot be drawn.
    pub fn compare(
        &self,
        frame: u64,
        pose: &Pose,
        sweeps: impl IntoIterator<Item = u32>,
    ) -> Result<Report, FrameError> {
        let mut sum = Report::default();
        self.run(frame, pose, sweeps, &|_| {})?.into_iter().for_each(|seen| sum.add(seen.report));
        Ok(sum)
    }
}

/// What a seed draws for the parts of a model with these broken lines ([`terrain_generator::broken_lines`]), for the interpreter.
pub fn drawn(seed: u64, broken_lines: &[Vec<f64>]) -> Drawn<'_> {
    Drawn {
        seed,
        deviate: |seed, part, number| Spread::new(seed).deviate(part, number),
        noise: |seed, (source, number), [sweep, sample]| {
            NoiseSource::new(seed, source, number).normal(sweep, sample)
        },
        broken_lines,
    }
}

fn figures(DrumUnit { rotation, transfer, start_angle }: DrumUnit) -> DrumFigures {
    DrumFigures { rotation, transfer, start_angle }
}

fn has_lost_a_crater(event: &Event) -> bool {
    let Happening::Words { part: Part::Crater { .. }, outcome, .. } = event.what else { return false };
    outcome != Outcome::InTime
}
