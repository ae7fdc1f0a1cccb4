//! The pictures that are compared: one pair, or a pair a frame.

use std::path::{Path, PathBuf};

use compare::{compare_any, compare_linear, horizon_of_picture, linear_luminance, ridge_error};
use photographs::CURVE;
use picture::{AnyPicture, Curve, Limits, Transfer, read_any_png};
use rayon::ThreadPool;
use replay::HeldRun;

use crate::edges::Edges;
use crate::pair::Pair;
use crate::{Compared, EdgeKind, RunCompareError};

/// Code of the sky.
const SKY: u16 = 0;

/// Frame, and the pictures of it.
type Paths = (Option<u64>, PathBuf, PathBuf);

/// Which pixels are left out.
#[derive(Clone, Copy)]
pub enum LeftOut<'a> {
    /// Those that are not black in a picture, if there is one.
    Mask(Option<&'a Path>),
    /// Those along the edges that the closed form sees in a scenario.
    Edges {
        /// File of the scenario of both runs.
        scenario: &'a Path,
        /// Kind of edges that are left out.
        kind: EdgeKind,
        /// Threads that draw the closed form.
        pool: &'a ThreadPool,
    },
}

/// Pictures that are to be compared.
pub struct Pictures {
    sides: [PathBuf; 2],
    pairs: Vec<Paths>,
    /// Frames of both runs, of the one under test, and of the other, where these differ.
    pub common: Option<[usize; 3]>,
    /// The display laws of both runs: a picture alone does not say how codes came from reflectivity.
    displays: Option<[Transfer; 2]>,
}

impl Pictures {
    /// Pairs two pictures, or the pictures of two run folders. Edges can be left out of runs alone.
    ///
    /// # Errors
    /// If there is nothing to pair, or a run cannot be read.
    pub fn of(test: &Path, reference: &Path, has_edges: bool) -> Result<Self, RunCompareError> {
        let sides = [test, reference].map(Path::to_owned);
        if let Some(missing) = sides.iter().find(|path| !path.exists()) {
            return Err(RunCompareError::Missing(missing.clone()));
        }
        match (test.is_dir(), reference.is_dir()) {
            (false, false) if has_edges => Err(RunCompareError::NoFrames),
            (false, false) => {
                let pairs = vec![(None, test.to_owned(), reference.to_owned())];
                Ok(Self { sides, pairs, common: None, displays: None })
            }
            (true, true) => Self::of_runs(sides),
            _ => Err(RunCompareError::Mixed(sides)),
        }
    }

    fn of_runs(sides: [PathBuf; 2]) -> Result<Self, RunCompareError> {
        let [test, reference] = &sides;
        let runs = [HeldRun::read(test)?, HeldRun::read(reference)?];
        let mut pairs = Vec::new();
        for frame in &runs[0].frames {
            let other = runs[1].frames.iter().find(|other| other.frame == frame.frame);
            if let (Some(a), Some(b)) = (frame.files.first(), other.and_then(|other| other.files.first())) {
                pairs.push((Some(frame.frame), test.join(&a.file), reference.join(&b.file)));
            }
        }
        if pairs.is_empty() {
            return Err(RunCompareError::NoCommonFrame(sides));
        }
        let [of_test, of_reference] = runs.each_ref().map(|run| run.frames.len());
        let is_all = [of_test, of_reference] == [pairs.len(); 2];
        let common = (!is_all).then_some([pairs.len(), of_test, of_reference]);
        let displays = Some([display(test, &runs[0])?, display(reference, &runs[1])?]);
        Ok(Self { sides, pairs, common, displays })
    }

    /// Compares them, and counts the pixels that are off by more than `levels` of 255 too.
    ///
    /// # Errors
    /// If a picture cannot be read, two do not go together, or a run is not of the scenario whose edges are left out.
    pub fn compare(self, left_out: LeftOut<'_>, levels: Option<u32>) -> Result<Compared, RunCompareError> {
        let pairs = match left_out {
            LeftOut::Mask(mask) => {
                let mask = mask.map(read_mask).transpose()?;
                let compare = |paths| self.pair(paths, mask.as_deref(), levels, None);
                self.pairs.iter().map(compare).collect::<Result<_, _>>()?
            }
            LeftOut::Edges { scenario, kind, pool } => self.along_edges(scenario, kind, pool, levels)?,
        };
        Ok(Compared { sides: self.sides, pairs })
    }

    fn along_edges(
        &self,
        scenario: &Path,
        kind: EdgeKind,
        pool: &ThreadPool,
        levels: Option<u32>,
    ) -> Result<Vec<Pair>, RunCompareError> {
        let mut edges = Edges::of(scenario, kind, pool)?;
        for folder in &self.sides {
            edges.expect_run(folder, &HeldRun::read(folder)?)?;
        }
        let compare = |paths: &Paths| {
            let mask = edges.mask(paths.0.unwrap_or_default(), pool)?;
            let pair = self.pair(paths, Some(&mask.pixels), levels, Some(kind))?;
            Ok(Pair { edges: matches!(kind, EdgeKind::Edges(_)).then_some(mask), ..pair })
        };
        self.pairs.iter().map(compare).collect()
    }

    fn pair(
        &self,
        (frame, test, reference): &Paths,
        mask: Option<&[bool]>,
        levels: Option<u32>,
        kind: Option<EdgeKind>,
    ) -> Result<Pair, RunCompareError> {
        let is_of_run = self.displays.is_some();
        let [a, b] = [read(test, is_of_run)?, read(reference, is_of_run)?];
        let curves = self.displays.map_or([CURVE; 2], |displays| displays.map(curve));
        let levels: Vec<u32> = [0, 1, 2].into_iter().chain(levels.filter(|levels| *levels > 2)).collect();
        let refused =
            |error| RunCompareError::Unlike { picture: test.clone(), reference: reference.clone(), error };
        let comparison = compare_any([&a, &b], curves, mask, &levels).map_err(refused)?;
        let linear = self.displays.map(|[of_a, of_b]| {
            compare_linear(&linear_luminance(&a, &of_a), &linear_luminance(&b, &of_b), mask)
        });
        let linear = linear.transpose().map_err(refused)?;
        let horizons = [(&a, curves[0]), (&b, curves[1])]
            .map(|(picture, curve)| horizon_of_picture(&picture.to_grey(curve), SKY));
        let is_colour = a.is_colour() || b.is_colour();
        let margin = |kind| usize::from(matches!(kind, EdgeKind::Edges(_)));
        let ridges = kind.map(|kind| ridge_error(&horizons[0], &horizons[1], margin(kind))).transpose()?;
        let (frame, test, reference) = (*frame, test.clone(), reference.clone());
        Ok(Pair { frame, test, reference, comparison, is_colour, linear, edges: None, ridges })
    }
}

/// The display law of a run.
fn display(folder: &Path, run: &HeldRun) -> Result<Transfer, RunCompareError> {
    let display = run.view.display;
    let refused = |error| RunCompareError::Display { folder: folder.to_owned(), error };
    Transfer::new(display.white as f32, display.gamma as f32).map_err(refused)
}

/// The curve of a run's display, by which its colours become grey.
fn curve(display: Transfer) -> Curve {
    Curve::Power(display.gamma().into())
}

/// A frame of a run is read as the program wrote it.
pub(crate) fn read(path: &Path, is_of_run: bool) -> Result<AnyPicture, RunCompareError> {
    match is_of_run {
        true => Ok(read_any_png(path, &Limits::default())?),
        false => Ok(photographs::read(path)?),
    }
}

fn read_mask(path: &Path) -> Result<Vec<bool>, RunCompareError> {
    Ok(photographs::read(path)?.is_lit())
}
