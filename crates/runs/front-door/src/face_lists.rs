//! Lists of faces of a scenario: its sea, its ships with their wakes, effects of files, plumes.

use std::sync::Arc;

use faces::ship::{Arrangement, Hiding, Motion, Wave};
use faces::{Board, Cone, Effect, FaceError, Group, Mesh, Plume, Sea, Setting, Side, Turn, Warning};
use glam::DVec3;
use landscape::Landscape;
use quantities::Rate;
use scenario::{
    Carrier, DrawnBy, EffectFileWish, FaceKind, FaceList, FaceLists, Object, OpenSea, OtherSide, PlumeWish,
    Scenario, SeaWish, ShipCourse, ShipWish, WaveWish,
};

use wind_waves::WindWaves;

use crate::StageError;

/// Priorities of the lists, the lower number before the higher (chosen): effects and plumes from 1, ships, levels upon the sea, the sea.
const SHIPS: i32 = 10_000;
const SHIP_STEP: i32 = 10;
const LEVELS: i32 = 20_000;
const SEA: i32 = 30_000;
/// The sea before all ships: the wrong order of the study.
const SEA_FIRST: i32 = 9000;

/// By how much a bow wake stands outside the waterline (rad). Chosen: the hull does not hide it.
const OUTSIDE: f64 = 0.05;

/// The lists of faces of a scenario at `frames` a second.
///
/// # Errors
/// If an effect file has a fault, or a figure makes no list.
pub(crate) fn face_lists(
    scenario: &Scenario,
    landscape: &Landscape,
    frames: Rate,
) -> Result<Arc<FaceLists>, StageError> {
    let (wishes, objects) = (&scenario.faces, &scenario.objects);
    let mut lists = Lists {
        lists: Vec::new(),
        by_depth: false,
        warnings: Vec::new(),
        next: 1,
        objects,
        landscape,
        frames,
    };
    wishes.effects.iter().try_for_each(|wish| lists.effect(wish))?;
    wishes.plumes.iter().enumerate().try_for_each(|(number, wish)| lists.plume(number, wish))?;
    if let Some(wish) = &wishes.sea {
        let sea = lists.sea(wish)?;
        lists.warn("[sea]", &sea.warnings());
        let mut is_first = false;
        for (number, ship) in wishes.ships.iter().enumerate() {
            let arranged = lists.ship(number as i32, ship, wish)?;
            is_first |= arranged.sea < arranged.ship.priority;
            lists.by_depth |= arranged.order == faces::Order::Depth;
            lists.stern_wake(number as i32, ship, wish, &sea)?;
        }
        let priority = if is_first { SEA_FIRST } else { SEA };
        let group = sea.group("sea", priority, Mesh::MOST_FACES)?;
        let (carrier, drawn_by) = (Carrier::Map(wish.height), imitation(wish));
        lists.lists.push(FaceList {
            sea: Some(sea),
            drawn_by,
            ..FaceList::new(group, FaceKind::Sea, carrier)
        });
    }
    let open_sea = wishes.sea.as_ref().map_or(Ok(None), |wish| open_sea(wish, landscape))?;
    let Lists { lists, by_depth, warnings, .. } = lists;
    Ok(Arc::new(FaceLists { lists, by_depth, warnings, open_sea }))
}

/// The sea of true waves, where a wish has one.
fn open_sea(wish: &SeaWish, landscape: &Landscape) -> Result<Option<OpenSea>, StageError> {
    let Some(wind) = &wish.waves else { return Ok(None) };
    let waves = WindWaves::new(wind)?;
    let area = wish.area.unwrap_or(landscape.level().extent());
    Ok(Some(OpenSea { waves, area, height: wish.height, colour: wish.colour }))
}

/// Who draws the flat sea and the levels upon it: machines alone, where `exact` has true waves.
fn imitation(wish: &SeaWish) -> DrawnBy {
    if wish.waves.is_some() { DrawnBy::Machines } else { DrawnBy::All }
}

struct Lists<'a> {
    lists: Vec<FaceList>,
    by_depth: bool,
    warnings: Vec<String>,
    /// Priority of the next list of an effect.
    next: i32,
    objects: &'a [Object],
    landscape: &'a Landscape,
    frames: Rate,
}

impl Lists<'_> {
    fn effect(&mut self, wish: &EffectFileWish) -> Result<(), StageError> {
        let setting = Setting { frames: self.frames, signals: &[faces::ship::PITCH], most: Mesh::MOST_FACES };
        let effect = Effect::read(&wish.file, setting).map_err(StageError::Effect)?;
        self.warn(&wish.file.display().to_string(), &effect.warnings);
        let mut groups = effect.groups;
        groups.sort_by_key(|group| group.priority);
        for mut group in groups {
            group.priority = self.priority();
            let carrier = Carrier::of(wish.place, self.objects, self.landscape);
            self.lists.push(FaceList::new(group, FaceKind::Effect, carrier));
        }
        Ok(())
    }

    fn plume(&mut self, number: usize, wish: &PlumeWish) -> Result<(), StageError> {
        let plume = Plume {
            flight: wish.flight,
            spread: wish.spread,
            azimuth: wish.azimuth,
            faces: wish.faces,
            colour: wish.colour,
        };
        for copy in 0..wish.copies {
            let name = format!("plume-{}-{}", number + 1, copy + 1);
            let group = plume.group(&name, self.priority(), wish.frames, (copy, wish.copies))?;
            let carrier = Carrier::of(wish.place, self.objects, self.landscape);
            self.lists.push(FaceList::new(group, FaceKind::Effect, carrier));
        }
        Ok(())
    }

    fn warn(&mut self, of: &str, warnings: &[Warning]) {
        self.warnings.extend(warnings.iter().map(|warning| format!("{of}: {warning}")));
    }

    fn priority(&mut self) -> i32 {
        self.next += 1;
        self.next - 1
    }

    fn sea(&self, wish: &SeaWish) -> Result<Sea, FaceError> {
        let [south, west, north, east] = wish.area.unwrap_or(self.landscape.level().extent());
        let square =
            |low: f64, high: f64| (low / wish.square).floor() as i64..(high / wish.square).ceil() as i64;
        let board = Board::new(wish.square, square(west, east), square(south, north))?;
        let cone = Cone::new(wish.normals, wish.normal_elevation)?;
        Sea::of_state(wish.state, (board, wish.pattern, cone), (wish.mean, wish.colour), self.frames)
    }

    fn ship(&mut self, number: i32, wish: &ShipWish, sea: &SeaWish) -> Result<Arrangement, StageError> {
        let arranged = wish.kind.arranged(&wish.id, wish.hiding, SHIPS + SHIP_STEP * number + 2)?;
        self.bow_wake(number, wish, sea)?;
        let motion = self.motion(wish)?;
        self.warn(&format!("[[ship]] {}", wish.id), &motion.warnings());
        let carrier = Carrier::Ship(self.course(wish, sea, motion));
        let is_true = wish.hiding == Hiding::Exact;
        let drawn_by = if is_true { DrawnBy::All } else { DrawnBy::Machines };
        self.hull(&arranged.ship, FaceKind::Ship, (carrier.clone(), drawn_by));
        if !is_true {
            let whole = wish.kind.arranged(&wish.id, Hiding::Exact, arranged.ship.priority)?;
            self.hull(&whole.ship, FaceKind::Ship, (carrier, DrawnBy::Exact));
        }
        if let Some(surround) = &arranged.surround {
            let carrier = Carrier::Ship(self.course(wish, sea, Motion::default()));
            self.hull(surround, FaceKind::Sea, (carrier, DrawnBy::Machines));
        }
        Ok(arranged)
    }

    fn hull(&mut self, group: &Group, kind: FaceKind, (carrier, drawn_by): (Carrier, DrawnBy)) {
        self.lists.push(FaceList { drawn_by, ..FaceList::new(group.clone(), kind, carrier) });
    }

    /// Foam on both sides of the bow: before the ship for an eye on its own side, behind it for one on the other.
    fn bow_wake(&mut self, number: i32, wish: &ShipWish, sea: &SeaWish) -> Result<(), StageError> {
        let Some((wake, frames)) = wish.bow_wake else { return Ok(()) };
        let half_angle = libm::atan(wish.kind.beam / 2.0 / (entrance(wish) * wish.kind.length)) + OUTSIDE;
        let sides = [
            (Side::Port, "port", half_angle, -DVec3::Y),
            (Side::Starboard, "starboard", -half_angle, DVec3::Y),
        ];
        for (k, (side, word, yaw, towards)) in sides.into_iter().enumerate() {
            let first = SHIPS + SHIP_STEP * number + k as i32;
            let group = wake.group(&format!("{}-bow-{word}", wish.id), side, first, frames)?;
            let origin = DVec3::X * (wish.kind.length / 2.0);
            let carrier =
                Carrier::Ship(ShipCourse { origin, yaw, ..self.course(wish, sea, Motion::default()) });
            let other_side = Some(OtherSide { towards, priority: first + SHIP_STEP / 2 });
            self.lists.push(FaceList { other_side, ..FaceList::new(group, FaceKind::Wake, carrier) });
        }
        Ok(())
    }

    fn stern_wake(
        &mut self,
        number: i32,
        wish: &ShipWish,
        water: &SeaWish,
        sea: &Sea,
    ) -> Result<(), StageError> {
        let Some(wake) = wish.stern_wake else { return Ok(()) };
        let side = sea.board.side() / 2.0;
        let [length, width] = wake.size.map(|size| (size / side).ceil() as i64);
        let board = Board::new(side, -(width / 2)..width - width / 2, -length..0)?;
        let level = sea.wake(board, wake.colour, self.frames)?;
        let group = level.group(&format!("{}-stern", wish.id), LEVELS + number, Mesh::MOST_FACES)?;
        let origin = DVec3::X * (-wish.kind.length / 2.0);
        let carrier = Carrier::Ship(ShipCourse { origin, ..self.course(wish, water, Motion::default()) });
        let group = group.detailed(wake.detail);
        let drawn_by = imitation(water);
        self.lists.push(FaceList {
            sea: Some(level),
            drawn_by,
            ..FaceList::new(group, FaceKind::Level, carrier)
        });
        Ok(())
    }

    fn course(&self, wish: &ShipWish, sea: &SeaWish, motion: Motion) -> ShipCourse {
        let [north, east] = wish.at;
        ShipCourse {
            start: DVec3::new(north, east, sea.height),
            heading: wish.heading,
            speed: wish.speed,
            frames: self.frames,
            motion,
            origin: DVec3::ZERO,
            yaw: 0.0,
        }
    }

    fn motion(&self, wish: &ShipWish) -> Result<Motion, FaceError> {
        let wave = |wave: &WaveWish| {
            let turn = Turn::new([1000, wave.period_ms as i64], self.frames)?;
            Ok(Wave { amplitude: wave.amplitude, turn, phase: wave.phase })
        };
        let waves = |waves: &[WaveWish]| waves.iter().map(wave).collect::<Result<_, FaceError>>();
        let [pitch, roll, heave, sway] = &wish.motion;
        Ok(Motion { pitch: waves(pitch)?, roll: waves(roll)?, heave: waves(heave)?, sway: waves(sway)? })
    }
}

/// Part of a ship's length over which its waterline narrows to a point at the bow.
fn entrance(wish: &ShipWish) -> f64 {
    let at_water = wish.kind.levels.iter().find(|level| level.up == 0.0);
    at_water.map_or(0.4, |level| level.entrance)
}
