//! Both engines, set for one stage.

use std::collections::HashSet;

use control_plane::{BankDemand, ControlPlane, DigitalUnit, FrameSweeps, MachineStage, ShadowBoundary};
use data_bank::{DrumUnit, Piece};
use generator::{FrameError, Planes, Session};
use hardware_model::ShadowParts;
use interpreter::parts::gates::Edge;
use interpreter::parts::kit::Kit;
use interpreter::parts::{Array, Drawn, LightStage};
use interpreter::{
    DrumFigures, Frame, FrameGiven, Given, GivenKind, Record, SceneData, ShadowLine, Unknown, interpret,
    range_programme, straight, why_not, why_straight,
};
use machine::Prepare;
use parts::{GateEdge, NoiseSource, Spread};
use quantities::{Timebase, unit_interval};
use rayon::iter::{IntoParallelIterator, ParallelIterator};
use scenario::Pose;
use shadow_controller::{COMPARATORS, PartsLines, comparator_of};
use signal::{Axis, Probe, Waveform};
use terrain_generator::broken_lines;

use crate::answers::compare_answers;
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
    /// Poses of the mission, one a frame.
    course: Vec<Pose>,
}

/// The stage that makes light of slopes, as one sweep drives it.
#[derive(Debug, Clone)]
pub struct LitSweep {
    /// The second engine's stage with its figures.
    pub stage: LightStage,
    /// Slopes of the machine to the north and to the east at the samples within the stored ground (m/m).
    pub slopes: [Vec<f64>; 2],
    /// Unit vector to the sun: north, east, up.
    pub to_sun: [f64; 3],
    /// Length of a sample (s).
    pub step: f64,
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
        let course = stage.scenery.course().to_vec();
        Self { control: ControlPlane::new(stage.clone()), stage, session, broken_lines, course }
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
        let own = self.own(&digital, (frame, pose));
        let of_frame = compare_frame(frame, &digital.frame_events(), &own.frame.events);
        let wires = self.session.wires();
        let there: HashSet<&str> = wires.iter().map(|wire| wire.signal.name).collect();
        let one = |sweep: u32| {
            let mut probe = Probe::new(vec!["*".into()], sweep..sweep + 1);
            let counts = self.session.frame(frame, pose, &mut Planes::new(0, 0, &[]), &mut probe)?;
            let mut events = digital.events(sweep);
            if own.frame.set_ups[sweep as usize] != sweep {
                events.retain(|event| event.unit != DigitalUnit::ShadowController);
            }
            let mut machine = probe.waveforms;
            machine.retain(|wave| there.contains(wave.signal.name));
            let answers: Vec<Waveform> =
                machine.extract_if(.., |wave| comparator_of(wave.signal.name).is_some()).collect();
            machine.retain(|wave| wave.signal.axis != Axis::Changes);
            machine.iter_mut().for_each(tamper);
            let record = own.interpret(&own.scene, sweep, &machine, 1);
            let unknown = unknown(&record);
            let sides = Sides {
                scene: &own.scene,
                wires: &wires,
                sweep,
                unknown,
                machine: &machine,
                events: &events,
                record: &record,
            };
            let mut report = compare(&sides);
            let turns = &own.gates[own.frame.set_ups[sweep as usize] as usize].turns;
            compare_answers(&sides, &answers, turns, &mut report);
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

    /// What the interpreter is given of a frame.
    fn scene(&self, frame: u64, pose: &Pose) -> SceneData<'_> {
        SceneData {
            landscape: &self.stage.landscape,
            settings: &self.stage.settings,
            sun: self.stage.scenery.sun(pose.time),
            eye: pose.eye,
            heading: pose.attitude.heading,
            pitch: pose.attitude.pitch,
            frame,
            course: &self.course,
        }
    }

    /// The array of real parts of a level (0 fine, 1 coarse) as sweep `sweep` drives it in the interpreter; none where the level or its
    /// parts are not there.
    ///
    /// # Errors
    /// If the pose cannot be drawn.
    pub fn array(
        &self,
        (frame, pose): (u64, &Pose),
        sweep: u32,
        level: usize,
    ) -> Result<Option<Array>, FrameError> {
        let digital = self.control.sweeps_with_gates(frame, pose)?;
        let own = self.own(&digital, (frame, pose));
        let ranges = range_programme(&own.scene.settings.range, own.scene.settings.raster.samples);
        let given = Given { shadow: &[], ..own.given(&ranges, &[], 1) };
        Ok(interpreter::array(&own.scene, sweep, &given, level))
    }

    /// The stage that makes light of slopes as sweep `sweep` drives it; none where it is ideal.
    ///
    /// # Errors
    /// If the pose cannot be drawn.
    pub fn light(&self, at: (u64, &Pose), sweep: u32) -> Result<Option<LitSweep>, FrameError> {
        let settings = &self.stage.settings;
        let step = 1.0 / settings.timebase.sample_rate().hertz();
        let drawn = drawn(settings.seed, &self.broken_lines);
        let Some(stage) = LightStage::of(&Kit { analog: &settings.analog, drawn: &drawn, step }, 1) else {
            return Ok(None);
        };
        const SLOPES: [&str; 2] = ["tg.slope.u", "tg.slope.v"];
        let (waves, record) = self.between(at, sweep, SLOPES.map(str::to_owned).into(), settings.timebase)?;
        let slopes = SLOPES.map(|name| {
            let wave = waves.iter().find(|wave| wave.signal.name == name);
            wave.map_or(vec![], |wave| wave.values[..record.samples].to_vec())
        });
        let to_sun = self.stage.scenery.sun(at.1.time).direction();
        Ok(Some(LitSweep { stage, slopes, to_sun, step }))
    }

    /// Sweep `sweep` on both, told between samples: the machine's waveforms of `signals` (patterns) and of what the interpreter is given,
    /// at samples, and what the interpreter makes of it at every step of `clocks`, up to the last within the stored ground. The clocks
    /// are those of the machine, divided.
    ///
    /// # Errors
    /// If the pose cannot be drawn.
    pub fn between(
        &self,
        (frame, pose): (u64, &Pose),
        sweep: u32,
        mut signals: Vec<String>,
        clocks: Timebase,
    ) -> Result<(Vec<Waveform>, Record), FrameError> {
        let digital = self.control.sweeps_with_gates(frame, pose)?;
        signals.extend(GIVEN.map(str::to_owned));
        let mut probe = Probe::new(signals, sweep..sweep + 1);
        self.session.frame(frame, pose, &mut Planes::new(0, 0, &[]), &mut probe)?;
        let own = self.own(&digital, (frame, pose));
        let mut settings = own.scene.settings.clone();
        let between = clocks.sweep_samples() / settings.timebase.sweep_samples();
        settings.timebase = clocks;
        let scene = SceneData { settings: &settings, ..own.scene };
        let record = own.interpret(&scene, sweep, &probe.waveforms, between);
        Ok((probe.waveforms, record))
    }

    /// Why the interpreter has no opinion on a signal of a sweep, as it has followed it.
    pub fn why_not(&self, signal: &str, record: &Record) -> Option<&'static str> {
        why_not(signal, &self.stage.settings, unknown(record))
    }

    /// Why the interpreter has nothing to say of a signal of a sweep between samples.
    pub fn why_straight(&self, signal: &str, record: &Record) -> Option<&'static str> {
        self.why_not(signal, record).or_else(|| why_straight(signal, &self.stage.settings))
    }

    fn own<'a>(&'a self, digital: &FrameSweeps<'_>, (frame, pose): (u64, &Pose)) -> Own<'a> {
        let scene = self.scene(frame, pose);
        Own {
            frame: self.frame(&scene, digital),
            scene,
            lines: self.control.shadow_lines(digital, pose.time).into_iter().map(shadow_line).collect(),
            gates: self.shadow_gates(digital),
            full_scales: self
                .session
                .wires()
                .iter()
                .map(|wire| (wire.signal.name, wire.full_scale))
                .collect(),
            parts: drawn(self.stage.settings.seed, &self.broken_lines),
        }
    }

    /// Gates of remote shadow of all sweeps as their line generators have them.
    fn shadow_gates(&self, digital: &FrameSweeps<'_>) -> Vec<ShadowGate> {
        let settings = &self.stage.settings;
        let is_real = !settings.analog.shadow_lines_are_ideal();
        let own = || PartsLines::new(&settings.shadow_controller, &settings.analog, settings.seed);
        let lines = is_real.then(own).flatten();
        let in_turn = match settings.shadow_controller {
            ShadowParts::Digital { line_generators: Some(count) } => count.max(1) as usize,
            _ => COMPARATORS.len(),
        };
        let gate = |sweep: u32| {
            let gate = digital.gate(sweep)?;
            let mut found: Vec<(usize, GateEdge)> = match &lines {
                Some(lines) => lines.answers(gate).collect(),
                // Ideal line generators take turns.
                None => gate.edges().enumerate().map(|(n, edge)| (n % in_turn, edge)).collect(),
            };
            found.sort_by(|(_, a), (_, b)| a.range.total_cmp(&b.range));
            let edge =
                |(turn, edge): (usize, GateEdge)| (turn, Edge { range: edge.range, slope: edge.slope });
            let (turns, edges) = found.into_iter().map(edge).unzip();
            Some(ShadowGate { dark_at_start: gate.dark_at_start, edges, turns })
        };
        (0..settings.raster.sweeps).map(|sweep| gate(sweep).unwrap_or_default()).collect()
    }

    /// Points of the broken lines of function generators ([`terrain_generator::broken_lines`]).
    pub fn broken_lines(&self) -> &[Vec<f64>] {
        &self.broken_lines
    }

    /// The digital side of a frame as the interpreter sees it.
    fn frame(&self, scene: &SceneData<'_>, digital: &FrameSweeps<'_>) -> Frame {
        let kinds = |bank: Vec<BankDemand>| -> Vec<GivenKind> { bank.into_iter().map(given_kind).collect() };
        let banks: Vec<Vec<GivenKind>> = self.control.demands(scene.frame).into_iter().map(kinds).collect();
        let given = FrameGiven {
            crossings: &digital.crossing_ticks(),
            vertices: digital.vertices_asked(),
            banks: &banks,
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

/// Signals of the machine that the interpreter is given: ground range of the samples, gate of remote shadow.
const GIVEN: [&str; 2] = ["sweep.range", "sc.or"];

/// A gate of remote shadow as its line generators have it.
#[derive(Debug, Clone, Default)]
struct ShadowGate {
    /// Whether the sweep starts in shadow.
    dark_at_start: bool,
    /// Where it changes, ascending.
    edges: Vec<Edge>,
    /// Number of the line generator that finds each of them.
    turns: Vec<usize>,
}

/// What the interpreter has of a frame.
struct Own<'a> {
    scene: SceneData<'a>,
    frame: Frame,
    lines: Vec<ShadowLine>,
    /// Gates of remote shadow by sweep.
    gates: Vec<ShadowGate>,
    full_scales: Vec<(&'static str, f64)>,
    parts: Drawn<'a>,
}

impl Own<'_> {
    /// What the interpreter makes of a sweep of `scene`, whose clock has `between` steps in each sample of the `machine`'s waveforms.
    fn interpret(&self, scene: &SceneData<'_>, sweep: u32, machine: &[Waveform], between: u32) -> Record {
        let [ranges, shadow] = GIVEN.map(|name| {
            let wave = machine.iter().find(|wave| wave.signal.name == name);
            wave.map_or(&[][..], |wave| &wave.values)
        });
        let steps = between as usize;
        let ranges = straight(stretched(ranges, steps), steps);
        let shadow = stretched(shadow, steps);
        let ShadowGate { dark_at_start, edges, .. } =
            &self.gates[self.frame.set_ups[sweep as usize] as usize];
        let given = Given { shadow_edges: (*dark_at_start, edges), ..self.given(&ranges, &shadow, steps) };
        interpret(scene, sweep, &given)
    }

    fn given<'g>(&'g self, ranges: &'g [f64], shadow: &'g [f64], between: usize) -> Given<'g> {
        Given {
            ranges,
            frame: &self.frame,
            draw: |seed, words| unit_interval(seed, &words),
            lines: &self.lines,
            shadow,
            shadow_edges: (false, &[]),
            parts: self.parts,
            between,
            full_scales: &self.full_scales,
        }
    }
}

/// Each value `between` times; the last once, as nothing lies behind it.
fn stretched(values: &[f64], between: usize) -> Vec<f64> {
    let count = values.len().saturating_sub(1) * between + values.len().min(1);
    values.iter().flat_map(|value| std::iter::repeat_n(*value, between)).take(count).collect()
}

fn unknown(record: &Record) -> Unknown {
    Unknown { breaks: record.has_breaks }
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

fn shadow_line(ShadowBoundary { ends, there_from }: ShadowBoundary) -> ShadowLine {
    ShadowLine { ends, there_from: there_from.map(|tick| tick.0 as i64) }
}

/// A kind of data on its drums. What is asked of terrain the interpreter works out itself.
fn given_kind(BankDemand { kind, drums, asked }: BankDemand) -> GivenKind {
    let pieces =
        |pieces: Vec<Piece>| pieces.iter().map(|piece| [piece.item, piece.records]).collect::<Vec<_>>();
    GivenKind {
        kind: kind as usize,
        drums: drums.into_iter().map(figures).collect(),
        asked: if kind.level().is_some() { vec![] } else { asked.into_iter().map(pieces).collect() },
    }
}

fn figures(DrumUnit { rotation, transfer, start_angle }: DrumUnit) -> DrumFigures {
    DrumFigures { rotation, transfer, start_angle }
}
