//! One frame's scene: what a ray through any place of the screen sees.

use std::borrow::Cow;

use generator::Label;
use glam::DVec3;
use landscape::{Landscape, Sun};
use scenario::{Laws, Pose, Scenery};
use solids::Body;

use crate::ground::Scratch;
use crate::light::Light;
use crate::lists::{self, FaceLayer, FacesSeen};
use crate::open_sea::Water;
use crate::outlook::{Outlook, Ray, Sight, Spot};
use crate::seen::Seen;
use crate::shadow::Shadows;
use crate::standing::{Lit, Stand, Standing};
use crate::view::View;

/// What a ray meets: the ground or the sky, a body before it, and faces of lists before both.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Meeting {
    ray: Ray,
    sight: Sight,
    body: Option<Seen>,
    faces: Option<FacesSeen>,
}

/// Ground, light, shadow, bodies and lists of faces from one eye at one time.
#[derive(Debug)]
pub struct Scene<'a> {
    landscape: &'a Landscape,
    outlook: Outlook<'a>,
    view: View,
    light: Light<'a>,
    shadows: Option<Shadows<'a>>,
    reach: f64,
    eye_height: f64,
    standing: Standing<'a>,
    water: Option<Water<'a>>,
    faces: Option<FaceLayer>,
}

impl<'a> Scene<'a> {
    /// The scene of `outlook` at a pose, with remote shadow up to a ground range of `reach` (m), or without any.
    pub fn new(
        landscape: &'a Landscape,
        scenery: &'a Scenery,
        outlook: Outlook<'a>,
        laws: Laws,
        reach: Option<f64>,
        pose: &Pose,
    ) -> Self {
        let sun: Sun = scenery.sun(pose.time);
        let view = View::new(laws.projection, &pose.attitude).with_yoke(pose.yoke);
        let still = scenery.bodies(pose.time).map(Cow::Borrowed);
        let bodies: Vec<Cow<Body>> = still.chain(scenery.guests(pose.time).map(Cow::Owned)).collect();
        let own_sun = |body: &Body| scenery.sun_of_group(body.group, pose.time);
        // The vehicle is not seen: it casts alone.
        let casters = || {
            let own = scenery.own_bodies(pose.eye, pose.attitude);
            // A group with a sun of its own is lit from elsewhere: the scene's sun finds nothing of it in its way.
            let cast = bodies.iter().filter(|body| own_sun(body).is_none()).cloned();
            cast.chain(own.into_iter().map(Cow::Owned)).collect()
        };
        let cast = || Shadows::new(*outlook.ground(), &sun, casters(), scenery.patches(pose.time));
        let shadows = reach.map(|_| cast());
        let lit = |body: Cow<'a, Body>| {
            let own = own_sun(&body);
            let to_sun = DVec3::from_array(own.unwrap_or(sun).direction());
            (body, Lit { sun: to_sun, apart: own.is_some() })
        };
        let bodies = bodies.into_iter().map(lit).collect();
        let standing = Standing::new(bodies, &outlook, &view, shadows.as_ref(), laws);
        let light = Light::new(landscape, &sun, laws, pose.eye[2]);
        let reach = reach.unwrap_or_default();
        let to_sun = DVec3::from_array(sun.direction());
        let water = scenery.face_lists().open_sea.as_ref().map(|sea| Water::new(sea, pose.time, to_sun));
        Self {
            landscape,
            outlook,
            view,
            light,
            shadows,
            reach,
            eye_height: pose.eye[2],
            standing,
            water,
            faces: None,
        }
    }

    /// The same with lists of faces.
    pub fn with_faces(self, faces: Option<FaceLayer>) -> Self {
        Self { faces, ..self }
    }

    /// The lists of faces in it, where there are some.
    pub fn faces(&self) -> Option<&FaceLayer> {
        self.faces.as_ref()
    }

    /// Whether it has a sea of true waves.
    pub fn has_open_sea(&self) -> bool {
        self.water.is_some()
    }

    /// The bodies in it.
    pub fn standing(&self) -> &Standing<'a> {
        &self.standing
    }

    /// Where ground begins to be seen (m).
    pub fn near(&self) -> f64 {
        self.outlook.near()
    }

    /// Distance (m) from the eye along the ray to what is seen at a ground range and a height above the lunoid (m); infinity
    /// where there is no place. It stands below the tangent plane by the drop of the lunoid.
    pub fn distance(&self, range: f64, height: f64) -> f64 {
        if range.is_infinite() {
            return range;
        }
        let rise = height - self.outlook.drop(range) - self.eye_height;
        (range * range + rise * rise).sqrt()
    }

    /// What is seen at (x, y) of the screen, among the bodies of `column`, if the ray is above the ground up to the
    /// range `clear` (m); and up to where every ray above it in the column is.
    pub fn look(
        &self,
        [x, y]: [f64; 2],
        column: &[&Stand<'a>],
        clear: f64,
        scratch: &mut Scratch,
    ) -> (Seen, f64) {
        let meeting = self.meet([x, y], column, clear, scratch);
        let clear = match meeting.sight {
            Sight::Ground(spot) => spot.range,
            Sight::Sky => f64::INFINITY,
            Sight::TooNear | Sight::Cut(_) => self.near(),
        };
        // Under pitch or yoke a column's rays have different azimuths: one says nothing about the next.
        let clear = if self.view.columns_are_vertical() { clear } else { self.near() };
        (self.seen(&meeting, scratch), clear)
    }

    /// What the ray through (x, y) of the screen meets without lists of faces; arguments are those of [`look`](Self::look).
    pub fn meet(
        &self,
        [x, y]: [f64; 2],
        column: &[&Stand<'a>],
        clear: f64,
        scratch: &mut Scratch,
    ) -> Meeting {
        let ray = self.view.ray(x, y);
        let sight = self.outlook.look_from(&ray, clear, scratch);
        let met = match sight {
            Sight::Ground(spot) => spot.range,
            Sight::Cut(range) => range,
            Sight::Sky | Sight::TooNear => f64::INFINITY,
        };
        let body = if column.is_empty() {
            None
        } else {
            self.standing.look(column, self.view.perspective(x, y), met)
        };
        let body = self.with_water([x, y], sight, body);
        Meeting { ray, sight, body, faces: None }
    }

    /// The body that a ray meets, or the water that it meets before body and ground. Ground under the calm water hides no water.
    fn with_water(&self, [x, y]: [f64; 2], sight: Sight, body: Option<Seen>) -> Option<Seen> {
        let Some(water) = &self.water else { return body };
        let ground = match sight {
            Sight::Ground(spot) if !water.covers(spot.place, self.outlook.height(&spot)) => spot.range,
            Sight::Cut(range) => range,
            Sight::Ground(_) | Sight::Sky | Sight::TooNear => f64::INFINITY,
        };
        let before = body.map_or(ground, |body| body.range.min(ground));
        water.look(&self.outlook, self.view.perspective(x, y), before).or(body)
    }

    /// The same meeting with what lists of faces have at the place (x, y) of the screen.
    pub fn with_faces_met(&self, meeting: Meeting, place: [f64; 2]) -> Meeting {
        let Some(layer) = &self.faces else { return meeting };
        let depth = self.depth(&meeting, place);
        Meeting { faces: layer.at(self, layer.screen().in_pixels(place), depth), ..meeting }
    }

    /// What is seen of what a ray meets.
    pub fn seen(&self, meeting: &Meeting, scratch: &mut Scratch) -> Seen {
        let Some(FacesSeen { mean, opaque }) = &meeting.faces else { return self.behind(meeting, scratch) };
        let behind = opaque.map_or_else(|| self.behind(meeting, scratch), |(seen, _)| seen);
        let light = lists::over(mean, if opaque.is_some() { [0.0; 3] } else { behind.light });
        Seen { light, ..behind }
    }

    /// The same without lists of faces.
    fn behind(&self, meeting: &Meeting, scratch: &mut Scratch) -> Seen {
        meeting.body.unwrap_or_else(|| match meeting.sight {
            Sight::Ground(spot) => self.ground(&spot, &meeting.ray, scratch),
            Sight::Sky => self.beyond(&meeting.ray),
            Sight::TooNear | Sight::Cut(_) => Seen::SKY,
        })
    }

    /// How far along the axis of view (m) the ray through a place of the screen ends; infinite where it meets no place.
    pub fn depth(&self, meeting: &Meeting, [x, y]: [f64; 2]) -> f64 {
        if let Some(FacesSeen { opaque: Some((_, depth)), .. }) = meeting.faces {
            return depth;
        }
        let (range, rise) = match (meeting.body, meeting.sight) {
            (Some(body), _) => (body.range, self.view.perspective(x, y).z),
            (None, Sight::Ground(Spot { range, .. }) | Sight::Cut(range)) => (range, meeting.ray.rise),
            (None, Sight::Sky | Sight::TooNear) => return f64::INFINITY,
        };
        range * ((1.0 + rise * rise) / (1.0 + x * x + y * y)).sqrt()
    }

    /// Whether a ray goes on into the sky: it meets no ground, no body, no silhouette and no face that hides them.
    pub fn is_open(&self, meeting: &Meeting) -> bool {
        if meeting.faces.is_some_and(|faces| faces.opaque.is_some()) {
            return false;
        }
        let passes = meeting.body.is_none() && meeting.sight == Sight::Sky;
        passes && self.beyond(&meeting.ray).label == Label::Sky
    }

    /// The view from its eye.
    pub fn view(&self) -> &View {
        &self.view
    }

    /// The ground around its eye.
    pub fn outlook(&self) -> &Outlook<'a> {
        &self.outlook
    }

    fn ground(&self, spot: &Spot, ray: &Ray, scratch: &mut Scratch) -> Seen {
        let rise = self.outlook.ground().craters_at(spot.place);
        let dark = |matters: bool| {
            let shadows = self.shadows.as_ref().filter(|_| spot.range <= self.reach)?;
            shadows.at(spot.place, matters, scratch)
        };
        self.light.ground(spot, ray.direction, &rise, dark)
    }

    /// Mountains beyond the stored area: the first listed that stands above the ray, as the last point of a profile.
    fn beyond(&self, ray: &Ray) -> Seen {
        let silhouettes = self.landscape.silhouettes();
        if silhouettes.is_empty() {
            return Seen::SKY;
        }
        let Some(rise) = self.outlook.over_horizon(ray.rise) else { return Seen::SKY };
        let azimuth = libm::atan2(ray.direction[1], ray.direction[0]);
        let above = |tangent: Option<f64>| tangent.is_some_and(|tangent| rise < tangent);
        let found = silhouettes.iter().find(|silhouette| above(silhouette.tangent(azimuth)));
        found.map_or(Seen::SKY, |silhouette| Seen::silhouette(silhouette.reflectivity()))
    }
}
