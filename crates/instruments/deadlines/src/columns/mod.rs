//! From every column that differs from the ideal machine to its cause.
//!
//! The frame is drawn four times: by the machine as it is, by the ideal machine, and with either side alone ideal
//! ([`hardware_model::Side`] says what belongs to which, and what is kept). What remains of a difference with one side
//! ideal shows whose work it is. What the timing has a hand in is traced to the misses of the sweeps that the pixel is
//! read from.

mod drawing;
mod four;
mod ground;
mod lines;
mod place;
mod tell;
mod trace;
mod verdict;

use sweep_generator::RangeTable;
use timing::TimingRecord;

use self::four::{Four, Seen};
use self::trace::Trace;
use crate::{DeadlineError, Rehearsal};

pub use tell::TracedColumns;
pub use trace::remembered;

/// Limits that decide which columns and record lines are listed.
#[derive(Debug, Clone, Copy)]
pub struct Limits {
    /// A column differs if any pixel of it is off by more levels of 255 than this.
    pub levels: u32,
    /// Lines of the record that are listed of a column, the last before its pixel.
    pub lines: usize,
}

/// One frame, drawn by four machines, with what their sweeps were seen to do.
pub struct FrameByFour<'a> {
    rehearsal: &'a Rehearsal,
    table: RangeTable,
    four: Four,
    seen: Seen,
}

impl<'a> FrameByFour<'a> {
    /// Draws frame `frame`.
    ///
    /// # Errors
    /// If the pose cannot be drawn.
    pub fn draw(rehearsal: &'a Rehearsal, frame: u64) -> Result<Self, DeadlineError> {
        let settings = &rehearsal.stage.settings;
        let table = RangeTable::new(&settings.range, settings.raster.samples as usize);
        let (four, seen) = four::draw(rehearsal, frame)?;
        Ok(Self { rehearsal, table, four, seen })
    }

    /// Traces its columns to `record`, whose last frame it is. The frames before are those that its tube still shows
    /// ([`remembered`]).
    ///
    /// # Errors
    /// If the record has no frame, or no fan of sweeps covers a pose.
    pub fn trace(
        &'a self,
        record: &'a TimingRecord,
        limits: Limits,
    ) -> Result<TracedColumns<'a>, DeadlineError> {
        let trace = Trace::new(self.rehearsal, record, &self.table, &self.seen)?;
        let columns = verdict::judge(&self.four, limits.levels, |pixel, way| trace.is_reached(pixel, way));
        let frame = record.frames.last().map_or(0, |timing| timing.frame);
        Ok(TracedColumns {
            title: format!("{} on {}, frame {frame}", record.scenario, record.machine),
            limits,
            four: &self.four,
            columns,
            trace,
            ns: 1e9 / self.rehearsal.stage.settings.timebase.sample_rate().hertz(),
        })
    }
}
