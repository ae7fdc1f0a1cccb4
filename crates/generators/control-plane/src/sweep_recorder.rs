//! What the service of one sweep did, on both levels.

use dpu::{AskedCorner, CornerArrival, CrossingTime, LineUse, Register, ServiceEvent, Watch};
use feature_generator::{CRATER_WORDS, FeatureMiss};
use hardware_model::Settings;
use quantities::{SweepClock, SweepTime, Tick};
use shadow_controller::{Gate, SEGMENT_WORDS, SegmentMiss};
use sweep_generator::RangeTable;
use sweep_program::{
    Fold, Load, Miss, MissCause, NO_CORNER, PreloadRegister, RampAxis, Stop, SweepProgram, Target, WordMask,
};
use timing::{Cause, Deadline, EventHash, Missed, Sets, Slack};

use crate::crossings::Crossings;
use crate::digital_event::LoadedPart;
use crate::feature_loads::FeatureLoads;
use crate::ticks::{frame_ticks, sweep_ticks};

/// What one sweep's service did.
#[derive(Debug, Default)]
pub(crate) struct SweepRecorder {
    /// Hash of what the sweep did, if anybody asks for it.
    pub hash: Option<EventHash>,
    pub sets: Sets,
    pub folds: u64,
    /// Loads of registers, of all words or some.
    loads: u64,
    pub late_words: u64,
    pub transfers: Slack,
    pub corners: Slack,
    pub features: Slack,
    pub segments: Slack,
    /// Ticks of the loads of craters and of boundaries.
    pub load_ticks: [u64; 2],
    pub lines: [LineUse; 4],
    pub misses: Vec<Missed>,
    sweep: u32,
    /// Corners of the level to the east.
    columns: usize,
    /// Master ticks of a sweep: what never comes is as late as that.
    period: i64,
    drums: Option<BehindDrums>,
    /// Ground range at which the farther profile ends (m).
    end_range: f64,
}

/// What the corners of a storage buffer behind drums are timed with.
#[derive(Debug, Clone, Copy)]
struct BehindDrums {
    frame_start: Tick,
    clock: SweepClock,
}

impl SweepRecorder {
    /// Runs the service of one sweep, both levels, and hashes its events into `hash`, if there is one.
    pub fn of(crossings: &Crossings<'_>, sweeps: [u32; 2], hash: Option<EventHash>) -> Self {
        let (settings, frame) = (&crossings.stage.settings, crossings.plan.frame);
        let drums = settings.data_banks.drum.map(|_| BehindDrums {
            frame_start: frame_ticks(crossings.stage, frame)[0],
            clock: settings.timebase.sweep_clock(frame, sweeps[1]),
        });
        let period = sweep_ticks(settings);
        let mut recorder = Self { hash, sweep: sweeps[1], period, drums, ..Self::default() };
        let mut program = SweepProgram::idle();
        let levels = crossings.stage.landscape.bank().levels();
        recorder.columns = levels[0].corners()[1];
        crossings.write_fine(sweeps, &mut program, &mut recorder);
        recorder.end_range = program.end_range;
        if let Some(coarse) = crossings.coarse {
            recorder.columns = levels[1].corners()[1];
            crossings.write_coarse(coarse, sweeps, &mut program, &mut recorder);
            recorder.end_range = recorder.end_range.max(program.end_range);
        }
        recorder
    }

    /// Events of the sweep: what is hashed if anybody asks for it.
    pub fn events(&self) -> u64 {
        self.folds + self.loads
    }

    /// What the crossings take of a processor that serves them.
    pub fn time_of_processor(&self) -> CrossingTime {
        let LineUse { busy, interrupts, .. } = self.lines[0];
        CrossingTime { interrupts, words: busy - interrupts }
    }

    /// What they take of it where others bring their words through its memory.
    pub fn stolen(&self, settings: &Settings) -> CrossingTime {
        let words = u64::from(WordMask::ALL.0.count_ones()) * self.sets.loaded;
        CrossingTime { interrupts: 0, words: settings.cpu.stolen(words) }
    }

    /// The loads of craters, with the set-up of sweep `drawn`.
    pub fn note_features(&mut self, crossings: &Crossings<'_>, drawn: u32) {
        let &Crossings { stage, table, .. } = crossings;
        if !FeatureLoads::can_miss(stage) {
            return;
        }
        let program = crossings.feature_program([drawn, self.sweep], self.end_range);
        self.load_ticks[0] = program.load_ticks;
        program.arrivals.iter().for_each(|arrival| self.features.add(arrival.load.slack));
        for miss in &program.misses {
            if miss.cause.is_none() {
                self.features.add(-self.period);
            }
            let part = miss.sub_generator.map(|number| LoadedPart::SubGenerator(miss.kind, number));
            let &FeatureMiss { range, due, arrival, cause, .. } = miss;
            let load = LateLoad { range, due, arrival, cause, words: CRATER_WORDS };
            self.misses.push(Missed {
                crater: Some(miss.crater),
                ..self.late_load(Deadline::FEATURE, part, load, table)
            });
        }
    }

    /// The loads of shadow boundaries, if the sweep has any.
    pub fn note_gate(&mut self, crossings: &Crossings<'_>, gate: Option<&Gate>) {
        let Some(gate) = gate else { return };
        self.load_ticks[1] = gate.load_ticks;
        gate.loads.iter().for_each(|load| self.segments.add(load.load.slack));
        for miss in &gate.misses {
            if miss.cause.is_none() {
                self.segments.add(-self.period);
            }
            let part = miss.line_generator.map(LoadedPart::LineGenerator);
            let &SegmentMiss { range, due, arrival, cause, .. } = miss;
            let load = LateLoad { range, due, arrival, cause, words: SEGMENT_WORDS };
            let missed = self.late_load(Deadline::SEGMENT, part, load, crossings.table);
            self.misses.push(missed);
        }
    }

    /// A load that its part did not have when the sweep was there.
    fn late_load(
        &self,
        deadline: Deadline,
        part: Option<LoadedPart>,
        load: LateLoad,
        table: &RangeTable,
    ) -> Missed {
        let LateLoad { range, due, arrival, cause, words } = load;
        Missed {
            part: part.map(|part| part.to_string()),
            range_m: Some(range),
            due: due.unwrap_or_else(|| table.time_of(range)).0,
            came: arrival.map(|arrival| arrival.0),
            words: WordMask::range(0, words).0,
            ..Missed::of(deadline, self.sweep, cause.map_or(Cause::Occupied, cause_of))
        }
    }

    /// A corner that was not there when it was asked for.
    fn missing(&self, asked: &AskedCorner, came: Option<f64>) -> Missed {
        Missed {
            crossing: asked.crossing,
            colour: Some(asked.colour.name().into()),
            register: matches!(asked.register, Register::Preload(_)).then(|| asked.register.name().into()),
            region: self.place(asked.corner),
            due: asked.at.0,
            came,
            words: WordMask::ALL.0,
            ..Missed::of(Deadline::CORNER, self.sweep, Cause::Drum)
        }
    }

    /// North and east index of a corner.
    fn place(&self, corner: u32) -> Option<[i64; 2]> {
        let corner = (corner != NO_CORNER).then_some(corner as usize)?;
        Some([(corner / self.columns) as i64, (corner % self.columns) as i64])
    }

    fn missed(&self, miss: &Miss, range: f64) -> Missed {
        Missed {
            crossing: Some(miss.crossing),
            colour: Some(miss.colour.name().into()),
            register: Some(register_word(miss.register).into()),
            region: self.place(miss.corner),
            range_m: range.is_finite().then_some(range),
            due: miss.time.0,
            came: miss.arrival.map(|arrival| arrival.0),
            words: miss.words.0,
            ..Missed::of(Deadline::TRANSFER, self.sweep, cause_of(miss.cause))
        }
    }
}

/// Words of a crater or of a shadow boundary that were late.
struct LateLoad {
    /// Ground range at which they were wanted (m).
    range: f64,
    due: Option<SweepTime>,
    arrival: Option<SweepTime>,
    cause: Option<MissCause>,
    words: u32,
}

fn cause_of(cause: MissCause) -> Cause {
    match cause {
        MissCause::Access => Cause::Access,
        MissCause::Queue => Cause::Queue,
        MissCause::HeldBack => Cause::HeldBack,
    }
}

fn register_word(register: PreloadRegister) -> &'static str {
    Register::Preload(register).name()
}

impl SweepRecorder {
    fn stop(&mut self, tick: Tick, fold: Fold) {
        self.folds += 1;
        let Some(hash) = &mut self.hash else { return };
        let axis = if fold.axis == RampAxis::X { "x" } else { "y" };
        hash.push(tick.0, "stop", axis, &[u64::from(fold.stop == Stop::One)]);
    }

    fn load(&mut self, tick: Tick, load: &Load) {
        self.loads += 1;
        let Some(hash) = &mut self.hash else { return };
        let target = match load.target {
            Target::Hold => "hold",
            Target::Preload(register) => register_word(register),
        };
        let words = [u64::from(load.corner), u64::from(load.words.0)];
        hash.push(tick.0, load.colour.name(), target, &words);
    }

    fn late(&mut self, miss: &Miss, range: f64) {
        self.sets.late += 1;
        self.late_words += u64::from(miss.words.0.count_ones());
        if miss.arrival.is_none() {
            self.transfers.add(-self.period);
        }
        let missed = self.missed(miss, range);
        self.misses.push(missed);
    }

    /// How long a corner was in the storage buffer before it was asked for, where drums bring it there.
    fn corner(&mut self, asked: &AskedCorner) {
        let Some(drums) = self.drums else { return };
        let slack = |arrival: Tick| asked.tick.0 as i64 - arrival.0 as i64;
        let (slack, came) = match asked.arrival {
            // It has waited for the whole frame, at least.
            CornerArrival::BeforeFrame => (slack(drums.frame_start), None),
            CornerArrival::At(arrival) => (slack(arrival), Some(drums.clock.instant_of(arrival).0)),
            CornerArrival::NotInFrame => (-self.period, None),
        };
        self.corners.add(slack);
        if slack < 0 {
            let missed = self.missing(asked, came);
            self.misses.push(missed);
        }
    }
}

impl Watch for SweepRecorder {
    fn tell(&mut self, tick: Tick, event: ServiceEvent) {
        match event {
            ServiceEvent::Stop { fold, .. } => self.stop(tick, fold),
            ServiceEvent::Load(load) => self.load(tick, &load),
            ServiceEvent::Transfer { slack, .. } => {
                slack.into_iter().for_each(|slack| self.transfers.add(slack))
            }
            ServiceEvent::LateSet { slack } => self.transfers.add(slack),
            ServiceEvent::Late { miss, range } => self.late(&miss, range),
            ServiceEvent::Wanted(_) => self.sets.wanted += 1,
            ServiceEvent::Wasted { .. } => self.sets.wasted += 1,
            ServiceEvent::Cancelled(_) => self.sets.cancelled += 1,
            ServiceEvent::Home(asked) | ServiceEvent::Diagonal(asked) => self.corner(&asked),
            ServiceEvent::Access(asked) => {
                self.sets.loaded += 1;
                self.corner(&asked);
            }
            // The corner is told before: here it is a miss.
            ServiceEvent::Absent(_) => {}
        }
    }

    fn end(&mut self, lines: &[LineUse; 4]) {
        for (line, used) in self.lines.iter_mut().zip(lines) {
            line.busy += used.busy;
            line.interrupts += used.interrupts;
            line.longest_queue = line.longest_queue.max(used.longest_queue);
        }
    }
}
