//! Craters with a wall that decays, of straight and of oblique impacts.
//!
//! With `q` the distance in radii, `D` depth, `W` wall, `E` extent, `k` decay constant:
//!
//! ```text
//!  q <= 1               -D + (D + W) q^2
//!  1 < q < E, exp        W (exp(-k (q - 1)) - e) / (1 - e),   e = exp(-k (E - 1))
//!  1 < q < E, linear     W (E - q) / (E - 1)
//!  q >= E                0
//! ```
//!
//! The document gives attributes and the two decays; the profile is our choice where it is silent. Taking `e` away makes the
//! exponential reach 0 at E.

mod nearest;

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use quantities::{degrees, sin_cos};

use crate::refused::{Refused, expect};

pub use nearest::{Nearest, NoNearest};

/// Extent of a crater in radii unless the file says otherwise (chosen).
pub const USUAL_EXTENT: f64 = 2.5;
/// Constant of the exponential decay unless the file says otherwise (chosen).
pub const USUAL_CONSTANT: f64 = 4.0;
/// Impact elevation from which a crater is as wide as it is long (rad; chosen).
const ROUND_FROM: f64 = 15.0 * PI / 180.0;
/// Length over width of a crater of a grazing impact (chosen).
const LONGEST: f64 = 2.0;
/// Share by which the rim is higher downrange of a grazing impact (chosen).
const LOPSIDED: f64 = 0.5;

/// How the wall goes down to the ground around.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Decay {
    /// By an exponential of this constant, shifted so that it reaches 0.
    Exponential(f64),
    /// Along a straight line to the extent.
    Linear,
}

/// Attributes of a crater, as a file gives them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CraterForm {
    /// Centre: north, east (m).
    pub centre: [f64; 2],
    /// Radius from the centre to the crest of the wall (m).
    pub radius: f64,
    /// Height of the wall as a share of the radius, 0 to 1.
    pub wall: f64,
    /// Depth below the surface around as a share of the radius, 0 to 1.
    pub depth: f64,
    /// How the wall goes down outwards.
    pub decay: Decay,
    /// Radius beyond which there is nothing of it, in radii; above 1.
    pub extent: f64,
    /// Elevation of the path of the impact above the horizon (rad): a quarter turn is straight down.
    pub impact_elevation: f64,
    /// Azimuth of travel of the impact, from north towards east (rad).
    pub impact_direction: f64,
}

/// A crater that is in order. Its height is a closed form of the place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Crater {
    form: CraterForm,
    /// Height of the wall and depth (m).
    wall: f64,
    depth: f64,
    /// The exponential at the extent; not used by the linear decay.
    end: f64,
    /// North and east of the unit vector of travel, length over width, `0.5 cos^2` of the elevation. None: straight down.
    oblique: Option<Oblique>,
}

#[derive(Debug, Clone, Copy, PartialEq)]
struct Oblique {
    travel: [f64; 2],
    elongation: f64,
    lopsided: f64,
}

impl Crater {
    /// The crater of these attributes.
    ///
    /// # Errors
    /// If the radius is not 0.001 m to 1e7 m, wall or depth not 0 to 100 % of it, the extent not above 1, the constant not above
    /// 0, or the impact elevation not 0 to 90 degrees.
    pub fn new(form: CraterForm) -> Result<Self, Refused> {
        check(&form)?;
        let end = match form.decay {
            Decay::Exponential(constant) => libm::exp(-constant * (form.extent - 1.0)),
            Decay::Linear => 0.0,
        };
        let oblique = (form.impact_elevation < FRAC_PI_2).then(|| Oblique::new(&form));
        Ok(Self { form, wall: form.wall * form.radius, depth: form.depth * form.radius, end, oblique })
    }

    /// Attributes that the crater was made of.
    pub fn form(&self) -> &CraterForm {
        &self.form
    }

    /// Radius of the circle outside which there is nothing of it (m).
    pub fn reach(&self) -> f64 {
        self.form.radius * self.form.extent * self.elongation()
    }

    /// Length over width, 1 to 2: above 1 for impacts below 15 degrees of elevation.
    pub fn elongation(&self) -> f64 {
        self.oblique.map_or(1.0, |oblique| oblique.elongation)
    }

    /// Height that the crater adds (m) at a place: north, east (m).
    pub fn height(&self, [north, east]: [f64; 2]) -> f64 {
        let [north, east] = [north - self.form.centre[0], east - self.form.centre[1]];
        let (distance, share) = match &self.oblique {
            None => ((north * north + east * east).sqrt(), 1.0),
            Some(oblique) => oblique.seen([north, east]),
        };
        self.profile(distance / self.form.radius, share * self.wall)
    }

    /// Distance from the centre (m) as the profile takes it: along the travel it counts less for an oblique impact.
    pub fn profile_distance(&self, [north, east]: [f64; 2]) -> f64 {
        let place = [north - self.form.centre[0], east - self.form.centre[1]];
        let straight = (place[0] * place[0] + place[1] * place[1]).sqrt();
        self.oblique.map_or(straight, |oblique| oblique.seen(place).0)
    }

    /// Height (m) at `q` radii where the wall is `wall` (m) high.
    fn profile(&self, q: f64, wall: f64) -> f64 {
        let extent = self.form.extent;
        if q <= 1.0 {
            return -self.depth + (self.depth + wall) * q * q;
        }
        if q >= extent {
            return 0.0;
        }
        match self.form.decay {
            Decay::Exponential(constant) => {
                wall * (libm::exp(-constant * (q - 1.0)) - self.end) / (1.0 - self.end)
            }
            Decay::Linear => wall * (extent - q) / (extent - 1.0),
        }
    }
}

impl Oblique {
    fn new(form: &CraterForm) -> Self {
        let (sin, cos) = sin_cos(form.impact_direction);
        let low = (1.0 - form.impact_elevation / ROUND_FROM).max(0.0);
        let (_, level) = sin_cos(form.impact_elevation);
        Self {
            travel: [cos, sin],
            elongation: 1.0 + (LONGEST - 1.0) * low,
            lopsided: LOPSIDED * level * level,
        }
    }

    /// Distance (m) of a place from the centre as the profile takes it, and height of the wall there as a share of its mean.
    fn seen(&self, [north, east]: [f64; 2]) -> (f64, f64) {
        let along = north * self.travel[0] + east * self.travel[1];
        let across = east * self.travel[0] - north * self.travel[1];
        let shortened = along / self.elongation;
        let distance = (shortened * shortened + across * across).sqrt();
        let straight = (along * along + across * across).sqrt();
        let cos = if straight > 0.0 { along / straight } else { 0.0 };
        (distance, 1.0 + self.lopsided * cos)
    }
}

fn check(form: &CraterForm) -> Result<(), Refused> {
    let is_length = (1e-3..=1e7).contains(&form.radius);
    expect(is_length, "radius_m", form.radius, "a length from 0.001 m to 1e7 m")?;
    for (key, share) in [("wall_percent", form.wall), ("depth_percent", form.depth)] {
        expect((0.0..=1.0).contains(&share), key, 100.0 * share, "0 to 100 % of the radius")?;
    }
    let reaches = form.extent > 1.0 && form.extent <= 100.0;
    expect(reaches, "extent", form.extent, "a number of radii above 1 and up to 100")?;
    if let Decay::Exponential(constant) = form.decay {
        let decays = constant > 0.0 && constant <= 1e3;
        expect(decays, "decay_constant", constant, "a number above 0 and up to 1000")?;
    }
    let (elevation, direction) = (form.impact_elevation, form.impact_direction);
    let is_elevation = (0.0..=FRAC_PI_2).contains(&elevation);
    expect(is_elevation, "impact_elevation_deg", degrees(elevation), "0 to 90 degrees")?;
    let is_azimuth = direction.abs() <= TAU;
    expect(is_azimuth, "impact_direction_deg", degrees(direction), "-360 to 360 degrees")?;
    let is_place = form.centre.iter().all(|place| place.abs() <= 1e9);
    expect(is_place, "longitude_deg", format!("{:?} m away", form.centre), "a place near the range")
}
