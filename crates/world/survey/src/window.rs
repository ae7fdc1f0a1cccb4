//! Which lines and columns of a file a survey needs.

use std::f64::consts::{FRAC_PI_2, PI};

use crate::area::{Area, check_inside, check_resampled, place};
use crate::elevation::Grid;
use crate::error::SurveyError;
use crate::read::Window;
use landscape::projection::{Projection, wrap};

/// The lines and columns of a file on `grid` that a survey of `area` needs; `reach(size)` says how far to the
/// north and east (m) samples are wanted for an area of that size.
///
/// # Errors
/// If the area does not go with the file or lies outside it.
pub fn window(
    grid: &Grid,
    area: Area,
    reach: impl FnOnce([f64; 2]) -> Result<[f64; 2], SurveyError>,
) -> Result<Window, SurveyError> {
    let placed = place(grid, area)?;
    let size = placed.size();
    let [south, west, north, east] = match &placed.resampled {
        Some(plane) => {
            check_resampled(grid, [grid.lines, grid.columns], plane, size)?;
            around(grid, plane, size, reach(size)?)
        }
        None => {
            check_inside(grid, placed.area)?;
            let reach = reach(size)?;
            let [south, west, ..] = placed.area;
            [south, west, south + reach[0] / placed.metres[0], west + reach[1] / placed.metres[1]]
        }
    };
    let touched = |axis: usize, edges: [f64; 2]| {
        let [a, b] = edges.map(|edge| (edge - grid.affine.first[axis]) / grid.affine.step[axis]);
        // One sample more on each side: some are interpolated.
        [a.min(b).floor() as i64 - 1, a.max(b).ceil() as i64 + 2]
    };
    let held = |[start, end]: [i64; 2], count: usize| {
        let held = |at: i64| at.clamp(0, count as i64) as usize;
        held(start)..held(end)
    };
    let (lines, columns) = (touched(0, [south, north]), touched(1, [west, east]));
    let columns = match grid.turn() {
        Some(turn) if columns[1] - columns[0] >= turn as i64 => 0..grid.columns,
        Some(turn) => {
            let start = columns[0].rem_euclid(turn as i64) as usize;
            start..start + (columns[1] - columns[0]) as usize
        }
        None => held(columns, grid.columns),
    };
    Ok(Window { lines: held(lines, grid.lines), columns })
}

/// South, west, north, east (rad) of a cap of the sphere that holds what is interpolated to a plane.
fn around(grid: &Grid, plane: &Projection, size: [f64; 2], reach: [f64; 2]) -> [f64; 4] {
    let far = [0, 1].map(|k| (0.5 * size[k]).max(reach[k] - 0.5 * size[k]));
    let radius = libm::asin((libm::hypot(far[0], far[1]) / plane.radius).min(1.0));
    let [_, west, _, east] = grid.extent();
    let middle = 0.5 * (west + east);
    let longitude = middle + wrap(plane.longitude - middle);
    let [low, high] = [plane.latitude - radius, plane.latitude + radius];
    let sine = libm::sin(radius) / libm::cos(plane.latitude);
    let reaches_pole = low.min(-high) <= -FRAC_PI_2 || sine >= 1.0;
    let across = if reaches_pole { PI } else { libm::asin(sine) };
    let crosses = (longitude - middle).abs() + across >= PI;
    if grid.turn().is_none() && crosses {
        return [low, west, high, east];
    }
    [low, longitude - across, high, longitude + across]
}
