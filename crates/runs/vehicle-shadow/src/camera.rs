//! What the camera sees: `camera.json` of a run, or of anybody else.

use std::path::Path;

use files::{FileError, read_all};
use quantities::{degrees, radians};
use scenario::FieldOfView;
use serde::Deserialize;

use crate::AugmentError;

/// Largest file of a camera.
const MAX_BYTES: u64 = 1 << 20;

/// A camera that is fixed to the vehicle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Camera {
    /// Half sizes of the view-plane.
    pub field: FieldOfView,
    /// Columns and lines of its pictures, if it says so.
    pub size: Option<[usize; 2]>,
    /// Whether its pictures turn with the vehicle's roll.
    pub rolls: bool,
}

/// The keys that are read.
#[derive(Deserialize)]
struct Written {
    columns: Option<usize>,
    lines: Option<usize>,
    tan_half_field: [f64; 2],
    projection: Option<String>,
    roll_drawn: Option<bool>,
}

impl Camera {
    /// A camera with these angles of view, width and height (deg); fixed to the vehicle, it rolls with it.
    pub fn of_field([width, height]: [f64; 2]) -> Option<Self> {
        let tangent = |angle: f64| libm::tan(0.5 * radians(angle));
        let is_angle = |angle: f64| angle > 0.0 && angle < 170.0;
        let field = FieldOfView { tan_half_width: tangent(width), tan_half_height: tangent(height) };
        (is_angle(width) && is_angle(height)).then_some(Self { field, size: None, rolls: true })
    }

    /// Its angles of view, width and height (deg).
    pub fn angles_of_view(&self) -> [f64; 2] {
        [self.field.tan_half_width, self.field.tan_half_height]
            .map(|tangent| degrees(2.0 * libm::atan(tangent)))
    }

    /// Reads `camera.json`: `tan_half_field`, and if they are there `columns`, `lines`, `projection` and `roll_drawn` (true
    /// if left out).
    ///
    /// # Errors
    /// If it cannot be read, lacks the field, or its pictures are no perspective.
    pub fn read(path: &Path) -> Result<Self, AugmentError> {
        let refused = |what: String, expected: &str| AugmentError::Content {
            path: path.to_owned(),
            line: None,
            what,
            expected: expected.into(),
        };
        let bytes = read_all(path, MAX_BYTES).map_err(|error| match error {
            FileError::Missing { path } => AugmentError::NoCamera { path },
            other => other.into(),
        })?;
        let written: Written = serde_json::from_slice(&bytes).map_err(|error| {
            refused(error.to_string(), "a JSON object with tan_half_field = [width, height]")
        })?;
        // The law stands before its explanation.
        let law = written.projection.as_deref().and_then(|words| words.split(':').next()).unwrap_or("exact");
        if law != "exact" {
            return Err(refused(
                format!("pictures of the projection law `{law}`"),
                "a perspective; draw them again with --set dpp.projection=exact",
            ));
        }
        let [tan_half_width, tan_half_height] = written.tan_half_field;
        if ![tan_half_width, tan_half_height].iter().all(|tangent| *tangent > 0.0 && *tangent < 12.0) {
            return Err(refused(
                format!("tan_half_field = {:?}", written.tan_half_field),
                "two tangents above 0 and below 12",
            ));
        }
        Ok(Self {
            field: FieldOfView { tan_half_width, tan_half_height },
            size: written.columns.zip(written.lines).map(|(columns, lines)| [columns, lines]),
            rolls: written.roll_drawn.unwrap_or(true),
        })
    }
}
