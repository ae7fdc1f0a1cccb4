//! Television lines of one picture as a file of waveforms, by the writers of `lunoid probe`.

use std::ops::Range;
use std::path::PathBuf;

use clap::Args;
use serde_json::{Value, json};
use signal::{Probe, Wire};
use vehicle_shadow::{Augmentation, Look, Sequence, line_timebase};
use waveform::{Format, Header};

use crate::commands::probe::{Target, names};
use command_line::Failure;
use command_line::output::Place;
use run_page::Request;
use scope::write;

/// What is looked at, and where it goes.
#[derive(Debug, Args)]
pub struct Probing {
    /// Record signals of lines of one frame, lines from 0 at the top; all signals if none are named.
    #[arg(long, value_name = "FRAME:LINE[..LINE][:SIGNALS]", value_parser = request, requires = "waveforms")]
    probe: Option<Request>,
    /// File for them, as its name ends: csv, vcd, fst, npz, json, raw, sr.
    #[arg(long, value_name = "FILE", value_parser = file, requires = "probe")]
    waveforms: Option<(PathBuf, Format)>,
    /// Write that file even if it has more than 2 GB.
    #[arg(long, requires = "probe")]
    large: bool,
}

fn request(text: &str) -> Result<Request, String> {
    text.parse().map_err(|_| {
        format!(
            "expected FRAME:LINE, FRAME:LINE..LINE or FRAME:LINE:SIGNALS, as 33:400 or '33:400:vs.video.*', not `{text}`"
        )
    })
}

fn file(text: &str) -> Result<(PathBuf, Format), String> {
    let path = PathBuf::from(text);
    let endings = || Format::ALL.map(|format| format!(".{}", format.name())).join(", ");
    match Format::of_path(&path) {
        Some(format) => Ok((path, format)),
        None => Err(format!("expected a name that ends in {}", endings())),
    }
}

/// What is being recorded.
pub struct Recording {
    /// Lines of the frame, and what has come of them.
    pub look: Look,
    header: Header,
    path: PathBuf,
    format: Format,
    large: bool,
}

/// Waveforms that were written: files, format, frame, lines and signals.
pub struct Recorded {
    files: Vec<PathBuf>,
    format: Format,
    frame: u64,
    lines: Range<u32>,
    signals: Vec<&'static str>,
}

impl Probing {
    /// The files that are to be written, if any.
    pub fn outputs(&self) -> Vec<Place> {
        let of = |(path, format): &(PathBuf, Format)| Target::Waveforms(*format).places("--waveforms", path);
        self.waveforms.as_ref().map_or(Vec::new(), of)
    }

    /// What to record of the pictures of `sequence`, if anything.
    pub fn recording(
        &self,
        augmentation: &Augmentation,
        sequence: &Sequence,
        provenance: Vec<(String, String)>,
    ) -> Result<Option<Recording>, Failure> {
        let Some((request, (path, format))) = self.probe.as_ref().zip(self.waveforms.as_ref()) else {
            return Ok(None);
        };
        let frame = sequence.frames().iter().find(|frame| frame.frame == request.frame);
        let frame = frame.ok_or_else(|| {
            let [first, last] = [sequence.frames().first(), sequence.frames().last()]
                .map(|frame| frame.map_or(0, |frame| frame.frame));
            Failure::usage(format!(
                "{request}: no such frame; expected one of the pictures, {first} to {last}"
            ))
        })?;
        let picture = photographs::read(&frame.path)?;
        let [columns, lines] = [picture.columns(), picture.lines()].map(|count| count as u32);
        let range = request.sweeps(lines).ok_or_else(|| {
            Failure::usage(format!("{request}: the picture has lines 0..{lines}; expected a range inside"))
        })?;
        let period = sequence.period();
        let timebase = line_timebase(period, [columns, lines]).ok_or_else(|| {
            Failure::usage(format!(
                "{request}: pictures {period} s apart; expected at most a day between two"
            ))
        })?;
        let wires = chosen(request, augmentation.wires(picture.depth()))?;
        let sweeps = range.start as u32..range.end as u32;
        let wanted = wires.iter().map(|wire| wire.signal.name.to_owned()).collect();
        let title = format!("vehicle shadow: frame {}", request.frame);
        Ok(Some(Recording {
            look: Look { frame: request.frame, probe: Probe::new(wanted, sweeps.clone()) },
            header: Header { title, provenance, wires, timebase, lines, frame: request.frame, sweeps },
            path: path.clone(),
            format: *format,
            large: self.large,
        }))
    }
}

/// Those of `wires` that a request names, all if it names none; each of its patterns must name one.
fn chosen(request: &Request, mut wires: Vec<Wire>) -> Result<Vec<Wire>, Failure> {
    let named = request.named();
    let is_none = |pattern: &&String| !wires.iter().any(|wire| wire.signal.matches(pattern));
    if let Some(pattern) = named.iter().find(is_none) {
        let there = wires.iter().map(|wire| wire.signal.name).collect::<Vec<_>>().join(", ");
        return Err(Failure::usage(format!(
            "{request}:{pattern}: no signal of this name under this method and ground; expected some of {there}"
        )));
    }
    wires.retain(|wire| named.is_empty() || named.iter().any(|pattern| wire.signal.matches(pattern)));
    Ok(wires)
}

impl Recording {
    /// Writes what was recorded.
    pub fn write(self) -> Result<Recorded, Failure> {
        let Self { look, header, path, format, large } = self;
        let (frame, lines) = (header.frame, header.sweeps.clone());
        let signals = header.wires.iter().map(|wire| wire.signal.name).collect();
        let files = write(header, &look.probe.waveforms, format, &path, large)?;
        Ok(Recorded { files, format, frame, lines, signals })
    }
}

impl Recorded {
    /// One line of text for people: file, frame, lines and signals.
    pub fn text(&self) -> String {
        let Self { files, frame, lines: Range { start, end }, signals, .. } = self;
        format!("{}: frame {frame}, lines {start}..{end}: {}\n", names(files)[0], signals.join(", "))
    }

    /// An object, as that of `lunoid probe`.
    pub fn json(&self) -> Value {
        let Self { files, format, frame, lines, signals } = self;
        json!({
            "files": names(files),
            "format": format.name(),
            "frame": frame,
            "lines": [lines.start, lines.end],
            "signals": signals,
        })
    }
}
