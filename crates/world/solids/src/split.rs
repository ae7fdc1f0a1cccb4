//! A closed surface that is not convex, as convex solids that fill it.
//!
//! Space is cut along planes of the surface until every room holds a convex piece of it, or nothing (a tree of planes, as
//! Fuchs, Kedem and Naylor's of 1980):
//!
//! ```text
//!  room: a convex cell, and what of the surface lies in it
//!    nothing           -> wholly inside (a part) or wholly outside, by the winding number of its middle
//!    no face is dented -> the cell behind all its faces is a part
//!    else              -> two rooms, by the plane that cuts fewest faces
//! ```
//!
//! Only planes with something of the surface in front of them cut: a convex piece is never cut. Both sides of a cut have the
//! same corners, so parts touch without a gap. Faces between parts lie inside the shape, where no ray gets.

mod cell;
mod plane;
mod winding;

use glam::DVec3;
use limits::Limit;

use crate::{Solid, SolidError};
use cell::Cell;
use plane::{Plane, planes_of};
use winding::winding;

/// Places nearer than this share of the size count as one, and corners so near to a plane as on it: files of 32-bit numbers
/// round by half of it.
const SLACK: f64 = 1e-7;
/// Share of [`SLACK`] within which corners of a cell lie on a plane.
const FINE: f64 = 1e-3;
/// Most planes that are tried for one cut.
const TRIED: usize = 48;
/// Cuts for each part that is allowed: most rooms of a shape are empty.
const CUTS: u64 = 4;
/// Largest share of the volume that a split may lose or add.
const LOST: f64 = 1e-3;

/// Most triangles of a surface that is split.
pub(crate) const MOST_TRIANGLES: usize = 10_000;

/// The parts of a shape, and how well they fill it.
#[derive(Debug)]
pub(crate) struct Split {
    /// Convex solids that touch and do not overlap, all white.
    pub parts: Vec<Solid>,
    /// Relative error of the volume: the parts minus the shape, divided by the shape.
    pub volume_error: f64,
    /// Largest distance of a corner of the shape from the nearest part (m).
    pub distance: f64,
}

/// Why a closed surface is not split.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum SplitError {
    /// More parts than the limit allows, or too many cuts on the way to them.
    TooManyParts,
    /// More triangles than are tried.
    TooManyTriangles(usize),
    /// The surface runs this often around a place inside it.
    Crosses { at: DVec3, around: f64 },
    /// The parts have not the volume of the shape, by this share.
    Lost(f64),
    /// A part is no solid.
    Part(SolidError),
}

/// Splits a closed surface. Its triangles run counter-clockwise seen from outside, by right-handed axes.
pub(crate) fn split(triangles: &[[DVec3; 3]], albedo: f64) -> Result<Split, SplitError> {
    if triangles.len() > MOST_TRIANGLES {
        return Err(SplitError::TooManyTriangles(triangles.len()));
    }
    let splitting = Splitting::new(triangles);
    let cells = splitting.cells()?;
    let volume = volume(triangles);
    let volume_error = cells.iter().map(Cell::volume).sum::<f64>() / volume - 1.0;
    if volume_error.is_nan() || volume_error.abs() > LOST {
        return Err(SplitError::Lost(volume_error));
    }
    let parts = cells
        .iter()
        .map(|cell| cell.solid(albedo))
        .collect::<Result<Vec<_>, _>>()
        .map_err(SplitError::Part)?;
    let distance = triangles.iter().flatten().map(|&place| outside(&parts, place)).fold(0.0, f64::max);
    Ok(Split { parts, volume_error, distance })
}

/// Volume of a closed surface (m3); negative if its triangles run clockwise seen from outside.
pub(crate) fn volume(triangles: &[[DVec3; 3]]) -> f64 {
    let from = triangles.first().map_or(DVec3::ZERO, |[corner, ..]| *corner);
    let of = |&[a, b, c]: &[DVec3; 3]| (a - from).dot((b - from).cross(c - from)) / 6.0;
    triangles.iter().map(of).sum()
}

/// How far a place lies outside the nearest part (m).
fn outside(parts: &[Solid], place: DVec3) -> f64 {
    let of = |part: &Solid| {
        let above = |face: &crate::Face| face.normal.dot(place - part.vertices()[face.corners[0] as usize]);
        part.faces().iter().map(above).fold(0.0, f64::max)
    };
    parts.iter().map(of).fold(f64::INFINITY, f64::min)
}

/// A piece of a triangle, in a plane.
#[derive(Debug, Clone)]
struct Fragment {
    plane: usize,
    corners: Vec<DVec3>,
}

/// A convex cell, and what of the surface lies in it.
#[derive(Debug)]
struct Room {
    cell: Cell,
    fragments: Vec<Fragment>,
}

/// A surface on its way to parts.
struct Splitting<'t> {
    triangles: &'t [[DVec3; 3]],
    planes: Vec<Plane>,
    of_triangle: Vec<Option<usize>>,
    /// Bounds of the surface (m).
    bounds: [DVec3; 2],
    /// Distance within which corners lie on a plane (m).
    slack: f64,
}

impl<'t> Splitting<'t> {
    fn new(triangles: &'t [[DVec3; 3]]) -> Self {
        let places = || triangles.iter().flatten().copied();
        let (low, high) =
            (places().fold(DVec3::INFINITY, DVec3::min), places().fold(DVec3::NEG_INFINITY, DVec3::max));
        let slack = SLACK * (high - low).length();
        let (planes, of_triangle) = planes_of(triangles, slack);
        Self { triangles, planes, of_triangle, bounds: [low, high], slack }
    }

    /// Convex cells that fill the inside.
    fn cells(&self) -> Result<Vec<Cell>, SplitError> {
        let mut open = vec![self.whole()];
        let (mut cells, mut cuts) = (Vec::new(), 0);
        while let Some(room) = open.pop() {
            match self.dented(&room) {
                Some(plane) => {
                    cuts += 1;
                    open.extend(self.halves(&room, &self.planes[plane]));
                }
                None => cells.extend(self.filled(room)?),
            }
            let most = Limit::ShapeParts.value();
            if cells.len() as u64 > most || cuts > most.saturating_mul(CUTS) {
                return Err(SplitError::TooManyParts);
            }
        }
        Ok(cells)
    }

    /// All of the surface, with room around it.
    fn whole(&self) -> Room {
        let [low, high] = self.bounds;
        let margin = DVec3::splat((high - low).length());
        let planed = self.triangles.iter().zip(&self.of_triangle);
        let fragments = planed
            .filter_map(|(corners, plane)| Some(Fragment { plane: (*plane)?, corners: corners.to_vec() }));
        Room { cell: Cell::boxed(low - margin, high + margin), fragments: fragments.collect() }
    }

    /// The plane along which a room is cut: of those with something in front, one that cuts few and leaves two like halves.
    fn dented(&self, room: &Room) -> Option<usize> {
        let mut planes: Vec<usize> = room.fragments.iter().map(|fragment| fragment.plane).collect();
        planes.sort_unstable();
        planes.dedup();
        let costs = |&plane: &usize| {
            let [mut front, mut back, mut cut] = [0_usize; 3];
            for fragment in &room.fragments {
                let [in_front, behind] = self.planes[plane].reaches(&fragment.corners, self.slack);
                front += usize::from(in_front);
                back += usize::from(behind);
                cut += usize::from(in_front && behind);
            }
            (front > 0).then_some((4 * cut + front.abs_diff(back), plane))
        };
        // Beyond some number of planes that would do, the best of the rest is not worth the search.
        planes.iter().filter_map(costs).take(TRIED).min().map(|(_, plane)| plane)
    }

    /// The rooms on both sides of a plane.
    fn halves(&self, room: &Room, plane: &Plane) -> Vec<Room> {
        let (mut front, mut back) = (Vec::new(), Vec::new());
        for fragment in &room.fragments {
            let [in_front, behind] = plane.reaches(&fragment.corners, self.slack);
            let halves = plane.cut(&fragment.corners, self.slack);
            let piece = |corners| Fragment { plane: fragment.plane, corners };
            front.extend(in_front.then(|| piece(halves.front)));
            back.extend(behind.then(|| piece(halves.back)));
        }
        let cells = room.cell.cut(plane, FINE * self.slack);
        let room = |(cell, fragments): (Option<Cell>, _)| Some(Room { cell: cell?, fragments });
        cells.into_iter().zip([front, back]).filter_map(room).collect()
    }

    /// The part in a room without dents; nothing if it lies outside, or is too thin to be anything.
    fn filled(&self, room: Room) -> Result<Option<Cell>, SplitError> {
        let mut cell = Some(room.cell);
        let mut planes: Vec<usize> = room.fragments.iter().map(|fragment| fragment.plane).collect();
        planes.sort_unstable();
        planes.dedup();
        for plane in planes {
            cell = cell.and_then(|cell| cell.behind(&self.planes[plane], FINE * self.slack));
        }
        let Some(cell) = cell.filter(|cell| !cell.is_thin(self.slack)) else { return Ok(None) };
        let at = cell.middle();
        let around = winding(self.triangles, at);
        match around.round() {
            0.0 => Ok(None),
            1.0 => Ok(Some(cell)),
            around => Err(SplitError::Crosses { at, around }),
        }
    }
}
