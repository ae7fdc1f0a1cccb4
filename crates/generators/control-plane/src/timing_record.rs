//! The timing record of a frame: what the service of every sweep did, the processor, the data banks.

use std::collections::BTreeMap;

use data_bank::FrameSupply;
use dpu::{CpuTime, LineUse};
use generator::FrameError;
use hardware_model::{CrossingServer, Settings, ShadowParts};
use quantities::SweepTime;
use rayon::iter::{IntoParallelIterator, ParallelIterator};
use scenario::Pose;
use shadow_controller::Gate;
use sweep_program::Colour;
use timing::{Cause, Deadline, EventHash, FrameTiming, Missed, Sets, Slack, UnitUse};

use crate::control_plane::ControlPlane;
use crate::data_kind::DataKind;
use crate::digital::DigitalFrame;
use crate::frame_sweeps::FrameSweeps;
use crate::sweep_recorder::SweepRecorder;
use crate::ticks::{frame_ticks, sweep_ticks};

/// Events of a sweep and their hash, to be joined.
type Part = (u64, [u8; 32]);

impl ControlPlane {
    /// Timing of frame `frame`, by all threads of the current pool; the same for any number of them.
    ///
    /// # Errors
    /// If the pose cannot be drawn.
    pub fn frame(&self, frame: u64, pose: &Pose) -> Result<FrameTiming, FrameError> {
        let sweeps = self.sweeps(frame, pose)?;
        let (recorders, parts) = self.recorders(&sweeps, pose.time, true)?;
        let (_, events_blake3) = EventHash::join(parts.into_iter().flatten());
        Ok(FrameTiming { events_blake3, ..self.summary(frame, &sweeps, recorders) })
    }

    /// The same without the hash of the events.
    pub(crate) fn frame_for_totals(&self, frame: u64, pose: &Pose) -> Result<FrameTiming, FrameError> {
        let sweeps = self.sweeps(frame, pose)?;
        let (recorders, _) = self.recorders(&sweeps, pose.time, false)?;
        Ok(self.summary(frame, &sweeps, recorders))
    }

    /// What the service of every sweep at `time` (s) did, and the hash of its events where one is asked for.
    fn recorders(
        &self,
        sweeps: &FrameSweeps<'_>,
        time: f64,
        is_hashed: bool,
    ) -> Result<(Vec<SweepRecorder>, Vec<Option<Part>>), FrameError> {
        let crossings = sweeps.crossings();
        let gates = self.gates(sweeps, time)?;
        let record = |sweep: u32| {
            let drawn = sweeps.set_up_of(sweep);
            let hash = is_hashed.then(EventHash::new);
            let mut recorder = SweepRecorder::of(&crossings, [drawn, sweep], hash);
            recorder.note_features(&crossings, drawn);
            recorder.note_gate(&crossings, gates.get(drawn as usize));
            let part = recorder.hash.take().map(|hash| hash.part());
            (recorder, part)
        };
        Ok((0..self.stage().settings.raster.sweeps).into_par_iter().map(record).unzip())
    }

    /// Shadow gates of all sweeps, if a boundary can come late in them or find no line generator: only then has the shadow
    /// any timing.
    fn gates(&self, sweeps: &FrameSweeps<'_>, time: f64) -> Result<Vec<Gate>, FrameError> {
        let settings = &self.stage().settings;
        let ShadowParts::Digital { line_generators } = settings.shadow_controller else {
            return Ok(Vec::new());
        };
        if self.blocks().shadows.is_none() || (settings.segment_words.is_none() && line_generators.is_none())
        {
            return Ok(Vec::new());
        }
        self.shadow_gates(sweeps, time)
    }

    /// The timing of a frame without the hash of its events.
    fn summary(&self, frame: u64, sweeps: &FrameSweeps<'_>, recorders: Vec<SweepRecorder>) -> FrameTiming {
        let digital = sweeps.digital();
        let [start, end] = frame_ticks(self.stage(), frame);
        let mut deadlines = BTreeMap::from([(Deadline::TRANSFER, Slack::default())]);
        let mut sets = Sets::default();
        let (mut folds, mut events, mut late_words, mut misses) = (0, 0, 0, Vec::new());
        let mut lines = [LineUse::default(); 4];
        let mut load_ticks = [0; 2];
        for sweep in recorders {
            deadlines.entry(Deadline::TRANSFER).or_default().merge(&sweep.transfers);
            let others = [
                (Deadline::CORNER, &sweep.corners),
                (Deadline::FEATURE, &sweep.features),
                (Deadline::SEGMENT, &sweep.segments),
            ];
            for (deadline, slack) in others.into_iter().filter(|(_, slack)| slack.count > 0) {
                deadlines.entry(deadline).or_default().merge(slack);
            }
            for (sum, ticks) in load_ticks.iter_mut().zip(sweep.load_ticks) {
                *sum += ticks;
            }
            add_sets(&mut sets, &sweep.sets);
            folds += sweep.folds;
            events += sweep.events();
            late_words += sweep.late_words;
            for (line, used) in lines.iter_mut().zip(&sweep.lines) {
                line.busy += used.busy;
                line.interrupts += used.interrupts;
                line.longest_queue = line.longest_queue.max(used.longest_queue);
            }
            misses.extend(sweep.misses);
        }
        let mut units = self.loader_units(&lines);
        self.processor(digital, &lines, &mut deadlines, &mut units, &mut misses);
        units.extend(drum_units(digital));
        if self.stage().settings.data_banks.channels.count.is_some() {
            units.extend(channel_units(digital));
        }
        units.extend(editor_units(digital, &self.stage().settings));
        note_squares(sweeps, (end.0 - start.0) as i64, &mut deadlines, &mut misses);
        units.extend(self.load_units(load_ticks));
        misses.sort_by(|a, b| a.sweep.cmp(&b.sweep).then(a.due.total_cmp(&b.due)));
        FrameTiming {
            frame,
            ticks: end.0 - start.0,
            folds,
            sets,
            late_words,
            vertices: digital.vertices(),
            deadlines,
            units,
            tasks: Vec::new(),
            level_changes: Vec::new(),
            misses,
            events,
            events_blake3: String::new(),
        }
    }

    fn loader_units(&self, lines: &[LineUse; 4]) -> Vec<UnitUse> {
        let unit = |unit: &str, line: &LineUse| UnitUse {
            unit: unit.into(),
            busy: line.busy,
            longest_queue: line.longest_queue,
        };
        match self.stage().settings.loader.served_by {
            CrossingServer::WiredPointers => Colour::ALL
                .map(|colour| unit(&format!("loader.{}", colour.name()), &lines[colour as usize]))
                .into(),
            CrossingServer::IoProcessor => vec![unit("io-processor", &lines[0])],
            CrossingServer::CpuInterrupt => Vec::new(),
        }
    }

    /// Lines on which the words of craters and of shadow boundaries come, where they take time.
    fn load_units(&self, [features, segments]: [u64; 2]) -> Vec<UnitUse> {
        let settings = &self.stage().settings;
        let has_features = self.blocks().features && settings.feature_words.is_some();
        let has_segments = self.blocks().shadows.is_some() && settings.segment_words.is_some();
        let lines = [
            (has_features, "feature-generator.load", features),
            (has_segments, "shadow-controller.load", segments),
        ];
        let there = lines.into_iter().filter(|(is_there, ..)| *is_there);
        there.map(|(_, unit, busy)| UnitUse { unit: unit.into(), busy, longest_queue: 0 }).collect()
    }

    fn processor(
        &self,
        digital: &DigitalFrame,
        lines: &[LineUse; 4],
        deadlines: &mut BTreeMap<Deadline, Slack>,
        units: &mut Vec<UnitUse>,
        misses: &mut Vec<Missed>,
    ) {
        let Some(cpu) = &digital.cpu else { return };
        let serves = self.stage().settings.loader.served_by == CrossingServer::CpuInterrupt;
        let longest_queue = if serves { lines[0].longest_queue } else { 0 };
        units.push(UnitUse { unit: "cpu".into(), busy: cpu.time.busy(), longest_queue });
        let CpuTime { interrupts, words, set_ups, tables, vertices } = cpu.time;
        let tasks = [
            ("interrupts", interrupts),
            ("words", words),
            ("set-ups", set_ups),
            ("tables", tables),
            ("vertices", vertices),
        ];
        let task = |(task, busy)| UnitUse { unit: format!("cpu.{task}"), busy, longest_queue: 0 };
        units.extend(tasks.map(task));
        let settings = &self.stage().settings;
        let set_up = deadlines.entry(Deadline::SWEEP_SET_UP).or_default();
        let per_sample = settings.timebase.ticks_per_sample();
        for &(sweep, slack) in &cpu.set_ups {
            set_up.add(slack);
            if slack < 0 {
                misses.push(late_task(Deadline::SWEEP_SET_UP, sweep, Some(-slack as f64 / per_sample)));
            }
        }
        for (sweep, &drawn) in cpu.drawn.iter().enumerate() {
            let made = cpu.set_ups.iter().any(|&(made, _)| made as usize == sweep);
            if !made && drawn as usize != sweep {
                set_up.add(-sweep_ticks(settings));
                misses.push(late_task(Deadline::SWEEP_SET_UP, sweep as u32, None));
            }
        }
        deadlines.entry(Deadline::FRAME_TASKS).or_default().add(cpu.frame_slack);
        if cpu.frame_slack < 0 {
            let last = self.stage().settings.raster.sweeps - 1;
            misses.push(late_task(Deadline::FRAME_TASKS, last, None));
        }
    }
}

/// A task of the processor that was not ready.
fn late_task(deadline: Deadline, sweep: u32, came: Option<f64>) -> Missed {
    Missed { came, ..Missed::of(deadline, sweep, Cause::Processor) }
}

/// The drums of every bank: all that they did, then each kind's share where several kinds lie on them.
fn drum_units(digital: &DigitalFrame) -> Vec<UnitUse> {
    bank_units(digital, "drum", |supply| (&supply.busy, supply.longest_queue))
}

/// The channels likewise. Nothing waits for a channel but the drums that would use it.
fn channel_units(digital: &DigitalFrame) -> Vec<UnitUse> {
    bank_units(digital, "channel", |supply| (&supply.carried, 0))
}

/// `drum.fine.0` and so on, with what `of` reads of a supply: ticks of each unit, and its longest queue.
fn bank_units(
    digital: &DigitalFrame,
    unit: &str,
    of: impl Fn(&FrameSupply) -> (&Vec<u64>, u32),
) -> Vec<UnitUse> {
    let mut units = Vec::new();
    for bank in digital.supplies.iter().filter(|supplied| supplied.names_drums()) {
        let kinds = digital.supplies.iter().filter(|supplied| supplied.drums == bank.kind);
        let kinds: Vec<(&str, (&Vec<u64>, u32))> =
            kinds.map(|supplied| (supplied.kind.name(), of(supplied.supply()))).collect();
        for number in 0..kinds[0].1.0.len() {
            let name = format!("{unit}.{}.{number}", bank.kind.name());
            let busy = kinds.iter().map(|(_, (ticks, _))| ticks[number]).sum();
            units.push(UnitUse { unit: name.clone(), busy, longest_queue: kinds[0].1.1 });
            let shares = kinds.iter().filter(|_| kinds.len() > 1).map(|(kind, (ticks, queue))| UnitUse {
                unit: format!("{name}.{kind}"),
                busy: ticks[number],
                longest_queue: *queue,
            });
            units.extend(shares);
        }
    }
    units
}

/// I/O processors that edit records, where editing takes time.
fn editor_units(digital: &DigitalFrame, settings: &Settings) -> Vec<UnitUse> {
    let banks = &settings.kind_banks;
    let edits = |kind: DataKind| match kind {
        DataKind::Fine | DataKind::Coarse => banks.terrain_edit > 0.0,
        DataKind::Features => banks.features.edit > 0.0,
        DataKind::Shadows => banks.shadows.edit > 0.0,
        DataKind::Polyhedra => banks.polyhedra.edit > 0.0,
    };
    let there = digital.supplies.iter().filter(|supplied| edits(supplied.kind));
    there
        .map(|supplied| UnitUse {
            unit: format!("editor.{}", supplied.kind.name()),
            busy: supplied.supply().edited,
            longest_queue: 0,
        })
        .collect()
}

/// Notes for each square of craters, boundaries and bodies whether its records were there as the frame began.
fn note_squares(
    sweeps: &FrameSweeps<'_>,
    length: i64,
    deadlines: &mut BTreeMap<Deadline, Slack>,
    misses: &mut Vec<Missed>,
) {
    for supplied in &sweeps.digital().supplies {
        let deadline = match supplied.kind {
            DataKind::Fine | DataKind::Coarse => continue,
            DataKind::Features => Deadline::FEATURE_RECORD,
            DataKind::Shadows => Deadline::SHADOW_RECORD,
            DataKind::Polyhedra => Deadline::BODY_RECORD,
        };
        let (supply, grid) = (supplied.supply(), sweeps.grid(supplied.kind));
        let (clock, start) = (sweeps.clock(0), sweeps.clock(0).tick_at_or_after(SweepTime(0.0)));
        let slack = deadlines.entry(deadline).or_default();
        (supply.missing.len() as u64..supply.pieces).for_each(|_| slack.add(0));
        for missing in &supply.missing {
            let late = missing.arrival.map_or(length, |arrival| (arrival.0 - start.0) as i64);
            slack.add(-late.max(1));
            misses.push(Missed {
                region: grid.map(|grid| grid.region_of(missing.item)),
                came: missing.arrival.map(|arrival| clock.instant_of(arrival).0),
                ..Missed::of(deadline, 0, Cause::Drum)
            });
        }
    }
}

fn add_sets(sum: &mut Sets, sets: &Sets) {
    sum.wanted += sets.wanted;
    sum.loaded += sets.loaded;
    sum.late += sets.late;
    sum.wasted += sets.wasted;
    sum.cancelled += sets.cancelled;
}
