//! The edges of a frame's triangles, drawn over its ground.

use generator::{Label, PlaneKind, Planes};
use glam::DVec3;
use lod_tiles::Surface;
use quantities::luminance;
use scene_sampler::{Camera, NEAR};

use crate::ground::{Mesh, level_colour};

/// Light of the ground between edges. Chosen: it hides what is behind it, and is dark.
pub const FILL: f64 = 0.02;

/// Share by which an edge may be behind what a pixel shows, and is seen all the same: a pixel shows the nearest of its sampling points. Chosen.
const BEHIND: f64 = 0.03;

/// Draws the edges of the triangles of a mesh, each in the colour of its tile's level, where the ground of a picture with these surfaces does not hide
/// them.
pub fn draw(
    mesh: &Mesh,
    surface: &Surface<'_>,
    camera: &Camera,
    surfaces: &[(f32, Label)],
    planes: &mut Planes,
) {
    let size = [planes.columns(), planes.lines()];
    let mut seen = vec![None; surfaces.len()];
    for (triangles, tile) in mesh.triangles_of_tiles() {
        let colour = level_colour(surface.tile_state(tile));
        for corners in triangles {
            let places = corners.map(|corner| mesh.places[corner as usize]);
            for k in 0..3 {
                pixels_of([places[k], places[(k + 1) % 3]], camera, size, |at, q| {
                    let (shown, label) = surfaces[at];
                    if label == Label::Terrain && q * (1.0 + BEHIND) >= f64::from(shown) {
                        seen[at] = Some(colour);
                    }
                });
            }
        }
    }
    fill(&seen, planes);
}

/// Puts the colours of edges into the planes of light.
fn fill(seen: &[Option<[f64; 3]>], planes: &mut Planes) {
    let of = |kind: PlaneKind, colour: [f64; 3]| match kind {
        PlaneKind::Intensity => luminance(colour),
        PlaneKind::Red => colour[0],
        PlaneKind::Green => colour[1],
        _ => colour[2],
    };
    for kind in [PlaneKind::Intensity, PlaneKind::Red, PlaneKind::Green, PlaneKind::Blue] {
        let Some(plane) = planes.get_mut(kind) else { continue };
        for (value, colour) in plane.iter_mut().zip(seen) {
            if let Some(colour) = colour {
                *value = of(kind, *colour) as f32;
            }
        }
    }
}

/// Tells each pixel of a picture of so many columns and lines that an edge in camera axes (m) passes, with how near (1/m) it is there.
fn pixels_of(edge: [DVec3; 2], camera: &Camera, size: [usize; 2], mut tell: impl FnMut(usize, f64)) {
    let Some([a, b]) = before_eye(edge) else { return };
    let [from, to] = [a, b].map(|end| camera.projection.project(end));
    let Some([first, last]) = within(from, to, size) else { return };
    let along = [to[0] - from[0], to[1] - from[1]];
    let steps = (last - first) * along[0].abs().max(along[1].abs());
    let steps = steps.ceil() as usize;
    for step in 0..=steps {
        let t = first + (last - first) * step as f64 / steps.max(1) as f64;
        let [column, line] = [0, 1].map(|axis| (from[axis] + t * along[axis]).floor());
        if (0.0..size[0] as f64).contains(&column) && (0.0..size[1] as f64).contains(&line) {
            tell(line as usize * size[0] + column as usize, (1.0 - t) / a.z + t / b.z);
        }
    }
}

/// The part of an edge that lies before the eye; `None` if there is none.
fn before_eye([a, b]: [DVec3; 2]) -> Option<[DVec3; 2]> {
    let clipped = |inside: DVec3, outside: DVec3| {
        inside + (outside - inside) * ((inside.z - NEAR) / (inside.z - outside.z))
    };
    match (a.z >= NEAR, b.z >= NEAR) {
        (true, true) => Some([a, b]),
        (true, false) => Some([a, clipped(a, b)]),
        (false, true) => Some([clipped(b, a), b]),
        (false, false) => None,
    }
}

/// Shares of the way between two places on the screen (pixels), 0 to 1, between which it lies on the picture; `None` if it does nowhere.
fn within(from: [f64; 2], to: [f64; 2], size: [usize; 2]) -> Option<[f64; 2]> {
    let [mut first, mut last] = [0.0_f64, 1.0_f64];
    for axis in 0..2 {
        let (start, way) = (from[axis], to[axis] - from[axis]);
        let end = size[axis] as f64;
        if way == 0.0 {
            if !(0.0..=end).contains(&start) {
                return None;
            }
            continue;
        }
        let [a, b] = [-start / way, (end - start) / way];
        first = first.max(a.min(b));
        last = last.min(a.max(b));
    }
    (first <= last).then_some([first, last])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_edge_is_cut_at_the_picture() {
        assert_eq!(within([-10.0, 5.0], [30.0, 5.0], [20, 10]), Some([0.25, 0.75]));
        assert_eq!(within([-10.0, 5.0], [-1.0, 5.0], [20, 10]), None);
        assert_eq!(within([5.0, 5.0], [5.0, 5.0], [20, 10]), Some([0.0, 1.0]));
        assert_eq!(within([5.0, 11.0], [9.0, 11.0], [20, 10]), None);
    }

    #[test]
    fn what_is_behind_the_eye_is_cut_off() {
        let (near, far) = (DVec3::new(0.0, 0.0, -1.0), DVec3::new(2.0, 0.0, 1.0));
        let [a, b] = before_eye([near, far]).unwrap();
        assert!((a.z - NEAR).abs() < 1e-12 && (a.x - 1.0 - NEAR).abs() < 1e-12 && b == far);
        assert!(before_eye([near, near]).is_none());
    }
}
