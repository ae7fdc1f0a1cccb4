//! The ground around an eye as a mesh with smooth normals, finest where it is seen largest.

use std::f64::consts::PI;

use landscape::Landscape;
use quantities::sin_cos;
use rayon::prelude::*;
use scenario::{FieldOfView, Pose};

/// How fine a mesh is, and over which ground it lies.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Grading {
    /// Meridians in the picture.
    pub meridians: usize,
    /// Rings between the nearest and the farthest ground that is seen.
    pub rings: usize,
    /// The nearest and the farthest ground that is seen (m).
    pub ranges: [f64; 2],
}

/// Faces between meridians and rings around an eye, which is the origin; axes north, east, up (m).
///
/// Meridians stand as far apart on the picture as columns do. Beside the picture their angles grow by `GROWTH` all around, and rings
/// go on by `MARGIN` beyond the farthest ground, because shadows fall from there into the picture.
#[derive(Debug, Clone, PartialEq)]
pub struct EyeMesh {
    /// Place and normal (not of unit length) of each vertex.
    pub vertices: Vec<[[f32; 3]; 2]>,
    /// Numbers of four vertices each, around the face; a triangle repeats its last one.
    pub faces: Vec<[u32; 4]>,
}

/// Meridians stand this much farther out than the picture's edges: a picture that looks up or down is wider there than on its axis.
const WIDER: f64 = 1.03;
/// Each angle between meridians beside the picture is so many times the one before.
const GROWTH: f64 = 1.05;
/// Rings go on so far beyond the farthest ground that is seen (m).
const MARGIN: f64 = 500.0;

impl EyeMesh {
    /// The mesh of `landscape` from a pose that looks about level. Where the problem area ends there is none.
    pub fn new(landscape: &Landscape, pose: &Pose, field: FieldOfView, grading: &Grading) -> Self {
        let azimuths = azimuths(field.tan_half_width * WIDER, grading.meridians);
        let ranges = ranges(grading);
        let turned = |azimuth: &f64| sin_cos(pose.attitude.heading + azimuth);
        let directions: Vec<(f64, f64)> = azimuths.iter().map(turned).collect();
        let ring = |&range: &f64| {
            let vertex = |&(sin, cos): &(f64, f64)| vertex(landscape, pose.eye, [range * cos, range * sin]);
            directions.iter().map(vertex).collect::<Vec<_>>()
        };
        let found: Vec<Option<[[f32; 3]; 2]>> = ranges.par_iter().flat_map(ring).collect();
        let (width, mut faces) = (directions.len(), Vec::with_capacity(found.len()));
        for near in (0..ranges.len() - 1).map(|ring| ring * width) {
            for (left, right) in (0..width).map(|left| (left, (left + 1) % width)) {
                let corners = [near + left, near + width + left, near + width + right, near + right];
                if corners.iter().all(|&corner| found[corner].is_some()) {
                    faces.push(corners.map(|corner| corner as u32));
                }
            }
        }
        // Vertices without ground are in no face.
        Self { vertices: found.into_iter().map(Option::unwrap_or_default).collect(), faces }
    }
}

/// Angles of the meridians against the heading (rad), once around, ascending.
fn azimuths(tangent: f64, count: usize) -> Vec<f64> {
    let last = count.max(2) - 1;
    let at = |meridian: usize| libm::atan(tangent * (2.0 * meridian as f64 / last as f64 - 1.0));
    let (mut angle, mut step) = (at(last), at(last) - at(last - 1));
    let mut beside = Vec::new();
    while angle + step * GROWTH < PI {
        step *= GROWTH;
        angle += step;
        beside.push(angle);
    }
    let left = beside.iter().rev().map(|angle| -angle);
    left.chain((0..=last).map(at)).chain(beside.iter().copied()).collect()
}

/// Ranges of the rings (m), ascending, from under the eye to beyond the farthest ground. Distances between rings grow as the root of
/// the range. Chosen: of the powers 0.3, 0.5, 0.7 and 1 it had the least error.
fn ranges(grading: &Grading) -> Vec<f64> {
    let [start, end] = grading.ranges;
    let last = grading.rings.max(2) - 1;
    let at = |ring: usize| {
        let root = start.sqrt() + (end.sqrt() - start.sqrt()) * ring as f64 / last as f64;
        root * root
    };
    let step = end - at(last - 1);
    let beyond = (1..=(MARGIN / step).ceil() as usize).map(|ring| end + ring as f64 * step);
    [0.0].into_iter().chain((0..=last).map(at)).chain(beyond).collect()
}

/// Place and normal of the ground that lies `[north, east]` (m) of the eye; `None` outside the problem area.
fn vertex(landscape: &Landscape, eye: [f64; 3], [north, east]: [f64; 2]) -> Option<[[f32; 3]; 2]> {
    let point = landscape.at(eye[0] + north, eye[1] + east)?;
    let [to_north, to_east] = point.slopes;
    let single = |place: [f64; 3]| place.map(|part| part as f32);
    Some([single([north, east, point.height - eye[2]]), single([-to_north, -to_east, 1.0])])
}

#[cfg(test)]
mod tests {
    use landscape::{Attitude, Bank, Landscape, Level};
    use scenario::{FieldOfView, Pose};

    use super::{EyeMesh, Grading};

    /// A plane that rises a metre in ten to the north, 200 m across.
    fn slope() -> Landscape {
        let corner = |m: f64| {
            let mut words = [0.0; 9];
            (words[0], words[3]) = (10.0 * m, 10.0);
            words
        };
        let words = vec![corner(0.0), corner(0.0), corner(1.0), corner(1.0)];
        let level = Level::new(100.0, [0.0; 2], [2, 2], words).unwrap();
        Landscape::new(Bank::new("slope", vec![level], None).unwrap(), 1.0)
    }

    #[test]
    fn vertices_lie_on_the_ground_and_faces_close_around_the_eye() {
        let attitude = Attitude { heading: 0.3, ..Attitude::default() };
        let pose = Pose { time: 0.0, eye: [50.0, 50.0, 7.0], attitude, yoke: 0.0 };
        let field = FieldOfView { tan_half_width: 0.5, tan_half_height: 0.3 };
        let grading = Grading { meridians: 16, rings: 20, ranges: [1.0, 40.0] };
        let mesh = EyeMesh::new(&slope(), &pose, field, &grading);
        let used = || mesh.faces.iter().flatten().map(|&corner| mesh.vertices[corner as usize]);
        for [[north, _, up], normal] in used() {
            assert!((up - (5.0 + 0.1 * north - 7.0)).abs() < 1e-5, "{north} {up}");
            assert!((normal[0] + 0.1).abs() < 1e-6 && normal[1].abs() < 1e-6 && normal[2] == 1.0);
        }
        let reach = |axis: usize, sign: f32| used().map(|[place, _]| sign * place[axis]).fold(0.0, f32::max);
        // All around up to where the area ends, 50 m away.
        for (axis, sign) in [(0, 1.0), (0, -1.0), (1, 1.0), (1, -1.0)] {
            assert!((40.0..=50.0).contains(&reach(axis, sign)), "{axis} {sign}");
        }
        // Seen from above the faces cover the square around the eye once.
        let area: f32 =
            mesh.faces.iter().map(|face| area(face.map(|corner| mesh.vertices[corner as usize][0]))).sum();
        assert!((5000.0..10_000.0).contains(&area), "{area}");
    }

    /// Area of a face from above.
    fn area(corners: [[f32; 3]; 4]) -> f32 {
        let cross = |k: usize| {
            let [[ax, ay, _], [bx, by, _]] = [corners[k], corners[(k + 1) % 4]];
            ax * by - ay * bx
        };
        0.5 * (0..4).map(cross).sum::<f32>().abs()
    }
}
