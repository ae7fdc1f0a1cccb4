//! Between two points and over an area of a landscape.

use rayon::prelude::*;

use crate::error::within;
use crate::line::Line;
use crate::search::{First, Hides, Least, Rises};
use crate::terrain::Look;
use crate::way::Way;
use crate::{Blocker, Curvature, LineOfSight, Point, Raster, Sight, SightError, Terrain};

/// Share of heights and distance by which ground may stand above a line that it touches. Chosen: some hundred roundings of f64.
const ROUNDING: f64 = 2e-14;

/// Rounding (m) of the clearance of a line.
fn touch(line: &Line, curvature: Curvature, length: f64) -> f64 {
    ROUNDING * (line.start.abs().max(line.end.abs()) + curvature.drop(length) + length)
}

impl Terrain {
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
        let Some(way) = Way::new(observer.place, target.place) else {
            return Ok(LineOfSight::upright(of_points, end_clear.map(|_| 0.0)));
        };
        curvature.check_reach(way.length)?;
        let line = Line::new(start, end, curvature, way.length);
        let look = Look { way: &way, line: &line, curvature };
        let touch = touch(&line, curvature, way.length);
        let mut least = Least { touch, clearance: of_points };
        self.walk(&look, &mut least);
        let mut first = First { touch, share: None };
        self.walk(&look, &mut first);
        let blocker =
            first.share.map(|share| Blocker { place: way.place(share), distance: share * way.length });
        let sight = if blocker.is_some() { Sight::Hidden } else { Sight::Visible };
        let on_ground = |clear: f64| self.rise(&Look { line: &line.ending_at(end - clear), ..look });
        let (distance, clearance, least_height) = (way.length, least.clearance, end_clear.map(on_ground));
        Ok(LineOfSight { sight, distance, clearance, blocker, least_height })
    }

    /// What lies between an observer and each target, in their order.
    ///
    /// # Errors
    /// The first point that [`Terrain::line_of_sight`] refuses.
    pub fn along(
        &self,
        observer: &Point,
        targets: &[Point],
        curvature: Curvature,
    ) -> Result<Vec<LineOfSight>, SightError> {
        targets.par_iter().map(|target| self.line_of_sight(observer, target, curvature)).collect()
    }

    /// Whether a target of a `height` (m) above the ground of each place of a grid is seen, row by row; unknown where there is no
    /// ground. `done` is called after each row.
    ///
    /// # Errors
    /// An observer that [`Terrain::line_of_sight`] refuses, a height below 0, or a grid without places.
    pub fn viewshed(
        &self,
        observer: &Point,
        targets: &Raster,
        height: f64,
        curvature: Curvature,
        done: &(impl Fn() + Sync),
    ) -> Result<Vec<Sight>, SightError> {
        within("height of the targets (m)", height, height >= 0.0, "a finite number of 0 or more")?;
        let start = self.start(observer, targets, curvature)?;
        let of_place = |place: [f64; 2]| {
            let Some(ground) = self.height(place) else { return Sight::Unknown };
            let Some(way) = Way::new(observer.place, place) else { return Sight::Visible };
            let line = Line::new(start, ground + height, curvature, way.length);
            self.sight(&Look { way: &way, line: &line, curvature })
        };
        Ok(targets.each(of_place, done))
    }

    /// Least height (m) above the ground of each place of a grid at which a target is seen, row by row; 0 where the ground is seen, NaN
    /// where there is none. `done` is called after each row.
    ///
    /// # Errors
    /// An observer that [`Terrain::line_of_sight`] refuses, or a grid without places.
    pub fn least_heights(
        &self,
        observer: &Point,
        targets: &Raster,
        curvature: Curvature,
        done: &(impl Fn() + Sync),
    ) -> Result<Vec<f64>, SightError> {
        let start = self.start(observer, targets, curvature)?;
        let of_place = |place: [f64; 2]| {
            let Some(ground) = self.height(place) else { return f64::NAN };
            let Some(way) = Way::new(observer.place, place) else { return 0.0 };
            let line = Line::new(start, ground, curvature, way.length);
            self.rise(&Look { way: &way, line: &line, curvature })
        };
        Ok(targets.each(of_place, done))
    }

    /// Height (m) above the datum of an observer that looks over a grid.
    fn start(&self, observer: &Point, targets: &Raster, curvature: Curvature) -> Result<f64, SightError> {
        targets.check()?;
        let (start, _) = observer.heights(|place| self.height(place))?;
        curvature.check_reach(targets.farthest(observer.place))?;
        Ok(start)
    }

    /// Whether the end of a line is seen, by the shortest look.
    fn sight(&self, look: &Look<'_>) -> Sight {
        let touch = touch(look.line, look.curvature, look.way.length);
        let mut hides = Hides { touch, blocked: false };
        self.walk(look, &mut hides);
        if hides.blocked { Sight::Hidden } else { Sight::Visible }
    }

    /// Least height (m) above the end of a line at which it would be seen.
    fn rise(&self, look: &Look<'_>) -> f64 {
        let touch = touch(look.line, look.curvature, look.way.length);
        let mut rises = Rises { touch, raise: 0.0 };
        self.walk(look, &mut rises);
        rises.raise
    }
}
