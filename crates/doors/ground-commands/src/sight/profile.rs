//! A picture of one line over its ground.

use plots::{Drawing, SightProfile, sight_profile};
use sight::{Height, LineOfSight, Point};

use super::SightCommand;
use super::ground::Site;
use super::lines::told;
use command_line::Failure;

/// Steps of the drawn ground.
const STEPS: u32 = 800;

/// Draws the line over the ground, heights above the datum: a straight line sags below its chord where the datum bends.
pub fn picture(
    command: &SightCommand,
    site: &Site,
    (target, line): (&Point, &LineOfSight),
) -> Result<Drawing, Failure> {
    let curvature = command.bending.curvature(site.radius())?;
    let observer = command.observer();
    let [start, end] = [&observer, target].map(|point| above_datum(site, point));
    let drop = curvature.drop(line.distance);
    let place = |step: u32| {
        let share = f64::from(step) / f64::from(STEPS);
        let along = |axis: usize| observer.place[axis] + share * (target.place[axis] - observer.place[axis]);
        let sag = share * drop - curvature.drop(share * line.distance);
        let height = (1.0 - share) * start + share * end - sag;
        let ground = site.height([along(0), along(1)]).unwrap_or(f64::NAN);
        [share * line.distance, ground, height]
    };
    let places: Vec<[f64; 3]> = (0..=STEPS).map(place).collect();
    let facts = [told(line), command.bending.told(site.radius())];
    let blocker = line.blocker.map(|blocker| blocker.distance);
    Ok(sight_profile(&SightProfile { places: &places, blocker, title: &site.title, facts: &facts })?)
}

/// Height (m) above the datum of a point over ground.
fn above_datum(site: &Site, point: &Point) -> f64 {
    match point.height {
        Height::AboveDatum(height) => height,
        Height::AboveGround(height) => height + site.height(point.place).unwrap_or(0.0),
    }
}
