//! What lies around a place: the same signals before, after and beside it, and the pixel that shows it.

use std::ops::Range;

use machine::FrameSweeps;
use scope::needs;
use signal::{Axis, Waveform};
use trigger::value_at;

use crate::pixel::pixel_of;
use crate::{Finder, Found, SearchError};

/// What tells where the beam is.
pub const BEAM: [&str; 2] = ["dpp.y", "dpp.blank"];

/// The neighbourhood of a place.
pub struct Around {
    /// Sweeps that were recorded.
    pub(crate) sweeps: Range<u32>,
    /// All that was recorded of them.
    pub(crate) waveforms: Vec<Waveform>,
    /// Names of the signals that are shown and written, in the order of the signal table.
    pub named: Vec<&'static str>,
    /// Rows of the table, if one is wanted.
    pub(crate) rows: Vec<Row>,
    /// The pixel that shows the place (column, line), unless the place is beyond the picture.
    pub pixel: Option<[usize; 2]>,
    /// Whether the beam is off there.
    pub(crate) is_blanked: bool,
}

/// A sample beside the place.
pub(crate) struct Row {
    pub sweep: u32,
    pub sample: usize,
    pub range: Option<f64>,
    /// By the signals that are named.
    pub values: Vec<Option<f64>>,
}

impl Around {
    /// Records `sweeps` around `found`: the signals that the condition tells of, and those that match `more`; for a page
    /// of the scope what it needs too. A table has `samples` rows before and after the place.
    ///
    /// # Errors
    /// If the pose cannot be drawn.
    pub fn record(
        finder: &Finder<'_>,
        found: &Found,
        sweeps: Range<u32>,
        samples: Option<u32>,
        more: &[String],
        is_picture: bool,
    ) -> Result<Self, SearchError> {
        let named = named(finder, found, more);
        let needed = if is_picture { &needs(&finder.rehearsal.stage.scan())[..] } else { &[] };
        let all = named.iter().chain(&BEAM).chain(needed).map(|name| (*name).to_owned()).collect();
        let waveforms = finder.record(found.frame, &found.pose, all, sweeps.clone())?;
        let mut around = Self { sweeps, waveforms, named, rows: Vec::new(), pixel: None, is_blanked: false };
        around.rows = around.rows(finder, found, samples);
        around.place(finder, found)?;
        Ok(around)
    }

    fn wave(&self, name: &str, sweep: u32) -> Option<&Waveform> {
        self.waveforms.iter().find(|waveform| waveform.sweep == sweep && waveform.signal.name == name)
    }

    fn value(&self, name: &str, sweep: u32, sample: usize) -> Option<f64> {
        value_at(self.wave(name, sweep)?, sample)
    }

    fn rows(&self, finder: &Finder<'_>, found: &Found, samples: Option<u32>) -> Vec<Row> {
        let has_beside = self.sweeps.len() > 1;
        if samples.is_none() && !has_beside {
            return Vec::new();
        }
        let (sample, beside) = (found.hit.sample, samples.unwrap_or(0) as usize);
        let end = self.samples(finder);
        let own = sample.saturating_sub(beside)..(sample + beside + 1).min(end);
        let of = |sweep: u32| if sweep == found.sweep { own.clone() } else { sample..sample + 1 };
        self.sweeps.clone().flat_map(|sweep| of(sweep).map(move |sample| self.row(sweep, sample))).collect()
    }

    fn samples(&self, finder: &Finder<'_>) -> usize {
        let axis = if finder.is_of_display { Axis::Display } else { Axis::Ground };
        let of_axis = self.waveforms.iter().filter(|waveform| waveform.signal.axis == axis);
        of_axis.map(|waveform| waveform.values.len()).max().unwrap_or(0)
    }

    fn row(&self, sweep: u32, sample: usize) -> Row {
        let shown = self.named.iter().filter(|name| **name != RANGE);
        let values = shown.map(|name| self.value(name, sweep, sample)).collect();
        Row { sweep, sample, range: self.value(RANGE, sweep, sample), values }
    }

    /// Signals that have a column.
    pub fn columns(&self) -> impl Iterator<Item = &'static str> + '_ {
        self.named.iter().copied().filter(|name| *name != RANGE)
    }

    /// Where the picture shows it.
    fn place(&mut self, finder: &Finder<'_>, found: &Found) -> Result<(), SearchError> {
        let line = match finder.is_of_display {
            true => Some(found.hit.sample as f64 + 0.5),
            false => self.value("dpp.y", found.sweep, found.hit.sample),
        };
        let blank = self.value("dpp.blank", found.sweep, found.hit.sample);
        self.is_blanked = !finder.is_of_display && blank.is_some_and(|blank| blank > 0.5);
        let raster = &finder.rehearsal.stage.settings.raster;
        let sweeps = self.digital_side(finder, found)?;
        let size = [raster.columns, raster.lines];
        self.pixel =
            line.and_then(|line| pixel_of(&sweeps, &found.pose, size, [f64::from(found.sweep), line]));
        Ok(())
    }

    fn digital_side<'f>(&self, finder: &Finder<'f>, found: &Found) -> Result<FrameSweeps<'f>, SearchError> {
        let rehearsal = finder.rehearsal;
        Ok(rehearsal.pool.install(|| rehearsal.control.sweeps(found.frame, &found.pose))?)
    }
}

const RANGE: &str = "sweep.range";

/// Signals of the machine that are told of, and those that match a pattern, in the order of the table.
fn named(finder: &Finder<'_>, found: &Found, more: &[String]) -> Vec<&'static str> {
    let told = |name: &str| found.hit.readings.iter().any(|reading| reading.signal.name == name);
    let range = |name: &str| !finder.is_of_display && name == RANGE;
    let wires = finder.wires.iter().map(|wire| &wire.signal);
    let is_named = |signal: &&signal::Signal| {
        told(signal.name) || range(signal.name) || more.iter().any(|pattern| signal.matches(pattern))
    };
    wires.filter(is_named).map(|signal| signal.name).collect()
}
