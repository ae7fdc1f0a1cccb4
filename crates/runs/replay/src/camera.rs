//! Where a pixel looks, in words and numbers.

use generator::Stage;
use quantities::degrees;
use scenario::Projection;
use serde_json::{Value, json};

/// The camera of a run.
pub(crate) fn camera(stage: &Stage) -> Value {
    let raster = &stage.view;
    let (half_width, half_height) = (raster.field.tan_half_width, raster.field.tan_half_height);
    let (columns, lines) = (f64::from(raster.columns), f64::from(raster.lines));
    let (fx, fy) = (0.5 * columns / half_width, 0.5 * lines / half_height);
    let angle = |tangent: f64| degrees(2.0 * libm::atan(tangent));
    json!({
        "schema": "lunoid.camera/1",
        "columns": raster.columns,
        "lines": raster.lines,
        "field_of_view_deg": [angle(half_width), angle(half_height)],
        "tan_half_field": [half_width, half_height],
        "intrinsic_matrix": [[fx, 0.0, 0.5 * (columns - 1.0)], [0.0, fy, 0.5 * (lines - 1.0)], [0.0, 0.0, 1.0]],
        "intrinsic_matrix_words":
            "pixel [column, line, 1] = matrix [X, Y, 1]; the centre of the top left pixel is [0, 0]",
        "pixel_to_ray":
            "X = tan_half_field[0] (2 column + 1 - columns) / columns, \
             Y = tan_half_field[1] (2 line + 1 - lines) / lines; ray [1, X, Y] in vehicle axes",
        "vehicle_axes": "forward, starboard, down; origin at the eye",
        "roll_drawn": stage.view.yoke.is_some(),
        "terrain_axes": "north, east, down; poses.csv gives x_m north, y_m east, z_m up",
        "vehicle_to_terrain": {
            "formula": "ray_terrain = Phi Theta Psi ray_vehicle with the heading and pitch of poses.csv",
            "phi": "[[cos h, -sin h, 0], [sin h, cos h, 0], [0, 0, 1]], h = heading, clockwise from north",
            "theta": "[[cos p, 0, sin p], [0, 1, 0], [-sin p, 0, cos p]], p = pitch, nose up",
            "psi": "[[1, 0, 0], [0, cos y, -sin y], [0, sin y, cos y]], y = angle of the yoke, starboard down",
            "roll": match stage.view.yoke {
                None => "recorded in poses.csv and not drawn: the yoke stays upright, y = 0",
                Some(_) => "drawn by the yoke, which turns by steps and at a limited rate: y follows the roll of \
                            poses.csv and may lag behind it",
            },
        },
        "projection": match stage.view.laws.projection {
            Projection::Exact => "exact: the formulas hold for every pixel",
            Projection::Corrected => "corrected: the formulas hold for every pixel at zero pitch",
            Projection::AsReported => "as-reported: the formulas hold on the centre column",
        },
    })
}
