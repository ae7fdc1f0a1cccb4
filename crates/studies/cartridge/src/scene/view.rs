//! From a pixel to its ray, to a point on the ray, and back to a pixel.

use exact::View;
use glam::DVec3;
use landscape::Attitude;
use quantities::radians;
use scenario::Projection;
use serde::Deserialize;

use super::within;

/// Every pixel of a picture under every pitch, heading and angle of the yoke. Angles in degrees.
#[derive(Debug, Clone, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct ViewScene {
    /// Pitches of the vehicle, nose up.
    pub pitches_deg: Vec<f64>,
    /// Headings of the vehicle, clockwise from north.
    pub headings_deg: Vec<f64>,
    /// Angles of the yoke, starboard down.
    pub yokes_deg: Vec<f64>,
    /// Field of view, across and upright.
    pub field_deg: [f64; 2],
    /// Columns and lines of the picture.
    pub raster: [u32; 2],
    /// Ranges along the rays at which the way back begins (m).
    pub ranges_m: Vec<f64>,
    /// Projection law of the rays.
    pub projection: ProjectionWord,
}

/// A projection law, from elevation to the view-plane.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub enum ProjectionWord {
    /// `Y = D tan(theta - eta)`.
    AsReported,
    /// `Y = (D / cos beta) tan(-eta)`.
    Corrected,
    /// Perspective, as `exact` draws it.
    Exact,
}

/// Pixels that went out, and where they came back (columns and lines).
#[derive(Debug, Clone, Default)]
pub struct Trips {
    pub out: Vec<[f64; 2]>,
    pub back: Vec<[f64; 2]>,
}

/// Ways out and back of a scene at most.
const MOST_TRIPS: f64 = 1e7;

impl ViewScene {
    pub(super) fn checked(&self) -> Result<(), String> {
        self.field_deg.iter().try_for_each(|&field| within("field_deg", field, 0.01, 160.0))?;
        let lists = [&self.pitches_deg, &self.headings_deg, &self.yokes_deg, &self.ranges_m];
        let trips = lists.iter().map(|list| list.len() as f64).product::<f64>();
        let trips = trips * f64::from(self.raster[0]) * f64::from(self.raster[1]);
        within("pitches x headings x yokes x ranges x raster", trips, 1.0, MOST_TRIPS)
    }

    pub(super) fn run(&self) -> Trips {
        let mut trips = Trips::default();
        for &pitch in &self.pitches_deg {
            for &heading in &self.headings_deg {
                for &yoke in &self.yokes_deg {
                    let attitude = Attitude {
                        roll: 0.0,
                        pitch: radians(pitch),
                        heading: radians(heading.rem_euclid(360.0)),
                    };
                    self.add(&View::new(self.law(), &attitude).with_yoke(radians(yoke)), &mut trips);
                }
            }
        }
        trips
    }

    fn law(&self) -> Projection {
        match self.projection {
            ProjectionWord::AsReported => Projection::AsReported,
            ProjectionWord::Corrected => Projection::Corrected,
            ProjectionWord::Exact => Projection::Exact,
        }
    }

    fn add(&self, view: &View, trips: &mut Trips) {
        let half = self.field_deg.map(|field| libm::tan(0.5 * radians(field)));
        let [columns, lines] = self.raster;
        let middle = |count: u32| 0.5 * f64::from(count);
        let sizes = [middle(columns), middle(lines)];
        for pixel in (0..lines).flat_map(|line| (0..columns).map(move |column| [column, line])) {
            let out = pixel.map(|index| f64::from(index) + 0.5);
            let on_screen: [f64; 2] = std::array::from_fn(|k| half[k] * (out[k] / sizes[k] - 1.0));
            let ray = view.ray(on_screen[0], on_screen[1]);
            for &range in &self.ranges_m {
                let [north, east] = ray.direction;
                let point = DVec3::new(north, east, ray.rise) * range;
                let found = view.project(point, 1e-6);
                let back = found.map(|back| std::array::from_fn(|k| sizes[k] * (1.0 + back[k] / half[k])));
                trips.out.push(out);
                trips.back.push(back.unwrap_or([f64::NAN; 2]));
            }
        }
    }
}
