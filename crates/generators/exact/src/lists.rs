//! Lists of faces of a frame: sea, wakes, ships, effects. They lie over ground and bodies by depth, and in a pixel by area.

mod gather;
mod told;
mod triangle;

use std::fmt;
use std::sync::Arc;

use face_areas::Mean;
use generator::{FaceScene, ScreenFace, Shade, Stage};
use glam::DVec3;
use scenario::Pose;

use gather::{Gather, Listed};
use triangle::{Triangle, linear};

use crate::column::Pixel;
use crate::effects::{Opaque, Screen, Surface, sub_rays};
use crate::scene::Scene;
use crate::seen::Seen;
use crate::standing::COINCIDENCE;
use crate::view::View;

/// Faces of a frame on the screen.
pub struct FaceLayer {
    triangles: Arc<[Triangle]>,
    /// The same for areas.
    areas: FaceScene,
    lists: Vec<Listed>,
    /// Numbers of triangles that reach each column, ascending.
    columns: Vec<Vec<u32>>,
    /// Least and greatest line (pixels) of each triangle.
    lines: Vec<[f64; 2]>,
    screen: Screen,
    view: View,
}

impl fmt::Debug for FaceLayer {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("FaceLayer").field("lists", &self.lists).finish_non_exhaustive()
    }
}

/// What faces make of a place of the screen.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FacesSeen {
    /// Light of the faces, and the share of light from behind that comes through.
    pub mean: Mean,
    /// What the place shows, and how far along the axis of view (m); `None` where levels alone lie before what is behind.
    pub opaque: Option<(Seen, f64)>,
}

impl FaceLayer {
    /// The lists of a stage in a frame, before the ground of `scene`; `None` where there are none.
    pub fn new(stage: &Stage, scene: &Scene, (frame, pose): (u64, &Pose), screen: Screen) -> Option<Self> {
        if stage.scenery.face_lists().is_empty() {
            return None;
        }
        let (outlook, view) = (scene.outlook(), scene.view());
        let (lists, drawn) = Gather { stage, outlook, view, screen, frame, pose }.all();
        let (triangles, outlines): (Vec<Triangle>, Vec<_>) = drawn.into_iter().unzip();
        let triangles: Arc<[Triangle]> = triangles.into();
        let mut columns = vec![Vec::new(); screen.size()[0]];
        let mut lines = Vec::with_capacity(outlines.len());
        for (number, outline) in outlines.iter().enumerate() {
            let [left, right] = extent(outline, 0);
            // The conversion saturates; a place on the border of two columns belongs to both.
            let last = (right.floor().max(0.0) as usize).min(columns.len().saturating_sub(1));
            let first = ((left.ceil() - 1.0).max(0.0) as usize).min(last);
            columns[first..=last].iter_mut().for_each(|column| column.push(number as u32));
            lines.push(extent(outline, 1));
        }
        let areas = areas(&triangles, outlines);
        Some(Self { triangles, areas, lists, columns, lines, screen, view: *view })
    }

    /// The pixels that it is drawn for.
    pub fn screen(&self) -> &Screen {
        &self.screen
    }

    /// Draws the faces over a column of ground and bodies, top line first, and returns the rays that it took.
    pub fn over(&self, scene: &Scene, column: usize, pixels: &mut [Pixel]) -> u64 {
        let mut surface = Opaque::beside_faces(scene, &self.screen, column);
        for (line, pixel) in pixels.iter_mut().enumerate() {
            let faces = self.of_lines(column, [line as f64, line as f64 + 1.0]);
            if !faces.is_empty() {
                self.over_pixel(scene, ([column, line], &faces), &mut surface, pixel);
            }
        }
        surface.rays()
    }

    /// Triangles of a column that reach lines between two places (pixels).
    fn of_lines(&self, column: usize, [top, bottom]: [f64; 2]) -> Vec<u32> {
        let reaches = |number: &u32| {
            let [low, high] = self.lines[*number as usize];
            low <= bottom && high >= top
        };
        self.columns.get(column).into_iter().flatten().copied().filter(reaches).collect()
    }

    fn over_pixel(
        &self,
        scene: &Scene,
        (at, faces): ([usize; 2], &[u32]),
        surface: &mut Opaque,
        pixel: &mut Pixel,
    ) {
        let [x, y] = at.map(|at| at as f64);
        let places = [[x + 0.5, y + 0.5], [x, y], [x + 1.0, y], [x, y + 1.0], [x + 1.0, y + 1.0]];
        let depths = places.map(|place| surface.back(place).depth);
        let is_before = |face: u32, k: usize| self.is_before(face, places[k], depths[k]);
        let is_even = faces.iter().all(|&face| (1..5).all(|k| is_before(face, k) == is_before(face, 0)));
        pixel.light = if is_even {
            let seen: Vec<u32> = faces.iter().copied().filter(|&face| is_before(face, 0)).collect();
            over(&face_areas::mean(&self.areas, &seen, at), pixel.light)
        } else {
            self.sampled(scene, [x, y], surface)
        };
        if let Some(FacesSeen { opaque: Some((seen, _)), .. }) = self.at(scene, places[0], depths[0]) {
            pixel.seen = seen;
        }
    }

    /// Mean light over the sub-rays of a pixel, where ground or a body passes between faces.
    fn sampled(&self, scene: &Scene, low: [f64; 2], surface: &mut Opaque) -> [f64; 3] {
        let (mut sum, mut count) = ([0.0; 3], 0.0);
        for within in sub_rays() {
            let at = [0, 1].map(|axis| low[axis] + within[axis]);
            let (back, light) = surface.lit(at);
            let mean = self.at(scene, at, back.depth).map(|seen| seen.mean);
            let light = mean.map_or(light, |mean| over(&mean, light));
            sum = [0, 1, 2].map(|channel| sum[channel] + light[channel]);
            count += 1.0;
        }
        sum.map(|channel| channel / count)
    }

    /// Whether the plane of a triangle lies before ground or a body at a depth (m; infinite in the sky), or coincides with it.
    fn is_before(&self, face: u32, at: [f64; 2], depth: f64) -> bool {
        if depth.is_infinite() {
            return true;
        }
        let triangle = &self.triangles[face as usize];
        let nearness = linear(&triangle.nearness, at);
        let sag = match triangle.sag > 0.0 {
            true => triangle.sag * nearness / self.ray(at).z.abs(),
            false => 0.0,
        };
        nearness > 0.0 && nearness * depth >= 1.0 - COINCIDENCE - sag
    }

    /// What lies 1 m along the axis of view through a place in pixels: north, east, up.
    fn ray(&self, at: [f64; 2]) -> DVec3 {
        self.view.ray_ahead(self.screen.on_plane(at))
    }

    /// Triangles at a place in pixels, near to far; of those of one list that coincide there the first.
    fn covers(&self, at: [f64; 2]) -> Vec<u32> {
        let column = (at[0].max(0.0) as usize).min(self.columns.len().saturating_sub(1));
        let mut faces = self.of_lines(column, [at[1]; 2]);
        faces.retain(|&face| self.triangles[face as usize].covers(at));
        face_areas::near_to_far(&self.areas, &mut faces, at);
        // A place on the border of two triangles lies in both.
        faces.dedup_by(|later, first| self.coincide([*first, *later], at));
        faces
    }

    /// Whether two triangles are of one list and coincide at a place in pixels.
    fn coincide(&self, faces: [u32; 2], at: [f64; 2]) -> bool {
        let [first, later] = faces.map(|face| &self.triangles[face as usize]);
        let [near, far] = [first, later].map(|triangle| linear(&triangle.nearness, at));
        first.paint.of[0] == later.paint.of[0] && (near - far).abs() <= COINCIDENCE * near
    }

    /// What faces make of a place in pixels before ground or a body at a depth (m); `None` where there are none.
    pub fn at(&self, scene: &Scene, at: [f64; 2], depth: f64) -> Option<FacesSeen> {
        let mut faces = self.covers(at);
        faces.retain(|&face| self.is_before(face, at, depth));
        let mean = face_areas::seen(&self.areas, &faces, at);
        let opaque = faces.iter().find(|face| self.triangles[**face as usize].is_opaque());
        let opaque = opaque.map(|&face| self.seen(scene, face, at));
        (!faces.is_empty()).then_some(FacesSeen { mean, opaque })
    }

    /// What a place in pixels shows of a triangle, and how far along the axis of view (m).
    fn seen(&self, scene: &Scene, face: u32, at: [f64; 2]) -> (Seen, f64) {
        let triangle = &self.triangles[face as usize];
        let depth = 1.0 / linear(&triangle.nearness, at);
        let place = self.ray(at) * depth;
        let (range, light) = (place.truncate().length(), triangle.light(at));
        let is_lit = light.iter().any(|channel| *channel > 0.0);
        let seen = Seen {
            light,
            range,
            height: scene.outlook().eye()[2] + place.z + scene.outlook().drop(range),
            normal: triangle.paint.normal.to_array(),
            reflectivity: light,
            shade: if is_lit { Shade::Lit } else { Shade::Local },
            label: self.lists[triangle.paint.of[0] as usize].label,
        };
        (seen, depth)
    }
}

/// Light of faces over light from behind them.
pub fn over(mean: &Mean, behind: [f64; 3]) -> [f64; 3] {
    [0, 1, 2].map(|channel| mean.light[channel] + mean.through[channel] * behind[channel])
}

/// The triangles with their outlines (pixels), for areas.
fn areas(triangles: &Arc<[Triangle]>, outlines: Vec<Vec<[f64; 2]>>) -> FaceScene {
    let face = |(id, (triangle, corners)): (usize, (&Triangle, Vec<[f64; 2]>))| ScreenFace {
        corners,
        q: triangle.nearness,
        priority: 0,
        id: id as u32,
    };
    let faces = triangles.iter().zip(outlines).enumerate().map(face).collect();
    let of = Arc::clone(triangles);
    let looks = Box::new(move |face: usize, at: [f64; 2]| of[face].look(at));
    FaceScene { faces, looks, coincidence: COINCIDENCE }
}

/// Least and greatest place of an outline along an axis (pixels).
fn extent(outline: &[[f64; 2]], axis: usize) -> [f64; 2] {
    let places = outline.iter().map(|corner| corner[axis]);
    places.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], at| [low.min(at), high.max(at)])
}
