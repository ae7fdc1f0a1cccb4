//! From an elevation and options to a bank and its report.

use landscape::{Bank, LUNOID_RADIUS};
use quantities::unit_interval;
use rayon::prelude::*;

use crate::area::{Area, Cut, cut};
use crate::elevation::Elevation;
use crate::error::SurveyError;
use crate::fill::fill;
use crate::fit::{Fit, Place, Stiffness, Stop, fit};
use crate::measure::{empty_regions, measure};
use crate::patch::Patch;
use crate::read::{Opened, Window};
use crate::report::{LevelReport, SurveyReport};
use crate::window::window;

/// What to survey and how.
#[derive(Debug, Clone, PartialEq)]
pub struct SurveyOptions {
    /// Area of the file that becomes the bank.
    pub area: Area,
    /// Side of a region of the finest level (m).
    pub region_size: f64,
    /// Region sizes of the levels in units of the finest, ascending from 1. Default `[1]`.
    pub levels: Vec<usize>,
    /// Smoothing and stiffness in voids.
    pub stiffness: Stiffness,
    /// Fraction of the samples that is kept from the fit to test it, 0 to 0.5. Default 0.01.
    pub held_out: f64,
    /// Relative residual at which the iteration stops. Default 1e-9.
    pub tolerance: f64,
    /// Most iterations a level. Default 1000.
    pub iterations: usize,
    /// Title of the bank; that of the file if `None`.
    pub title: Option<String>,
}

impl SurveyOptions {
    /// Defaults for regions of `region_size` m.
    pub fn new(region_size: f64) -> Self {
        Self {
            area: Area::Whole,
            region_size,
            levels: vec![1],
            stiffness: Stiffness::default(),
            held_out: 0.01,
            tolerance: 1e-9,
            iterations: 1000,
            title: None,
        }
    }

    /// The lines and columns of a file that a survey with these options needs: what to give to [`Opened::window`].
    ///
    /// # Errors
    /// If an option is unusable, or the area does not go with the file or lies outside it.
    pub fn window(&self, opened: &Opened) -> Result<Window, SurveyError> {
        self.check()?;
        window(&opened.grid, self.area, |size| Ok(self.reach(&self.shapes(size)?)))
    }

    /// Regions of each level over an area of this size (m), to the north and east.
    fn shapes(&self, size: [f64; 2]) -> Result<Vec<[usize; 2]>, SurveyError> {
        let shape = |factor: &usize| regions(size, self.region_size * *factor as f64);
        self.levels.iter().map(shape).collect()
    }

    /// How far to the north and east (m) the regions of all levels go.
    fn reach(&self, shapes: &[[usize; 2]]) -> [f64; 2] {
        let reach = |axis: usize| {
            let ends = self.levels.iter().zip(shapes);
            ends.map(|(factor, shape)| (factor * shape[axis]) as f64).fold(0.0, f64::max)
        };
        [0, 1].map(|axis| reach(axis) * self.region_size)
    }

    fn check(&self) -> Result<(), SurveyError> {
        let refuse = |option, found: String, expected: &str| {
            Err(SurveyError::Option { option, found, expected: expected.to_string() })
        };
        if !(self.region_size.is_finite() && self.region_size > 0.0) {
            return refuse("region size", format!("{} m", self.region_size), "a length above 0 m");
        }
        let follows = |pair: &[usize]| pair[1] > pair[0];
        if self.levels.first() != Some(&1) || !self.levels.windows(2).all(follows) {
            return refuse(
                "levels",
                format!("{:?}", self.levels),
                "ascending whole numbers that begin with 1",
            );
        }
        if !(0.0..=0.5).contains(&self.held_out) {
            return refuse("held-out fraction", self.held_out.to_string(), "0 to 0.5");
        }
        if !(self.tolerance > 0.0 && self.tolerance < 1.0) {
            return refuse("tolerance", self.tolerance.to_string(), "above 0 and below 1");
        }
        let Stiffness { smoothing, filled_weight } = self.stiffness;
        if !(smoothing > 0.0 && smoothing <= 10.0) {
            return refuse("smoothing", smoothing.to_string(), "above 0 and at most 10 region sizes");
        }
        if !(filled_weight > 0.0 && filled_weight <= 1.0) {
            return refuse("weight of filled heights", filled_weight.to_string(), "above 0 and at most 1");
        }
        Ok(())
    }
}

/// Values at the sample places of the finest level.
#[derive(Debug, Clone, PartialEq)]
pub struct Grid {
    /// Lines, the first the southernmost.
    pub lines: usize,
    /// Columns, the first the westernmost.
    pub columns: usize,
    /// Place of line 0, column 0 in the bank: north, east (m).
    pub first: [f64; 2],
    /// From line to line and column to column (m).
    pub step: [f64; 2],
    /// Values line by line; NaN where there is none.
    pub values: Vec<f64>,
}

/// Result of a finished survey.
#[derive(Debug, Clone, PartialEq)]
pub struct Survey {
    /// Terrain coefficients that were fitted, all levels of them.
    pub bank: Bank,
    /// Figures of the survey, for people and tools.
    pub report: SurveyReport,
    /// Fitted heights (m) of the finest level, in voids too.
    pub fitted: Grid,
    /// Height of the file less fitted height (m); NaN in voids.
    pub residuals: Grid,
}

/// What a running survey tells.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Step {
    /// Level being fitted, from 0, the finest.
    pub level: usize,
    /// Number of iterations made so far on this level.
    pub iteration: usize,
    /// Relative residual now; the fit ends at [`SurveyOptions::tolerance`].
    pub residual: f64,
}

/// Seed of the choice of held-out samples.
const HELD_OUT_SEED: u64 = 0x5011_0e7e_57ed;

/// Most coefficients a sample that a fit is made for.
const COEFFICIENTS_PER_SAMPLE: usize = 64;

/// Fits a bank to an area of `elevation`; `progress` hears of every iteration.
///
/// # Errors
/// If an option is unusable, the area is not in the file or holds only voids, or regions are far smaller than the
/// spacing of the samples.
pub fn survey(
    elevation: &Elevation,
    options: &SurveyOptions,
    progress: &mut dyn FnMut(Step),
) -> Result<Survey, SurveyError> {
    options.check()?;
    let mut shapes = Vec::new();
    let cut = cut(elevation, options.area, |size| {
        shapes = options.shapes(size)?;
        Ok(options.reach(&shapes))
    })?;
    landscape::bank_file::check_map(&cut.map)?;
    let places = choose(&cut.patch, options.held_out);
    let samples = places.iter().filter(|place| **place == Place::Used).count();
    if samples == 0 {
        let what = format!("area of {}", elevation.title);
        return Err(SurveyError::AllVoid { what, count: places.len() });
    }
    check_size(&shapes[0], options.region_size, samples)?;

    let filled = fill(&cut.patch, &places);
    let (mut levels, mut reports, mut grids, mut fit_memory) = (Vec::new(), Vec::new(), None, 0);
    for (index, (&factor, &shape)) in options.levels.iter().zip(&shapes).enumerate() {
        let stop = Stop { tolerance: options.tolerance, iterations: options.iterations };
        let size = options.region_size * factor as f64;
        let mut tell = |iteration, residual| progress(Step { level: index, iteration, residual });
        let fit = fit(&cut.patch, &places, &filled, size, shape, options.stiffness, stop, &mut tell)?;
        let (fitted, residuals, report) = measure(&cut.patch, &places, &fit);
        grids.get_or_insert_with(|| (fitted, residuals, empty_regions(&cut.patch, &fit.axes)));
        fit_memory = fit_memory.max(fit.memory);
        reports.push(report);
        let Fit { level, .. } = fit;
        levels.push(level);
    }
    let (fitted, residuals, voids) = grids.ok_or(landscape::BankError::NoLevels)?;
    let title = options.title.clone().unwrap_or_else(|| elevation.title.clone());
    let peak_memory =
        8 * (elevation.lines * elevation.columns + 4 * places.len()) + places.len() + fit_memory;
    let report = assemble(elevation, &cut, title.clone(), reports, options, peak_memory);
    let bank = Bank::new(title, levels, cut.georeference)?.with_voids(voids)?.with_map(Some(cut.map));
    Ok(Survey { bank, report, fitted, residuals })
}

/// Regions of side `region` that cover `size`, to the north and east.
fn regions(size: [f64; 2], region: f64) -> Result<[usize; 2], SurveyError> {
    if size.iter().any(|&length| region > length * (1.0 + 1e-9)) {
        return Err(SurveyError::Option {
            option: "region size",
            found: format!("{region} m"),
            expected: format!("at most the size of the area, {} m x {} m", size[0], size[1]),
        });
    }
    Ok(size.map(|length| ((length / region - 1e-6).ceil() as usize).max(1)))
}

fn check_size(shape: &[usize; 2], size: f64, samples: usize) -> Result<(), SurveyError> {
    let corners = (shape[0].saturating_add(1)).saturating_mul(shape[1].saturating_add(1));
    let (coefficients, most) =
        (corners.saturating_mul(9), samples.saturating_mul(COEFFICIENTS_PER_SAMPLE).max(576));
    if coefficients > most {
        return Err(SurveyError::TooManyRegions { size, coefficients, samples, most });
    }
    Ok(())
}

/// Sorts the sample places; the fraction `held_out` is chosen by place in the file, not by order.
fn choose(patch: &Patch, held_out: f64) -> Vec<Place> {
    let columns = patch.count[1];
    let sort = |(index, height): (usize, &f64)| {
        let chance = || {
            let [line, column] = patch.in_file(index / columns, index % columns);
            unit_interval(HELD_OUT_SEED, &[line as u64, column as u64])
        };
        match height {
            height if height.is_nan() => Place::Void,
            _ if held_out > 0.0 && chance() < held_out => Place::HeldOut,
            _ => Place::Used,
        }
    };
    patch.heights.par_iter().enumerate().map(sort).collect()
}

fn assemble(
    elevation: &Elevation,
    cut: &Cut,
    title: String,
    levels: Vec<LevelReport>,
    options: &SurveyOptions,
    peak_memory: usize,
) -> SurveyReport {
    let mut warnings = elevation.notes.clone();
    warnings.extend(cut.warnings.iter().cloned());
    warnings.extend(levels.iter().flat_map(|level| level_warnings(level, options)));
    let held = cut.patch.heights.iter().filter(|height| !height.is_nan());
    let height = held.fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], &h| [a.min(h), b.max(h)]);
    SurveyReport {
        title,
        area: cut.area,
        samples: cut.patch.count,
        spacing: cut.patch.step,
        height,
        true_north: cut.true_north,
        levels,
        warnings,
        peak_memory,
    }
}

fn level_warnings(level: &LevelReport, options: &SurveyOptions) -> Vec<String> {
    let mut out = Vec::new();
    let size = level.region_size;
    if level.coefficients > level.used {
        out.push(format!(
            "regions of {size} m: {} coefficients for {} samples; smoothing decides what the samples leave open",
            level.coefficients, level.used
        ));
    }
    if level.relative_residual > options.tolerance {
        out.push(format!(
            "regions of {size} m: stopped after {} iterations at relative residual {:.1e}, above {:.1e}",
            level.iterations, level.relative_residual, options.tolerance
        ));
    }
    let edge = size * (level.corners[0].max(level.corners[1]) - 1) as f64;
    if edge > 0.1 * LUNOID_RADIUS {
        out.push(format!(
            "the bank is {:.0} km wide; a plane stands for the Moon up to some tens",
            edge / 1000.0
        ));
    }
    out
}
