//! What a frame shows: faces, lights and discs of the sky, gathered from the stage.

use generator::{FrameError, Label, Stage};
use glam::DVec3;
use ground_mesh::body_triangles;
use landscape::Photometry;
use raster::Screen;
use scenario::{Effects, LightPoint, Medium, Overlay, Sheet, SkyDisc};
use solids::{Body, Kind};
use translucency::{Feature, FeatureError};

use crate::camera::Camera;
use crate::faces::{Face, FaceError, Faces, Paint, Sides};
use crate::ground::Ground;
use crate::ground_map::GroundMap;
use crate::lights::{Lights, Optics, Point};
use crate::parameters::Parameters;

/// Everything of one frame, ready for the sub-areas.
pub struct Scene {
    /// The camera of the pose.
    pub camera: Camera,
    /// Triangles of all surfaces.
    pub faces: Faces,
    /// Sheets of dust, as their faces number them, with the numbers of their features.
    pub dust: Vec<(Sheet, u32)>,
    /// Light points, near to far.
    pub lights: Lights,
    /// Discs of the sky, the nearer first, with the numbers of their features.
    pub discs: Vec<(SkyDisc, u32)>,
    /// Colours of the ground, where they are looked up pixel by pixel.
    pub ground_map: Option<GroundMap>,
}

/// Priority of the nearest disc of the sky over stars, which are as far. Chosen.
pub const DISC_PRIORITY: i32 = 1000;

/// Distance (m) of the plane on which overlays lie: any would do.
const OVERLAY_DEPTH: f64 = 1.0;

impl Scene {
    /// Gathers frame `frame` at `time` (s), seen by `camera`, with its ground.
    ///
    /// # Errors If a corner is no number.
    pub fn new(
        stage: &Stage,
        run: &Parameters,
        screen: &Screen,
        camera: Camera,
        ground: Ground<'_>,
        (frame, time): (u64, f64),
    ) -> Result<Self, FrameError> {
        let refused = |reason: String| FrameError::Refused { frame, reason };
        let of_face = |error: FaceError| refused(error.to_string());
        let ground_map = ground.map.clone();
        let faces = ground.faces(&camera, screen).map_err(of_face)?;
        let mut gathering = Gathering { stage, screen, camera, faces, dust: Vec::new() };
        gathering.bodies(time).map_err(of_face)?;
        let effects = by_number(stage.scenery.effects(time));
        gathering.sheets(&effects.sheets).map_err(of_face)?;
        gathering.overlays(&effects.overlays).map_err(of_face)?;
        let Gathering { camera, mut faces, dust, .. } = gathering;
        let discs = effects.discs.iter().map(|disc| (*disc, faces.number(Label::Silhouette))).collect();
        let optics = Optics::new(run).map_err(|error| refused(error.to_string()))?;
        let point =
            |light: &LightPoint| Point::new(light, faces.number(Label::Light), &camera, screen, &optics);
        let points: Result<Vec<Option<Point>>, FeatureError> = effects.lights.iter().map(point).collect();
        let points = points.map_err(|error| refused(error.to_string()))?.into_iter().flatten().collect();
        Ok(Self { camera, faces, dust, lights: Lights::new(points, screen), discs, ground_map })
    }
}

/// Effects in the order of their numbers in the mission, so that features equally near do not depend on the order of the lists.
fn by_number(mut effects: Effects) -> Effects {
    effects.lights.sort_by_key(|light| light.id);
    effects.sheets.sort_by_key(|sheet| sheet.id);
    effects.overlays.sort_by_key(|overlay| overlay.id);
    effects
}

struct Gathering<'a> {
    stage: &'a Stage,
    screen: &'a Screen,
    camera: Camera,
    faces: Faces,
    dust: Vec<(Sheet, u32)>,
}

impl Gathering<'_> {
    /// Rocks, man-made things and what moves.
    fn bodies(&mut self, time: f64) -> Result<(), FaceError> {
        let scenery = &self.stage.scenery;
        for body in scenery.bodies(time) {
            self.body(body, time)?;
        }
        for body in scenery.guests(time) {
            self.body(&body, time)?;
        }
        Ok(())
    }

    fn body(&mut self, body: &Body, time: f64) -> Result<(), FaceError> {
        if !self.may_show(body) {
            return Ok(());
        }
        let scenery = &self.stage.scenery;
        let sun = scenery.sun_of_group(body.group, time).unwrap_or_else(|| scenery.sun(time));
        let sun = DVec3::from_array(sun.direction());
        let drop = DVec3::Z * self.camera.drop_at(body.foot);
        let (is_open, law) = (body.solid.is_open(), body.solid.photometry());
        let id = self.faces.number(match body.kind {
            Kind::Rock => Label::Rock,
            Kind::Culture => Label::Culture,
        });
        for triangle in body_triangles(body) {
            // An open surface is lit on the side that is seen.
            let is_behind = triangle.normals[0].dot(self.camera.eye - triangle.corners[0]) < 0.0;
            let turned = if is_open && is_behind { -1.0 } else { 1.0 };
            let colour = |corner: usize| {
                let normal = turned * triangle.normals[corner];
                // Lambert's law does not ask where the eye is.
                let to_eye = match law {
                    Photometry::Lambert => DVec3::Z,
                    _ => (self.camera.eye - (triangle.corners[corner] - drop)).normalize_or(DVec3::Z),
                };
                let cosines = [normal.dot(sun), normal.dot(to_eye), sun.dot(to_eye)];
                triangle.albedo.map(|albedo| law.returned(albedo, cosines))
            };
            let face = Face {
                corners: triangle
                    .corners
                    .map(|corner| self.camera.direction(corner - drop - self.camera.eye)),
                id,
                priority: i32::from(body.priority),
                sides: if is_open { Sides::Both } else { Sides::Front },
            };
            self.faces.add_opaque(&face, [0, 1, 2].map(colour), &self.camera, self.screen)?;
        }
        Ok(())
    }

    /// Whether a body's sphere reaches into the view.
    fn may_show(&self, body: &Body) -> bool {
        let centre = self.camera.place(body.centre);
        let [x, y] = [0, 1].map(|axis| self.camera.projection.centre[axis] / self.camera.projection.focal);
        let beside = |offset: f64, tangent: f64, radius: f64| {
            (offset.abs() - centre.z * tangent) / (1.0 + tangent * tangent).sqrt() > 2.0 * radius
        };
        let along = body.radius * self.camera.squeeze().max(1.0);
        centre.z > -body.radius && !beside(centre.x, x, body.radius) && !beside(centre.y, y, along)
    }

    /// Translucent polygons of the scene.
    fn sheets(&mut self, sheets: &[Sheet]) -> Result<(), FaceError> {
        for sheet in sheets {
            let id = self.faces.number(Label::Sheet);
            let priority = i32::from(sheet.priority);
            let paint = match sheet.medium {
                Medium::Share(share) => Paint::Flat(Feature::surface(id, priority, sheet.colour, share)?),
                Medium::Dust { .. } => {
                    self.dust.push((sheet.clone(), id));
                    Paint::Dust(self.dust.len() as u32 - 1)
                }
            };
            let corners: Vec<DVec3> = sheet.corners.iter().map(|corner| self.camera.place(*corner)).collect();
            self.polygon(&corners, id, priority, paint)?;
        }
        Ok(())
    }

    /// Polygons that are fixed to the eye: before everything else.
    fn overlays(&mut self, overlays: &[Overlay]) -> Result<(), FaceError> {
        let [x, y] = [0, 1].map(|axis| self.camera.projection.centre[axis] / self.camera.projection.focal);
        for overlay in overlays {
            let id = self.faces.number(Label::EyeFixed);
            let priority = i32::from(overlay.priority);
            let feature = Feature::surface(id, priority, overlay.colour, overlay.share)?;
            let corner = |at: &[f64; 2]| DVec3::new(at[0] * x, at[1] * y, 1.0) * OVERLAY_DEPTH;
            let corners: Vec<DVec3> = overlay.corners.iter().map(corner).collect();
            let first = self.faces.planes.len();
            self.polygon(&corners, id, priority, Paint::Flat(feature))?;
            for (plane, _) in &mut self.faces.planes[first..] {
                (plane.slope, plane.origin) = ([0.0; 2], f64::INFINITY);
            }
        }
        Ok(())
    }

    /// A convex polygon as a fan, seen from both sides.
    fn polygon(&mut self, corners: &[DVec3], id: u32, priority: i32, paint: Paint) -> Result<(), FaceError> {
        for pair in corners[1..].windows(2) {
            let face = Face { corners: [corners[0], pair[0], pair[1]], id, priority, sides: Sides::Both };
            self.faces.add(&face, paint, &self.camera, self.screen)?;
        }
        Ok(())
    }
}
