//! What a scene has beside ground and bodies, as functions of time.

use glam::{DMat3, DVec3};

use crate::{DiscFace, Flash, Frame, LightPoint, LightSource, Lobe, Overlay, Sheet, SkyDisc};

/// Light points, sheets, overlays and discs of the sky at one time.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Effects {
    /// Lamps and stars that shine at this time.
    pub lights: Vec<LightPoint>,
    /// Translucent polygons of the scene.
    pub sheets: Vec<Sheet>,
    /// Polygons that are fixed to the eye.
    pub overlays: Vec<Overlay>,
    /// The sun and the Earth, the nearer first.
    pub discs: Vec<SkyDisc>,
}

impl Effects {
    /// Whether there is nothing.
    pub fn is_empty(&self) -> bool {
        let Self { lights, sheets, overlays, discs } = self;
        lights.is_empty() && sheets.is_empty() && overlays.is_empty() && discs.is_empty()
    }
}

/// Effects that come, move, flash and go together.
#[derive(Debug, Clone, PartialEq)]
pub struct Carried {
    /// First time at which they are there (s).
    pub from: f64,
    /// Time from which on they are gone (s); infinite if they stay.
    pub until: f64,
    /// Frames of what carries them, ascending in time. None: they are in the axes of the ground.
    pub frames: Vec<Frame>,
    /// Rate at which the heading of what carries them turns (rad/s).
    pub spin: f64,
    /// When their lights are lit; `None` if always.
    pub flash: Option<Flash>,
    /// The effects: places and directions in the axes of what carries them (forward, starboard, up; m).
    pub effects: Effects,
}

impl Carried {
    /// Effects that stay for the whole mission in the axes of the ground.
    pub fn still(effects: Effects) -> Self {
        Self { from: 0.0, until: f64::INFINITY, frames: Vec::new(), spin: 0.0, flash: None, effects }
    }

    /// Adds what is there at `time` (s), in the axes of the ground.
    pub(crate) fn add_at(&self, time: f64, all: &mut Effects) {
        if !(self.from <= time && time < self.until) {
            return;
        }
        let place = Place(Frame::at(&self.frames, self.spin, time).unwrap_or((DVec3::ZERO, DMat3::IDENTITY)));
        let Effects { lights, sheets, overlays, discs } = &self.effects;
        if self.flash.is_none_or(|flash| flash.is_lit(time)) {
            all.lights.extend(lights.iter().map(|light| place.light(light)));
        }
        all.sheets.extend(sheets.iter().map(|sheet| place.sheet(sheet)));
        all.overlays.extend_from_slice(overlays);
        all.discs.extend(discs.iter().map(|disc| place.disc(disc)));
    }
}

/// Foot point (m) and turn of what carries effects.
struct Place((DVec3, DMat3));

impl Place {
    fn point(&self, at: DVec3) -> DVec3 {
        self.0.0 + self.direction(at)
    }

    fn direction(&self, direction: DVec3) -> DVec3 {
        self.0.1 * direction
    }

    fn light(&self, light: &LightPoint) -> LightPoint {
        let source = match light.source {
            LightSource::Lamp { at, diameter } => LightSource::Lamp { at: self.point(at), diameter },
            LightSource::Star { direction, magnitude } => {
                LightSource::Star { direction: self.direction(direction), magnitude }
            }
        };
        let lobe = light.lobe.map(|lobe| Lobe { axis: self.direction(lobe.axis), ..lobe });
        LightPoint { source, lobe, ..*light }
    }

    fn sheet(&self, sheet: &Sheet) -> Sheet {
        Sheet { corners: sheet.corners.iter().map(|corner| self.point(*corner)).collect(), ..sheet.clone() }
    }

    fn disc(&self, disc: &SkyDisc) -> SkyDisc {
        let face = match disc.face {
            DiscFace::Ball { albedo, sun } => DiscFace::Ball { albedo, sun: self.direction(sun) },
            face @ DiscFace::Sun { .. } => face,
        };
        SkyDisc { direction: self.direction(disc.direction), face, ..*disc }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use landscape::Attitude;
    use std::f64::consts::FRAC_PI_2;

    #[test]
    fn a_lamp_goes_with_what_carries_it() {
        let lobe = Lobe { axis: DVec3::X, half_angle: 1.0, power: 1.0 };
        let light = LightPoint {
            id: 3,
            source: LightSource::Lamp { at: DVec3::new(2.0, 0.0, 1.5), diameter: 0.2 },
            colour: [1.0; 3],
            intensity: 1.0,
            lobe: Some(lobe),
            priority: 0,
            calligraphic: true,
        };
        let frame = |time: f64, north: f64| Frame {
            time,
            foot: DVec3::new(north, 50.0, 7.0),
            attitude: Attitude { heading: FRAC_PI_2, ..Attitude::default() },
        };
        let carried = Carried {
            from: 1.0,
            until: 9.0,
            frames: vec![frame(0.0, 0.0), frame(10.0, 100.0)],
            spin: 0.0,
            flash: Some(Flash { period: 4.0, duty: 0.5, phase: 0.0 }),
            effects: Effects { lights: vec![light], ..Effects::default() },
        };
        let lights = |time: f64| {
            let mut effects = Effects::default();
            carried.add_at(time, &mut effects);
            effects.lights
        };
        let [there] = lights(5.0)[..] else { panic!("one light") };
        let LightSource::Lamp { at, .. } = there.source else { panic!("a lamp") };
        assert!((at - DVec3::new(50.0, 52.0, 8.5)).length() < 1e-12, "{at}");
        assert!((there.lobe.unwrap().axis - DVec3::Y).length() < 1e-12);
        // Dark, not yet there, gone.
        for time in [3.0, 0.5, 9.0] {
            assert!(lights(time).is_empty(), "{time}");
        }
    }
}
