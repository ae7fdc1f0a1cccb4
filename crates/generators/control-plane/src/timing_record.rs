//! The timing record of a frame: what the service of every sweep did, the processor, the data banks.

use std::collections::BTreeMap;

use data_bank::FrameSupply;
use dpu::{CpuTime, LineUse};
use generator::FrameError;
use hardware_model::{CrossingServer, ShadowParts};
use rayon::iter::{IntoParallelIterator, ParallelIterator};
use scenario::Pose;
use shadow_controller::Gate;
use sweep_program::Colour;
use timing::{Cause, Deadline, EventHash, FrameTiming, Missed, Sets, Slack, UnitUse};

use crate::control_plane::ControlPlane;
use crate::digital::DigitalFrame;
use crate::frame_sweeps::FrameSweeps;
use crate::sweep_recorder::SweepRecorder;
use crate::ticks::{frame_ticks, sweep_ticks};

impl ControlPlane {
    /// Timing of frame `frame`, by all threads of the current pool; the same for any number of them.
    ///
    /// # Errors
    /// If the pose cannot be drawn.
    pub fn frame(&self, frame: u64, pose: &Pose) -> Result<FrameTiming, FrameError> {
        let sweeps = self.sweeps(frame, pose)?;
        let crossings = sweeps.crossings();
        let gates = self.gates(&sweeps, pose.time)?;
        let record = |sweep: u32| {
            let drawn = sweeps.set_up_of(sweep);
            let mut recorder = SweepRecorder::of(&crossings, [drawn, sweep]);
            recorder.note_features(&crossings, drawn);
            recorder.note_gate(&crossings, gates.get(drawn as usize));
            recorder
        };
        let count = self.stage().settings.raster.sweeps;
        let recorded: Vec<SweepRecorder> = (0..count).into_par_iter().map(record).collect();
        Ok(self.summary(frame, sweeps.digital(), recorded))
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

    fn summary(&self, frame: u64, digital: &DigitalFrame, sweeps: Vec<SweepRecorder>) -> FrameTiming {
        let [start, end] = frame_ticks(self.stage(), frame);
        let (events, events_blake3) = EventHash::join(sweeps.iter().map(|sweep| sweep.events.part()));
        let mut deadlines = BTreeMap::from([(Deadline::TRANSFER, Slack::default())]);
        let mut sets = Sets::default();
        let (mut folds, mut late_words, mut misses) = (0, 0, Vec::new());
        let mut lines = [LineUse::default(); 4];
        let mut load_ticks = [0; 2];
        for sweep in sweeps {
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
            misses,
            events,
            events_blake3,
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

/// What each level's data bank did, with the name of the level.
fn supplied(digital: &DigitalFrame) -> impl Iterator<Item = (&'static str, &FrameSupply)> {
    let levels = ["fine", "coarse"].into_iter().zip(&digital.supplies);
    levels.filter_map(|(level, supply)| Some((level, supply.as_deref()?)))
}

fn drum_units(digital: &DigitalFrame) -> impl Iterator<Item = UnitUse> {
    supplied(digital).flat_map(|(level, supply)| numbered("drum", level, &supply.busy, supply.longest_queue))
}

/// Nothing waits for a channel but the drums that would use it.
fn channel_units(digital: &DigitalFrame) -> impl Iterator<Item = UnitUse> {
    supplied(digital).flat_map(|(level, supply)| numbered("channel", level, &supply.carried, 0))
}

/// `drum.fine.0` and so on.
fn numbered(kind: &str, level: &str, busy: &[u64], longest_queue: u32) -> impl Iterator<Item = UnitUse> {
    busy.iter().enumerate().map(move |(number, &busy)| UnitUse {
        unit: format!("{kind}.{level}.{number}"),
        busy,
        longest_queue,
    })
}

fn add_sets(sum: &mut Sets, sets: &Sets) {
    sum.wanted += sets.wanted;
    sum.loaded += sets.loaded;
    sum.late += sets.late;
    sum.wasted += sets.wasted;
    sum.cancelled += sets.cancelled;
}
