//! Remote shadow: what stands between a place of the map and the sun.
//!
//! The map is flat for light, as it is for the shadow data bank: whether a place is dark depends on the place alone.

use std::borrow::Cow;

use glam::DVec3;
use landscape::Sun;
use quantities::sin_cos;
use scenario::TrackPatch;
use solids::Body;

use crate::bend::Bend;
use crate::buckets::{Box2, Buckets};
use crate::ground::{Ground, Scratch, Zone};
use crate::line::Line;
use crate::standing::COINCIDENCE;

/// How far above the ground a sunbeam begins, as a share of 1 m and the height there: above the rounding of heights,
/// so that level ground does not shadow itself.
pub const LIFT: f64 = 1e-10;

/// What makes a place dark.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Dark {
    /// Ground or a body in front of the sun.
    Cast,
    /// A track that the vehicle has left.
    Track,
}

/// The shadows of one instant.
#[derive(Debug, Clone)]
pub struct Shadows<'a> {
    ground: Ground<'a>,
    beam: Beam,
    bodies: Vec<Cow<'a, Body>>,
    /// Bodies by their place in the plane that the sun sees.
    casters: Buckets,
    patches: &'a [TrackPatch],
    tracks: Buckets,
}

impl<'a> Shadows<'a> {
    /// Shadows under `sun` of the ground, of `bodies`, and `patches` of track.
    pub fn new(ground: Ground<'a>, sun: &Sun, bodies: Vec<Cow<'a, Body>>, patches: &'a [TrackPatch]) -> Self {
        let beam = Beam::new(sun);
        let seen = |body: &Cow<Body>| hull(body.vertices().map(|vertex| beam.across(vertex)));
        let casters = Buckets::new(&bodies.iter().map(seen).collect::<Vec<_>>());
        let laid = |patch: &TrackPatch| hull(patch.corners.into_iter());
        let tracks = Buckets::new(&patches.iter().map(laid).collect::<Vec<_>>());
        Self { ground, beam, bodies, casters, patches, tracks }
    }

    /// What makes a place (north, east; m) dark, if anything does. What is `cast` on it is only looked for if that
    /// is asked.
    pub fn at(&self, place: [f64; 2], cast: bool, scratch: &mut Scratch) -> Option<Dark> {
        if self.is_track(place) {
            return Some(Dark::Track);
        }
        let height = if cast { self.ground.height(place)? } else { return None };
        let cast = self.is_behind_body(place, height) || self.is_behind_ground(place, height, scratch);
        cast.then_some(Dark::Cast)
    }

    /// Whether a place lies in a patch of track.
    fn is_track(&self, place: [f64; 2]) -> bool {
        self.tracks.at(place).iter().any(|&patch| holds(&self.patches[patch as usize].corners, place))
    }

    /// Whether the ground alone makes a place dark: its own steepness too.
    pub fn is_dark_ground(&self, place: [f64; 2], scratch: &mut Scratch) -> bool {
        let height = self.ground.height(place);
        height.is_some_and(|height| self.is_behind_ground(place, height, scratch))
    }

    fn is_behind_body(&self, [x, y]: [f64; 2], height: f64) -> bool {
        let origin = DVec3::new(x, y, height);
        // An open surface that lies on the ground throws no shadow on it. A closed body's faces are met from outside: none is near.
        let room = COINCIDENCE * (1.0 + height.abs());
        let from = |body: &Body| if body.solid.is_open() { room } else { 0.0 };
        let covers = |body: &Body| body.first_hit(origin, self.beam.to_sun, from(body)).is_some();
        self.casters.at(self.beam.across(origin)).iter().any(|&index| covers(&self.bodies[index as usize]))
    }

    fn is_behind_ground(&self, place: [f64; 2], height: f64, scratch: &mut Scratch) -> bool {
        let Some((direction, rise)) = self.beam.over_ground else { return false };
        let height = height + LIFT * (1.0 + height.abs());
        let line = Line { origin: place, direction, height, rise, bend: Bend::FLAT };
        let mut from = 0.0;
        while let Some(zone) = self.zone(&line, from) {
            if self.ground.meet(&line, &zone, scratch).is_some() {
                return true;
            }
            if self.ground.is_below(&line, zone.ends[1]) {
                return false;
            }
            from = zone.ends[1];
        }
        false
    }

    /// From a range on, the finest level that has the ground there, up to where that changes; where none has it, from
    /// where the line comes in again.
    fn zone(&self, line: &Line, from: f64) -> Option<Zone> {
        let mut to = f64::INFINITY;
        for level in 0..self.ground.levels() {
            let [enters, leaves] = self.ground.track(level, line).inside();
            if enters <= from && from < leaves {
                return Some(Zone { level, into: None, ends: [from, leaves.min(to)] });
            }
            if enters < leaves && from < enters {
                to = to.min(enters);
            }
        }
        if to.is_finite() { self.zone(line, to) } else { None }
    }
}

/// The way to the sun.
#[derive(Debug, Clone, Copy)]
struct Beam {
    to_sun: DVec3,
    /// Over the ground, and its tangent of elevation; `None` in the zenith.
    over_ground: Option<([f64; 2], f64)>,
    axes: [DVec3; 2],
}

impl Beam {
    fn new(sun: &Sun) -> Self {
        let ((sin_e, cos_e), (sin_a, cos_a)) = (sin_cos(sun.elevation), sin_cos(sun.azimuth));
        let over_ground = (cos_e > 0.0).then(|| ([cos_a, sin_a], sin_e / cos_e));
        let right = DVec3::new(-sin_a, cos_a, 0.0);
        let above = DVec3::new(-sin_e * cos_a, -sin_e * sin_a, cos_e);
        Self { to_sun: DVec3::from_array(sun.direction()), over_ground, axes: [right, above] }
    }

    /// Place in the plane across the beam.
    fn across(&self, point: DVec3) -> [f64; 2] {
        self.axes.map(|axis| axis.dot(point))
    }
}

fn hull(points: impl Iterator<Item = [f64; 2]>) -> Box2 {
    points.fold([[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]], |[low, high], point| {
        [[low[0].min(point[0]), low[1].min(point[1])], [high[0].max(point[0]), high[1].max(point[1])]]
    })
}

/// Whether a convex polygon, its corners clockwise seen from above, holds a place; its edge belongs to it.
fn holds(corners: &[[f64; 2]; 4], [x, y]: [f64; 2]) -> bool {
    (0..4).all(|k| {
        let ([ax, ay], [bx, by]) = (corners[k], corners[(k + 1) % 4]);
        // x is north and y east: clockwise from above has its inside to the right.
        (bx - ax) * (y - ay) - (by - ay) * (x - ax) >= 0.0
    })
}
