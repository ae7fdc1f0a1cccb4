//! `[raster]`: what is asked of the picture.

use diagnostics::Reader;
use quantities::radians;

use crate::{FieldOfView, FieldWish, RasterWishes, words};

pub(super) fn wishes(table: &Reader) -> RasterWishes {
    let count = |key: &str, least: u32, most: u32| table.u32(key).between(least, most).optional();
    let update = words::rate(table, "update_hz", 1).optional();
    let refresh = words::rate(table, "refresh_hz", 1).optional();
    words::check_refresh(table, update, refresh);
    RasterWishes {
        sweeps: count("sweeps", 1, 8192),
        samples: count("samples_per_sweep", 2, 65_536),
        columns: count("columns", 1, 8192),
        lines: count("lines", 1, 8192),
        update,
        refresh,
    }
}

/// Both angles of `table`, or the horizontal one and pixels that are square, whose lines `raster` must then name.
pub(super) fn field_of_view(table: &Reader, raster: &Reader) -> Option<FieldWish> {
    let angles = table
        .f64_or_pair("field_of_view_deg")
        .between(0.1, 170.0)
        .unit("degrees")
        .default(vec![50.0, 30.0])?;
    let tangent = |angle: f64| libm::tan(radians(0.5 * angle));
    match angles[..] {
        [width, height] => {
            let field = FieldOfView { tan_half_width: tangent(width), tan_half_height: tangent(height) };
            Some(FieldWish::Both(field))
        }
        _ if raster.has("lines") => Some(FieldWish::Across(tangent(angles[0]))),
        _ => {
            let (key, lines) = (table.path("field_of_view_deg"), raster.path("lines"));
            let title = format!("`{key}` is one angle, without `{lines}`: the height of the picture is open");
            let problem = table.problem("field_of_view_deg", title).expected("two angles, or lines as well");
            table.report(
                problem.help("with one angle pixels are square, as in `columns = 640`, `lines = 480`"),
            );
            None
        }
    }
}
