//! Where a pixel looks, in words and numbers.

use generator::Stage;
use quantities::degrees;
use scenario::{Projection, View};
use serde_json::{Value, json};

/// The pinhole camera of a picture: focal lengths and principal point (pixels). The centre of the top left pixel is [0, 0].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pinhole {
    /// Focal lengths along columns and along lines.
    pub focal: [f64; 2],
    /// Column and line of the principal point.
    pub centre: [f64; 2],
}

impl Pinhole {
    /// The pinhole of the pictures of `view`.
    pub fn of(view: &View) -> Self {
        let (columns, lines) = (f64::from(view.columns), f64::from(view.lines));
        Self {
            focal: [0.5 * columns / view.field.tan_half_width, 0.5 * lines / view.field.tan_half_height],
            centre: [0.5 * (columns - 1.0), 0.5 * (lines - 1.0)],
        }
    }

    /// Rows of the matrix from a place on the view-plane to a pixel.
    pub fn matrix(&self) -> [[f64; 3]; 3] {
        let ([fx, fy], [cx, cy]) = (self.focal, self.centre);
        [[fx, 0.0, cx], [0.0, fy, cy], [0.0, 0.0, 1.0]]
    }

    /// The pixels for which the pinhole is exact under a law of projection, in words.
    pub fn reach(law: Projection) -> &'static str {
        match law {
            Projection::Exact => "exact: the formulas hold for every pixel",
            Projection::Corrected => "corrected: the formulas hold for every pixel at zero pitch",
            Projection::AsReported => "as-reported: the formulas hold on the centre column",
        }
    }
}

/// The camera of a run.
pub(crate) fn camera(stage: &Stage) -> Value {
    let raster = &stage.view;
    let (half_width, half_height) = (raster.field.tan_half_width, raster.field.tan_half_height);
    let angle = |tangent: f64| degrees(2.0 * libm::atan(tangent));
    json!({
        "schema": "lunoid.camera/1",
        "columns": raster.columns,
        "lines": raster.lines,
        "field_of_view_deg": [angle(half_width), angle(half_height)],
        "tan_half_field": [half_width, half_height],
        "intrinsic_matrix": Pinhole::of(raster).matrix(),
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
        "projection": Pinhole::reach(stage.view.laws.projection),
    })
}
