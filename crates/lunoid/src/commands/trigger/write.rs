//! The sweep of a place as a file, in the formats of `lunoid probe`.

use std::path::{Path, PathBuf};

use plots::Place;
use signal::Waveform;
use waveform::{Format, Header, SweepTraces, WaveformError, open};

use super::around::{Around, BEAM};
use super::find::{Finder, Found};
use crate::commands::probe::Target;
use crate::{Failure, output};
use scope::{Recorded, ScopeError, ScopeWishes, columns_of, draw};

/// A file that is to be written.
pub struct File {
    path: PathBuf,
    target: Target,
}

impl File {
    /// The kind of file that its name says; `beside` is how many sweeps it has to each side.
    pub fn named(path: &Path, beside: u32) -> Result<Self, Failure> {
        let target = Target::of_name(path)?;
        if target == Target::Picture && beside > 0 {
            return Err(Failure::usage(
                "--around-sweeps: a picture shows one sweep; leave it out, or write another format",
            ));
        }
        Ok(Self { path: path.to_owned(), target })
    }

    /// All files that come of it.
    pub fn places(&self) -> Vec<output::Place> {
        self.target.places("--out", &self.path)
    }

    /// Whether it is a page of the scope.
    pub fn is_picture(&self) -> bool {
        self.target == Target::Picture
    }

    /// Writes it; the names of what was written.
    pub fn write(
        &self,
        finder: &Finder<'_>,
        found: &Found,
        around: &Around,
        condition: &str,
    ) -> Result<Vec<String>, Failure> {
        let title = format!("{}: {condition}", finder.rehearsal.scenario.title);
        let Target::Waveforms(format) = self.target else {
            self.draw(finder, found, around, &title)?;
            return Ok(vec![self.path.display().to_string()]);
        };
        let paths = self.stream(format, finder, found, around, title).map_err(failure)?;
        Ok(paths.iter().map(|path| path.display().to_string()).collect())
    }

    /// With a cursor at the place.
    fn draw(&self, finder: &Finder<'_>, found: &Found, around: &Around, title: &str) -> Result<(), Failure> {
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
        let drawing = draw(&recorded, &ScopeWishes { cursors, ..ScopeWishes::default() })?;
        Ok(drawing.write(&self.path).map_err(ScopeError::Write)?)
    }

    fn stream(
        &self,
        format: Format,
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
        let mut sink = open(format, &self.path, header)?;
        for sweep in around.sweeps.clone() {
            let own = |waveform: &&Waveform| waveform.sweep == sweep && is_named(waveform.signal.name);
            let waveforms: Vec<Waveform> = around.waveforms.iter().filter(own).cloned().collect();
            sink.sweep(&SweepTraces { frame: found.frame, sweep, waveforms: &waveforms })?;
        }
        sink.finish()
    }
}

/// Lines that a sweep writes: more than those of the picture where the yoke turns it.
fn cells(around: &Around) -> Option<u32> {
    let display = around.waveforms.iter().find(|waveform| waveform.signal.axis == signal::Axis::Display);
    display.map(|waveform| waveform.values.len() as u32)
}

fn failure(error: WaveformError) -> Failure {
    match error {
        WaveformError::File(error) => error.into(),
        other => Failure::input(other),
    }
}
