//! One sweep of both engines, signal by signal and event by event.

use control_plane::DigitalEvent;
use features::{Crater, Shape};
use hardware_model::AnalogParts;
use interpreter::clock::Clock;
use interpreter::{Event, Record, SceneData, Unknown, range_programme, why_not};
use scenario::Scalar;
use signal::{Unit, Waveform, Wire};

use crate::bounds;
use crate::events::{in_order, of_machine};
use crate::report::{Difference, EventDifference, Report, Tally};

/// One sweep as both have it.
pub struct Sides<'a> {
    pub scene: &'a SceneData<'a>,
    pub wires: &'a [Wire],
    pub sweep: u32,
    pub unknown: Unknown,
    pub machine: &'a [Waveform],
    pub events: &'a [DigitalEvent],
    pub record: &'a Record,
}

/// What the comparison comes to.
pub fn compare(sides: &Sides<'_>) -> Report {
    let mut report = Report { sweeps: 1, ..Report::default() };
    compare_events(sides, &mut report);
    let mut first: Option<Difference> = None;
    for wave in sides.machine {
        let (tally, difference) = sides.signal(wave);
        report.signals.insert(wave.signal.name.to_owned(), tally);
        // Of one sample, the signal that comes first in the drawing.
        if let Some(difference) = difference
            && first.as_ref().is_none_or(|first| difference.sample < first.sample)
        {
            first = Some(difference);
        }
    }
    report.difference = first;
    report
}

/// The events of the crossings, and those of the loads: each list has its own roundings.
fn compare_events(sides: &Sides<'_>, report: &mut Report) {
    let Sides { scene, record, .. } = *sides;
    let is_load = |event: &Event| event.level.is_none();
    let lists = |of: &[Event]| -> [Vec<Event>; 2] {
        let (loads, crossings): (Vec<_>, Vec<_>) = of.iter().copied().partition(is_load);
        [crossings, loads].map(|events| in_order(&events, record.last_ticks))
    };
    let [crossings, loads] = lists(&of_machine(sides.events));
    let [own_crossings, own_loads] = lists(&record.events);
    let stops_undecided = record.undecided.iter().any(|ticks| !ticks.is_empty());
    let place = (scene.frame, Some(sides.sweep));
    compare_lists(place, [&crossings, &own_crossings], stops_undecided, report);
    compare_lists(place, [&loads, &own_loads], record.loads_undecided, report);
}

/// Events of a whole frame.
pub fn compare_frame(frame: u64, machine: &[DigitalEvent], interpreter: &[Event]) -> Report {
    let mut report = Report::default();
    let [machine, interpreter] =
        [&of_machine(machine)[..], interpreter].map(|events| in_order(events, [i64::MAX; 2]));
    compare_lists((frame, None), [&machine, &interpreter], false, &mut report);
    report
}

/// The machine's list and the interpreter's, of a frame or of one of its sweeps. Where rounding says which tick sees an event, a
/// list that differs is left out.
fn compare_lists(
    (frame, sweep): (u64, Option<u32>),
    [machine, interpreter]: [&[Event]; 2],
    undecided: bool,
    report: &mut Report,
) {
    let first = (0..machine.len().max(interpreter.len())).find(|&k| machine.get(k) != interpreter.get(k));
    let Some(first) = first else {
        for event in machine {
            *report.events.entry(event.what.name()).or_default() += 1;
        }
        return;
    };
    if undecided {
        report.events_left_out += machine.len() as u64;
        return;
    }
    let [machine, interpreter] = [machine, interpreter].map(|events| events.get(first).copied());
    report.event_difference.get_or_insert(EventDifference { frame, sweep, machine, interpreter });
}

impl Sides<'_> {
    /// One signal: its row, and the first sample at which it differs.
    fn signal(&self, wave: &Waveform) -> (Tally, Option<Difference>) {
        let name = wave.signal.name;
        let mut tally = Tally::default();
        if let Some(reason) = why_not(name, self.scene.settings, self.unknown) {
            tally.not_compared.insert(reason, wave.values.len() as u64);
            return (tally, None);
        }
        let programme;
        let expected = if name == "sweep.range" {
            programme = range_programme(&self.scene.settings.range, self.scene.settings.raster.samples);
            programme.as_slice()
        } else {
            self.record.signals.get(name).map_or(&[][..], Vec::as_slice)
        };
        let beyond = wave.values.len() - expected.len();
        if beyond > 0 {
            tally.not_compared.insert("beyond the stored ground", beyond as u64);
        }
        let declared = self.declared(wave);
        let scale = self.full_scale(wave, declared, expected);
        let (bound, doubts, carried) = (self.bound(name), self.doubts(name), self.carried(name));
        let (is_line, mut first) = (wave.signal.unit == Unit::Line, None);
        for (sample, (&machine, &interpreter)) in wave.values.iter().zip(expected).enumerate() {
            if doubts.has(sample) {
                tally.doubtful += 1;
                continue;
            }
            tally.samples += 1;
            let scale = if is_line { off_the_picture(declared, interpreter) } else { scale };
            let carried =
                carried.get(sample).map_or(0.0, |carried| carried * if is_line { scale } else { 1.0 });
            let allowed = if wave.signal.unit == Unit::Gate { 0.0 } else { bound * scale + carried };
            let off = (machine - interpreter).abs();
            if wave.signal.unit != Unit::Gate {
                tally.worst = tally.worst.max(off / scale);
            }
            // NaN agrees with nothing.
            let agrees = off <= allowed;
            if !agrees && first.is_none() {
                first = Some(Difference { machine, interpreter, allowed, ..self.place(name, sample) });
            }
        }
        (tally, first)
    }

    /// A difference of `signal` at a sample of the sweep, whose values are not said yet.
    pub fn place(&self, signal: &str, sample: usize) -> Difference {
        Difference {
            signal: signal.to_owned(),
            frame: self.scene.frame,
            sweep: self.sweep,
            sample,
            tick: Clock::of(self.scene, self.sweep).last_before(sample as f64),
            range: self.range(sample),
            machine: f64::NAN,
            interpreter: f64::NAN,
            allowed: 0.0,
        }
    }

    fn range(&self, sample: usize) -> f64 {
        let wave = self.machine.iter().find(|wave| wave.signal.name == "sweep.range");
        wave.and_then(|wave| wave.values.get(sample)).copied().unwrap_or(f64::NAN)
    }

    /// Full scale of the wire, or the largest value that the sweep has on it; the summer takes the eye's height off, so
    /// that counts as a height.
    fn full_scale(&self, wave: &Waveform, declared: f64, values: &[f64]) -> f64 {
        let eye = if wave.signal.unit == Unit::Metre { self.scene.eye[2].abs() } else { 0.0 };
        values.iter().fold(declared.max(eye), |largest, value| largest.max(value.abs()))
    }

    fn declared(&self, wave: &Waveform) -> f64 {
        let wire = self.wires.iter().find(|wire| wire.signal == wave.signal);
        wire.map_or(1.0, |wire| wire.full_scale)
    }

    fn bound(&self, name: &str) -> f64 {
        let settings = self.scene.settings;
        let steps = self.steps(name);
        let craters = match name {
            "fg.height" | "fg.slope.u" | "fg.slope.v" | "fg.reflectivity" | "mu.reflectivity"
            | "sm.video" => self.of_craters(),
            _ => 0.0,
        };
        let own = match name {
            // A rounding of 1/z shows in the farthest range by the ratio of both ends.
            "sweep.range" => 4.0 * f64::EPSILON * (settings.range.end / settings.range.start).max(16.0),
            "mu.reflectivity" | "sm.video" if lies_behind_parts(name, &settings.analog) => {
                bounds::of_edges_of_parts(settings.scalar)
            }
            "tg.reflectivity" | "fg.reflectivity" if lies_behind_parts(name, &settings.analog) => {
                bounds::of_light_of_parts(settings.scalar)
            }
            _ if lies_behind_parts(name, &settings.analog) => bounds::of_parts(settings.scalar),
            _ => bounds::of(settings.scalar),
        };
        own * steps + craters
    }

    /// Differences of neighbours: each of both may be off, that is one of a step, and a quarter of a microsecond has many.
    fn steps(&self, name: &str) -> f64 {
        match name {
            "dpp.derivative" => 2.0 * (0.25e-6 * self.scene.settings.timebase.sample_rate().hertz()).max(1.0),
            _ => 1.0,
        }
    }

    /// What the heights of both sides, which are compared on a wire of their own, are apart, as the signals behind them have it at each
    /// sample: an elevation is height over range, so that near the foot of the beam a rounding of the height counts most. Nothing in an
    /// ideal chain, and nothing of other signals.
    fn carried(&self, name: &str) -> Vec<f64> {
        let is_elevation = name == "dpp.elevation";
        if !(is_elevation || matches!(name, "dpp.hold" | "dpp.derivative" | "dpp.y"))
            || !lies_behind_parts(name, &self.scene.settings.analog)
        {
            return Vec::new();
        }
        let height = self.machine.iter().find(|wave| wave.signal.name == "mu.height");
        let (Some(machine), Some(interpreter)) = (height, self.record.signals.get("mu.height")) else {
            return Vec::new();
        };
        // A line position goes by the share of full scale.
        let elevation = self.wires.iter().find(|wire| wire.signal.name == "dpp.elevation");
        let unit = elevation.filter(|_| name == "dpp.y").map_or(1.0, |wire| wire.full_scale);
        let (steps, mut largest) = (self.steps(name), 0.0_f64);
        let apart =
            machine.values.iter().zip(interpreter).enumerate().map(|(sample, (machine, interpreter))| {
                let here = steps * (machine - interpreter).abs() / self.range(sample) / unit;
                largest = largest.max(here);
                // The others remember elevations that have passed.
                if is_elevation { here } else { largest }
            });
        apart.collect()
    }

    fn of_craters(&self) -> f64 {
        let rings = self.scene.landscape.features().craters().iter().map(|crater| narrowest(&crater));
        let ring = rings.fold(f64::INFINITY, f64::min);
        bounds::of_craters(self.scene.settings.scalar, ring, self.scene.settings.range.end)
    }

    fn doubts(&self, name: &str) -> Doubts<'_> {
        let scalar = self.scene.settings.scalar;
        let undecided = match (name, scalar) {
            (_, scalar) if lies_behind_parts(name, &self.scene.settings.analog) => bounds::undecided(scalar),
            ("dpp.blank" | "sm.video", Scalar::F64) => 4.0 * bounds::F64,
            ("dpp.blank" | "sm.video", Scalar::F32) => 4.0 * bounds::F32,
            (_, scalar) => bounds::undecided(scalar),
        };
        let stairs = if name == "sweep.range" { &[][..] } else { &self.record.stairs };
        let margins = self.record.margins.get(name).map_or(&[][..], Vec::as_slice);
        Doubts { margins, undecided, stairs, between_words: bounds::between_words(scalar) }
    }
}

/// Where rounding decides what a signal is, so that both engines may be right.
struct Doubts<'a> {
    /// Distance of each sample from another decision.
    margins: &'a [f64],
    undecided: f64,
    /// Distance of each sample from another word of the converters.
    stairs: &'a [f64],
    between_words: f64,
}

impl Doubts<'_> {
    fn has(&self, sample: usize) -> bool {
        let is_below = |list: &[f64], limit: f64| list.get(sample).is_some_and(|&near| near < limit);
        is_below(self.stairs, self.between_words) || is_below(self.margins, self.undecided)
    }
}

/// Whether a signal comes from real parts, or from blocks that are driven by some.
fn lies_behind_parts(name: &str, parts: &AnalogParts) -> bool {
    let features = !parts.features_are_ideal();
    let mixed = features || !parts.texture_is_ideal() || !parts.switching_is_ideal();
    let own = match name.split('.').next() {
        Some("fg") => features,
        Some("mu") => mixed,
        Some("dpp" | "sm") => mixed || !parts.beam_is_ideal(),
        Some("txg") => return features || !parts.texture_is_ideal(),
        _ => false,
    };
    name != "sweep.range" && (own || !parts.terrain_is_ideal())
}

/// Width of the narrowest ring of a crater, or the radius of its bowl (m).
fn narrowest(crater: &Crater) -> f64 {
    match crater.shape() {
        Shape::Bowl { r1 } => r1,
        Shape::RimmedBowl { r1, r2 } => r1.min(r2 - r1),
        Shape::FlatFloor { r1, r2, r3 } => (r2 - r1).min(r3 - r2),
    }
}

/// Full scale of a line position: it is a quotient, and off the picture its divisor goes to 0, so that a rounding of the
/// elevation counts with the square of the position.
fn off_the_picture(lines: f64, position: f64) -> f64 {
    let pictures = 1.0 + position.abs() / lines;
    lines * pictures * pictures
}
