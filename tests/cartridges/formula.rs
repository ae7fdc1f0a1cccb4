//! Closed forms, by name.

use landscape::LUNOID_RADIUS;
use quantities::{radians, sin_cos};
use serde::Deserialize;

use crate::ground::Ground;
use crate::schema::Variant;

/// A quantity at every place of a sweep.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Along {
    /// Height of a plane (m).
    PlaneHeight,
    /// Its slope to the north.
    PlaneSlopeNorth,
    /// Its slope to the east.
    PlaneSlopeEast,
    /// `g_ip(u) g_jq(v)` times the one word that is not 0; 0 in regions that do not touch its corner (m).
    OneWordHeight,
    /// Tangent of the elevation of flat ground on the lunoid: `-(H + z^2 / 2R) / z`.
    LunoidTangent,
}

/// Line of the horizon in a column.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Horizon {
    /// Edge of a plane that ends at the range programme's end.
    Plane,
    /// `tan eta = -sqrt(2 H / R)` at every azimuth, at level pitch.
    Lunoid,
}

impl Along {
    /// Value at ground range `range` (m), which lies at `place` north and east (m).
    pub fn at(self, of: &Variant, range: f64, place: [f64; 2]) -> f64 {
        match self {
            Self::PlaneHeight => {
                let ([north, east], height) = (plane_slopes(of), plane_height(of));
                height + north * place[0] + east * place[1]
            }
            Self::PlaneSlopeNorth => plane_slopes(of)[0],
            Self::PlaneSlopeEast => plane_slopes(of)[1],
            Self::OneWordHeight => one_word(of, place),
            Self::LunoidTangent => {
                -(of.file.eye_m[2] - plane_height(of) + range * range / (2.0 * LUNOID_RADIUS)) / range
            }
        }
    }
}

/// Lambert's factor of a plane times albedo: `albedo (sin e - cos e (hx cos a + hy sin a)) / sqrt(1 + hx^2 + hy^2)`.
pub fn lambert(of: &Variant) -> f64 {
    let ((sin_e, cos_e), (sin_a, cos_a)) =
        (sin_cos(radians(of.file.sun_elevation_deg)), sin_cos(radians(of.file.sun_azimuth_deg)));
    let [hx, hy] = plane_slopes(of);
    of.file.albedo * (sin_e - cos_e * (hx * cos_a + hy * sin_a)) / (1.0 + hx * hx + hy * hy).sqrt()
}

impl Horizon {
    /// Y over the distance of the view-plane, positive down, at the same of X.
    pub fn at(self, of: &Variant, x: f64) -> f64 {
        match self {
            Self::Plane => plane_edge(of, x),
            Self::Lunoid => {
                let height = of.file.eye_m[2] - plane_height(of);
                (2.0 * height / LUNOID_RADIUS).sqrt() * (1.0 + x * x).sqrt()
            }
        }
    }
}

/// The ray `(1, x, y)` turned up by the pitch goes `F = cos th + y sin th` forward, x to the right and
/// `sin th - y cos th` up. It meets the edge of the ground, seen `H` lower at range `end`, where
/// `up = hf F + hs x - H / end sqrt(F^2 + x^2)`. The last term is small: four rounds of inserting y are enough.
fn plane_edge(of: &Variant, x: f64) -> f64 {
    let [north, east] = plane_slopes(of);
    let (sin_h, cos_h) = sin_cos(radians(of.heading_deg));
    let (forward, starboard) = (north * cos_h + east * sin_h, east * cos_h - north * sin_h);
    let (sin, cos) = sin_cos(radians(of.file.pitch_deg));
    let [eye_north, eye_east, eye] = of.file.eye_m;
    let drop = (eye - plane_height(of) - north * eye_north - east * eye_east) / of.scene().range.end;
    let mut y = 0.0;
    for _ in 0..4 {
        let ahead = cos + y * sin;
        let length = (ahead * ahead + x * x).sqrt();
        y = (sin - forward * cos - starboard * x + drop * length) / (cos + forward * sin);
    }
    y
}

fn plane_slopes(of: &Variant) -> [f64; 2] {
    match of.ground {
        Ground::Plane { slope_north, slope_east, .. } => [slope_north, slope_east],
        _ => panic!("the formula is of a plane, the ground is {:?}", of.ground),
    }
}

fn plane_height(of: &Variant) -> f64 {
    match of.ground {
        Ground::Plane { height_m, .. } => height_m,
        _ => panic!("the formula is of a plane, the ground is {:?}", of.ground),
    }
}

fn one_word(of: &Variant, place: [f64; 2]) -> f64 {
    let Ground::OneWord { corners, words, value_m } = &of.ground else {
        panic!("the formula is of one word, the ground is {:?}", of.ground)
    };
    let (corner, orders) = (corners[0], [words[0] / 3, words[0] % 3]);
    let weight = |axis: usize| {
        let from_corner = place[axis] / of.file.region_size_m - corner[axis] as f64;
        hermite(orders[axis], from_corner)
    };
    value_m * weight(0) * weight(1)
}

/// The quintic that has derivative 1 of one order at 0 and none else at 0, 1 and -1: `g_0p` on the far side of the
/// corner, `g_1p` on the near side, `(-1)^p g_0p(-t)`.
fn hermite(order: usize, t: f64) -> f64 {
    let z = t.abs();
    if z >= 1.0 {
        return 0.0;
    }
    let w = 1.0 - z;
    let near =
        [w * w * w * (1.0 + 3.0 * z + 6.0 * z * z), z * w * w * w * (1.0 + 3.0 * z), 0.5 * z * z * w * w * w];
    if t < 0.0 && order == 1 { -near[order] } else { near[order] }
}
