//! Shadows of bodies on the ground.

use glam::DVec3;
use landscape::Sun;
use solids::Body;

use crate::Outlines;
use crate::axes::SunAxes;
use crate::bank::ShadowBank;
use crate::ground::GroundSheets;

/// Length of outline over which the ground is taken to be flat (m): a longer edge is cut into pieces.
const FLAT: f64 = 0.5;
/// Most pieces of an edge.
const MOST_PIECES: usize = 6;
/// Farthest that a shadow is followed over the ground (m).
const LONGEST: f64 = 5000.0;
/// Steepest rise of ground towards a ray at which no piece of ground is stepped over.
const STEEPEST: f64 = 1.0;
/// Smallest step along the ground (m).
const SMALLEST_STEP: f64 = 0.02;
/// Error that ends the search for the ground (m).
const NEAR_ENOUGH: f64 = 1e-5;
/// Most steps of that search.
const MOST_STEPS: u32 = 40;

impl ShadowBank {
    /// Outline of the shadow that `body` casts on the ground under `sun`, clockwise.
    ///
    /// The outline is that of what stands above the ground, seen from the sun; each of its points is followed along the
    /// ray to the ground, for 5 km at most or to the end of the ground. So the side of the outline that faces the sun
    /// lies where the body enters the ground. Nothing for a sun that is not above the horizon.
    pub fn cast_by_body(&self, body: &Body, sun: &Sun) -> Outlines {
        if sun.direction()[2] <= 0.0 {
            return Outlines::default();
        }
        let axes = SunAxes::new(sun);
        let hull = outline(&axes, &above_ground(body, self.ground()));
        let next = hull.iter().cycle().skip(1);
        let edges = hull.iter().zip(next);
        let points = edges.flat_map(|(&a, &b)| {
            let pieces = ((a.distance(b) / FLAT).ceil() as usize).clamp(1, MOST_PIECES);
            (0..pieces).map(move |k| a.lerp(b, k as f64 / pieces as f64))
        });
        let corners: Vec<[f64; 2]> = points.map(|point| fall(self.ground(), &axes, point)).collect();
        Outlines::closed(&corners)
    }
}

/// Vertices above the ground, and the places where edges enter it: what casts a shadow on the ground.
fn above_ground(body: &Body, ground: &GroundSheets) -> Vec<DVec3> {
    let clearance = |vertex: &DVec3| {
        let height = ground.height([vertex.x, vertex.y]);
        height.map_or(f64::NEG_INFINITY, |height| vertex.z - height)
    };
    let vertices: Vec<DVec3> = body.vertices().collect();
    let above: Vec<f64> = vertices.iter().map(clearance).collect();
    let mut points: Vec<DVec3> =
        vertices.iter().zip(&above).filter(|(_, above)| **above >= 0.0).map(|(v, _)| *v).collect();
    for face in body.solid.faces() {
        let next = face.corners.iter().cycle().skip(1);
        for (&a, &b) in face.corners.iter().zip(next) {
            let (from, to) = (above[a as usize], above[b as usize]);
            // Each edge belongs to two faces, once in either direction.
            if from > 0.0 && to < 0.0 && to.is_finite() {
                let (a, b) = (vertices[a as usize], vertices[b as usize]);
                points.push(a.lerp(b, from / (from - to)));
            }
        }
    }
    points
}

/// Vertices on the convex outline as the sun sees it, in the order that is clockwise on the ground (monotone chain).
fn outline(axes: &SunAxes, vertices: &[DVec3]) -> Vec<DVec3> {
    let mut points: Vec<([f64; 2], DVec3)> = vertices.iter().map(|&v| (seen(axes, v), v)).collect();
    points.sort_by(|a, b| a.0[0].total_cmp(&b.0[0]).then(a.0[1].total_cmp(&b.0[1])));
    let mut hull = half(points.iter());
    hull.extend(half(points.iter().rev()));
    hull
}

/// One side of the outline, without its last point.
fn half<'a>(points: impl Iterator<Item = &'a ([f64; 2], DVec3)>) -> Vec<DVec3> {
    let mut chain: Vec<&([f64; 2], DVec3)> = Vec::new();
    for point in points {
        while let [.., a, b] = chain[..]
            && turn(a.0, b.0, point.0) <= 0.0
        {
            chain.pop();
        }
        chain.push(point);
    }
    chain.pop();
    chain.into_iter().map(|point| point.1).collect()
}

fn turn(a: [f64; 2], b: [f64; 2], c: [f64; 2]) -> f64 {
    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
}

/// Place in the plane square to the sun: across, and away from it along the ground.
fn seen(axes: &SunAxes, v: DVec3) -> [f64; 2] {
    let [p, q] = axes.to_sun_axes([v.x, v.y]);
    [p, v.z * axes.cos + q * axes.sin]
}

/// Where the ray from the sun through `point` meets the ground: north, east (m).
fn fall(ground: &GroundSheets, axes: &SunAxes, point: DVec3) -> [f64; 2] {
    let along = |way: f64| [point.x + way * axes.away()[0], point.y + way * axes.away()[1]];
    if axes.cos <= 0.0 {
        return along(0.0);
    }
    let tan = axes.sin / axes.cos;
    let clearance = |way: f64| Some(point.z - way * tan - ground.height(along(way))?);
    let (mut low, mut way) = ([0.0; 2], 0.0);
    while let Some(above) = clearance(way).filter(|_| way < LONGEST) {
        if above <= 0.0 {
            return along(meeting(clearance, low, [way, above]));
        }
        low = [way, above];
        way += (above / (tan + STEEPEST)).max(SMALLEST_STEP);
    }
    along(low[0])
}

/// Root between a way with clearance above 0 and one with clearance of at most 0: false position, the end that stays
/// counting half (Illinois).
fn meeting(clearance: impl Fn(f64) -> Option<f64>, mut low: [f64; 2], mut high: [f64; 2]) -> f64 {
    for _ in 0..MOST_STEPS {
        if high[0] - low[0] <= NEAR_ENOUGH {
            break;
        }
        let way = low[0] + (high[0] - low[0]) * low[1] / (low[1] - high[1]);
        let Some(above) = clearance(way) else { break };
        if above.abs() <= NEAR_ENOUGH {
            return way;
        }
        if above > 0.0 {
            (low, high[1]) = ([way, above], 0.5 * high[1]);
        } else {
            (high, low[1]) = ([way, above], 0.5 * low[1]);
        }
    }
    high[0]
}
