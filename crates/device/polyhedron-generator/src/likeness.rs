//! A body as the eye sees it: vertices on the picture and faces that look at the eye, eight side by side.

use std::ops::Range;

use fearless_simd::prelude::{Select, SimdMask};
use fearless_simd::{Level, Simd, SimdBase, dispatch, f64x8};
use glam::{DMat3, DVec3};
use signal::{LANES, Number, eight};
use solids::{Body, EightFaces, Eights};

use crate::face::Corner;
use crate::light::Returned;
use crate::view::{Place, Sighting, project};
use crate::{FaceLight, NEAREST};

/// Buffers that are kept from body to body.
#[derive(Debug, Default)]
pub(crate) struct Likeness {
    /// Vertices on the picture in groups of eight: x, y, inverse depth and spread of each, as a [`Corner`] has them.
    pub corners: Vec<[[f64; 4]; LANES]>,
    /// Tangent of a sweep through each, eight side by side; the last one stands in for those that are not there.
    across: Vec<[f64; LANES]>,
    /// Whether all of them are in it, as far as up and down go.
    pub is_inside: bool,
    /// Reflectivity of each face, [`UNSEEN`] of those that do not look at the eye.
    pub faces: Vec<f32>,
    /// The first faces that look at the eye, a bit each.
    pub seen: u64,
}

/// Reflectivity of a face that nobody sees: no other is negative.
pub(crate) const UNSEEN: f32 = -1.0;

/// What a body is seen by.
#[derive(Debug)]
pub(crate) struct Eye<'a> {
    pub sighting: &'a Sighting,
    pub vectors: Level,
    pub light: &'a FaceLight,
    /// Where it stands, for this body: north, east, up (m).
    pub place: DVec3,
    /// Half the height of the picture on the view-plane.
    pub half_height: f64,
}

impl Likeness {
    /// A vertex on the picture, before sweeps at ascending `tangents`.
    pub fn corner(&self, number: u32, tangents: &[f64]) -> Corner {
        let [x, y, depth, spread] = self.corners.as_flattened()[number as usize];
        let across = self.across.as_flattened()[number as usize];
        let sweep = tangents.partition_point(|&tangent| tangent < across) as u32;
        Corner { place: Place { x, y, depth }, spread, sweep, light: 0.0 }
    }

    /// Which of the sweeps at ascending `tangents` pass between the leftmost and the rightmost corner.
    #[inline(always)]
    pub fn sweeps<V: Simd>(&self, simd: V, tangents: &[f64]) -> Range<usize> {
        let [mut low, mut high] = [f64x8::splat(simd, f64::INFINITY), f64x8::splat(simd, f64::NEG_INFINITY)];
        for across in &self.across {
            let across = eight(simd, across);
            (low, high) = (low.min(across), high.max(across));
        }
        let first = |across| tangents.partition_point(|&tangent| tangent < across);
        first(low.reduce_min())..first(high.reduce_max())
    }

    /// The first corners that lie to the left of a sweep at a tangent, or on it: a bit each.
    #[inline(always)]
    pub fn left_of<V: Simd>(&self, simd: V, tangent: f64) -> u32 {
        let mut left = 0;
        for across in self.across.iter().rev() {
            left = left << LANES | eight(simd, across).simd_le(tangent).to_bitmask() as u32;
        }
        left
    }

    /// Takes that of a body, black if it is `dark`; false if a vertex is too near.
    pub fn take(&mut self, eye: &Eye<'_>, body: &Body, dark: bool) -> bool {
        dispatch!(eye.vectors, simd => self.take_by(simd, eye, body, dark))
    }

    #[inline(always)]
    fn take_by<V: Simd>(&mut self, simd: V, eye: &Eye<'_>, body: &Body, dark: bool) -> bool {
        self.corners.clear();
        self.across.clear();
        self.faces.clear();
        (self.is_inside, self.seen) = (true, 0);
        let (turn, scale) = body.to_ground();
        let Eights { vertices, faces } = body.solid.eights();
        for vertices in vertices {
            let places = [body.foot, DVec3::splat(scale)];
            if !self.project(simd, eye, places, &turn, vertices) {
                return false;
            }
        }
        // Where the eye is for the solid.
        let at = turn.transpose() * (eye.place - body.foot) / scale;
        let turned = |normals| turned(&turn, normals);
        match Returned::new(body, eye.place) {
            _ if dark => self.find_all(simd, at, faces, |_, albedo| albedo.like(0.0)),
            None => {
                self.find_all(simd, at, faces, |normals, albedo| eye.light.diffuse(turned(normals), albedo))
            }
            Some(returned) => self.find_all(simd, at, faces, |normals, albedo| {
                eye.light.reflectivity(turned(normals), albedo, &returned)
            }),
        }
        true
    }

    /// Projects eight vertices in body axes.
    #[inline(always)]
    fn project<V: Simd>(
        &mut self,
        simd: V,
        eye: &Eye<'_>,
        [foot, scale]: [DVec3; 2],
        turn: &DMat3,
        vertices: &[[f64; LANES]; 3],
    ) -> bool {
        let scale = eight(simd, &[scale.x; LANES]);
        let [x, y, z] = [eight(simd, &vertices[0]), eight(simd, &vertices[1]), eight(simd, &vertices[2])];
        let [north, east, up] = turned(turn, [x * scale, y * scale, z * scale]);
        let [north, east, up] = [x.like(foot.x) + north, x.like(foot.y) + east, x.like(foot.z) + up];
        let [from_north, from_east, from_up] =
            [north - x.like(eye.place.x), east - x.like(eye.place.y), up - x.like(eye.place.z)];
        let ahead = eye.sighting.turn([from_north, from_east, from_up]);
        if ahead[0].simd_le(x.like(NEAREST)).any_true() {
            return false;
        }
        let place = project(ahead);
        let half_height = x.like(eye.half_height);
        self.is_inside &= !(half_height.simd_lt(place.y) | place.y.simd_lt(-half_height)).any_true();
        let spread = eye.sighting.spread(place.y);
        self.across.push((place.x / spread).to_array());
        self.corners.push(rows([place.x, place.y, place.depth, spread]));
        true
    }

    /// Which faces look at the eye, which is at `at` for the solid, with their reflectivities by normals in body axes and albedos.
    #[inline(always)]
    fn find_all<V: Simd>(
        &mut self,
        simd: V,
        at: DVec3,
        faces: &[EightFaces],
        lit: impl Fn([f64x8<V>; 3], f64x8<V>) -> f64x8<V>,
    ) {
        faces.iter().for_each(|eight| self.find_seen(simd, at, eight, &lit));
    }

    /// The same of eight faces.
    #[inline(always)]
    fn find_seen<V: Simd>(
        &mut self,
        simd: V,
        at: DVec3,
        faces: &EightFaces,
        lit: &impl Fn([f64x8<V>; 3], f64x8<V>) -> f64x8<V>,
    ) {
        let [x, y, z] = &faces.normals;
        let normals = [eight(simd, x), eight(simd, y), eight(simd, z)];
        let distance = eight(simd, &faces.distances);
        let from_foot = normals[0] * distance.like(at.x)
            + normals[1] * distance.like(at.y)
            + normals[2] * distance.like(at.z);
        let is_seen = from_foot.simd_gt(distance);
        let first = self.faces.len() as u32;
        self.seen |= is_seen.to_bitmask().checked_shl(first).unwrap_or(0);
        let lit = lit(normals, eight(simd, &faces.albedos));
        let lit = is_seen.select(lit, lit.like(f64::from(UNSEEN))).to_array();
        let mut faces = [0.0; LANES];
        for n in 0..LANES {
            faces[n] = lit[n] as f32;
        }
        self.faces.extend_from_slice(&faces);
    }
}

/// Four numbers of eight corners, corner by corner.
#[inline(always)]
fn rows<V: Simd>([x, y, depth, spread]: [f64x8<V>; 4]) -> [[f64; 4]; LANES] {
    let (first, others) = (x.interleave(depth), y.interleave(spread));
    let (low, high) = (first.0.interleave(others.0), first.1.interleave(others.1));
    let mut rows = [[0.0; 4]; LANES];
    for (two, row) in
        [low.0, low.1, high.0, high.1].iter().zip(rows.as_flattened_mut().chunks_exact_mut(LANES))
    {
        two.store_slice(row);
    }
    rows
}

/// `turn` times a vector, in the order of the plain product.
#[inline(always)]
fn turned<V: Simd>(turn: &DMat3, [x, y, z]: [f64x8<V>; 3]) -> [f64x8<V>; 3] {
    let (along, across, up) = (turn.x_axis, turn.y_axis, turn.z_axis);
    [
        x.like(along.x) * x + x.like(across.x) * y + x.like(up.x) * z,
        x.like(along.y) * x + x.like(across.y) * y + x.like(up.y) * z,
        x.like(along.z) * x + x.like(across.z) * y + x.like(up.z) * z,
    ]
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use fearless_simd::{Level, dispatch};
    use glam::{DMat3, DVec3, EulerRot};
    use photometry::Photometry;
    use proptest::prelude::{prop_assert_eq, proptest};
    use scenario::{BodyShading, Curvature, Projection};
    use solids::{Body, Kind, rocks};

    use super::{Eye, Likeness, UNSEEN};
    use crate::face::{Corner, Crossing, sweeps_of};
    use crate::view::{Sighting, project};
    use crate::{FaceLight, NEAREST, ViewPlane};

    proptest! {
        /// To the bit: rocks ahead, beside, behind and about the eye, upright and tumbled.
        #[test]
        fn eight_side_by_side_are_what_each_is_alone(
            shape in 0..rocks::SHAPES,
            foot in [-3.0..30.0f64, -9.0..9.0, -2.0..2.0],
            turns in [-3.0..3.0f64, -3.0..3.0, -3.0..3.0],
            (is_upright, is_dark, is_straight) in proptest::prelude::any::<(bool, bool, bool)>(),
            scale in 0.1..4.0f64,
            sweeps in 0..60i32,
            [heading, pitch] in [-0.5..0.5f64, -0.5..0.5],
            law in 0..3usize,
        ) {
            let gloss = Photometry::Specular { strength: 3.0, exponent: 5 };
            let law = [Photometry::Lambert, Photometry::LunarLambert, gloss][law];
            let solid = Arc::new(rocks::shapes(7).unwrap().swap_remove(shape).reflecting(law));
            let turn = match is_upright {
                true => DMat3::from_rotation_z(turns[0]),
                false => DMat3::from_euler(EulerRot::ZYX, turns[0], turns[1], turns[2]),
            };
            let body = Body::place(1, Kind::Rock, &solid, DVec3::from_array(foot), &turn, scale);
            let sighting = Sighting::new(&ViewPlane {
                eye: [0.0; 3],
                heading,
                pitch,
                projection: if is_straight { Projection::Exact } else { Projection::Corrected },
                curvature: Curvature::None,
                tan_half_height: 0.3,
                lines: 500.0,
            });
            let (light, place) = (FaceLight { sun: DVec3::new(-0.6, 0.48, 0.64), shading: BodyShading::Flat }, DVec3::new(0.1, 0.2, 1.5));
            let tangents: Vec<f64> = (0..sweeps).map(|sweep| 0.02 * f64::from(sweep) - 0.6).collect();

            let vertices: Vec<DVec3> = body.vertices().collect();
            let ahead = |vertex: &DVec3| sighting.turn((*vertex - place).to_array());
            let corner = |vertex: &DVec3| {
                Corner::new(Crossing { place: project(ahead(vertex)), light: 0.0 }, &sighting, &tangents)
            };
            let corners: Vec<Corner> = vertices.iter().map(corner).collect();
            let is_inside = corners.iter().all(|corner| corner.place.y.abs() <= 0.3);
            let is_near = vertices.iter().any(|vertex| ahead(vertex)[0] <= NEAREST);
            let faces = body.solid.faces().iter().zip(body.normals()).map(|(face, normal)| {
                let to_eye = (place - body.centre).normalize();
                let cosines = [normal.dot(light.sun), normal.dot(to_eye), light.sun.dot(to_eye)];
                let lit = if is_dark { 0.0 } else { law.returned(face.albedo, cosines) };
                let faces_eye = normal.dot(place - vertices[face.corners[0] as usize]) > 0.0;
                if faces_eye { lit as f32 } else { UNSEEN }
            });
            let faces: Vec<f32> = faces.collect();
            for vectors in [Level::new(), Level::baseline()] {
                let eye = Eye { sighting: &sighting, vectors, light: &light, place, half_height: 0.3 };
                let mut likeness = Likeness::default();
                prop_assert_eq!(likeness.take(&eye, &body, is_dark), !is_near);
                if !is_near {
                    let found = (0..corners.len() as u32).map(|number| likeness.corner(number, &tangents));
                    prop_assert_eq!(&found.collect::<Vec<_>>(), &corners);
                    let reach = sweeps_of(corners.iter().map(|corner| corner.sweep));
                    let found = dispatch!(vectors, simd => likeness.sweeps(simd, &tangents));
                    prop_assert_eq!(found, reach.start as usize..reach.end as usize);
                    for (sweep, &tangent) in tangents.iter().enumerate() {
                        let left = corners.iter().rev().fold(0, |left, corner| left << 1 | u32::from(corner.sweep <= sweep as u32));
                        let found = dispatch!(vectors, simd => likeness.left_of(simd, tangent));
                        prop_assert_eq!(found & ((1 << corners.len()) - 1), left);
                    }
                    prop_assert_eq!(likeness.is_inside, is_inside);
                    prop_assert_eq!(&likeness.faces[..faces.len()], &faces);
                    let seen = faces.iter().rev().fold(0, |seen, face| seen << 1 | u64::from(*face != UNSEEN));
                    prop_assert_eq!(likeness.seen, seen);
                }
            }
        }
    }
}
