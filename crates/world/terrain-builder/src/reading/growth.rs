//! `kind = "growth"`: control points and curves.

use diagnostics::Reader;
use quantities::radians;

use super::checked;
use super::features::area;
use crate::description::Kind;
use crate::frame::Frame;
use crate::grid::Grid;
use crate::growth::{ControlPoint, Growth, Pick};

/// Reads the points of a feature that grows.
pub fn growth(table: &Reader, frame: &Frame, grid: &Grid) -> Option<Kind> {
    let area = area(table, frame);
    let spacing = table.f64("spacing_m").default(grid.north.resolution);
    let iterations = table.u32("iterations").optional();
    let points: Vec<_> = table.tables("points").iter().map(|point| control_point(point, frame)).collect();
    let curves: Vec<_> = table.tables("curves").iter().map(|curve| curve_of(curve, frame)).collect();
    let growth = Growth {
        area: area?,
        spacing: spacing?,
        points: points.into_iter().collect::<Option<_>>()?,
        curves: curves.into_iter().collect::<Option<_>>()?,
        iterations,
    };
    checked(table, growth.check())?;
    Some(Kind::Growth(growth))
}

/// A point with its place, height and weight.
fn pick(table: &Reader, frame: &Frame) -> Option<Pick> {
    let place = table.f64_array::<2>("at_deg").between(-360.0, 360.0).required();
    let (height, weight) = (table.f64("height_m").required(), table.f64("weight").default(1.0));
    let [longitude, latitude] = place?.map(radians);
    Some(Pick { at: frame.forward(latitude, longitude), height: height?, weight: weight? })
}

fn control_point(table: &Reader, frame: &Frame) -> Option<ControlPoint> {
    let initial = table.f64("initial_m").default(0.0);
    let Pick { at, height, weight } = pick(table, frame)?;
    Some(ControlPoint { at, height, weight, initial: initial? })
}

fn curve_of(table: &Reader, frame: &Frame) -> Option<Vec<Pick>> {
    let picks: Vec<_> = table.tables("picks").iter().map(|point| pick(point, frame)).collect();
    let picks = picks.into_iter().collect::<Option<Vec<_>>>()?;
    if picks.len() < 2 {
        let title = format!("`{}` has {} picks", table.path("picks"), picks.len());
        table.report(
            table
                .problem("picks", title)
                .expected("at least two picks")
                .help("a single point belongs to `points`"),
        );
        return None;
    }
    Some(picks)
}
