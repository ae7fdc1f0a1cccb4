//! Between two points.

use rayon::prelude::*;

use crate::error::within;
use crate::judges::{Blocked, Kept, Raised, is_void, lowest};
use crate::ray::{Line, Piece, Ray};
use crate::{Curvature, Posts, SightError};

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
    pub(crate) fn heights(&self, posts: &Posts) -> Result<(f64, Option<f64>), SightError> {
        for north_or_east in self.place {
            within("place of a point (m)", north_or_east, true, "a finite number")?;
        }
        let ground = posts.height(self.place);
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

impl Posts {
    /// What lies between an observer and a target.
    ///
    /// # Errors
    /// A point that is no place, has a height out of range, or lies below the ground or over none.
    pub fn line_of_sight(
        &self,
        observer: &Point,
        target: &Point,
        curvature: Curvature,
    ) -> Result<LineOfSight, SightError> {
        let (start, start_clear) = observer.heights(self)?;
        let (end, end_clear) = target.heights(self)?;
        let of_points = [start_clear, end_clear].into_iter().flatten().fold(f64::INFINITY, f64::min);
        let Some(ray) = Ray::new(self.in_posts(observer.place), self.in_posts(target.place)) else {
            let least_height = end_clear.map(|_| 0.0);
            let (sight, distance, blocker) = (Sight::Visible, 0.0, None);
            return Ok(LineOfSight { sight, distance, clearance: of_points, blocker, least_height });
        };
        let distance = ray.length() * self.spacing();
        let line = Line::new(start, end, curvature, distance);
        let pieces = self.pieces(&ray);
        let known = pieces.iter().filter(|piece| !is_void(piece));
        let clearance = known.clone().map(|piece| lowest(&line, piece)).fold(of_points, f64::min);
        let first = known.clone().find(|piece| lowest(&line, piece) < 0.0);
        let blocker = first.map(|piece| {
            let share = begins(&line, piece);
            let place = [0, 1].map(|axis| (1.0 - share) * observer.place[axis] + share * target.place[axis]);
            Blocker { place, distance: share * distance }
        });
        let void = pieces.iter().any(is_void);
        let sight = if blocker.is_some() { Sight::Hidden } else { seen(void) };
        let ground = end_clear.map(|clear| end - clear);
        let least_height = ground.and_then(|ground| self.least(&ray, Line { end: ground, ..line }));
        Ok(LineOfSight { sight, distance, clearance, blocker, least_height })
    }

    /// What lies between an observer and each target, in their order.
    ///
    /// # Errors
    /// The first point that [`Posts::line_of_sight`] refuses.
    pub fn along(
        &self,
        observer: &Point,
        targets: &[Point],
        curvature: Curvature,
    ) -> Result<Vec<LineOfSight>, SightError> {
        targets.par_iter().map(|target| self.line_of_sight(observer, target, curvature)).collect()
    }

    /// All pieces of a way, from the observer to the target.
    fn pieces(&self, ray: &Ray) -> Vec<Piece> {
        let mut kept = Kept::default();
        ray.walk(self, &mut kept);
        let Kept(mut pieces) = kept;
        if ray.is_reversed() {
            pieces.reverse();
            let turn = |[first, last]: [f64; 2]| [last, first];
            pieces
                .iter_mut()
                .for_each(|piece| *piece = Piece { shares: turn(piece.shares), ground: turn(piece.ground) });
        }
        pieces
    }

    /// Whether the end of a line is seen, by the shortest look.
    pub(crate) fn sight(&self, ray: &Ray, line: Line) -> Sight {
        let mut judge = Blocked { line, blocked: false, void: false };
        ray.walk(self, &mut judge);
        if judge.blocked { Sight::Hidden } else { seen(judge.void) }
    }

    /// Least height (m) above the end of a line at which it would be seen; `None` across a void.
    pub(crate) fn least(&self, ray: &Ray, line: Line) -> Option<f64> {
        let mut judge = Raised { line, void: false };
        ray.walk(self, &mut judge);
        (!judge.void).then_some(judge.line.end - line.end)
    }
}

/// The answer of a line that nothing blocks.
fn seen(void: bool) -> Sight {
    if void { Sight::Unknown } else { Sight::Visible }
}

/// Share of the way at which the ground of a piece first reaches the line; halved until the bits end.
fn begins(line: &Line, piece: &Piece) -> f64 {
    let [mut clear, end] = piece.shares;
    let inside = line.nearest(piece).filter(|&share| line.clearance(piece, share) < 0.0);
    let mut above = inside.unwrap_or(end);
    if clear > 0.0 && line.clearance(piece, clear) < 0.0 {
        return clear;
    }
    loop {
        let middle = 0.5 * (clear + above);
        if middle <= clear || middle >= above {
            return above;
        }
        if line.clearance(piece, middle) < 0.0 { above = middle } else { clear = middle }
    }
}
