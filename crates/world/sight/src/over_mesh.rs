//! Between two points over a mesh.

use rayon::prelude::*;

use crate::judges::{Blocked, Kept, Raised, is_void, lowest};
use crate::line::{Line, Piece};
use crate::ray::Ray;
use crate::{Blocker, Curvature, LineOfSight, Point, Posts, Sight, SightError};

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
        let (start, start_clear) = observer.heights(|place| self.height(place))?;
        let (end, end_clear) = target.heights(|place| self.height(place))?;
        let of_points = [start_clear, end_clear].into_iter().flatten().fold(f64::INFINITY, f64::min);
        let Some(ray) = Ray::new(self.in_posts(observer.place), self.in_posts(target.place)) else {
            return Ok(LineOfSight::upright(of_points, end_clear.map(|_| 0.0)));
        };
        let distance = ray.length() * self.spacing();
        curvature.check_reach(distance)?;
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
        let least_height = ground.and_then(|ground| self.least(&ray, line.ending_at(ground)));
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
