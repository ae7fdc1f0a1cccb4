//! Columns of a list.

use tables::{Column, Form};

pub(super) const X: usize = 0;
pub(super) const Y: usize = 1;
pub(super) const RADIUS: usize = 2;
pub(super) const DEPTH: usize = 3;
pub(super) const RIM: usize = 4;
pub(super) const TYPE: usize = 5;
pub(super) const OUTER_RADIUS: usize = 6;
pub(super) const FLOOR_RADIUS: usize = 7;

/// The table of a list of craters.
pub(super) const FORM: Form = Form {
    what: "list of craters",
    columns: &[
        Column::needed("x_m"),
        Column::needed("y_m"),
        Column::needed("radius_m"),
        Column::needed("depth_m"),
        Column::needed("rim_m"),
        Column::needed("type"),
        Column::optional("outer_m"),
        Column::optional("floor_m"),
    ],
    harmless: &[],
};
