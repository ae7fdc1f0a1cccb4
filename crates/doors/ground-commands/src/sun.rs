//! `lunoid sun`: where Sun and Earth stand over a place on the Moon.

use std::path::PathBuf;

use clap::Args;
use ephemeris::{Instant, MOON_RADIUS, Place, Sky};
use landscape::bank_file;
use limits::Limit;
use quantities::radians;
use run_record::{PlaceRecord, SkyRecord};
use scenario::{DatedSky, SceneryProblem};
use serde_json::json;
use text::{latitude, longitude, shortened, table};

use command_line::output::{print, print_json};
use command_line::{Failure, Verdict, values};

const AFTER: &str = "Example:
  lunoid sun --place 30.77,20.19 --at 1972-12-11T22:00:00Z
  lunoid sun moon.bank --at 2009-10-28T00:00:00Z --until 2009-10-29T00:00:00Z --step 3600

docs/sun.md says what the numbers mean, and how large their errors are.";

/// Say where Sun and Earth stand over a place on the Moon.
#[derive(Debug, Args)]
#[command(after_help = AFTER)]
pub struct SunCommand {
    /// Bank of surveyed ground: its place, and the direction of true north in its axes.
    #[arg(required_unless_present = "place")]
    bank: Option<PathBuf>,
    /// Date and time, ISO 8601: 1960 to 2050, with Z or an offset from UTC.
    #[arg(long, value_name = "DATE")]
    at: Instant,
    /// Longitude (positive east) and latitude in degrees, instead of the bank's place.
    #[arg(long, value_name = "LON,LAT", value_parser = place)]
    place: Option<[f64; 2]>,
    /// Last date and time of a table.
    #[arg(long, value_name = "DATE", requires = "step")]
    until: Option<Instant>,
    /// Time from row to row of the table.
    #[arg(long, value_name = "SECONDS", value_parser = values::positive, requires = "until")]
    step: Option<f64>,
    /// Print the result as JSON.
    #[arg(long)]
    json: bool,
}

fn place(text: &str) -> Result<[f64; 2], String> {
    let is_there = |&[longitude, latitude]: &[f64; 2]| longitude.abs() <= 360.0 && latitude.abs() <= 90.0;
    let expected = "expected longitude (-360 to 360) and latitude (-90 to 90) in degrees, as 30.77,20.19";
    values::pair(text).ok().filter(is_there).ok_or_else(|| expected.into())
}

impl SunCommand {
    /// Prints Sun and Earth at one date, or a table of them.
    pub fn run(&self) -> Result<Verdict, Failure> {
        let first = self.first()?;
        let rows = self.rows()?;
        let over = |row: u64| {
            let at = self.at.later(row as f64 * self.step.unwrap_or(0.0));
            SkyRecord::from(&DatedSky { at, sky: Sky::over(first.place, at), ..first })
        };
        let skies: Vec<SkyRecord> = (0..rows).map(over).collect();
        if self.json {
            print_json(&json!({ "schema": "lunoid.sun/1", "skies": skies }))?;
        } else if self.until.is_some() {
            print(&told(&skies))?;
        } else {
            print(&skies.iter().map(one).collect::<String>())?;
        }
        Ok(Verdict::Yes)
    }

    /// The sky of the first row; the others are over the same place.
    fn first(&self) -> Result<DatedSky, Failure> {
        let place = self.place.map(|[longitude, latitude]| Place {
            longitude: radians(longitude),
            latitude: radians(latitude),
            radius: MOON_RADIUS,
        });
        match (&self.bank, place) {
            (Some(path), place) => {
                let bank = bank_file::read(path)?;
                let said = |error| Failure::input(format!("{}: {}", path.display(), without_sky(&error)));
                DatedSky::over(&bank, self.at, place).map_err(said)
            }
            (None, Some(place)) => {
                Ok(DatedSky { at: self.at, place, true_north: 0.0, sky: Sky::over(place, self.at) })
            }
            (None, None) => Err(Failure::usage("a bank, or --place LON,LAT, says where on the Moon")),
        }
    }

    fn rows(&self) -> Result<u64, Failure> {
        let (Some(until), Some(step)) = (self.until, self.step) else { return Ok(1) };
        let span = until.since(self.at);
        if span < 0.0 {
            let at = self.at;
            return Err(Failure::usage(format!("--until {until}: expected {at} or later, the date of --at")));
        }
        let rows = (span / step + 1e-9).floor() + 1.0;
        let most = Limit::SunSteps.value();
        if rows > most as f64 {
            let advice = Limit::SunSteps;
            return Err(Failure::usage(format!(
                "{rows:.0} rows, expected at most {most}: raise --step; {advice}"
            )));
        }
        Ok(rows as u64)
    }
}

/// Why a bank has no sky, and what to do about it on this command line.
fn without_sky(problem: &SceneryProblem) -> String {
    match problem {
        SceneryProblem::SunWithoutPlace { .. } => {
            "the bank knows no place on the Moon (imported words, a file without a \
             projection, or ground of another body), expected one; give --place LON,LAT"
                .into()
        }
        SceneryProblem::SunWithoutNorth { .. } => {
            "the bank was made without the direction of true north, expected one; make \
             it again with `lunoid survey`, or give --place LON,LAT without the bank"
                .into()
        }
        other => other.to_string(),
    }
}

/// A sky in a few lines.
fn one(sky: &SkyRecord) -> String {
    let SkyRecord { at, sun, earth, earth_phase, .. } = sky;
    let north = match sky.true_north_deg {
        0.0 => String::new(),
        turn => format!("  true north: {} deg clockwise from the x axis of the bank\n", shortened(turn, 3)),
    };
    format!(
        "{at} at {}\n\
         \x20 sun    azimuth {:.3}, elevation {:.3} deg; {:.3} million km away, {:.4} deg across\n\
         \x20 earth  azimuth {:.3}, elevation {:.3} deg; {:.0} km away, {:.3} deg across; {:.0} % lit, {}\n\
         \x20 overhead: the sun at {}, the earth at {}\n\
         {north}\
         \x20 in a scenario: azimuth_deg = {:.4}, elevation_deg = {:.4}\n",
        where_on_moon(&sky.place),
        sun.true_azimuth_deg,
        sun.elevation_deg,
        1e-9 * sun.distance_m,
        sun.angular_diameter_deg,
        earth.true_azimuth_deg,
        earth.elevation_deg,
        1e-3 * earth.distance_m,
        earth.angular_diameter_deg,
        100.0 * earth_phase.lit,
        if earth_phase.waxes { "waxing" } else { "waning" },
        where_on_moon(&sky.sub_solar),
        where_on_moon(&sky.sub_earth),
        sun.azimuth_deg,
        sun.elevation_deg,
    )
}

fn where_on_moon(place: &PlaceRecord) -> String {
    format!("{}, {}", latitude(place.latitude_deg, 3), longitude(place.longitude_deg, 3))
}

/// Skies over one place as a table; angles in degrees, azimuths from true north and, for the sun, from the x axis too.
fn told(skies: &[SkyRecord]) -> String {
    let heading = ["UTC", "sun azimuth", "elevation", "in a scenario", "earth azimuth", "elevation", "lit"];
    let row = |sky: &SkyRecord| {
        let [sun, earth] = [&sky.sun, &sky.earth];
        let angles = [
            sun.true_azimuth_deg,
            sun.elevation_deg,
            sun.azimuth_deg,
            earth.true_azimuth_deg,
            earth.elevation_deg,
        ];
        let angles = angles.map(|angle| format!("{angle:.3}"));
        let lit = format!("{:.0} %", 100.0 * sky.earth_phase.lit);
        [sky.at.clone()].into_iter().chain(angles).chain([lit]).collect()
    };
    let heading = heading.map(str::to_owned).to_vec();
    table(&[heading].into_iter().chain(skies.iter().map(row)).collect::<Vec<_>>())
}
