//! By how much a session is off: its signals against the ground below the sweep, its picture against `exact`.

use control_plane::{ControlPlane, MachineStage};
use exact::{Columns, ProfilePoint};
use generator::{Planes, Session};
use picture::{Depth, Encoder};
use scenario::{Display, Pose};
use serde::Serialize;
use signal::{LANES, Probe, Waveform};

use crate::StudyError;
use crate::reference::ExactPicture;

/// Groups of neighbouring sweeps of a frame on which signals are compared.
const GROUPS: u32 = 6;
/// Sweeps of a group: what a machine draws at once.
const GROUP: u32 = LANES as u32;
/// Places between two samples at which the ridge is looked for.
const BETWEEN: usize = 8;
/// Signals that are compared.
const SIGNALS: [&str; 6] =
    ["sweep.range", "mu.height", "tg.slope.u", "tg.slope.v", "tg.reflectivity", "dpp.elevation"];

/// Every error that a study of a machine tells, with its unit, in the order of the table.
pub const NAMES: [(&str, &str); 17] = [
    ("height rms", "m"),
    ("height max", "m"),
    ("height rms of full scale", "1"),
    ("height between samples rms", "m"),
    ("slope rms", "1"),
    ("slope max", "1"),
    ("slope rms of full scale", "1"),
    ("reflectivity rms", "1"),
    ("reflectivity max", "1"),
    ("ridge rms", "lines"),
    ("ridge max", "lines"),
    ("picture rmse", "1"),
    ("picture psnr", "dB"),
    ("picture ssim", "1"),
    ("picture flip", "1"),
    ("picture beyond two levels", "1"),
    ("picture rmse, law of the base", "1"),
];

/// One error of a rung.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct ErrorFigure {
    /// One of [`NAMES`], or a ladder's own.
    pub name: &'static str,
    /// Its unit; `1` for a share.
    pub unit: &'static str,
    /// Value of the error, in its unit.
    pub value: f64,
}

/// First sweeps of the groups that are compared, spread over `sweeps`.
fn groups(sweeps: u32) -> impl Iterator<Item = u32> {
    let all = sweeps.div_ceil(GROUP);
    let chosen = all.min(GROUPS);
    (0..chosen).map(move |index| (2 * index + 1) * all / (2 * chosen) * GROUP)
}

/// The errors of one rung.
pub type Figures = Vec<ErrorFigure>;

/// A sum of squares and the largest of what went into it.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Sum {
    squares: f64,
    count: f64,
    max: f64,
}

impl Sum {
    pub fn add(&mut self, off: f64) {
        self.squares += off * off;
        self.count += 1.0;
        self.max = self.max.max(off.abs());
    }

    pub fn rms(&self) -> f64 {
        if self.count > 0.0 { (self.squares / self.count).sqrt() } else { 0.0 }
    }

    pub fn max(&self) -> f64 {
        self.max
    }
}

/// Errors of signals, summed over sweeps and frames.
#[derive(Debug, Default)]
pub(crate) struct SignalErrors {
    height: Sum,
    between: Sum,
    slope: Sum,
    reflectivity: Sum,
    ridge: Sum,
    /// Largest height and slope: what stands for full scale.
    highest: f64,
    steepest: f64,
}

/// Where signals are compared: the machine's frame and what it stands for.
pub(crate) struct Bench<'a> {
    pub stage: &'a MachineStage,
    pub session: &'a dyn Session,
    pub control: &'a ControlPlane,
    pub exact: &'a Columns,
}

impl SignalErrors {
    /// Adds a frame. The planes are not drawn: only what the signals need runs.
    pub fn add_frame(&mut self, bench: &Bench<'_>, frame: u64, pose: &Pose) -> Result<(), StudyError> {
        let raster = bench.stage.settings.raster;
        let way = bench.control.sweeps(frame, pose)?;
        let lines = f64::from(raster.lines) / (2.0 * raster.field.tan_half_height);
        for first in groups(raster.sweeps) {
            let sweeps = first..(first + GROUP).min(raster.sweeps);
            let patterns = SIGNALS.iter().map(|name| (*name).to_owned()).collect();
            let mut probe = Probe::new(patterns, sweeps.clone());
            let mut planes = Planes::new(raster.columns as usize, raster.lines as usize, &[]);
            bench.session.frame(frame, pose, &mut planes, &mut probe)?;
            for sweep in sweeps {
                let direction = way.programs(sweep)[0].start.direction;
                let waves: Vec<&Waveform> =
                    probe.waveforms.iter().filter(|wave| wave.sweep == sweep).collect();
                self.add_sweep(&waves, |ranges| bench.exact.profile(pose, direction, ranges), lines);
            }
        }
        Ok(())
    }

    /// `lines` are display lines for a unit of elevation, as on the level axis.
    fn add_sweep(
        &mut self,
        waves: &[&Waveform],
        profile: impl Fn(&[f64]) -> Vec<Option<ProfilePoint>>,
        lines: f64,
    ) {
        let wave = |name: &str| {
            let found = waves.iter().find(|wave| wave.signal.name == name);
            found.map_or(&[][..], |wave| wave.values.as_slice())
        };
        let [range, height, north, east, light, elevation] = SIGNALS.map(wave);
        let truth = profile(range);
        for (sample, point) in truth.iter().enumerate() {
            let Some(point) = point else { continue };
            let mut add = |sum: fn(&mut Self) -> &mut Sum, signal: &[f64], truth: f64| {
                if let Some(value) = signal.get(sample) {
                    sum(self).add(value - truth);
                }
            };
            add(|all| &mut all.height, height, point.height);
            add(|all| &mut all.slope, north, point.slopes[0]);
            add(|all| &mut all.slope, east, point.slopes[1]);
            add(|all| &mut all.reflectivity, light, point.reflectivity);
            self.highest = self.highest.max(point.height.abs());
            self.steepest = self.steepest.max(point.slopes[0].abs()).max(point.slopes[1].abs());
        }
        self.add_between([range, height], &truth, &profile);
        self.add_ridge(range, elevation, &truth, &profile, lines);
    }

    /// Height half way between two samples that are both inside the problem area, where a straight line stands for it.
    fn add_between(
        &mut self,
        [range, height]: [&[f64]; 2],
        truth: &[Option<ProfilePoint>],
        profile: &impl Fn(&[f64]) -> Vec<Option<ProfilePoint>>,
    ) {
        let middle = |pair: &[f64]| 0.5 * (pair[0] + pair[1]);
        let places: Vec<f64> = range.windows(2).map(middle).collect();
        let values = height.windows(2).map(middle).zip(truth.windows(2));
        for (point, (value, ends)) in profile(&places).iter().zip(values) {
            if let (Some(point), [Some(_), Some(_)]) = (point, ends) {
                self.between.add(value - point.height);
            }
        }
    }

    /// The highest elevation of the sweep. The true one is looked for around the highest samples.
    fn add_ridge(
        &mut self,
        range: &[f64],
        elevation: &[f64],
        truth: &[Option<ProfilePoint>],
        profile: &impl Fn(&[f64]) -> Vec<Option<ProfilePoint>>,
        lines: f64,
    ) {
        let found = elevation.iter().copied().reduce(f64::max);
        let at_samples: Vec<f64> =
            truth.iter().map(|point| point.map_or(f64::NEG_INFINITY, |point| point.elevation)).collect();
        let Some(highest) = at_samples.iter().copied().reduce(f64::max).filter(|top| top.is_finite()) else {
            return;
        };
        // A crest between two samples rises above both by no more than what the next ones on either side lie below.
        let near = |sample: usize| at_samples[sample] > highest - 2.0 / lines;
        let finer: Vec<f64> = (1..range.len())
            .filter(|&sample| near(sample) || near(sample - 1))
            .flat_map(|sample| {
                let step = range[sample] - range[sample - 1];
                (1..BETWEEN).map(move |k| range[sample - 1] + step * k as f64 / BETWEEN as f64)
            })
            .collect();
        let between = profile(&finer).into_iter().flatten().map(|point| point.elevation);
        let true_ridge = between.fold(highest, f64::max);
        if let Some(found) = found {
            self.ridge.add((found - true_ridge) * lines);
        }
    }

    /// One of the figures by its name.
    pub fn value(&self, name: &str) -> f64 {
        self.figures().iter().find(|figure| figure.name == name).map_or(0.0, |figure| figure.value)
    }

    /// Largest height (m) and slope met.
    pub fn largest(&self) -> [f64; 2] {
        [self.highest, self.steepest]
    }

    /// The figures, in the order of [`NAMES`].
    pub fn figures(&self) -> Figures {
        let share = |rms: f64, full: f64| if full > 0.0 { rms / full } else { 0.0 };
        let values = [
            self.height.rms(),
            self.height.max(),
            share(self.height.rms(), self.highest),
            self.between.rms(),
            self.slope.rms(),
            self.slope.max(),
            share(self.slope.rms(), self.steepest),
            self.reflectivity.rms(),
            self.reflectivity.max(),
            self.ridge.rms(),
            self.ridge.max(),
        ];
        NAMES.iter().zip(values).map(|(&(name, unit), value)| ErrorFigure { name, unit, value }).collect()
    }
}

/// Errors of pictures, summed over frames.
#[derive(Debug, Default)]
pub(crate) struct PictureErrors {
    own: Sum,
    base: Sum,
    ssim: f64,
    flip: f64,
    beyond: f64,
    frames: f64,
}

impl PictureErrors {
    /// Adds a picture of linear intensity, as it is displayed, against `exact` under its own laws and, where those are
    /// others, under the laws of the base.
    pub fn add(
        &mut self,
        display: &Display,
        plane: &[f32],
        own: &ExactPicture,
        base: Option<&ExactPicture>,
        [columns, lines]: [usize; 2],
    ) -> Result<(), StudyError> {
        let encoder = Encoder::new(transfer(display)?, Depth::Sixteen);
        let test = encoder.encode(plane, columns, lines)?;
        let reference = encoder.encode(&own.intensity, columns, lines)?;
        let found = compare::compare(&test, &reference, None, &[2])?;
        self.own.add(found.rmse);
        self.beyond += found.beyond[0].share;
        self.ssim += found.ssim.unwrap_or(1.0);
        self.flip += compare::flip(&test, &reference, compare::PIXELS_PER_DEGREE)?.mean;
        self.frames += 1.0;
        if let Some(base) = base {
            let reference = encoder.encode(&base.intensity, columns, lines)?;
            self.base.add(compare::compare(&test, &reference, None, &[])?.rmse);
        }
        Ok(())
    }

    /// The figures, in the order of [`NAMES`].
    pub fn figures(&self) -> Figures {
        let rmse = self.own.rms();
        let mean = |sum: f64| sum / self.frames.max(1.0);
        // A picture without a difference has no PSNR: it is left out.
        let psnr = (rmse > 0.0).then(|| -20.0 * libm::log10(rmse));
        let base = (self.base.count > 0.0).then(|| self.base.rms());
        let values =
            [Some(rmse), psnr, Some(mean(self.ssim)), Some(mean(self.flip)), Some(mean(self.beyond)), base];
        let named = NAMES[11..].iter().zip(values);
        named.filter_map(|(&(name, unit), value)| Some(ErrorFigure { name, unit, value: value? })).collect()
    }
}

/// How a display shows light.
pub(crate) fn transfer(display: &Display) -> Result<picture::Transfer, StudyError> {
    Ok(picture::Transfer::new(display.white as f32, display.gamma as f32)?)
}

#[cfg(test)]
mod tests {
    use super::groups;

    #[test]
    fn groups_are_spread_and_whole() {
        assert_eq!(groups(1000).collect::<Vec<_>>(), [80, 248, 416, 576, 744, 912]);
        assert_eq!(groups(20).collect::<Vec<_>>(), [0, 8, 16]);
        assert_eq!(groups(1).collect::<Vec<_>>(), [0]);
    }
}
