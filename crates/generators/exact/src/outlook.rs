//! The ground as one eye sees it: the first place where a ray meets it.

use landscape::Landscape;
use scenario::{Curvature, LevelSwitch};

use crate::bend::Bend;
use crate::ceilings::Ceilings;
use crate::ground::{Ground, Met, Scratch, Zone};
use crate::line::Line;
use crate::relief::{Blend, Relief};

/// A line of sight: where it goes over the ground, and how it rises.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ray {
    /// Unit vector over the ground: north, east.
    pub direction: [f64; 2],
    /// Tangent of its elevation, positive up; 1e18 and no more straight up or down.
    pub rise: f64,
}

/// What a ray meets.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Sight {
    /// The ray meets the ground at this place.
    Ground(Spot),
    /// Nothing up to the far range or the edge of the problem area.
    Sky,
    /// At the near range the ray is under the ground: what it met lies nearer, and no sweep draws that.
    TooNear,
    /// The side of the ground, where the stored area begins at this range (m): the eye stands beside the area, and the
    /// ray comes in under its ground. Nothing is drawn there, and nothing seen behind it.
    Cut(f64),
}

/// A visible place of the ground.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Spot {
    /// Ground range of the place (m).
    pub range: f64,
    /// Place on the ground: north, east (m).
    pub place: [f64; 2],
    /// Height of the terrain without craters (m).
    pub height: f64,
    /// Its slopes to the north and east.
    pub slopes: [f64; 2],
}

/// The ground around one eye.
#[derive(Debug, Clone, Copy)]
pub struct Outlook<'a> {
    ground: Ground<'a>,
    eye: [f64; 3],
    bend: Bend,
    near: f64,
    far: f64,
    switch: Option<LevelSwitch>,
    /// The eye stands beside all ground that it could see.
    is_beside: bool,
}

impl<'a> Outlook<'a> {
    /// The ground of `landscape` from `eye` (north, east, height; m), between the ranges `near` and `far` (m): its
    /// finest level, and behind `switch`, or where the finest is not, the next. If `near` is 0 no sweep draws this:
    /// ground is seen from under the eye on.
    pub fn new(
        landscape: &'a Landscape,
        ceilings: &'a Ceilings,
        eye: [f64; 3],
        curvature: Curvature,
        [near, far]: [f64; 2],
        switch: Option<LevelSwitch>,
    ) -> Self {
        let ground = Ground::new(landscape, ceilings);
        let switch = switch.filter(|_| ground.levels() > 1);
        let seen = &landscape.bank().levels()[..=usize::from(switch.is_some())];
        let is_beside = seen.iter().all(|level| level.locate(eye[0], eye[1]).is_none());
        let bend = Bend::of(curvature);
        Self { ground, eye, bend, near, far: far.min(bend.end()), switch, is_beside }
    }

    /// Returns the ground around the eye.
    pub fn ground(&self) -> &Ground<'a> {
        &self.ground
    }

    /// The eye: north, east, height (m).
    pub fn eye(&self) -> [f64; 3] {
        self.eye
    }

    /// How far the lunoid has dropped at a range (m); 0 where it is flat.
    pub fn drop(&self, range: f64) -> f64 {
        self.bend.drop(range)
    }

    /// The same, and by how much it grows for each metre.
    pub fn drop_and_slope(&self, range: f64) -> [f64; 2] {
        self.bend.drop_and_slope(range)
    }

    /// Range at which ground ends for the eye (m).
    pub fn far(&self) -> f64 {
        self.far
    }

    /// Whether sweeps draw this too, from a first sample on.
    pub fn is_swept(&self) -> bool {
        self.near > 0.0
    }

    /// Range at which the lunoid itself ends (m).
    pub fn end(&self) -> f64 {
        self.bend.end()
    }

    /// Rise of a ray (tangents) over the foot of the mountains beyond the stored area. To a sweep they are the last point
    /// of its profile: their foot is the horizontal, and they are seen down to the last ground. Where no sweep is drawn
    /// they stand on the horizon, and below it is `None`.
    pub fn over_horizon(&self, rise: f64) -> Option<f64> {
        if self.is_swept() {
            return Some(rise);
        }
        let over = rise - self.bend.horizon(self.eye[2]);
        (over >= 0.0).then_some(over)
    }

    /// Where ground begins to be seen (m).
    pub fn near(&self) -> f64 {
        self.near
    }

    /// What `ray` meets first.
    pub fn look(&self, ray: &Ray) -> Sight {
        self.look_from(ray, self.near, &mut Scratch::default())
    }

    /// The same, if it is known that the ray is above the ground up to the range `from` (m).
    pub fn look_from(&self, ray: &Ray, from: f64, scratch: &mut Scratch) -> Sight {
        let line = self.line(ray);
        let Some(met) = self.meet(&line, [from, self.far], scratch) else { return Sight::Sky };
        let spot = self.spot(&line, &met);
        let is_under = || self.height(&spot) > line.lowest(met.range, met.range);
        if met.range == self.near && is_under() {
            return Sight::TooNear;
        }
        if self.is_beside && met.range == self.begin(&line) && is_under() {
            return Sight::Cut(met.range);
        }
        Sight::Ground(spot)
    }

    /// Range at which `line` comes over the first ground (m), for an eye beside it.
    fn begin(&self, line: &Line) -> f64 {
        let levels = 0..=usize::from(self.switch.is_some());
        let inside = levels.map(|level| self.ground.track(level, line).inside());
        let enters = inside.filter(|[enters, leaves]| enters <= leaves).map(|[enters, _]| enters);
        enters.fold(f64::INFINITY, f64::min)
    }

    /// Whether ground hides what lies on `ray` at the range `to` (m).
    pub fn hides(&self, ray: &Ray, to: f64, scratch: &mut Scratch) -> bool {
        self.meet(&self.line(ray), [self.near, to.min(self.far)], scratch).is_some()
    }

    /// Height of terrain and craters (m).
    pub fn height(&self, spot: &Spot) -> f64 {
        spot.height + self.ground.craters_at(spot.place).height
    }

    /// The ground at `range` (m) in `direction` (unit vector: north, east), whether or not it is seen; `None` outside
    /// the problem area.
    pub fn spot_at(&self, direction: [f64; 2], range: f64) -> Option<Spot> {
        let line = self.line(&Ray { direction, rise: 0.0 });
        let relief = match self.switch {
            None => Relief::One(self.ground.sheet(0, &line, range)?),
            Some(switch) => {
                let zones = self.zones(&line, switch, [range, range]);
                let zone = zones.iter().find(|zone| zone.ends[0] <= zone.ends[1])?;
                self.ground.relief(zone, &line, range)?
            }
        };
        Some(self.spot(&line, &Met { range, relief }))
    }

    fn line(&self, ray: &Ray) -> Line {
        let [x, y, height] = self.eye;
        Line { origin: [x, y], direction: ray.direction, height, rise: ray.rise, bend: self.bend }
    }

    fn spot(&self, line: &Line, met: &Met) -> Spot {
        let [height, north, east] = met.relief.at(met.range);
        Spot { range: met.range, place: line.place(met.range), height, slopes: [north, east] }
    }

    fn meet(&self, line: &Line, ends: [f64; 2], scratch: &mut Scratch) -> Option<Met<'a>> {
        let Some(switch) = self.switch else {
            return self.ground.meet(line, &Zone { level: 0, into: None, ends }, scratch);
        };
        let zones = self.zones(line, switch, ends);
        zones.iter().find_map(|zone| self.ground.meet(line, zone, scratch))
    }

    /// Coarse ground before the fine level begins, fine, fading and coarse ground. Where the fine level ends before the
    /// switch the coarse one begins there.
    fn zones(&self, line: &Line, switch: LevelSwitch, [from, to]: [f64; 2]) -> [Zone; 4] {
        let [begin, leave] = self.ground.track(0, line).inside();
        let end = switch.range.min(leave);
        let blend = Blend { from: switch.range - switch.blend, length: switch.blend };
        let fade = if switch.blend > 0.0 { blend.from.min(end) } else { end };
        let zone =
            |level, into, low: f64, high: f64| Zone { level, into, ends: [low.max(from), high.min(to)] };
        [
            zone(1, None, f64::NEG_INFINITY, begin),
            zone(0, None, begin, fade),
            zone(0, Some((1, blend)), fade.max(begin), end),
            zone(1, None, end, f64::INFINITY),
        ]
    }
}
