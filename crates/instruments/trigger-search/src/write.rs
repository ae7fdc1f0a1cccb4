//! The sweep of a place as a file, in the formats of `lunoid probe`.

use std::path::{Path, PathBuf};

use plots::{Drawing, Place};
use scope::{Recorded, ScopeError, ScopeWishes, columns_of, draw};
use signal::Waveform;
use waveform::{Format, Header, SweepTraces, WaveformError, open};

use crate::around::BEAM;
use crate::{Around, Finder, Found};

/// Draws the sweep of a place as a page of the scope under `title`, with a cursor at the place.
///
/// # Errors
/// If the page cannot be drawn.
pub fn page(finder: &Finder<'_>, found: &Found, around: &Around, title: &str) -> Result<Drawing, ScopeError> {
    // Events alone are no curve: the beam always is.
    let beam = BEAM.iter().filter(|name| !around.named.contains(name));
    let wanted: Vec<&str> = around.named.iter().chain(beam).copied().collect();
    let stage = &finder.rehearsal.stage;
    let recorded = Recorded {
        title,
        waveforms: &around.waveforms,
        wires: &finder.wires,
        wanted: &wanted,
        scan: stage.scan(),
        display: stage.settings.display,
        columns: &columns_of(stage.landscape.bank()),
    };
    let cursors = found.hit.range.map(Place::Range).into_iter().collect();
    draw(&recorded, &ScopeWishes { cursors, ..ScopeWishes::default() })
}

/// Writes the sweeps around a place into the file `path`, as waveforms under `title`. Returns the files that it wrote.
///
/// # Errors
/// If the file cannot be written.
pub fn write_waveforms(
    (format, path): (Format, &Path),
    finder: &Finder<'_>,
    found: &Found,
    around: &Around,
    title: String,
) -> Result<Vec<PathBuf>, WaveformError> {
    let settings = &finder.rehearsal.stage.settings;
    let is_named = |name: &str| around.named.contains(&name);
    let header = Header {
        title,
        provenance: vec![
            ("scenario".into(), finder.rehearsal.scenario.title.clone()),
            ("machine".into(), finder.rehearsal.model.name.clone()),
        ],
        wires: finder.wires.iter().filter(|wire| is_named(wire.signal.name)).copied().collect(),
        timebase: settings.timebase,
        lines: cells(around).unwrap_or(settings.raster.lines),
        frame: found.frame,
        sweeps: around.sweeps.clone(),
    };
    let mut sink = open(format, path, header)?;
    for sweep in around.sweeps.clone() {
        let own = |waveform: &&Waveform| waveform.sweep == sweep && is_named(waveform.signal.name);
        let waveforms: Vec<Waveform> = around.waveforms.iter().filter(own).cloned().collect();
        sink.sweep(&SweepTraces { frame: found.frame, sweep, waveforms: &waveforms })?;
    }
    sink.finish()
}

/// Lines that a sweep writes: more than those of the picture where the yoke turns it.
fn cells(around: &Around) -> Option<u32> {
    let display = around.waveforms.iter().find(|waveform| waveform.signal.axis == signal::Axis::Display);
    display.map(|waveform| waveform.values.len() as u32)
}
