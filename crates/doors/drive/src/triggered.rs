//! Places of a frame where a condition on its signals is met.

use std::ops::Range;

use diagnostics::Problem;
use machine::FrameSweeps;
use scope::{Look, Looking};
use signal::{LANES, Waveform};
use trigger::{Condition, ConditionError, Hit, Machine, Search, Trigger, Which, value_at};
use trigger_search::{BEAM, pixel_of};

use crate::{DriveError, Viewpoint};

/// Sweeps that are recorded at once: whole groups, and few enough that a near place comes soon.
const AT_ONCE: usize = 16 * LANES;

/// What is searched for, and where.
#[derive(Debug, Clone, Default)]
pub struct TriggerWishes {
    /// Condition in the language of `lunoid trigger`.
    pub on: String,
    /// Sweeps that are searched; all of the frame if left out.
    pub sweeps: Option<Range<u32>>,
    /// Samples, or lines of the display, at which the trigger is armed; all if left out.
    pub samples: Option<Range<u32>>,
    /// Instant of the first sweep behind which a place counts (samples of the sweep).
    pub after: Option<f64>,
    /// Most places that are listed.
    pub limit: u64,
}

/// A place where the condition is met.
#[derive(Debug, Clone, PartialEq)]
pub struct TriggerPlace {
    /// Sweep of the place, from 0 at the left.
    pub sweep: u32,
    /// Sample, instant and values there.
    pub hit: Hit,
    /// Instant in microseconds of the sweep; none down the display.
    pub instant_us: Option<f64>,
    /// Pixel that shows the place (column, line); none beyond the picture.
    pub pixel: Option<[usize; 2]>,
    /// Whether the beam is off there.
    pub is_blanked: bool,
}

/// Places of one frame.
#[derive(Debug, Clone, PartialEq)]
pub struct Triggered {
    /// Number of the frame, counted at the update rate.
    pub frame: u64,
    /// Places in the order of sweeps and instants.
    pub places: Vec<TriggerPlace>,
    /// Number of sweeps that were searched.
    pub sweeps: u32,
}

/// A search that is made ready.
struct Ready<'a> {
    trigger: Trigger,
    look: Look<'a>,
    sample_us: f64,
    is_of_display: bool,
    armed: Range<usize>,
}

impl Viewpoint<'_> {
    /// Searches sweeps in their order for places where a condition is met, and ends at the last one that is wanted.
    ///
    /// # Errors
    /// If the hybrid machine does not draw, the text is no condition on its wires, there is no such sweep or sample, or the pose cannot
    /// be drawn.
    pub fn trigger(&self, wishes: &TriggerWishes) -> Result<Triggered, DriveError> {
        let ready = self.ready(wishes)?;
        let all = self.bench.machine.settings.raster.sweeps;
        let sweeps = wishes.sweeps.clone().unwrap_or(0..all);
        self.expect_sweeps(&sweeps, all)?;
        let after = (sweeps.start, wishes.after.unwrap_or(f64::NEG_INFINITY));
        let mut found = Triggered { frame: self.frame, places: Vec::new(), sweeps: 0 };
        let mut side = None;
        for first in (sweeps.start / LANES as u32 * LANES as u32..sweeps.end).step_by(AT_ONCE) {
            if found.places.len() as u64 >= wishes.limit {
                break;
            }
            let part = first.max(sweeps.start)..sweeps.end.min(first + AT_ONCE as u32);
            found.sweeps += part.end - part.start;
            let waveforms = self.recorded(&ready, part)?;
            for own in waveforms.chunk_by(|one, next| one.sweep == next.sweep) {
                let sweep = own[0].sweep;
                let hits = Search::new(&ready.trigger, Which::All, ready.armed.clone()).look_at(own);
                let later = hits.into_iter().map(|(_, hit)| hit);
                let later = later.filter(|hit| sweep != after.0 || hit.time > after.1);
                let room = wishes.limit.saturating_sub(found.places.len() as u64);
                for hit in later.take(usize::try_from(room).unwrap_or(usize::MAX)) {
                    let side = match &side {
                        Some(side) => side,
                        None => side.insert(self.digital_side()?),
                    };
                    found.places.push(self.place(&ready, side, own, hit));
                }
            }
        }
        Ok(found)
    }

    fn ready(&self, wishes: &TriggerWishes) -> Result<Ready<'_>, DriveError> {
        let Self { drive, bench, frame, pose } = self;
        if !drive.opened.is_machine() {
            let title = format!("{} has no trigger", drive.drawn_by());
            return Err(DriveError::asked(drive.file(), title, "a hardware model"));
        }
        let settings = &bench.machine.settings;
        let sample_us = 1e6 / settings.timebase.sample_rate().hertz();
        let condition =
            Condition::parse(&wishes.on, machine::signals()).map_err(|error| self.no_condition(&error))?;
        let wires = bench.session.wires();
        let own = Machine { wires: &wires, saturation: settings.analog.amplifier.saturation, sample_us };
        let trigger = Trigger::new(&condition, &own).map_err(|error| self.no_condition(&error))?;
        let is_of_display = condition.is_of_display();
        let count = if is_of_display { settings.raster.lines } else { settings.raster.samples };
        let samples = wishes.samples.clone().unwrap_or(0..count);
        if samples.start >= samples.end || samples.end > count {
            let title = format!("no samples {}..{}: a sweep has 0..{count}", samples.start, samples.end);
            return Err(DriveError::asked(drive.file(), title, format!("a range inside 0..{count}")));
        }
        let raster = [bench.stage.view.columns as usize, bench.stage.view.lines as usize];
        let look = Look { session: &*bench.session, pool: &drive.pool, frame: *frame, pose, raster };
        let armed = samples.start as usize..samples.end as usize;
        Ok(Ready { trigger, look, sample_us, is_of_display, armed })
    }

    /// The signals of the condition, and those that say where the beam is.
    fn recorded(&self, ready: &Ready<'_>, sweeps: Range<u32>) -> Result<Vec<Waveform>, DriveError> {
        let names = ready.trigger.signals().into_iter().chain(BEAM).map(str::to_owned).collect();
        ready.look.at(names, sweeps).map_err(|error| DriveError::of(self.drive.file(), &error))
    }

    fn digital_side(&self) -> Result<FrameSweeps<'_>, DriveError> {
        let Self { drive, bench, frame, pose } = self;
        let sweeps = drive.pool.install(|| bench.control().sweeps(*frame, pose));
        sweeps.map_err(|error| DriveError::of(drive.file(), &error))
    }

    fn place(&self, ready: &Ready<'_>, side: &FrameSweeps<'_>, own: &[Waveform], hit: Hit) -> TriggerPlace {
        let beam = |name: &str| value_at(own.iter().find(|wave| wave.signal.name == name)?, hit.sample);
        let [line, blank] = BEAM.map(beam);
        let is_blanked = !ready.is_of_display && blank.is_some_and(|blank| blank > 0.5);
        let line = if ready.is_of_display { Some(hit.sample as f64 + 0.5) } else { line };
        let raster = &self.bench.machine.settings.raster;
        let (sweep, size) = (own[0].sweep, [raster.columns, raster.lines]);
        let pixel = line.and_then(|line| pixel_of(side, &self.pose, size, [f64::from(sweep), line]));
        let instant_us = (!ready.is_of_display).then_some(hit.time * ready.sample_us);
        TriggerPlace { sweep, hit, instant_us, pixel, is_blanked }
    }

    fn no_condition(&self, error: &ConditionError) -> DriveError {
        let ConditionError { text, place, fault } = error;
        let problem = Problem::of_file(self.drive.file(), format!("no condition: {fault}")).key("on");
        let found = format!("`{}` at letter {} of `{text}`", &text[place.clone()], place.start + 1);
        problem.found(found).expected("a condition of docs/trigger-and-trace.md").into()
    }
}
