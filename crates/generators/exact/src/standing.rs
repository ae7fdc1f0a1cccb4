//! Bodies in the picture: in true perspective, by depth or as a whole (section 12).

use std::borrow::Cow;

use generator::{Label, Shade};
use glam::DVec3;
use scenario::{BodyVisibility, Laws, ShadowedBodies};
use smallvec::SmallVec;
use solids::{Body, Hit, Kind};

use crate::ground::Scratch;
use crate::outlook::{Outlook, Ray};
use crate::seen::Seen;
use crate::shadow::Shadows;
use crate::view::View;

/// What lies nearer ahead than this has no place on the screen (m); such a body is looked for in every column.
pub const NEAR: f64 = 1e-3;

/// By how much the ground before a foot point may stand higher than it (tangent of elevation; an angle in rad where no
/// sweep is drawn) and not hide it.
pub const FOOT_TOLERANCE: f64 = 1e-6;

/// Two things whose ranges differ by no more than this share of 1 m and the range coincide: their priorities say which is seen,
/// and an open surface throws no shadow on ground that it lies on.
pub const COINCIDENCE: f64 = 1e-6;

/// The light of a body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Lit {
    /// Unit vector to its sun.
    pub sun: DVec3,
    /// Whether that is a sun of its group, not the scene's.
    pub apart: bool,
}

/// A body as an eye sees it.
#[derive(Debug, Clone)]
pub struct Stand<'a> {
    body: Cow<'a, Body>,
    /// Where the ray begins if the body stays in its place: the eye, raised by the drop at the foot point.
    eye: DVec3,
    /// Range of the foot point (m).
    foot: f64,
    /// Unit vector to the sun of its group.
    sun: DVec3,
    dark: bool,
    /// Vertices on the screen, if all lie ahead.
    screen: Option<Vec<[f64; 2]>>,
    across: [f64; 2],
}

/// All bodies of a frame.
#[derive(Debug, Clone)]
pub struct Standing<'a> {
    stands: Vec<Stand<'a>>,
    law: BodyVisibility,
}

impl<'a> Standing<'a> {
    /// Those of `bodies`, each with the unit vector to its sun, that the laws let be seen. The light of a group with a sun of its
    /// own comes from elsewhere: no ground darkens it.
    pub fn new(
        bodies: Vec<(Cow<'a, Body>, Lit)>,
        outlook: &Outlook,
        view: &View,
        shadows: Option<&Shadows>,
        laws: Laws,
    ) -> Self {
        let mut scratch = Scratch::default();
        let stand = |(body, lit): (Cow<'a, Body>, Lit)| {
            let shadows = shadows.filter(|_| !lit.apart);
            let dark = shadows.is_some_and(|s| s.is_dark_ground([body.foot.x, body.foot.y], &mut scratch));
            let vanishes = dark && laws.shadowed_bodies == ShadowedBodies::Vanish;
            let stand = Stand::new(body, outlook, view, lit.sun, dark).filter(|_| !vanishes)?;
            let whole = laws.body_visibility == BodyVisibility::AsReported;
            let hidden = whole && stand.is_hidden(outlook, &mut scratch);
            (!hidden).then_some(stand)
        };
        Self { stands: bodies.into_iter().filter_map(stand).collect(), law: laws.body_visibility }
    }

    /// How many there are.
    pub fn len(&self) -> usize {
        self.stands.len()
    }

    /// Those that reach over `x` on the screen.
    pub fn column(&self, x: f64) -> Vec<&Stand<'a>> {
        self.between([x, x])
    }

    /// Those that reach over a place from `low` to `high` (x) on the screen.
    pub fn between(&self, [low, high]: [f64; 2]) -> Vec<&Stand<'a>> {
        self.stands.iter().filter(|stand| stand.across[0] <= high && low <= stand.across[1]).collect()
    }

    /// What is seen along `direction` (1 over the ground), if the ground is met at `ground` (m; infinite if not).
    pub fn look<'s>(&self, column: &'s [&'s Stand<'a>], direction: DVec3, ground: f64) -> Option<Seen> {
        let hit = |stand: &'s &'s Stand<'a>| Some((*stand, stand.body.first_hit(stand.eye, direction, 0.0)?));
        let met = column.iter().filter_map(hit);
        let (stand, hit) = match self.law {
            BodyVisibility::Depth => {
                nearest(met.filter(|(stand, hit)| is_before(stand.body.priority, hit.distance, ground)))?
            }
            // Parts of one object share a foot point: the nearer part lies on top.
            BodyVisibility::AsReported => met.min_by(|(a, near), (b, far)| {
                let feet = a.foot.total_cmp(&b.foot).then(b.body.priority.cmp(&a.body.priority));
                feet.then(near.distance.total_cmp(&far.distance))
            })?,
        };
        Some(stand.seen(hit.face, hit.distance, direction))
    }
}

/// The first of those met; among those that coincide with it the one of the highest priority.
fn nearest<'s, 'a>(met: impl Iterator<Item = (&'s Stand<'a>, Hit)>) -> Option<(&'s Stand<'a>, Hit)> {
    let met: SmallVec<[_; 4]> = met.collect();
    let first = met.iter().map(|(_, hit)| hit.distance).fold(f64::INFINITY, f64::min);
    let alike = met.into_iter().filter(|(_, hit)| hit.distance <= first + room(first));
    alike.min_by(|(a, near), (b, far)| {
        b.body.priority.cmp(&a.body.priority).then(near.distance.total_cmp(&far.distance))
    })
}

/// How far apart (m along the ground) two things at a range (m) may lie and still coincide.
fn room(range: f64) -> f64 {
    COINCIDENCE * (1.0 + range)
}

/// Whether something of a priority is seen at a range before what has priority 0 at another (m).
pub fn is_before(priority: i8, range: f64, other: f64) -> bool {
    match priority {
        0 => range < other,
        above if above > 0 => range <= other + room(range),
        _ => range < other - room(range),
    }
}

impl<'a> Stand<'a> {
    /// `None` if it lies behind the eye, or where the lunoid has ended.
    fn new(body: Cow<'a, Body>, outlook: &Outlook, view: &View, sun: DVec3, dark: bool) -> Option<Self> {
        let [x, y, height] = outlook.eye();
        let foot = libm::hypot(body.foot.x - x, body.foot.y - y);
        let eye = DVec3::new(x, y, height + outlook.drop(foot));
        let places: Vec<_> = body.vertices().map(|vertex| view.project(vertex - eye, NEAR)).collect();
        if places.iter().all(Option::is_none) || foot >= outlook.end() {
            return None;
        }
        let screen: Option<Vec<[f64; 2]>> = places.into_iter().collect();
        let across = screen.as_ref().map_or([f64::NEG_INFINITY, f64::INFINITY], |screen| {
            let each = screen.iter().map(|place| place[0]);
            [each.clone().fold(f64::INFINITY, f64::min), each.fold(f64::NEG_INFINITY, f64::max)]
        });
        Some(Self { body, eye, foot, sun, dark, screen, across })
    }

    /// Whether ground before the foot point stands higher than it.
    fn is_hidden(&self, outlook: &Outlook, scratch: &mut Scratch) -> bool {
        let to = self.body.foot - self.eye;
        let direction = [to.x / self.foot, to.y / self.foot];
        let sight = to.z / self.foot;
        let turned = if outlook.is_swept() { 1.0 } else { 1.0 + sight * sight };
        let rise = sight + FOOT_TOLERANCE * turned;
        self.foot > outlook.near() && outlook.hides(&Ray { direction, rise }, self.foot, scratch)
    }

    /// Places (y) where edges of its faces cross the column at `x`.
    pub fn edges(&self, x: f64, cuts: &mut Vec<f64>) {
        let Some(screen) = &self.screen else { return };
        for (index, face) in self.body.solid.faces().iter().enumerate() {
            let is_turned = || self.body.normal(index).dot(self.eye - self.body.on_face(index)) <= 0.0;
            if !self.body.solid.is_open() && is_turned() {
                continue;
            }
            for (k, &corner) in face.corners.iter().enumerate() {
                let next = face.corners[(k + 1) % face.corners.len()];
                let ([ax, ay], [bx, by]) = (screen[corner as usize], screen[next as usize]);
                if (ax <= x) != (bx <= x) {
                    cuts.push(ay + (by - ay) * (x - ax) / (bx - ax));
                }
            }
        }
    }

    /// The outward normal of what is seen: of the side that the ray meets, where both sides of a face can be seen.
    fn normal(&self, face: usize, place: DVec3, direction: DVec3) -> DVec3 {
        let normal = self.body.normal_at(face, place);
        let is_back = self.body.solid.is_open() && self.body.normal(face).dot(direction) > 0.0;
        if is_back { -normal } else { normal }
    }

    fn seen(&self, face: usize, range: f64, direction: DVec3) -> Seen {
        let normal = self.normal(face, self.eye + range * direction, direction);
        let to_eye = -direction.normalize();
        let cosines = [normal.dot(self.sun), normal.dot(to_eye), self.sun.dot(to_eye)];
        let law = self.body.solid.photometry();
        let reflectivity = self.body.solid.albedo(face).map(|albedo| law.returned(albedo, cosines));
        Seen {
            light: if self.dark { [0.0; 3] } else { reflectivity },
            range,
            height: self.eye.z + range * direction.z,
            normal: normal.to_array(),
            reflectivity,
            shade: match reflectivity.iter().any(|channel| *channel > 0.0) {
                false => Shade::Local,
                true if self.dark => Shade::Remote,
                true => Shade::Lit,
            },
            label: match self.body.kind {
                Kind::Rock => Label::Rock,
                Kind::Culture => Label::Culture,
            },
        }
    }
}
