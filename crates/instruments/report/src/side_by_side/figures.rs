//! Errors and times of runs that stand side by side.

use std::path::{Path, PathBuf};

use compare::{CompareError, compare, horizon_of_picture, ridge_error, shadow_agreement};
use picture::{Curve, Limits, read_any_png};
use rayon::iter::{IntoParallelIterator, ParallelIterator};
use run_record::FrameRecord;
use serde::{Deserialize, Serialize};

use crate::ReportError;
use crate::run::Run;

const TIMES: &str = "performance.json";
const MAX_BYTES: u64 = 1 << 20;
/// Code of the sky.
const SKY: u16 = 0;
/// Levels of 255 beyond which a pixel is counted.
const LEVELS: u32 = 2;

/// A run among others.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct MachineFigures {
    /// Name of the run's folder within the folder of the page.
    pub name: String,
    /// Name of the generator that drew.
    pub generator: String,
    /// Hardware model, of a generator that has one.
    pub model: Option<String>,
    /// Fingerprint of the run, hexadecimal.
    pub fingerprint: String,
    /// How many things were left out.
    pub omissions: usize,
    /// Error of every frame; none for the reference itself.
    pub errors: Option<Vec<FrameError>>,
    /// Time it took, of the session that drew last; none where it was not kept.
    pub time: Option<RunTime>,
}

/// Error of a frame against the reference, without any mask.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct FrameError {
    /// Frame, counted at the update rate.
    pub frame: u64,
    /// Root of the mean squared difference of grey (of colour its luminance), 0 to 1, as displayed.
    pub rmse: f64,
    /// Peak signal to noise (dB); none where no pixel differs.
    pub psnr_db: Option<f64>,
    /// Structural similarity; none of the smallest pictures.
    pub ssim: Option<f64>,
    /// Share of the pixels that differ by more than two levels of 255.
    pub beyond_two_levels: f64,
    /// By how many lines the horizon is off: half of the columns, and 99 of 100, by so much or less.
    pub horizon_lines: [usize; 2],
    /// Share of the pixels below both horizons that are dark in both pictures or lit in both.
    pub shadow_agreement: f64,
}

/// Wall time of the session that drew last.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct RunTime {
    /// Number of threads that drew.
    pub threads: u64,
    /// Number of frames drawn.
    pub frames_drawn: u64,
    /// Wall time (s) of all of them, with encoding and writing.
    pub drawing_s: f64,
}

impl RunTime {
    /// Wall time of a frame (s), where several are drawn at once as where one is.
    pub fn of_a_frame(&self) -> Option<f64> {
        (self.frames_drawn > 0).then(|| self.drawing_s / self.frames_drawn as f64)
    }
}

/// The runs in the folders `names` of `folder`.
pub(crate) fn read(folder: &Path, names: &[String]) -> Result<Vec<(String, Run)>, ReportError> {
    names.iter().map(|name| Ok((name.clone(), Run::read(&folder.join(name))?))).collect()
}

/// Each run, held against the one called `reference`, if there is one.
pub(crate) fn figures(
    folder: &Path,
    runs: &[(String, Run)],
    reference: Option<&str>,
) -> Result<Vec<MachineFigures>, ReportError> {
    let judge = runs.iter().find(|(name, _)| Some(name.as_str()) == reference);
    let of_run = |(name, run): &(String, Run)| {
        let errors = match judge.filter(|(judge, _)| judge != name) {
            Some((judge, of_judge)) => {
                Some(errors([&folder.join(name), &folder.join(judge)], [run, of_judge])?)
            }
            None => None,
        };
        Ok(MachineFigures {
            name: name.clone(),
            generator: run.generator.clone(),
            model: run.has_sweeps().then(|| run.model.name.clone()),
            fingerprint: run.fingerprint.clone(),
            omissions: run.omissions.len(),
            errors,
            time: time(&folder.join(name)),
        })
    };
    runs.iter().map(of_run).collect()
}

/// Errors of the frames that both runs have.
fn errors(folders: [&PathBuf; 2], runs: [&Run; 2]) -> Result<Vec<FrameError>, ReportError> {
    let (frames, curves) = (runs.map(|run| &run.frames[..]), runs.map(Run::curve));
    let pair = |test: &FrameRecord| {
        let at = frames[1].binary_search_by_key(&test.frame, |frame| frame.frame).ok()?;
        let (test_file, judge_file) = (test.files.first()?, frames[1][at].files.first()?);
        Some((test.frame, folders[0].join(&test_file.file), folders[1].join(&judge_file.file)))
    };
    let pairs: Vec<_> = frames[0].iter().filter_map(pair).collect();
    pairs.into_par_iter().map(|(frame, test, judge)| error(frame, &test, &judge, curves)).collect()
}

fn error(frame: u64, test: &Path, judge: &Path, curves: [Curve; 2]) -> Result<FrameError, ReportError> {
    let read = |path, curve| Ok::<_, ReportError>(read_any_png(path, &Limits::default())?.to_grey(curve));
    let [a, b] = [read(test, curves[0])?, read(judge, curves[1])?];
    let refused = |source: CompareError| ReportError::Compare { path: test.to_owned(), source };
    let comparison = compare(&a, &b, None, &[LEVELS]).map_err(refused)?;
    let horizons = [&a, &b].map(|picture| horizon_of_picture(picture, SKY));
    let ridges = ridge_error(&horizons[0], &horizons[1], 0).map_err(refused)?;
    Ok(FrameError {
        frame,
        rmse: comparison.rmse,
        psnr_db: comparison.psnr_db,
        ssim: comparison.ssim,
        beyond_two_levels: comparison.beyond.first().map_or(0.0, |beyond| beyond.share),
        horizon_lines: [ridges.median, ridges.percentile_99],
        shadow_agreement: shadow_agreement(&a, &b).map_err(refused)?.share(),
    })
}

/// Times that a run kept: a missing or foreign file is none.
fn time(folder: &Path) -> Option<RunTime> {
    serde_json::from_slice(&files::read_all(folder.join(TIMES), MAX_BYTES).ok()?).ok()
}
