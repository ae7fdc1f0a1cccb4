//! The vehicle at a place to which nobody has driven it.

use landscape::{Attitude, Landscape};
use quantities::{degrees, radians};
use scenario::{Driven, DrivenError, Pose, PoseFault};

use crate::{Drive, DriveError, EyePose};

/// Where the vehicle is to be.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Place {
    /// North and east of the origin (m).
    pub at_m: [f64; 2],
    /// Clockwise from north (degrees).
    pub heading_deg: f64,
    /// How it flies there; on its wheels if left out.
    pub flight: Option<Flight>,
}

/// Height and attitude of a vehicle that flies.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Flight {
    /// Eye above the tangent plane (m).
    pub z_m: f64,
    /// Pitch, nose up (degrees).
    pub pitch_deg: f64,
    /// Roll, starboard down (degrees).
    pub roll_deg: f64,
}

/// Why the vehicle cannot be at a place.
#[derive(Debug, Clone, PartialEq)]
pub enum Unplaced {
    /// The law of the path refuses the pose.
    Pose(PoseFault),
    /// The ground under the wheels is steeper than the vehicle climbs.
    Steep {
        /// Slope of the ground (degrees).
        found_deg: f64,
        /// Steepest slope that the vehicle climbs (degrees).
        most_deg: f64,
    },
    /// A number is none, or beyond what a path may state.
    Number(DriveError),
}

impl Drive {
    /// Puts the vehicle at `place` in frame `frame`, with the yoke settled at its roll, as in the first frame of a path.
    ///
    /// # Errors
    /// If the vehicle cannot be there.
    pub fn place(&self, frame: u64, place: &Place) -> Result<EyePose, Unplaced> {
        let (scenario, view) = (&self.opened.scenario, &self.bench.stage.view);
        let landscape = &self.bench.stage.landscape;
        let mut driven = Driven::new(scenario, view.update, view.yoke);
        let (at, heading) = (place.at_m, radians(place.heading_deg));
        let pose = match place.flight {
            Some(flight) => flown(at, heading, &flight),
            None => self.stood(&driven, landscape, at, heading)?,
        };
        let told = EyePose::of(&pose, None).checked(self.file()).map_err(Unplaced::Number)?;
        let picture = driven.push(landscape, told.eye_m, told.attitude());
        let picture = picture.map_err(|error| self.unplaced(&error))?;
        let time = frame as f64 / view.update.hertz();
        Ok(EyePose { yoke_deg: degrees(picture.yoke), time_s: time, ..told })
    }

    fn stood(
        &self,
        driven: &Driven,
        landscape: &Landscape,
        at: [f64; 2],
        heading: f64,
    ) -> Result<Pose, Unplaced> {
        let pose = driven.stand(landscape, at, heading, None).map_err(|error| self.unplaced(&error))?;
        let vehicle = &self.opened.scenario.vehicle;
        let steepness = vehicle.stand(landscape, at, heading).map_or(0.0, |stand| stand.steepness());
        match steepness <= vehicle.max_slope {
            true => Ok(pose),
            false => {
                Err(Unplaced::Steep { found_deg: degrees(steepness), most_deg: degrees(vehicle.max_slope) })
            }
        }
    }

    fn unplaced(&self, error: &DrivenError) -> Unplaced {
        let fault = match error {
            DrivenError::Problems(problems) => problems.iter().next().map(|problem| problem.fault.clone()),
            DrivenError::Waypoint(_) => None,
        };
        fault.map_or_else(|| Unplaced::Number(DriveError::of(self.file(), error)), Unplaced::Pose)
    }
}

fn flown([x, y]: [f64; 2], heading: f64, flight: &Flight) -> Pose {
    let [pitch, roll] = [flight.pitch_deg, flight.roll_deg].map(radians);
    let attitude = Attitude { heading, pitch, roll };
    Pose { time: 0.0, eye: [x, y, flight.z_m], attitude, yoke: 0.0 }
}
