//! From a session into a file, some sweeps at a time.

use std::ops::Range;
use std::path::{Path, PathBuf};

use generator::{Planes, Session};
use rayon::ThreadPool;
use scenario::Pose;
use signal::{Axis, LANES, Probe, Waveform, Wire};
use waveform::{Format, Header, Sink, SweepTraces, estimate, open};

use crate::ScopeError;

/// Values that are held at once: 32 MB. The allocator keeps up to as much again for each thread.
pub const WINDOW: usize = 4 << 20;
/// What is written without being asked twice (bytes).
const MOST_BYTES: u64 = 2_000_000_000;
/// Sweeps by which the size is judged.
const SPECIMEN: usize = 16;
/// Instants that a wire told when it changes is taken to have in a sweep.
const CHANGES: usize = 64;

/// One frame that is looked at.
pub struct Look<'a> {
    /// Session of the machine that draws.
    pub session: &'a dyn Session,
    /// Threads that draw the sweeps.
    pub pool: &'a ThreadPool,
    /// Number of the frame, counted at the update rate.
    pub frame: u64,
    /// Where it is seen from.
    pub pose: &'a Pose,
    /// Columns and lines of its picture, which is not drawn.
    pub raster: [usize; 2],
}

/// Whoever looks at signals of some sweeps.
pub trait Looking {
    /// Waveforms of `names` in `sweeps`, by sweep, then by signal table order.
    ///
    /// # Errors
    /// If the pose cannot be drawn.
    fn at(&self, names: Vec<String>, sweeps: Range<u32>) -> Result<Vec<Waveform>, ScopeError>;
}

impl Looking for Look<'_> {
    fn at(&self, names: Vec<String>, sweeps: Range<u32>) -> Result<Vec<Waveform>, ScopeError> {
        let mut probe = Probe::new(names, sweeps);
        let mut planes = Planes::new(self.raster[0], self.raster[1], &[]);
        self.pool.install(|| self.session.frame(self.frame, self.pose, &mut planes, &mut probe))?;
        Ok(probe.waveforms)
    }
}

/// What is written where.
pub struct Order<'a> {
    /// Format of the file.
    pub format: Format,
    /// Path of the file.
    pub out: &'a Path,
    /// More than 2 GB may be written.
    pub large: bool,
    /// Nothing is written: the size alone is wanted.
    pub dry_run: bool,
    /// Values that are held at once.
    pub window: usize,
}

/// What came of it.
#[derive(Debug)]
pub struct Written {
    /// Size that was said before.
    pub estimate: u64,
    /// Files, the one that was asked for first; none for a dry run.
    pub files: Vec<PathBuf>,
}

/// What is heard while sweeps are traced.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Tracing {
    /// The file will have about so many bytes.
    Size(u64),
    /// Sweeps that are written, and how many there are.
    Sweeps {
        /// Number of sweeps written so far.
        done: u32,
        /// Number of sweeps to write in all.
        all: u32,
    },
}

/// Traces the sweeps of `header` into a file. Its lines are those that the first sweep has. `hear` hears of the size
/// before anything is written, and then of every sweep.
///
/// # Errors
/// If the pose cannot be drawn, the file would be large and may not, or it cannot be written.
pub fn trace(
    look: &dyn Looking,
    mut header: Header,
    order: &Order<'_>,
    hear: &mut dyn FnMut(Tracing),
) -> Result<Written, ScopeError> {
    let names: Vec<String> = header.wires.iter().map(|wire| wire.signal.name.to_owned()).collect();
    let mut windows = windows(&header, order.window).into_iter();
    let mut waveforms = look.at(names.clone(), windows.next().unwrap_or_default())?;
    header.lines = lines(&waveforms).unwrap_or(header.lines);
    let estimate = judge(&header, order.format, &waveforms)?;
    expect_small(order.out, estimate, order.large || order.dry_run)?;
    hear(Tracing::Size(estimate));
    if order.dry_run {
        return Ok(Written { estimate, files: Vec::new() });
    }
    let (count, frame, sweeps) = (header.wires.len(), header.frame, header.sweeps.clone());
    let all = sweeps.end - sweeps.start;
    let mut heard = |sweep: u32| hear(Tracing::Sweeps { done: sweep + 1 - sweeps.start, all });
    let mut sink = open(order.format, order.out, header)?;
    loop {
        put(&mut *sink, frame, &waveforms, count, &mut heard)?;
        let Some(window) = windows.next() else { break };
        drop(waveforms);
        waveforms = look.at(names.clone(), window)?;
    }
    Ok(Written { estimate, files: sink.finish()? })
}

/// Writes waveforms that are all there, by sweep and then by wire of `header`, into a file; more than 2 GB if `large`.
/// Returns the files that it wrote.
///
/// # Errors
/// If the file would be large and may not, or it cannot be written.
pub fn write(
    header: Header,
    waveforms: &[Waveform],
    format: Format,
    out: &Path,
    large: bool,
) -> Result<Vec<PathBuf>, ScopeError> {
    expect_small(out, judge(&header, format, waveforms)?, large)?;
    let (count, frame) = (header.wires.len(), header.frame);
    let mut sink = open(format, out, header)?;
    put(&mut *sink, frame, waveforms, count, &mut |_| {})?;
    Ok(sink.finish()?)
}

/// Writes whole sweeps of `count` waveforms each; `heard` hears which.
fn put(
    sink: &mut dyn Sink,
    frame: u64,
    waveforms: &[Waveform],
    count: usize,
    heard: &mut dyn FnMut(u32),
) -> Result<(), ScopeError> {
    for waveforms in waveforms.chunks(count) {
        let sweep = waveforms[0].sweep;
        sink.sweep(&SweepTraces { frame, sweep, waveforms })?;
        heard(sweep);
    }
    Ok(())
}

/// Sweeps that are worked out together: as many as fit, in whole groups.
fn windows(header: &Header, window: usize) -> Vec<Range<u32>> {
    let samples = header.timebase.active_samples as usize;
    let of = |wire: &Wire| match wire.signal.axis {
        Axis::Ground | Axis::Line => samples,
        Axis::Display => header.lines as usize,
        Axis::Changes => 2 * CHANGES,
    };
    let values = header.wires.iter().map(of).sum::<usize>().max(1);
    let groups = (window / values / LANES).max(1);
    let (mut windows, mut start) = (Vec::new(), header.sweeps.start);
    while start < header.sweeps.end {
        let first = start as usize / LANES * LANES;
        let end = ((first + groups * LANES) as u32).min(header.sweeps.end);
        windows.push(start..end);
        start = end;
    }
    windows
}

fn lines(waveforms: &[Waveform]) -> Option<u32> {
    let display = waveforms.iter().find(|waveform| waveform.signal.axis == Axis::Display);
    display.map(|waveform| waveform.values.len() as u32)
}

/// The size of the file, by some sweeps out of the middle of those that are there.
fn judge(header: &Header, format: Format, waveforms: &[Waveform]) -> Result<u64, ScopeError> {
    let sweeps: Vec<SweepTraces<'_>> = waveforms
        .chunks(header.wires.len())
        .map(|waveforms| SweepTraces { frame: header.frame, sweep: waveforms[0].sweep, waveforms })
        .collect();
    let begin = sweeps.len().saturating_sub(SPECIMEN) / 2;
    let end = (begin + SPECIMEN).min(sweeps.len());
    Ok(estimate(format, header, &sweeps[begin..end])?)
}

/// Refuses what is large.
fn expect_small(out: &Path, bytes: u64, large: bool) -> Result<(), ScopeError> {
    match bytes > MOST_BYTES && !large {
        true => Err(ScopeError::TooLarge { out: out.to_owned(), bytes }),
        false => Ok(()),
    }
}

/// A size for people: `9999 B`, `250.0 kB`.
pub fn size(bytes: u64) -> String {
    match bytes {
        0..10_000 => format!("{bytes} B"),
        10_000..1_000_000 => format!("{:.1} kB", bytes as f64 / 1e3),
        1_000_000..1_000_000_000 => format!("{:.1} MB", bytes as f64 / 1e6),
        _ => format!("{:.1} GB", bytes as f64 / 1e9),
    }
}

#[cfg(test)]
mod tests {
    use std::fs;
    use std::path::Path;

    use front_door::Wishes;
    use waveform::{Format, Header};

    use super::{Look, Order, WINDOW, size, trace, windows};

    const TINY: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../doors/lunoid/tests/tiny.toml");

    /// Traces sweeps 3..31 of the tiny scenario into a CSV, `window` values at a time; the text, and the windows.
    fn traced(window: usize) -> (String, usize) {
        let opened = front_door::open(Path::new(TINY), &Wishes::default()).unwrap();
        let pool = rayon::ThreadPoolBuilder::new().num_threads(2).build().unwrap();
        let stage = pool.install(|| opened.stage()).unwrap();
        let settings = opened.settings.clone();
        let clocks = settings.timebase;
        let pose = opened.poses(&stage, 1..2).unwrap().rows()[0].pose;
        let session = opened.generator.prepare(stage).unwrap();
        let raster = [settings.raster.columns as usize, settings.raster.lines as usize];
        let look = Look { session: &*session, pool: &pool, frame: 1, pose: &pose, raster };
        let header = Header {
            title: "tiny".into(),
            provenance: vec![],
            wires: session.wires(),
            timebase: clocks,
            lines: settings.raster.lines,
            frame: 1,
            sweeps: 3..31,
        };
        let folder = tempfile::tempdir().unwrap();
        let out = folder.path().join("w.csv");
        let order = Order { format: Format::Csv, out: &out, large: false, dry_run: false, window };
        let count = windows(&header, window).len();
        trace(&look, header, &order, &mut |_| {}).unwrap();
        (fs::read_to_string(&out).unwrap(), count)
    }

    /// In one window and in four the values are the same to the bit: CSV has all digits.
    #[test]
    fn windows_change_nothing() {
        let ((whole, one), (parts, four)) = (traced(WINDOW), traced(1));
        assert_eq!((one, four), (1, 4));
        assert!(whole == parts && whole.lines().count() == 1 + 28 * 80);
    }

    #[test]
    fn sizes_for_people() {
        let said = [9_999, 250_000, 12_345_678, 3_100_000_000].map(size);
        assert_eq!(said, ["9999 B", "250.0 kB", "12.3 MB", "3.1 GB"]);
    }
}
