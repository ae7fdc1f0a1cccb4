//! Silhouettes: where they are, and how far off.

use picture::GreyPicture;

use crate::metrics::CompareError;

/// The pixels along ridge lines: every ridge pixel and its eight neighbours. A ridge pixel is ground whose
/// vertical or horizontal neighbour is sky, or lies farther by more than `jump` times its own range.
///
/// `range` holds ground ranges in any unit, line by line from the top, infinity for the sky. `jump` is
/// relative: 0.2 marks steps of more than a fifth.
///
/// # Errors
/// [`CompareError::Plane`], [`CompareError::Range`].
pub fn ridge_mask(range: &[f32], columns: usize, lines: usize, jump: f32) -> Result<Vec<bool>, CompareError> {
    check_range(range, columns, lines)?;
    let mut mask = vec![false; range.len()];
    for at in (0..range.len()).filter(|at| is_ridge(range, columns, *at, jump)) {
        let (column, line) = (at % columns, at / columns);
        for line in line.saturating_sub(1)..(line + 2).min(lines) {
            mask[line * columns..][column.saturating_sub(1)..(column + 2).min(columns)].fill(true);
        }
    }
    Ok(mask)
}

fn check_range(range: &[f32], columns: usize, lines: usize) -> Result<(), CompareError> {
    let expected = columns.saturating_mul(lines);
    if range.len() != expected || range.is_empty() {
        return Err(CompareError::Plane { what: "range plane", found: range.len(), expected });
    }
    match range.iter().position(|range| range.is_nan() || *range < 0.0) {
        Some(at) => {
            let (column, line, value) = (at % columns, at / columns, range[at]);
            Err(CompareError::Range { column, line, value })
        }
        None => Ok(()),
    }
}

fn is_ridge(range: &[f32], columns: usize, at: usize, jump: f32) -> bool {
    let here = range[at];
    let column = at % columns;
    let beyond = |neighbour: usize| range[neighbour] - here > jump * here;
    here.is_finite()
        && ((column > 0 && beyond(at - 1))
            || (column + 1 < columns && beyond(at + 1))
            || (at >= columns && beyond(at - columns))
            || (at + columns < range.len() && beyond(at + columns)))
}

/// For each column the first line from the top that is ground in a range plane (infinity is sky).
///
/// # Errors
/// [`CompareError::Plane`], [`CompareError::Range`].
pub fn horizon_of_range(
    range: &[f32],
    columns: usize,
    lines: usize,
) -> Result<Vec<Option<usize>>, CompareError> {
    check_range(range, columns, lines)?;
    let first_ground = |column: usize| (0..lines).find(|line| range[line * columns + column].is_finite());
    Ok((0..columns).map(first_ground).collect())
}

/// For each column the first line from the top whose code is above `sky`. Shadow on a ridge is as black as
/// the sky: use the range plane where there is one.
pub fn horizon_of_picture(picture: &GreyPicture, sky: u16) -> Vec<Option<usize>> {
    let first_ground = |column| (0..picture.lines()).find(|line| picture.code(column, *line) > sky);
    (0..picture.columns()).map(first_ground).collect()
}

/// By how many lines one horizon lies off another, over the columns where both see ground.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RidgeError {
    /// Columns where both see ground.
    pub compared: usize,
    /// Columns where only one does.
    pub only_one: usize,
    /// Half the columns are off by so much or less.
    pub median: usize,
    /// 99 of 100 columns are off by so much or less.
    pub percentile_99: usize,
    /// Largest error of any column (lines).
    pub maximum: usize,
}

/// Compares two horizons. A column is off by the distance from the lines that the reference spans within `reach`
/// columns to either side: 0 for column against column, 1 for a mask of one pixel along upright edges (masts, rocks).
///
/// # Errors
/// [`CompareError::Plane`] for different numbers of columns.
pub fn ridge_error(
    test: &[Option<usize>],
    reference: &[Option<usize>],
    reach: usize,
) -> Result<RidgeError, CompareError> {
    let (found, expected) = (test.len(), reference.len());
    if found != expected {
        return Err(CompareError::Plane { what: "horizon", found, expected });
    }
    let pairs = || test.iter().zip(reference);
    let off = |column: usize| {
        let line = test[column]?;
        reference[column]?;
        let near = &reference[column.saturating_sub(reach)..(column + reach + 1).min(expected)];
        let lines = || near.iter().flatten().copied();
        let (highest, lowest) = (lines().min()?, lines().max()?);
        Some(highest.saturating_sub(line).max(line.saturating_sub(lowest)))
    };
    let mut errors: Vec<usize> = (0..expected).filter_map(off).collect();
    errors.sort_unstable();
    // Nearest rank; no column at all is no error.
    let rank = |share: usize| {
        errors.get((errors.len() * share).div_ceil(100).saturating_sub(1)).copied().unwrap_or(0)
    };
    Ok(RidgeError {
        compared: errors.len(),
        only_one: pairs().filter(|(test, reference)| test.is_some() != reference.is_some()).count(),
        median: rank(50),
        percentile_99: rank(99),
        maximum: rank(100),
    })
}
