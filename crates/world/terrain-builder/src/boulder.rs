//! Boulders: spheres, cubes and rocks, on the ground or partly in it.

use std::f64::consts::TAU;
use std::sync::Arc;

use glam::{DMat3, DVec3};
use quantities::{sin_cos, unit_interval};
use solids::{Body, Kind, Solid, SolidError};

use crate::draw::{Use, draw};
use crate::refused::{Refused, expect};

/// Share of a boulder's height below the ground unless the file says otherwise (chosen).
pub const USUAL_BURIAL: f64 = 0.25;
/// Faces of a rock unless the file says otherwise (chosen).
pub const USUAL_FACES: u32 = 14;
/// Corners of the polyhedron that stands for a sphere (chosen).
const SPHERE_CORNERS: u64 = 60;
/// Albedo of every face, relative to the ground's (chosen).
const ALBEDO: f64 = 1.0;
/// Names the use of a hash.
const ROCK: u64 = u64::from_be_bytes(*b"rockface");

/// Form of a boulder.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Shape {
    /// A sphere of the radius.
    Sphere,
    /// A cube whose side is the radius, as the document has it.
    Cube,
    /// A convex polyhedron of this many faces; its farthest corner lies one radius from its middle.
    Rock(u32),
}

/// A boulder and where it lies. Its height comes from the ground.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Boulder {
    at: [f64; 2],
    radius: f64,
    shape: Shape,
    burial: f64,
    seed: u64,
    number: u64,
}

impl Boulder {
    /// A boulder at a place (north, east; m). `burial` is the share of its height below the ground; `seed` and `number` turn it
    /// and form a rock.
    ///
    /// # Errors
    /// If the radius is not 0.001 m to 1e5 m, the burial not 0 to 0.9, or the faces not 4 to 64.
    pub fn new(
        at: [f64; 2],
        radius: f64,
        shape: Shape,
        burial: f64,
        [seed, number]: [u64; 2],
    ) -> Result<Self, Refused> {
        let is_length = (1e-3..=1e5).contains(&radius);
        expect(is_length, "radius_m", radius, "a length from 0.001 m to 1e5 m")?;
        expect((0.0..=0.9).contains(&burial), "burial", burial, "a share from 0 to 0.9")?;
        if let Shape::Rock(faces) = shape {
            expect((4..=64).contains(&faces), "faces", faces, "a whole number from 4 to 64")?;
        }
        Ok(Self { at, radius, shape, burial, seed, number })
    }

    /// Place of its middle: north, east (m).
    pub fn at(&self) -> [f64; 2] {
        self.at
    }

    /// Radius, or side of a cube (m).
    pub fn radius(&self) -> f64 {
        self.radius
    }

    /// Form of the boulder.
    pub fn shape(&self) -> Shape {
        self.shape
    }

    /// Share of its height below the ground.
    pub fn burial(&self) -> f64 {
        self.burial
    }

    /// Seed of its feature, and its number there: together they turn it and form a rock.
    pub fn seeds(&self) -> [u64; 2] {
        [self.seed, self.number]
    }

    /// Azimuth to which its forward axis is turned (rad), from the seed.
    pub fn yaw(&self) -> f64 {
        TAU * draw(self.seed, self.number, Use::Yaw, 0)
    }

    /// Lowest and highest point against its middle (m).
    ///
    /// # Errors
    /// If the faces of a rock do not close; no seed is known to do that.
    pub fn span(&self) -> Result<[f64; 2], SolidError> {
        let span = match self.shape {
            Shape::Sphere => [-1.0, 1.0],
            Shape::Cube => [-0.5, 0.5],
            Shape::Rock(faces) => span_of(&rock_corners(faces, self.rock_seed())?),
        };
        Ok(span.map(|height| height * self.radius))
    }

    /// Height of its middle above the ground (m) that buries its share of the height.
    ///
    /// # Errors
    /// As those of [`span`](Self::span).
    pub fn lift(&self) -> Result<f64, SolidError> {
        let [low, high] = self.span()?;
        Ok(-low - self.burial * (high - low))
    }

    /// The polyhedron, its origin in the middle (m).
    ///
    /// # Errors
    /// As those of [`span`](Self::span).
    fn corners(&self) -> Result<Vec<DVec3>, SolidError> {
        let corners = match self.shape {
            Shape::Sphere => directions(0, SPHERE_CORNERS, 0.0).collect(),
            Shape::Cube => cube_corners(),
            Shape::Rock(faces) => rock_corners(faces, self.rock_seed())?,
        };
        Ok(corners.into_iter().map(|corner| corner * self.radius).collect())
    }

    /// The boulder as a body of the polyhedron generator, on ground of a height (m). A sphere becomes a polyhedron of 60 corners
    /// on the sphere.
    ///
    /// # Errors
    /// As those of [`span`](Self::span).
    pub fn body(&self, object: u32, ground: f64) -> Result<Body, SolidError> {
        let lift = DVec3::Z * self.lift()?;
        let corners: Vec<_> = self.corners()?.into_iter().map(|corner| corner + lift).collect();
        let solid = Arc::new(Solid::hull(&corners, ALBEDO)?);
        let (sin, cos) = sin_cos(self.yaw());
        let turn = DMat3::from_cols(DVec3::new(cos, sin, 0.0), DVec3::new(-sin, cos, 0.0), DVec3::Z);
        let foot = DVec3::new(self.at[0], self.at[1], ground);
        Ok(Body::place(object, Kind::Rock, &solid, foot, &turn, 1.0))
    }

    fn rock_seed(&self) -> u64 {
        quantities::hash_words(self.seed, &[self.number, Use::Shape as u64])
    }
}

fn span_of(corners: &[DVec3]) -> [f64; 2] {
    let heights = corners.iter().map(|corner| corner.z);
    heights.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], z| [low.min(z), high.max(z)])
}

fn cube_corners() -> Vec<DVec3> {
    let half = |bit: u32| if bit == 0 { -0.5 } else { 0.5 };
    (0..8).map(|corner: u32| DVec3::new(half(corner & 1), half(corner & 2), half(corner & 4))).collect()
}

/// Unit vectors spread evenly (golden spiral), each moved by up to `stray`.
fn directions(seed: u64, count: u64, stray: f64) -> impl Iterator<Item = DVec3> {
    const GOLDEN_TURN: f64 = TAU * 0.381_966_011_250_105_1;
    (0..count).map(move |point| {
        let z = 1.0 - (2.0 * point as f64 + 1.0) / count as f64;
        let (sin, cos) = sin_cos(GOLDEN_TURN * point as f64);
        let across = (1.0 - z * z).sqrt();
        let moved = [0, 1, 2].map(|part| stray * (2.0 * unit_interval(seed, &[ROCK, point, part]) - 1.0));
        (DVec3::new(across * cos, across * sin, z) + DVec3::from_array(moved)).normalize()
    })
}

/// Corners of a polyhedron with exactly `faces` faces: the polar body of as many points on a sphere, of which none lies inside the
/// others' hull, then squashed. The farthest corner is 1 from the origin.
fn rock_corners(faces: u32, seed: u64) -> Result<Vec<DVec3>, SolidError> {
    let stray = 0.9 / f64::from(faces).sqrt();
    let points: Vec<_> = directions(seed, faces.into(), stray).collect();
    let hull = Solid::hull(&points, ALBEDO)?;
    let squash = DVec3::from_array(
        [0, 1, 2]
            .map(|part| 1.0 - 0.15 * f64::from(part as u32) * unit_interval(seed, &[ROCK, u64::MAX, part])),
    );
    let polar = hull.faces().iter().map(|face| {
        let distance = face.normal.dot(hull.vertices()[face.corners[0] as usize]);
        face.normal / distance * squash
    });
    let corners: Vec<_> = polar.collect();
    let farthest = corners.iter().map(|corner| corner.length()).fold(0.0, f64::max);
    Ok(corners.into_iter().map(|corner| corner / farthest).collect())
}
