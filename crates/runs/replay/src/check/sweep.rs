//! One sweep against the ground below it, and its column against the same of `exact`.

use std::path::Path;

use exact::{Columns, ProfilePoint};
use generator::{PlaneKind, Planes, Session};
use picture::{Curve, Encoder, Limits, read_any_png};
use scenario::Pose;
use signal::Probe;

use crate::ReplayError;
use run_record::{CheckedSweep, FrameRecord};

/// Errors of a sweep, with their units.
pub(super) const NAMES: [(&str, &str); 4] =
    [("picture", "1"), ("height", "m"), ("slope", "1"), ("reflectivity", "1")];
const RANGE: &str = "sweep.range";
/// A signal, which of [`NAMES`] it belongs to, and what it should be.
type Compared = (&'static str, usize, fn(&ProfilePoint) -> f64);
const SIGNALS: [Compared; 4] = [
    ("mu.height", 1, |point| point.height),
    ("tg.slope.u", 2, |point| point.slopes[0]),
    ("tg.slope.v", 2, |point| point.slopes[1]),
    ("tg.reflectivity", 3, |point| point.reflectivity),
];

/// Mean squared difference of error `index` of a sweep.
pub(super) fn square_of(sweep: &CheckedSweep, index: usize) -> Option<f64> {
    sweep.rms_and_max[index].map(|[rms, _]| rms * rms)
}

/// Largest difference of error `index` of a sweep.
pub(super) fn max_of(sweep: &CheckedSweep, index: usize) -> Option<f64> {
    sweep.rms_and_max[index].map(|[_, max]| max)
}

#[derive(Debug, Clone, Copy, Default)]
struct Sum {
    squares: f64,
    count: f64,
    max: f64,
}

impl Sum {
    fn add(&mut self, off: f64) {
        self.squares += off * off;
        self.count += 1.0;
        self.max = self.max.max(off.abs());
    }

    fn rms_and_max(self) -> Option<[f64; 2]> {
        (self.count > 0.0).then(|| [(self.squares / self.count).sqrt(), self.max])
    }
}

/// Everything that a check of a sweep needs.
pub(super) struct Bench<'a> {
    pub session: &'a dyn Session,
    pub exact: Columns,
    pub encoder: Encoder,
    /// Columns and lines of a picture.
    pub size: [usize; 2],
    /// Sweeps of a frame.
    pub sweeps: u32,
    pub folder: &'a Path,
}

impl Bench<'_> {
    /// Checks sweep `sweep` of the frame.
    pub fn sweep(&self, frame: &FrameRecord, pose: &Pose, sweep: u32) -> Result<CheckedSweep, ReplayError> {
        let mut sums = [Sum::default(); 4];
        self.signals(frame.frame, pose, sweep, &mut sums)?;
        let columns = self.size[0] as u64;
        let column = (2 * u64::from(sweep) + 1) * columns / (2 * u64::from(self.sweeps));
        self.picture(frame, pose, column as usize, &mut sums[0])?;
        let rms_and_max = sums.map(Sum::rms_and_max);
        Ok(CheckedSweep { frame: frame.frame, sweep, column: column as usize, rms_and_max })
    }

    /// Without planes only the sweep's group is drawn.
    fn signals(&self, frame: u64, pose: &Pose, sweep: u32, sums: &mut [Sum; 4]) -> Result<(), ReplayError> {
        let names = SIGNALS.iter().map(|(name, ..)| *name).chain([RANGE]);
        let mut probe = Probe::new(names.map(str::to_owned).collect(), sweep..sweep + 1);
        let [columns, lines] = self.size;
        self.session.frame(frame, pose, &mut Planes::new(columns, lines, &[]), &mut probe)?;
        let values = |name: &str| {
            let wave = probe.waveforms.iter().find(|wave| wave.signal.name == name);
            wave.map_or(&[][..], |wave| wave.values.as_slice())
        };
        let Some(direction) = self.session.direction(frame, pose, sweep)? else { return Ok(()) };
        let truth = self.exact.profile(pose, direction, values(RANGE));
        for (name, error, meant) in SIGNALS {
            let pairs = values(name).iter().zip(&truth);
            pairs.for_each(|(value, point)| {
                if let Some(point) = point {
                    sums[error].add(value - meant(point));
                }
            });
        }
        Ok(())
    }

    fn picture(
        &self,
        frame: &FrameRecord,
        pose: &Pose,
        column: usize,
        sum: &mut Sum,
    ) -> Result<(), ReplayError> {
        let number = frame.frame;
        let planes = self.exact.column(number, pose, column, &[PlaneKind::Intensity])?;
        let exact = planes.get(PlaneKind::Intensity).unwrap_or_default();
        let refused = |source| ReplayError::Picture { frame: number, source };
        let exact = self.encoder.encode(exact, 1, exact.len()).map_err(refused)?;
        // Of several showings the last, which is the update.
        let file = frame.files.last().map(|file| self.folder.join(&file.file)).unwrap_or_default();
        let shown = read_any_png(file, &Limits::default())?;
        // Of a frame in colour its luminance: `exact` is grey.
        let shown = shown.to_grey(Curve::Power(self.encoder.transfer().gamma().into()));
        let shown = (0..shown.lines()).map(|line| shown.code(column, line));
        let white = f64::from(self.encoder.depth().white());
        for (shown, exact) in shown.zip(exact.codes()) {
            sum.add((f64::from(shown) - f64::from(*exact)) / white);
        }
        Ok(())
    }
}
