//! Points, and what is told of the line between two of them.

use crate::SightError;
use crate::error::within;

/// Largest height (m) of an observer or a target. Chosen: ten times 1000 km.
const MOST_HEIGHT: f64 = 1e7;

/// Whether a target is seen.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Sight {
    /// Nothing stands above the line. Ground that touches the line does not hide the target.
    Visible,
    /// Ground stands above the line.
    Hidden,
    /// Known ground does not hide the target, but the line crosses a void, or the target lies in one.
    Unknown,
}

/// How high a point lies.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Height {
    /// In metres above the ground of its place, 0 or more.
    AboveGround(f64),
    /// In metres above the datum of the mesh.
    AboveDatum(f64),
}

/// An observer or a target.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Point {
    /// North and east (m).
    pub place: [f64; 2],
    /// Above ground or datum.
    pub height: Height,
}

/// Where ground first stands above the line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Blocker {
    /// North and east (m).
    pub place: [f64; 2],
    /// Distance on the map from the observer (m).
    pub distance: f64,
}

/// What lies along the line between two points.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LineOfSight {
    /// Whether the target is seen.
    pub sight: Sight,
    /// Length on the map (m).
    pub distance: f64,
    /// Least height (m) of the line over known ground, both points included; negative where the target is hidden.
    pub clearance: f64,
    /// The first ground above the line, seen from the observer.
    pub blocker: Option<Blocker>,
    /// Least height (m) above the ground of its place at which the target would be seen; `None` where this is not known.
    pub least_height: Option<f64>,
}

impl LineOfSight {
    /// Two points at one place, of which the lower lies `clearance` (m) above the ground.
    pub(crate) fn upright(clearance: f64, least_height: Option<f64>) -> Self {
        Self { sight: Sight::Visible, distance: 0.0, clearance, blocker: None, least_height }
    }
}

impl Point {
    /// A point at a place (north, east, m) and a height (m) above the ground.
    pub fn above_ground(place: [f64; 2], height: f64) -> Self {
        Self { place, height: Height::AboveGround(height) }
    }

    /// A point at a place (north, east, m) and a height (m) above the datum.
    pub fn above_datum(place: [f64; 2], height: f64) -> Self {
        Self { place, height: Height::AboveDatum(height) }
    }

    /// Height above the datum and, where there is ground, above the ground (m).
    pub(crate) fn heights(
        &self,
        ground: impl Fn([f64; 2]) -> Option<f64>,
    ) -> Result<(f64, Option<f64>), SightError> {
        for north_or_east in self.place {
            within("place of a point (m)", north_or_east, true, "a finite number")?;
        }
        let ground = ground(self.place);
        match self.height {
            Height::AboveGround(height) => {
                let allowed = (0.0..=MOST_HEIGHT).contains(&height);
                within("height above the ground (m)", height, allowed, "a number from 0 to 1e7")?;
                let ground = ground.ok_or(SightError::NoGround { place: self.place })?;
                Ok((ground + height, Some(height)))
            }
            Height::AboveDatum(height) => {
                let allowed = height.abs() <= MOST_HEIGHT;
                within("height above the datum (m)", height, allowed, "a number from -1e7 to 1e7")?;
                match ground {
                    Some(ground) if height < ground => {
                        Err(SightError::Below { place: self.place, depth: ground - height })
                    }
                    _ => Ok((height, ground.map(|ground| height - ground))),
                }
            }
        }
    }
}
