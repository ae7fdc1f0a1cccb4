//! Tracks of the vehicle: patches of remote shadow along the way already driven (section 17).

use landscape::Landscape;
use limits::Limit;

use crate::ride::{Instant, distance, instants};
use crate::{Path, SceneryProblem, TrackPatch, Vehicle};

/// What the wheels leave behind.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tracks {
    /// Along the way (m).
    pub length: f64,
    /// Width of a patch across the way (m).
    pub width: f64,
    /// From the middle of one patch to that of the next (m).
    pub spacing: f64,
}

/// An eye this many times as high above the ground as a standing vehicle's belongs to one that flies.
const FLYING: f64 = 1.5;

impl Tracks {
    /// The patches of both rear wheels, ascending in time: each is laid when the wheel has come to its far end. Path
    /// and vehicle decide them, never the frames that are drawn.
    ///
    /// # Errors
    /// If the path is too long for its patches.
    pub fn lay(
        &self,
        path: &Path,
        vehicle: &Vehicle,
        landscape: &Landscape,
    ) -> Result<Vec<TrackPatch>, SceneryProblem> {
        let points = instants(path, self.spacing)?;
        let drives: Vec<bool> = points.iter().map(|instant| stands(instant, vehicle, landscape)).collect();
        let mut patches = Vec::new();
        for wheel in [2, 3] {
            let place = |instant: &Instant| vehicle.wheels(instant.at, instant.heading)[wheel];
            let mut first = 0;
            for stretch in drives.chunk_by(|a, b| a == b) {
                let end = first + stretch.len();
                if stretch[0] {
                    self.lay_wheel(&points[first..end], place, &mut patches)?;
                }
                first = end;
            }
        }
        // Stable: port before starboard at one time.
        patches.sort_by(|a, b| a.laid.total_cmp(&b.laid));
        Ok(patches)
    }

    fn lay_wheel(
        &self,
        points: &[Instant],
        wheel: impl Fn(&Instant) -> [f64; 2],
        patches: &mut Vec<TrackPatch>,
    ) -> Result<(), SceneryProblem> {
        // Way of the wheel at which the next patch has its far end.
        let (mut way, mut next) = (0.0, self.length);
        for pair in points.windows(2) {
            let [from, to] = [wheel(&pair[0]), wheel(&pair[1])];
            let step = distance(from, to);
            while step > 0.0 && next <= way + step {
                if !Limit::Patches.allows(patches.len() as u64 + 1) {
                    return Err(SceneryProblem::TooManyPatches { spacing: self.spacing });
                }
                let share = (next - way) / step;
                let end = [0, 1].map(|axis| from[axis] + share * (to[axis] - from[axis]));
                let ahead = [0, 1].map(|axis| (to[axis] - from[axis]) / step);
                let laid = pair[0].time + share * (pair[1].time - pair[0].time);
                patches.push(TrackPatch { laid, corners: self.corners(end, ahead) });
                next += self.spacing;
            }
            way += step;
        }
        Ok(())
    }

    /// Clockwise seen from above, from the far port corner on.
    fn corners(&self, end: [f64; 2], ahead: [f64; 2]) -> [[f64; 2]; 4] {
        let half = 0.5 * self.width;
        let corner = |back: f64, starboard: f64| {
            [end[0] - back * ahead[0] - starboard * ahead[1], end[1] - back * ahead[1] + starboard * ahead[0]]
        };
        [corner(0.0, -half), corner(0.0, half), corner(self.length, half), corner(self.length, -half)]
    }
}

/// Whether the vehicle is on the ground; a path that says no height is.
fn stands(instant: &Instant, vehicle: &Vehicle, landscape: &Landscape) -> bool {
    let Some(eye) = instant.eye_height else { return true };
    let ground = landscape.height(instant.at[0], instant.at[1]);
    ground
        .is_some_and(|ground| instant.height_over.above(eye, ground) - ground <= FLYING * vehicle.eye_height)
}

#[cfg(test)]
mod tests {
    use super::Tracks;
    use crate::{Path, Vehicle, Waypoint};
    use landscape::{Bank, Landscape, Level};

    fn flat() -> Landscape {
        let level = Level::new(500.0, [0.0; 2], [2, 2], vec![[0.0; 9]; 4]).unwrap();
        Landscape::new(Bank::new("", vec![level], None).unwrap(), 1.0)
    }

    fn waypoint(time: f64, x: f64, y: f64, eye_height: Option<f64>) -> Waypoint {
        Waypoint { time, at: [x, y], heading: None, eye_height, pitch: None, roll: None }
    }

    const TRACKS: Tracks = Tracks { length: 0.2, width: 0.3, spacing: 0.5 };

    #[test]
    fn a_straight_ride_leaves_two_straight_rows() {
        let vehicle = Vehicle::default();
        let path =
            Path::new(vec![waypoint(1.0, 100.0, 50.0, None), waypoint(11.0, 120.0, 50.0, None)]).unwrap();
        let patches = TRACKS.lay(&path, &vehicle, &flat()).unwrap();
        assert_eq!(patches.len(), 2 * 40);
        for (number, pair) in patches.chunks(2).enumerate() {
            let end = 100.0 - 0.5 * vehicle.wheelbase + 0.2 + 0.5 * number as f64;
            for (patch, side) in pair.iter().zip([-1.0, 1.0]) {
                let expected = 1.0 + (0.2 + 0.5 * number as f64) / 2.0;
                assert!((patch.laid - expected).abs() < 1e-9, "{number}: {}", patch.laid);
                let lane = 50.0 + side * 0.5 * vehicle.track;
                let corners = [
                    [end, lane - 0.15],
                    [end, lane + 0.15],
                    [end - 0.2, lane + 0.15],
                    [end - 0.2, lane - 0.15],
                ];
                for (found, expected) in patch.corners.iter().zip(corners) {
                    assert!(super::distance(*found, expected) < 1e-9, "{number}: {found:?} {expected:?}");
                }
            }
        }
    }

    #[test]
    fn what_flies_leaves_nothing_until_it_stands() {
        let heights = [Some(30.0), Some(1.7), Some(1.7)];
        let at = |(index, height): (usize, Option<f64>)| {
            waypoint(10.0 * index as f64, 100.0 + 20.0 * index as f64, 50.0, height)
        };
        let path = Path::new(heights.into_iter().enumerate().map(at).collect()).unwrap();
        let patches = TRACKS.lay(&path, &Vehicle::default(), &flat()).unwrap();
        let first = patches.first().map(|patch| patch.laid);
        assert!(first.is_some_and(|laid| laid > 8.0 && laid < 9.0), "{first:?}");
        assert!(patches.windows(2).all(|pair| pair[0].laid <= pair[1].laid));
    }
}
