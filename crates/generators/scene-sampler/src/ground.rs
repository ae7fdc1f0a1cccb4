//! The ground of a frame, as the generator that draws it made it.

use generator::Label;
use raster::{Clipper, Screen, Seen};
use rayon::prelude::*;

use crate::camera::Camera;
use crate::faces::{Corner, Face, FaceError, Faces, NEAR, Paint, Sides};
use crate::ground_map::GroundMap;

/// Triangles that a thread clips at a time. Chosen: the order of the list does not depend on it.
const CHUNK: usize = 1024;

/// Chunks that are clipped before they are put into the list. Chosen: few enough that they take little memory.
const CHUNKS: usize = 32;

/// Ground as triangles, seen from above.
#[derive(Debug)]
pub struct Ground<'a> {
    /// Its vertices. One that is no place must belong to no triangle.
    pub corners: Vec<Corner>,
    /// Numbers of the corners of each triangle, counter-clockwise seen from above.
    pub triangles: &'a [[u32; 3]],
    /// Colours that are looked up pixel by pixel instead of those of the corners.
    pub map: Option<GroundMap>,
}

impl Ground<'_> {
    /// The first faces of a frame: the ground's. Numbers of their corners are those of the ground's vertices.
    ///
    /// # Errors
    /// If a corner is no number, or so near that the raster cannot hold it.
    pub(crate) fn faces(self, camera: &Camera, screen: &Screen) -> Result<Faces, FaceError> {
        let mut all = Faces::default();
        let id = all.number(Label::Terrain);
        let is_mapped = self.map.is_some();
        let clipper = Clipper::new(&camera.projection, screen, NEAR);
        // Six triangles share a corner: each is projected once.
        let seen: Vec<Seen> = self.corners.par_iter().map(|corner| clipper.seen(corner.place)).collect();
        let clipped = |triangles: &[[u32; 3]]| {
            let mut faces = Faces::default();
            for triangle in triangles {
                let places = triangle.map(|corner| self.corners[corner as usize].place);
                let face = Face { corners: places, id, priority: 0, sides: Sides::Front };
                let paint = if is_mapped { Paint::Mapped(*triangle) } else { Paint::Corners(*triangle) };
                match Seen::whole(triangle.map(|corner| seen[corner as usize])) {
                    Some(corners) => faces.add_whole(&face, paint, camera, corners),
                    None => faces.add(&face, paint, camera, screen)?,
                }
            }
            Ok(faces)
        };
        all.reserve(self.triangles.len());
        // While chunks are clipped, those before them are put into the list.
        let mut before = Vec::new();
        for triangles in self.triangles.chunks(CHUNKS * CHUNK) {
            let (parts, ()) = rayon::join(
                || triangles.par_chunks(CHUNK).map(clipped).collect::<Result<Vec<Faces>, FaceError>>(),
                || before.drain(..).for_each(|part| all.append(part)),
            );
            before = parts?;
        }
        before.into_iter().for_each(|part| all.append(part));
        all.corners = self.corners;
        Ok(all)
    }
}
