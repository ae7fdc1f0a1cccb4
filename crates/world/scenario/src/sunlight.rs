//! Where the light of a mission comes from: angles, the true sun of a date, or the place that has the sun overhead.

use ephemeris::{Instant, Place, Sky, elevation_and_azimuth, icrf_to_local, sun_direction};
use glam::DMat3;
use landscape::{Bank, Georeference, LUNOID_RADIUS, Sun};
use limits::Limit;
use quantities::{degrees, wrap_heading};

use crate::turns::about_z;
use crate::{Drift, SceneryProblem};

/// Where the light of a mission comes from.
#[derive(Debug, Clone, PartialEq)]
pub enum Sunlight {
    /// Angles in the axes of the ground.
    Angles {
        /// The sun at the start.
        first: Sun,
        /// Where it goes from there.
        drift: Option<Drift>,
    },
    /// The true sun of a date.
    Dated(SunDate),
    /// A sun that stands overhead at a place, and stays there.
    SubSolar(SubSolarPoint),
}

/// A date that says where the sun stands.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SunDate {
    /// Date and time of the start of the mission.
    pub at: Instant,
    /// Place on the Moon; that of the bank if the scenario names none.
    pub place: Option<Place>,
    /// Time from one sun to the next (s).
    pub step: f64,
}

/// A place of the Moon that has the sun overhead.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SubSolarPoint {
    /// Its latitude and longitude (rad).
    pub point: [f64; 2],
    /// Place on the Moon that is lit; that of the bank if the scenario names none.
    pub place: Option<Place>,
}

/// What stood over the ground at the start of a mission with a date.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DatedSky {
    /// Date and time of the start.
    pub at: Instant,
    /// Place on the Moon that the sky is of.
    pub place: Place,
    /// Direction of true north, clockwise from the north of the ground (rad).
    pub true_north: f64,
    /// Sun and Earth; azimuths from true north.
    pub sky: Sky,
}

impl DatedSky {
    /// Sky over the ground of `bank`, or over `place` if one is given.
    ///
    /// # Errors
    /// If there is no place, or the bank knows its place but not where north is there.
    pub fn over(bank: &Bank, at: Instant, place: Option<Place>) -> Result<Self, SceneryProblem> {
        let (place, true_north) = place_and_north(bank, place, "at")?;
        Ok(Self { at, place, true_north, sky: Sky::over(place, at) })
    }

    /// The sun in the axes of the ground.
    pub fn sun(&self) -> Sun {
        Sun { azimuth: self.on_ground(self.sky.sun.azimuth), elevation: self.sky.sun.elevation }
    }

    /// Matrix from the ICRF to north, east, up of the ground.
    pub fn icrf_to_ground(&self) -> DMat3 {
        about_z(self.true_north) * icrf_to_local(self.place, self.at)
    }

    /// An azimuth from true north (rad) as an azimuth from the north of the ground, 0 to 2 pi.
    pub fn on_ground(&self, azimuth: f64) -> f64 {
        wrap_heading(azimuth + self.true_north)
    }
}

/// Where the ground of `bank` lies, or `place` if one is given, and the direction of true north there, clockwise from the north of the
/// ground (rad). `key` of `[sun]` asks.
fn place_and_north(
    bank: &Bank,
    place: Option<Place>,
    key: &'static str,
) -> Result<(Place, f64), SceneryProblem> {
    let own = bank.georeference();
    let place = place.or(own.as_ref().map(place_of)).ok_or(SceneryProblem::SunWithoutPlace { key })?;
    let true_north = match own {
        Some(own) => own.true_north.ok_or(SceneryProblem::SunWithoutNorth { key })?,
        // Axes of a bank: x is north.
        None => 0.0,
    };
    Ok((place, true_north))
}

/// The place of a bank as the ephemeris wants it: on the sphere that heights refer to.
fn place_of(own: &Georeference) -> Place {
    Place { longitude: own.longitude, latitude: own.latitude, radius: LUNOID_RADIUS }
}

/// Each sun of a mission with the time (s) from which on it holds; never empty.
type Suns = Vec<(f64, Sun)>;

impl Sunlight {
    /// The sun at the start, where the scenario gives its angles.
    pub fn first(&self) -> Option<Sun> {
        match self {
            Self::Angles { first, .. } => Some(*first),
            Self::Dated(_) | Self::SubSolar(_) => None,
        }
    }

    /// Whether the sun moves.
    pub fn moves(&self) -> bool {
        match self {
            Self::Angles { drift, .. } => drift.is_some(),
            Self::Dated(_) => true,
            Self::SubSolar(_) => false,
        }
    }

    /// Every sun of a mission of `length` (s) over the ground of `bank`, and the sky of its start where it has a date.
    ///
    /// # Errors
    /// If the date comes to no sun above the horizon, to too many steps, or beyond the years that are measured.
    pub(crate) fn suns(&self, bank: &Bank, length: f64) -> Result<(Suns, Option<DatedSky>), SceneryProblem> {
        match self {
            Self::Angles { first, drift: None } => Ok((vec![(0.0, *first)], None)),
            Self::Angles { first, drift: Some(drift) } => Ok((drift.suns(*first), None)),
            Self::Dated(date) => date.suns(bank, length).map(|(suns, sky)| (suns, Some(sky))),
            Self::SubSolar(point) => Ok((vec![(0.0, point.sun(bank)?)], None)),
        }
    }
}

impl SubSolarPoint {
    /// The sun in the axes of the ground of `bank`.
    ///
    /// # Errors
    /// If there is no place, the bank knows its place but not where north is there, or the sun is down.
    pub fn sun(&self, bank: &Bank) -> Result<Sun, SceneryProblem> {
        let (place, true_north) = place_and_north(bank, self.place, "sub_solar_deg")?;
        let of = [place.latitude, place.longitude];
        let [elevation, azimuth] = elevation_and_azimuth(sun_direction(of, self.point));
        if elevation > 0.0 {
            return Ok(Sun { azimuth: wrap_heading(azimuth + true_north), elevation });
        }
        Err(SceneryProblem::SunOverTheEdge {
            sub_solar_deg: self.point.map(degrees),
            place_deg: of.map(degrees),
            elevation_deg: degrees(elevation),
        })
    }
}

impl SunDate {
    fn suns(&self, bank: &Bank, length: f64) -> Result<(Suns, DatedSky), SceneryProblem> {
        let start = DatedSky::over(bank, self.at, self.place)?;
        // A step that begins with the end of the mission lights nothing.
        let steps = (length / self.step - 1e-9).ceil().max(1.0);
        if steps > Limit::SunSteps.value() as f64 {
            return Err(SceneryProblem::TooManySuns { found: steps, step: self.step });
        }
        let sun = |step: u64| {
            let time = step as f64 * self.step;
            let at = self.at.later(time);
            if !at.is_measured() {
                return Err(SceneryProblem::SunUnmeasured { at, time });
            }
            let sky = DatedSky { at, sky: Sky::over(start.place, at), ..start };
            match sky.sun() {
                sun if sun.elevation > 0.0 => Ok((time, sun)),
                sun => Err(SceneryProblem::SunDown { at, time, elevation_deg: degrees(sun.elevation) }),
            }
        };
        let suns = (0..steps as u64).map(sun).collect::<Result<Suns, _>>()?;
        Ok((suns, start))
    }
}
