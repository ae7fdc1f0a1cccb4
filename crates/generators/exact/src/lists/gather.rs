//! From lists of faces to triangles on the screen.

use faces::{Cut, Detail, Half, Sides, SunProgramme};
use generator::{Label, Stage};
use glam::DVec3;
use scenario::{FaceKind, FaceList, ListAxes, Pose};

use super::triangle::{Corner, Paint, Triangle, fan};
use crate::effects::Screen;
use crate::outlook::Outlook;
use crate::view::View;

/// A list in a frame.
#[derive(Debug, Clone, PartialEq)]
pub struct Listed {
    /// What it is called.
    pub name: String,
    /// What its faces are in the plane of labels.
    pub label: Label,
    /// Unit vector to its sun: north, east, up.
    pub sun: DVec3,
    /// Whether that is a sun of its own.
    pub has_own_sun: bool,
}

/// A frame that is gathered.
pub struct Gather<'a> {
    /// The scene that is drawn.
    pub stage: &'a Stage,
    /// The ground around the eye.
    pub outlook: &'a Outlook<'a>,
    /// The view of the eye.
    pub view: &'a View,
    /// The pixels of the picture.
    pub screen: Screen,
    /// Number of the frame.
    pub frame: u64,
    /// Pose in the frame.
    pub pose: &'a Pose,
}

/// Lists of a frame, the lowest priority first, and their triangles with outlines in pixels, in stored order.
pub type Gathered = (Vec<Listed>, Vec<(Triangle, Vec<[f64; 2]>)>);

impl Gather<'_> {
    /// All lists that `exact` draws.
    pub fn all(&self) -> Gathered {
        let (scenery, eye) = (&self.stage.scenery, DVec3::from_array(self.pose.eye));
        let mut lists: Vec<(i32, &FaceList, ListAxes)> = Vec::new();
        for list in scenery.face_lists().of_exact() {
            let axes = list.carrier.axes(self.frame, self.pose, (scenery, &self.stage.landscape));
            lists.extend(axes.map(|axes| (list.priority(&axes, eye), list, axes)));
        }
        lists.sort_by_key(|(priority, ..)| *priority);
        let (mut listed, mut triangles) = (Vec::new(), Vec::new());
        for (number, (_, list, axes)) in lists.into_iter().enumerate() {
            listed.push(self.listed(list));
            self.add(list, &axes, (number as u32, listed[number].sun), &mut triangles);
        }
        (listed, triangles)
    }

    fn listed(&self, list: &FaceList) -> Listed {
        let scenario = DVec3::from_array(self.stage.scenery.sun(self.pose.time).direction());
        Listed {
            name: list.group.name.clone(),
            label: Label::of_faces(list.kind),
            sun: list.group.sun.vector(self.frame, scenario),
            has_own_sun: matches!(list.group.sun, SunProgramme::Turning(_)),
        }
    }

    /// Adds the faces of a list that are seen under its sun.
    fn add(
        &self,
        list: &FaceList,
        axes: &ListAxes,
        (number, sun): (u32, DVec3),
        to: &mut Vec<(Triangle, Vec<[f64; 2]>)>,
    ) {
        let (group, eye) = (&list.group, DVec3::from_array(self.pose.eye));
        let is_level = list.kind == FaceKind::Level || group.detail != Detail::Replace;
        let water = self.stage.scenery.face_lists().cut().filter(|_| list.kind == FaceKind::Ship);
        let sun = axes.turn.transpose() * sun;
        for face in group.shown(self.frame, |name| list.carrier.signal(name, self.frame)) {
            let of_mesh = &group.mesh.faces()[face];
            let places = group.mesh.places(of_mesh).into_iter().map(|place| axes.place(place));
            let normal = axes.turn * group.mesh.normals()[face];
            let lit = |behind| group.brightness(face, sun, behind);
            let places: Vec<DVec3> = places.collect();
            let is_behind = normal.dot(eye - places[0]) < 0.0;
            if is_behind && of_mesh.sides == Sides::One {
                continue;
            }
            let corner = |(place, brightness)| Corner { place, brightness };
            let corners: Vec<Corner> = places.into_iter().zip(lit(is_behind)).map(corner).collect();
            let paint = Paint {
                of: [number, face as u32],
                colour: of_mesh.colour,
                normal: if is_behind { -normal } else { normal },
                level: is_level.then_some(group.detail),
            };
            for piece in Cut::Fan.pieces(corners.len()) {
                self.add_piece(&[0, 1, 2].map(|k| corners[piece[k]]), water, paint, to);
            }
        }
    }

    /// Adds a triangle of places on the map, cut at the height of the water.
    fn add_piece(
        &self,
        corners: &[Corner; 3],
        water: Option<f64>,
        paint: Paint,
        to: &mut Vec<(Triangle, Vec<[f64; 2]>)>,
    ) {
        let dry = water.map(|height| Half::above(height).cut(corners, |corner| corner.place, between));
        for triangle in fan(dry.as_deref().unwrap_or(corners)) {
            let Some(lowered) = self.lowered(triangle) else { continue };
            let longest = (0..3).map(|k| triangle[k].place.distance(triangle[(k + 1) % 3].place));
            let sag = self.outlook.drop(longest.fold(0.0, f64::max) / 2.0);
            let made = Triangle::new(lowered, paint, sag, (self.view, &self.screen));
            to.extend(made.filter(|(_, outline)| self.reaches(outline)));
        }
    }

    /// Corners from the eye, each lowered by the drop of the lunoid at its place; `None` where the lunoid has ended.
    fn lowered(&self, triangle: [Corner; 3]) -> Option<[Corner; 3]> {
        let eye = DVec3::from_array(self.pose.eye);
        let mut lowered = triangle;
        for corner in &mut lowered {
            let to = corner.place - eye;
            let range = to.truncate().length();
            if range >= self.outlook.end() {
                return None;
            }
            corner.place = to - DVec3::Z * self.outlook.drop(range);
        }
        Some(lowered)
    }

    /// Whether the box of an outline meets the picture.
    fn reaches(&self, outline: &[[f64; 2]]) -> bool {
        let size = self.screen.size();
        (0..2).all(|axis| {
            let places = || outline.iter().map(|corner| corner[axis]);
            places().any(|at| at >= 0.0) && places().any(|at| at <= size[axis] as f64)
        })
    }
}

/// The corner at a share of the way between two.
fn between(from: Corner, to: Corner, share: f64) -> Corner {
    Corner {
        place: from.place + (to.place - from.place) * share,
        brightness: from.brightness + (to.brightness - from.brightness) * share,
    }
}
