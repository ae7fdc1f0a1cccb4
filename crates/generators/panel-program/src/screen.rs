//! A panel on the screen: projected, clipped or left out.

use glam::DVec3;
use raster::{Clipper, DistancePlane, Fan, Point, Screen};

use crate::Restrictions;
use crate::depth::{DepthPlane, NoDepth};
use crate::view::Camera;

/// Depth (m) nearer than which repaired ground is cut off. Chosen by the specification.
const NEAR: f64 = 0.1;

/// Corners of a panel before the eye.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Corners {
    /// Right, down, ahead (m).
    pub places: [DVec3; 3],
    /// Distances from the eye (m).
    pub distances: [f64; 3],
}

/// What is left of a panel.
pub(crate) enum Shape {
    /// Whole-number corners for the fill of the listing.
    Whole(Vec<[[i64; 2]; 3]>),
    /// Corners in steps of 1/256 pixel.
    Fine(Fan),
    /// A corner lies beyond the screen, or has no image.
    Discarded,
    /// Nothing of it is on the screen.
    Unseen,
}

/// Places on the screen (pixels); none for a corner that has no image.
fn on_screen(corners: &Corners, camera: &Camera, restrictions: Restrictions) -> Option<[[f64; 2]; 3]> {
    let has_image = |place: DVec3| if restrictions.mirror_behind { place.z != 0.0 } else { place.z >= NEAR };
    let all = corners.places.iter().all(|place| has_image(*place));
    all.then(|| corners.places.map(|place| camera.projection.project(place)))
}

/// A place as the listing stores it: cut to a whole number.
fn whole(place: [f64; 2]) -> [i64; 2] {
    place.map(|at| at.trunc() as i64)
}

/// The part of a panel that is filled.
pub(crate) fn shape(
    corners: &Corners,
    camera: &Camera,
    screen: &Screen,
    restrictions: Restrictions,
) -> Shape {
    let places = on_screen(corners, camera, restrictions);
    match (restrictions.discard_partial, restrictions.both_ends) {
        (true, is_whole) => match places {
            Some(places) if is_whole => whole_inside(places, screen),
            Some(places) => fine_inside(places, screen),
            None => Shape::Discarded,
        },
        (false, is_whole) => {
            let fan = clipped(corners, camera, screen, restrictions);
            match (fan.is_empty(), is_whole) {
                (true, _) => Shape::Unseen,
                (false, false) => Shape::Fine(fan),
                (false, true) => Shape::Whole(fan.iter().map(|corners| kept_on(*corners, screen)).collect()),
            }
        }
    }
}

/// The listing's test: all corners from 1 to the last column and row.
fn whole_inside(places: [[f64; 2]; 3], screen: &Screen) -> Shape {
    let corners = places.map(whole);
    let is_inside =
        |corner: &[i64; 2]| (0..2).all(|axis| (1..=i64::from(screen.size()[axis])).contains(&corner[axis]));
    if corners.iter().all(is_inside) { Shape::Whole(vec![corners]) } else { Shape::Discarded }
}

/// The same test for corners that are not cut to whole numbers.
fn fine_inside(places: [[f64; 2]; 3], screen: &Screen) -> Shape {
    let is_inside =
        |place: &[f64; 2]| (0..2).all(|axis| (0.0..=f64::from(screen.size()[axis])).contains(&place[axis]));
    let snapped = places.map(|place| Point::snap(place).ok());
    match (places.iter().all(is_inside), snapped) {
        (true, [Some(a), Some(b), Some(c)]) => Shape::Fine(Fan::from_slice(&[[a, b, c]])),
        _ => Shape::Discarded,
    }
}

/// What clipping leaves. Mirrored corners are clipped on the screen alone.
fn clipped(corners: &Corners, camera: &Camera, screen: &Screen, restrictions: Restrictions) -> Fan {
    let flat = |place: DVec3| place / place.z;
    let (places, near) = match restrictions.mirror_behind {
        true => (corners.places.map(flat), 0.5),
        false => (corners.places, NEAR),
    };
    // Corners too far away to be clipped have no image either.
    Clipper::new(&camera.projection, screen, near).clip(places).unwrap_or_default()
}

/// Whole-number corners within the screen, from 1.
fn kept_on(corners: [Point; 3], screen: &Screen) -> [[i64; 2]; 3] {
    let last = screen.size().map(i64::from);
    corners.map(|corner| {
        let [column, row] = whole(corner.position());
        [column.clamp(1, last[0]), row.clamp(1, last[1])]
    })
}

/// Depth of a panel.
///
/// # Errors
/// If it stands edge-on, or the listing divides by 0.
pub(crate) fn depth(
    corners: &Corners,
    camera: &Camera,
    restrictions: Restrictions,
) -> Result<DepthPlane, NoDepth> {
    let places = on_screen(corners, camera, restrictions);
    let lift = |value: &dyn Fn(usize) -> f64| {
        places.map(|places| {
            [0, 1, 2].map(|k| {
                let place = match restrictions.both_ends {
                    true => whole(places[k]).map(|at| at as f64),
                    false => places[k],
                };
                DVec3::new(place[0], place[1], value(k))
            })
        })
    };
    if restrictions.linear_depth {
        // A panel that the eye's plane cuts has no corners to be linear between; there the distance is exact.
        if let Some(lifted) = lift(&|k| corners.distances[k]) {
            return DepthPlane::written(lifted);
        }
    }
    if restrictions.mirror_behind && corners.places.iter().any(|place| place.z < 0.0) {
        let lifted = lift(&|k| 1.0 / corners.places[k].z.abs());
        return lifted.and_then(DepthPlane::nearness).ok_or(NoDepth::EdgeOn);
    }
    DistancePlane::new(corners.places, &camera.projection).map(DepthPlane::Nearness).ok_or(NoDepth::EdgeOn)
}
