//! Values of the options of `lunoid sight`.

use clap::{Args, ValueEnum};
use sight::{Curvature, Height, Point};

use command_line::{Failure, values};

/// Ground that lines of sight are held against.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Surface {
    /// The closed form of a scenario or bank.
    Landscape,
    /// Triangles between every 2^level-th post.
    Mesh(u32),
    /// Triangles as a generator with levels of detail draws them in a frame.
    Shown,
}

/// Reads `landscape`, `mesh`, `level:N` or `shown`.
pub fn surface(text: &str) -> Result<Surface, String> {
    let level = |word: &str| word.parse().ok().filter(|level| *level <= 20).map(Surface::Mesh);
    let found = match text {
        "landscape" => Some(Surface::Landscape),
        "mesh" => Some(Surface::Mesh(0)),
        "shown" => Some(Surface::Shown),
        other => other.strip_prefix("level:").and_then(level),
    };
    found.ok_or_else(|| "expected landscape, mesh, shown, or level:N with N from 0 to 20".into())
}

/// Reads metres above the ground, or `datum:` and metres above the datum.
pub fn height(text: &str) -> Result<Height, String> {
    let expected =
        || "expected metres above the ground from 0 to 1e7, or datum:METRES from -1e7 to 1e7".into();
    let (number, is_datum) = match text.strip_prefix("datum:") {
        Some(number) => (number, true),
        None => (text, false),
    };
    let number = values::finite(number).map_err(|_| expected())?;
    match (is_datum, number) {
        (true, -1e7..=1e7) => Ok(Height::AboveDatum(number)),
        (false, 0.0..=1e7) => Ok(Height::AboveGround(number)),
        _ => Err(expected()),
    }
}

/// Answer for each place of an area.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Layer {
    /// Whether a target is seen: 1 visible, 0 hidden, 255 unknown.
    Seen,
    /// Least height above the ground at which a target is seen (metres).
    LeastHeight,
}

/// The law of curvature.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Law {
    /// The ground does not bend.
    Flat,
    /// The datum falls by s^2 / 2R.
    Parabola,
    /// The datum falls by R - sqrt(R^2 - s^2).
    Sphere,
}

/// How the datum bends and light with it.
#[derive(Debug, Args)]
pub struct Bending {
    /// Curvature of the datum along the line.
    #[arg(long, value_enum, default_value = "sphere")]
    pub curvature: Law,
    /// Radius of the body. If left out, the map of the ground names it, or it is the Moon.
    #[arg(long, value_name = "METRES", value_parser = values::positive)]
    radius_m: Option<f64>,
    /// Refraction coefficient of an atmosphere, from 0 to below 1.
    #[arg(long, value_name = "K", default_value_t = 0.0, value_parser = values::not_negative)]
    pub refraction: f64,
}

impl Bending {
    /// Radius of the body (m).
    pub fn radius(&self, of_map: f64) -> f64 {
        self.radius_m.unwrap_or(of_map)
    }

    /// The curvature over a body whose map has a radius (m).
    pub fn curvature(&self, of_map: f64) -> Result<Curvature, Failure> {
        let (radius, refraction) = (self.radius(of_map), self.refraction);
        let found = match self.curvature {
            Law::Flat => Ok(Curvature::FLAT),
            Law::Parabola => Curvature::parabolic(radius, refraction),
            Law::Sphere => Curvature::spherical(radius, refraction),
        };
        found.map_err(|error| Failure::usage(format!("--curvature: {error}")))
    }

    /// The law in words.
    pub fn told(&self, of_map: f64) -> String {
        let law = match self.curvature {
            Law::Flat => return "flat datum".into(),
            Law::Parabola => "parabola",
            Law::Sphere => "sphere",
        };
        format!("{law} of {} m, refraction {}", self.radius(of_map), self.refraction)
    }
}

/// A point at a place (north, east, m).
pub fn point(place: [f64; 2], height: Height) -> Point {
    Point { place, height }
}

#[cfg(test)]
mod tests {
    use sight::Height;

    use super::{Surface, height, surface};

    #[test]
    fn heights_above_ground_and_datum() {
        assert_eq!(height("2.5"), Ok(Height::AboveGround(2.5)));
        assert_eq!(height("datum:-30"), Ok(Height::AboveDatum(-30.0)));
        for wrong in ["-1", "datum:", "2e7", "datum:1e300", "nan", "ground:3"] {
            assert!(height(wrong).is_err(), "{wrong}");
        }
    }

    #[test]
    fn surfaces_by_name() {
        assert_eq!((surface("landscape"), surface("shown")), (Ok(Surface::Landscape), Ok(Surface::Shown)));
        assert_eq!((surface("mesh"), surface("level:3")), (Ok(Surface::Mesh(0)), Ok(Surface::Mesh(3))));
        for wrong in ["level", "level:", "level:21", "level:-1", "morphed"] {
            assert!(surface(wrong).is_err(), "{wrong}");
        }
    }
}
