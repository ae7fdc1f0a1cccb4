//! The ground as one eye sees it: the first place where a ray meets it.

use landscape::{Landscape, parabolic_drop};
use scenario::{Curvature, LevelSwitch};

use crate::ceilings::Ceilings;
use crate::ground::{Ground, Met, Scratch, Zone};
use crate::line::Line;
use crate::relief::{Blend, Relief};

/// A line of sight: where it goes over the ground, and how it rises.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ray {
    /// Unit vector over the ground: north, east.
    pub direction: [f64; 2],
    /// Tangent of its elevation, positive up.
    pub rise: f64,
}

/// What a ray meets.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Sight {
    /// The ground.
    Ground(Spot),
    /// Nothing up to the far range or the edge of the problem area.
    Sky,
    /// At the near range the ray is under the ground: what it met lies nearer, and no sweep draws that.
    TooNear,
}

/// A visible place of the ground.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Spot {
    /// Ground range (m).
    pub range: f64,
    /// North, east (m).
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
    bend: f64,
    near: f64,
    far: f64,
    switch: Option<LevelSwitch>,
}

impl<'a> Outlook<'a> {
    /// The ground of `landscape` from `eye` (north, east, height; m), between the ranges `near` and `far` (m): its
    /// finest level, and behind `switch` the next.
    pub fn new(
        landscape: &'a Landscape,
        ceilings: &'a Ceilings,
        eye: [f64; 3],
        curvature: Curvature,
        [near, far]: [f64; 2],
        switch: Option<LevelSwitch>,
    ) -> Self {
        let bend = match curvature {
            Curvature::None => 0.0,
            Curvature::Parabolic => parabolic_drop(1.0),
        };
        let ground = Ground::new(landscape, ceilings);
        let switch = switch.filter(|_| ground.levels() > 1);
        Self { ground, eye, bend, near, far, switch }
    }

    /// The ground.
    pub fn ground(&self) -> &Ground<'a> {
        &self.ground
    }

    /// The eye: north, east, height (m).
    pub fn eye(&self) -> [f64; 3] {
        self.eye
    }

    /// How far the lunoid has dropped at a range (m); 0 where it is flat.
    pub fn drop(&self, range: f64) -> f64 {
        self.bend * range * range
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
        if met.range == self.near && self.height(&spot) > line.lowest(met.range, met.range) {
            return Sight::TooNear;
        }
        Sight::Ground(spot)
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

    /// Fine, fading and coarse ground. Where the fine level ends before the switch the coarse one begins there.
    fn zones(&self, line: &Line, switch: LevelSwitch, [from, to]: [f64; 2]) -> [Zone; 3] {
        let end = switch.range.min(self.ground.track(0, line).inside()[1]);
        let blend = Blend { from: switch.range - switch.blend, length: switch.blend };
        let fade = if switch.blend > 0.0 { blend.from.min(end) } else { end };
        let zone =
            |level, into, low: f64, high: f64| Zone { level, into, ends: [low.max(from), high.min(to)] };
        [
            zone(0, None, f64::NEG_INFINITY, fade),
            zone(0, Some((1, blend)), fade, end),
            zone(1, None, end, f64::INFINITY),
        ]
    }
}
