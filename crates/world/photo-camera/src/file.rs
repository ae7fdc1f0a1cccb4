//! The camera file: JSON that says its units in the names of its keys.
//!
//! ```json
//! {
//!   "format": 1,
//!   "focal_length_m": 0.15,
//!   "principal_point_m": [0.0, 0.0],
//!   "perspective_centre_m": [0.0, 0.0, 1740000.0],
//!   "omega_phi_kappa_rad": [0.0, 0.0, 0.0],
//!   "affine_x_um": [20.0, 0.0, 0.0],
//!   "affine_y_um": [0.0, 20.0, 0.0],
//!   "body": { "semi_major_axis_m": 1737400.0, "eccentricity_squared": 0.0 }
//! }
//! ```
//!
//! `image_axes`, three rows of three numbers, may stand in place of `omega_phi_kappa_rad`. The rows of the affine are A1, B1, C1
//! and A2, B2, C2. `"axes": "landscape"` may stand in place of `body`: then points are metres east, north and up of a landscape.
//! The keys of [`Light`] may be added. Unknown and repeated keys are refused. Numbers are read to one unit in the last place.

use diagnostics::Problem;
use glam::DVec3;
use serde::{Deserialize, Serialize};

use crate::{Affine, Axes, Camera, CameraError, Ellipsoid, Light, Orientation};

/// Format number of camera files that this code reads and writes.
const FORMAT: u64 = 1;

/// What to do about a text that is no camera file.
const HELP: &str = "correct the file at this place; docs/photo.md shows a whole one";

/// Word of the file for the axes of a landscape.
const LANDSCAPE: &str = "landscape";

/// A camera file: the camera, the axes in which it stands, and the light of its photograph.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CameraFile {
    /// The camera of the photograph.
    pub camera: Camera,
    /// The axes of the camera's centre and of ground points.
    pub axes: Axes,
    /// Sun and grey curve of the photograph, where the file has them.
    pub light: Light,
}

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Written {
    format: u64,
    focal_length_m: f64,
    principal_point_m: [f64; 2],
    perspective_centre_m: [f64; 3],
    #[serde(default, skip_serializing_if = "Option::is_none")]
    omega_phi_kappa_rad: Option<[f64; 3]>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    image_axes: Option<[[f64; 3]; 3]>,
    affine_x_um: [f64; 3],
    affine_y_um: [f64; 3],
    #[serde(default, skip_serializing_if = "Option::is_none")]
    body: Option<WrittenBody>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    axes: Option<String>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    sun_azimuth_elevation_rad: Option<[f64; 2]>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    grey_white_gamma: Option<[f64; 2]>,
}

#[derive(Clone, Copy, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct WrittenBody {
    semi_major_axis_m: f64,
    eccentricity_squared: f64,
}

impl CameraFile {
    /// Reads the text of a camera file; `name` is the file as the user named it.
    ///
    /// # Errors
    ///
    /// If the text is no camera file of format 1, with line and column; or if a figure makes no camera, with its key.
    pub fn read(name: &str, text: &str) -> Result<Self, Box<Problem>> {
        let written: Result<Written, Problem> = serde_json::from_str(text).map_err(|error| {
            let at = format!("{name}:{}:{}", error.line(), error.column());
            Problem::of_file(at, format!("the camera file cannot be read: {error}"))
                .expected("a camera file of format 1")
                .help(HELP)
        });
        let written = written.map_err(Box::new)?;
        if written.format != FORMAT {
            let problem = Problem::of_file(name, format!("`format` is {}, not {FORMAT}", written.format));
            let problem =
                problem.key("format").found(written.format.to_string()).expected(FORMAT.to_string());
            return Err(Box::new(problem.help("write the camera file anew with this version")));
        }
        written.meant(name)
    }

    /// The text of the file; the orientation is written as axes, which keep every digit.
    pub fn write(&self) -> String {
        let [affine_x_um, affine_y_um] = self.camera.affine().rows();
        let written = Written {
            format: FORMAT,
            focal_length_m: self.camera.focal_length(),
            principal_point_m: self.camera.principal_point(),
            perspective_centre_m: self.camera.centre().to_array(),
            omega_phi_kappa_rad: None,
            // A zero has no sign in the file.
            image_axes: Some(
                self.camera.orientation().axes().map(|axis| axis.to_array().map(|part| part + 0.0)),
            ),
            affine_x_um,
            affine_y_um,
            body: self.axes.body().map(|body| WrittenBody {
                semi_major_axis_m: body.semi_major(),
                eccentricity_squared: body.eccentricity_squared(),
            }),
            axes: (self.axes == Axes::Landscape).then(|| LANDSCAPE.to_owned()),
            sun_azimuth_elevation_rad: self.light.sun(),
            grey_white_gamma: self.light.grey(),
        };
        serde_json::to_string_pretty(&written).expect("numbers under fixed keys always make JSON") + "\n"
    }
}

impl Written {
    fn meant(&self, name: &str) -> Result<CameraFile, Box<Problem>> {
        let refused = |key: &'static str| {
            move |error: CameraError| {
                Box::new(Problem::of_file(name, format!("`{key}`: {error}")).key(key).help(HELP))
            }
        };
        let affine = Affine::new(self.affine_x_um, self.affine_y_um).map_err(refused("affine_x_um"))?;
        let centre = DVec3::from(self.perspective_centre_m);
        let camera =
            Camera::new(self.focal_length_m, self.principal_point_m, centre, self.orientation(name)?, affine)
                .map_err(refused("focal_length_m"))?;
        let light = Light::new(self.sun_azimuth_elevation_rad, self.grey_white_gamma);
        let light = light.map_err(|(key, error)| refused(key)(error))?;
        Ok(CameraFile { camera, axes: self.axes(name)?, light })
    }

    fn axes(&self, name: &str) -> Result<Axes, Box<Problem>> {
        let title = match (&self.body, &self.axes) {
            (Some(body), None) => {
                let made = Ellipsoid::new(body.semi_major_axis_m, body.eccentricity_squared);
                return made.map(Axes::Body).map_err(|error| {
                    Box::new(Problem::of_file(name, format!("`body`: {error}")).key("body").help(HELP))
                });
            }
            (None, Some(word)) if word == LANDSCAPE => return Ok(Axes::Landscape),
            (None, Some(word)) => format!("`axes` is \"{word}\", not \"{LANDSCAPE}\""),
            (Some(_), Some(_)) => "the axes are given by both of `body` and `axes`".to_owned(),
            (None, None) => "the axes are given by neither of `body` and `axes`".to_owned(),
        };
        let problem =
            Problem::of_file(name, title).key("axes").expected("a `body`, or `axes` as \"landscape\"");
        Err(Box::new(problem.help("give the body, or the axes of a landscape, not both")))
    }

    fn orientation(&self, name: &str) -> Result<Orientation, Box<Problem>> {
        let (key, made) = match (self.omega_phi_kappa_rad, self.image_axes) {
            (Some(angles), None) => ("omega_phi_kappa_rad", Orientation::from_angles(angles)),
            (None, Some(axes)) => ("image_axes", Orientation::from_axes(axes.map(DVec3::from))),
            (angles, _) => {
                let found = if angles.is_some() { "both" } else { "neither" };
                let title =
                    format!("the orientation is given by {found} of `omega_phi_kappa_rad` and `image_axes`");
                let problem = Problem::of_file(name, title).key("omega_phi_kappa_rad").found(found);
                let help = "give the three angles or the three axes, not both";
                return Err(Box::new(problem.expected("one of the two").help(help)));
            }
        };
        made.map_err(|error| {
            Box::new(Problem::of_file(name, format!("`{key}`: {error}")).key(key).help(HELP))
        })
    }
}
