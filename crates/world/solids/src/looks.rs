//! What a shape may have beside plane faces of one albedo: colours, normals at its corners, a law of reflection.

use glam::DVec3;
use photometry::Photometry;
use quantities::{intensity, is_grey};

use crate::{Eights, Face, Solid, SolidError};

/// Normals this near (cosine) to that of their face are its own: files round them.
const FLAT: f64 = 1.0 - 1e-6;

impl Solid {
    /// The same in a colour: linear red, green and blue, 0..=1 each, which multiply the albedo of every face. Generators
    /// without colour draw its luminance.
    ///
    /// # Errors
    /// If a channel is not 0 to 1.
    pub fn coloured(self, colour: [f64; 3]) -> Result<Self, SolidError> {
        self.with_colours(|_| colour)
    }

    /// The same with a colour for each face, by its number.
    ///
    /// # Errors
    /// As [`coloured`](Self::coloured).
    pub fn with_colours(mut self, colour: impl Fn(usize) -> [f64; 3]) -> Result<Self, SolidError> {
        let mut colours = Vec::with_capacity(self.faces.len());
        for face in 0..self.faces.len() {
            let own = colour(face);
            if let Some(&albedo) = own.iter().find(|channel| !(0.0..=1.0).contains(*channel)) {
                return Err(SolidError::BadAlbedo { face, albedo });
            }
            let albedo = self.albedo(face);
            colours.push(std::array::from_fn(|channel| albedo[channel] * own[channel]));
        }
        for (face, colour) in self.faces.iter_mut().zip(&colours) {
            face.albedo = intensity(*colour).min(1.0);
        }
        let is_colourful = colours.iter().any(|colour| !is_grey(*colour));
        self.colours = is_colourful.then(|| colours.into());
        self.eights = Eights::new(&self.vertices, &self.faces);
        Ok(self)
    }

    /// Whether a face has a colour.
    pub fn is_colourful(&self) -> bool {
        self.colours.is_some()
    }

    /// Albedo of a face for red, green and blue light, 0..=1.
    pub fn albedo(&self, face: usize) -> [f64; 3] {
        self.colours.as_ref().map_or([self.faces[face].albedo; 3], |colours| colours[face])
    }

    /// The same whose faces return light by `photometry`; Lambert's law is that of every new solid.
    pub fn reflecting(mut self, photometry: Photometry) -> Self {
        self.photometry = photometry;
        self
    }

    /// How its faces return light.
    pub fn photometry(&self) -> Photometry {
        self.photometry
    }

    /// The same with normals at its corners, for smooth light: `normal` has that of a corner (index of a vertex) of a face, of any
    /// length, outwards. A corner has the normal of its face if it has none of its own, or one without a direction, or one that
    /// lies in the face or behind it: such a normal says nothing about this side of the face.
    pub fn with_normals(mut self, normal: impl Fn(usize, u32) -> Option<DVec3>) -> Self {
        let of_face = |(number, face): (usize, &Face)| -> Vec<DVec3> {
            let own = |&corner: &u32| normal(number, corner)?.try_normalize();
            let outwards = |unit: &DVec3| unit.dot(face.normal) > 0.0;
            face.corners.iter().map(|corner| own(corner).filter(outwards).unwrap_or(face.normal)).collect()
        };
        let normals: Vec<_> = self.faces.iter().enumerate().map(of_face).collect();
        let is_flat = |(face, own): (&Face, &Vec<DVec3>)| own.iter().all(|n| n.dot(face.normal) > FLAT);
        let is_smooth = !self.faces.iter().zip(&normals).all(is_flat);
        self.normals = is_smooth.then(|| normals.into());
        self
    }

    /// The same with a normal at each vertex, the mean of those of its faces in equal parts; a solid that has normals keeps them.
    pub fn rounded(&self) -> Self {
        if self.is_smooth() {
            return self.clone();
        }
        let mut sums = vec![DVec3::ZERO; self.vertices.len()];
        for Face { corners, normal, .. } in &self.faces {
            corners.iter().for_each(|corner| sums[*corner as usize] += *normal);
        }
        self.clone().with_normals(|_, corner| Some(sums[corner as usize]))
    }

    /// Unit normals at the corners of a face (body axes), in their order; none of a solid whose light is flat.
    pub fn corner_normals(&self, face: usize) -> Option<&[DVec3]> {
        self.normals.as_ref().map(|normals| normals[face].as_slice())
    }

    /// Whether its light follows normals at its corners.
    pub fn is_smooth(&self) -> bool {
        self.normals.is_some()
    }

    /// Unit normal at a place of a face (body axes; m). A flat solid has the normal of the face there. A smooth one mixes the
    /// normals of the corners in proportion, over the triangles from the first corner.
    pub fn normal_at(&self, face: usize, place: DVec3) -> DVec3 {
        let flat = self.faces[face].normal;
        let Some(normals) = &self.normals else { return flat };
        let (corners, normals) = (&self.faces[face].corners, &normals[face]);
        let at = |k: usize| self.vertices[corners[k] as usize];
        let mut best = (f64::NEG_INFINITY, flat);
        for k in 1..corners.len() - 1 {
            let shares = shares([at(0), at(k), at(k + 1)], flat, place);
            let least = shares.into_iter().fold(f64::INFINITY, f64::min);
            if least > best.0 {
                let [a, b, c] = shares.map(|share| share.max(0.0));
                best = (least, normals[0] * a + normals[k] * b + normals[k + 1] * c);
            }
        }
        best.1.try_normalize().unwrap_or(flat)
    }
}

/// Shares of the corners of a triangle at a place in its plane; one is negative outside.
fn shares([a, b, c]: [DVec3; 3], normal: DVec3, place: DVec3) -> [f64; 3] {
    let area = |a: DVec3, b: DVec3, c: DVec3| normal.dot((b - a).cross(c - a));
    let whole = area(a, b, c);
    [area(place, b, c), area(a, place, c), area(a, b, place)].map(|part| part / whole)
}

#[cfg(test)]
mod tests {
    use crate::{Solid, SolidError};
    use glam::DVec3;
    use photometry::Photometry;

    fn cube() -> Solid {
        Solid::boxed(-DVec3::ONE, DVec3::ONE, 0.5).unwrap()
    }

    #[test]
    fn a_colour_multiplies_the_albedo_and_its_luminance_is_the_face_s() {
        let red = cube().coloured([1.0, 0.5, 0.0]).unwrap();
        assert!(red.is_colourful() && red.albedo(3) == [0.5, 0.25, 0.0]);
        assert!((red.faces()[3].albedo - (0.2126 * 0.5 + 0.7152 * 0.25)).abs() < 1e-15);
        let grey = cube().coloured([0.25; 3]).unwrap();
        assert!(!grey.is_colourful() && grey == cube().painted(|_| 0.125).unwrap());
        assert!(matches!(cube().coloured([0.0, 2.0, 0.0]), Err(SolidError::BadAlbedo { .. })));
    }

    /// The corners of a cube as normals: at the middle of a face they sum to its own.
    #[test]
    fn normals_are_mixed_between_corners() {
        let places = cube().vertices().to_vec();
        let round = cube().with_normals(|_, corner| Some(places[corner as usize]));
        assert!(round.is_smooth());
        for (number, face) in round.faces().iter().enumerate() {
            for &corner in &face.corners {
                let place = places[corner as usize];
                assert!(round.normal_at(number, place).distance(place.normalize()) < 1e-15);
            }
            assert!(round.normal_at(number, face.normal).distance(face.normal) < 1e-15);
        }
    }

    /// What was written before there were laws of bodies is written so still.
    #[test]
    fn a_law_of_reflection_shows_in_its_text_where_it_is_not_lamberts() {
        let gloss = Photometry::Specular { strength: 2.0, exponent: 20 };
        let (plain, shining) = (cube(), cube().reflecting(gloss));
        assert_eq!((plain.photometry(), shining.photometry()), (Photometry::Lambert, gloss));
        assert!(
            !format!("{plain:?}").contains("photometry")
                && format!("{shining:?}").contains("photometry: Specular")
        );
        assert!(plain != shining && shining.rounded().photometry() == gloss);
    }

    #[test]
    fn a_rounded_cube_has_the_mean_of_three_faces_at_each_corner() {
        let round = cube().rounded();
        for (number, face) in round.faces().iter().enumerate() {
            for (corner, normal) in face.corners.iter().zip(round.corner_normals(number).unwrap()) {
                let expected = round.vertices()[*corner as usize].normalize();
                assert!((*normal - expected).length() < 1e-15, "{normal}");
            }
        }
        // One that has normals keeps them.
        let places = cube().vertices().to_vec();
        let own = cube().with_normals(|_, corner| Some(places[corner as usize] + DVec3::X * 0.5));
        assert_eq!(own.rounded(), own);
        assert!(cube().corner_normals(0).is_none());
    }

    #[test]
    fn normals_that_say_nothing_leave_those_of_faces() {
        let places = cube().vertices().to_vec();
        let normals = cube().faces().iter().map(|face| face.normal).collect::<Vec<_>>();
        let of_faces = cube().with_normals(|face, _| Some(3.0 * normals[face]));
        let inwards = cube().with_normals(|_, corner| Some(-places[corner as usize]));
        let across = cube().with_normals(|face, _| Some(normals[face].any_orthogonal_vector()));
        let nowhere = [DVec3::ZERO, DVec3::NAN, DVec3::INFINITY, DVec3::splat(1e-300)]
            .map(|nowhere| cube().with_normals(|_, _| Some(nowhere)));
        for flat in [of_faces, inwards, across].iter().chain(&nowhere) {
            assert!(!flat.is_smooth() && *flat == cube());
        }
        // One corner without a normal of its own: the others keep theirs.
        let mixed = cube().with_normals(|_, corner| (corner > 0).then(|| places[corner as usize]));
        let face = mixed.faces().iter().position(|face| face.corners.contains(&0)).unwrap();
        assert_eq!(mixed.normal_at(face, places[0]), normals[face]);
        let other = *mixed.faces()[face].corners.iter().find(|&&corner| corner > 0).unwrap() as usize;
        assert!(mixed.normal_at(face, places[other]).distance(places[other].normalize()) < 1e-15);
    }
}
