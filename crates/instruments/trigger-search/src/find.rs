//! The search through a mission, frame by frame; only the signals that are named are recorded.

use std::ops::Range;
use std::sync::atomic::{AtomicBool, Ordering};

use deadlines::Rehearsal;
use generator::{Planes, Session};
use machine::Prepare;
use replay::Progress;
use scenario::{Pose, PoseRow};
use signal::{LANES, Probe, Waveform, Wire};
use trigger::{Condition, Hit, Machine, Search, Trigger, Which};

use crate::SearchError;

/// Values that are held at once: 32 MB.
const VALUES_AT_ONCE: usize = 4_000_000;

/// Frames, sweeps and samples that are searched.
pub struct Area {
    /// Frames to search, ascending.
    pub frames: Vec<u64>,
    /// Sweeps of each frame.
    pub sweeps: Range<u32>,
    /// Samples, or lines of the display.
    pub samples: Range<u32>,
}

/// A place that was found.
pub struct Found {
    /// Which in the mission, from 1.
    pub number: u64,
    /// Frame of the place, counted at the update rate.
    pub frame: u64,
    /// Where the vehicle is in that frame.
    pub pose: Pose,
    /// Sweep of the place, from 0 at the left.
    pub sweep: u32,
    /// Its sample and instant, and the values there.
    pub hit: Hit,
}

/// How a search ended.
#[derive(Debug, Default)]
pub struct Ended {
    /// Number of places at which the condition was met.
    pub met: u64,
    /// Those of them that were wanted.
    pub shown: u64,
    /// Sweeps that were looked at.
    pub sweeps: u64,
    /// The frame at which it was told to end.
    pub interrupted_at: Option<u64>,
}

/// A machine that is searched.
pub struct Finder<'a> {
    pub(crate) rehearsal: &'a Rehearsal,
    pub(crate) wires: Vec<Wire>,
    trigger: Trigger,
    pub(crate) is_of_display: bool,
    session: Box<dyn Session>,
}

impl<'a> Finder<'a> {
    /// `condition` on the machine of `rehearsal`.
    ///
    /// # Errors
    /// If the condition names a wire that the machine does not have, or asks for what the wire cannot do.
    pub fn new(rehearsal: &'a Rehearsal, condition: &Condition) -> Result<Self, SearchError> {
        let session = rehearsal.stage.clone().prepare();
        let wires = session.wires();
        let machine = Machine {
            wires: &wires,
            saturation: rehearsal.stage.settings.analog.amplifier.saturation,
            sample_us: 1e6 / rehearsal.stage.settings.timebase.sample_rate().hertz(),
        };
        let trigger = Trigger::new(condition, &machine)?;
        Ok(Self { rehearsal, wires, trigger, is_of_display: condition.is_of_display(), session })
    }

    /// Title of the scenario.
    pub fn title(&self) -> &str {
        &self.rehearsal.scenario.title
    }

    /// Length of a sample (µs).
    pub(crate) fn sample_us(&self) -> f64 {
        1e6 / self.rehearsal.stage.settings.timebase.sample_rate().hertz()
    }

    /// Searches in order of frames, sweeps and instants. `tell` hears of what is wanted as it is found, `progress` of every
    /// frame. Once `cancel` is set the search ends at the frame where it is.
    ///
    /// # Errors
    /// If the path cannot be driven, a pose cannot be drawn, or `tell` fails.
    pub fn search<E: From<SearchError>>(
        &self,
        area: &Area,
        which: Which,
        progress: &dyn Fn(Progress),
        cancel: &AtomicBool,
        mut tell: impl FnMut(Found) -> Result<(), E>,
    ) -> Result<Ended, E> {
        let rows = self.rehearsal.poses(&area.frames).map_err(SearchError::from)?;
        let armed = area.samples.start as usize..area.samples.end as usize;
        let mut search = Search::new(&self.trigger, which, armed);
        let mut ended = Ended::default();
        progress(Progress::Begins { what: "searching", frames: area.frames.len() as u64, kept: 0 });
        for ((done, &frame), row) in (1..).zip(&area.frames).zip(&rows) {
            for sweeps in self.chunks(&area.sweeps) {
                if cancel.load(Ordering::Relaxed) {
                    ended.interrupted_at = Some(frame);
                    return Ok(ended);
                }
                ended.sweeps += u64::from(sweeps.end - sweeps.start);
                self.look_at(&mut search, frame, row, sweeps, &mut ended, &mut tell)?;
                if search.is_over() {
                    return Ok(ended);
                }
            }
            progress(Progress::Frame { done });
        }
        Ok(ended)
    }

    fn look_at<E: From<SearchError>>(
        &self,
        search: &mut Search<'_>,
        frame: u64,
        row: &PoseRow,
        sweeps: Range<u32>,
        ended: &mut Ended,
        tell: &mut impl FnMut(Found) -> Result<(), E>,
    ) -> Result<(), E> {
        let names: Vec<String> = self.trigger.signals().into_iter().map(String::from).collect();
        let waveforms = self.record(frame, &row.pose, names, sweeps)?;
        for own in waveforms.chunk_by(|a, b| a.sweep == b.sweep) {
            for (number, hit) in search.look_at(own) {
                ended.shown += 1;
                tell(Found { number, frame, pose: row.pose, sweep: own[0].sweep, hit })?;
            }
        }
        ended.met = search.met();
        Ok(())
    }

    /// Sweeps that fit into memory together: whole groups, since a group is worked out as one.
    fn chunks(&self, sweeps: &Range<u32>) -> impl Iterator<Item = Range<u32>> + use<> {
        let raster = &self.rehearsal.stage.settings.raster;
        let values = self.trigger.signals().len() * raster.samples.max(raster.lines) as usize;
        let groups = (VALUES_AT_ONCE / values.max(1) / LANES).max(1);
        let (step, Range { start, end }) = (groups * LANES, sweeps.clone());
        (start / step as u32 * step as u32..end)
            .step_by(step)
            .map(move |first| first.max(start)..end.min(first + step as u32))
    }

    /// Signals `names` of some sweeps of a frame, by sweep, then in the order of the signal table.
    pub(crate) fn record(
        &self,
        frame: u64,
        pose: &Pose,
        names: Vec<String>,
        sweeps: Range<u32>,
    ) -> Result<Vec<Waveform>, SearchError> {
        let raster = &self.rehearsal.stage.settings.raster;
        let mut planes = Planes::new(raster.columns as usize, raster.lines as usize, &[]);
        let mut probe = Probe::new(names, sweeps);
        self.rehearsal.pool.install(|| self.session.frame(frame, pose, &mut planes, &mut probe))?;
        Ok(probe.waveforms)
    }
}
