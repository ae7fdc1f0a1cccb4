//! The other law, where ground data exist: what each place of a line sees, and whether it lies behind the vehicle.
//!
//! The first thing that a ray meets is found as `exact` finds it, so nearer ground and bodies hide what is behind them.
//! Between two neighbouring places that see the same surface the ground is their chord; the prisms behind the
//! vehicle's parts cut it in closed form.

use exact::{Ceilings, Outlook, Ray, Sight};
use generator::Stage;
use glam::DVec3;
use rayon::prelude::*;
use scenario::{Scenery, TrackPatch};
use solids::Body;

use crate::casters::Casters;
use crate::gate::{Gate, Gates, PictureGates};
use crate::shot::{edge, middle};
use crate::stretch::{Spot, Stretch};
use crate::{AugmentError, Shape, Shot};

/// Ground nearer than this is not looked for (m of range).
const NEAR: f64 = 1e-3;

/// Ground data of a scenario.
#[derive(Debug, Clone)]
pub struct TrueGround {
    stage: Stage,
    ceilings: Ceilings,
}

/// One shot over the ground.
struct CastingScene<'a> {
    ground: &'a TrueGround,
    shot: &'a Shot,
    eye: DVec3,
    /// Nearest first, each with the least distance that it may have (m).
    bodies: Vec<(f64, &'a Body)>,
    casters: Casters,
}

impl TrueGround {
    /// The ground of a stage, with what stands on it.
    ///
    /// # Errors
    /// If something on it moves, is open or has a sun of its own: it would neither hide ground nor take shadow as it should.
    pub fn new(stage: Stage) -> Result<Self, AugmentError> {
        let without_law = without_law(&stage.scenery);
        if !without_law.is_empty() {
            return Err(AugmentError::Guests(without_law.join(", ")));
        }
        let ceilings = Ceilings::new(&stage.landscape);
        Ok(Self { stage, ceilings })
    }

    /// Returns the stage of the ground.
    pub fn stage(&self) -> &Stage {
        &self.stage
    }

    /// Gates of a picture of `columns` x `lines` for each of `suns` (unit vectors: north, east, up): the shadow of
    /// `shape` and `tracks`. Places between columns are looked at.
    pub fn gates(
        &self,
        shape: &Shape,
        shot: &Shot,
        suns: &[DVec3],
        tracks: &[TrackPatch],
        [columns, lines]: [usize; 2],
    ) -> PictureGates {
        let casters = Casters::new(&shape.bodies(shot), shot, suns, tracks);
        let scene = self.scene(shot, casters);
        let half_height = shot.field.tan_half_height;
        let of_line = |line: usize| scene.line(middle(half_height, line, lines), columns, suns.len());
        let (mut by_line, tracks): (Vec<Vec<Gate>>, Vec<Gate>) =
            (0..lines).into_par_iter().map(of_line).unzip();
        let of_sun = |sun: usize| {
            let gate = |line: &mut Vec<Gate>| {
                let gate = std::mem::take(&mut line[sun]);
                let ends = 2 * gate.stretches().len();
                (gate, ends)
            };
            Gates::of(by_line.iter_mut().map(gate).collect())
        };
        PictureGates { suns: (0..suns.len()).map(of_sun).collect(), tracks }
    }

    fn scene<'a>(&'a self, shot: &'a Shot, casters: Casters) -> CastingScene<'a> {
        let eye = DVec3::from_array(shot.eye);
        let away = |body: &Body| (body.centre.distance(eye) - body.radius).max(0.0);
        let mut bodies: Vec<(f64, &Body)> =
            self.stage.scenery.bodies(shot.time).map(|body| (away(body), body)).collect();
        bodies.sort_by(|a, b| a.0.total_cmp(&b.0));
        CastingScene { ground: self, shot, eye, bodies, casters }
    }
}

/// What of a scenery has no law here, by name. Colours, normals and priorities move no shadow.
fn without_law(scenery: &Scenery) -> Vec<&'static str> {
    let rows = [
        (scenery.has_moving_objects(), "objects that move (`moves` of an [[object]])"),
        (scenery.has_open_surfaces(), "open surfaces (`open` of an [[object]])"),
        (scenery.has_suns_of_groups(), "suns of groups (`sun` of a [[group]])"),
    ];
    rows.into_iter().filter_map(|(is_there, name)| is_there.then_some(name)).collect()
}

impl CastingScene<'_> {
    /// Gates of the line at `y` for each of `suns` points of the sun, and of its tracks.
    fn line(&self, y: f64, columns: usize, suns: usize) -> (Vec<Gate>, Gate) {
        let half = self.shot.field.tan_half_width;
        let edges: Vec<f64> = (0..=columns).map(|index| edge(half, index, columns)).collect();
        let spots: Vec<Option<Spot>> = edges.iter().map(|&x| self.look(x, y)).collect();
        let (mut gates, mut tracks) = (vec![Gate::default(); suns], Gate::default());
        for (spots, ends) in spots.as_slice().windows(2).zip(edges.windows(2)) {
            let stretch = Stretch { spots: [spots[0], spots[1]], ends: [ends[0], ends[1]] };
            for part in self.casters.parts.iter().filter(|part| stretch.may_meet(&part.reach)) {
                for (gate, prism) in gates.iter_mut().zip(&part.shadows) {
                    prism.iter().for_each(|prism| stretch.darken(prism, gate));
                }
            }
            self.casters.patches(&stretch).for_each(|prism| stretch.darken(prism, &mut tracks));
        }
        tracks.join();
        for gate in &mut gates {
            gate.add_all(&tracks);
            gate.join();
        }
        (gates, tracks)
    }

    /// What is seen through a place of the view-plane, as far as there may be shadow or tracks.
    fn look(&self, x: f64, y: f64) -> Option<Spot> {
        let direction = self.shot.ray(x, y);
        let over = direction.truncate().length();
        let view = &self.ground.stage.view;
        let shadow = self.casters.reach.map_or(0.0, |reach| reach.along(self.eye, direction) * over);
        let far = shadow.max(self.casters.tracks_reach).min(view.ranges[1]);
        let outlook = Outlook::new(
            &self.ground.stage.landscape,
            &self.ground.ceilings,
            self.shot.eye,
            view.laws.curvature,
            [NEAR, far.max(NEAR)],
            view.levels,
        );
        let ground = self.ground_spot(&outlook, direction, over);
        self.body_spot(&outlook, direction, ground.map_or(far / over, |spot| spot.ahead)).or(ground)
    }

    fn ground_spot(&self, outlook: &Outlook, direction: DVec3, over: f64) -> Option<Spot> {
        let [x, y, height] = self.shot.eye;
        let rise = direction.z / over;
        let ray = Ray { direction: [direction.x / over, direction.y / over], rise };
        // Straight down there is no direction over the ground.
        let sight = if over * height.abs().max(1.0) > NEAR { outlook.look(&ray) } else { Sight::TooNear };
        match sight {
            Sight::Ground(spot) => {
                let place = DVec3::new(spot.place[0], spot.place[1], outlook.height(&spot));
                Some(Spot { place, ahead: spot.range / over, of: 0 })
            }
            Sight::TooNear => {
                let below = self.ground.stage.landscape.height(x, y)?;
                Some(Spot { place: DVec3::new(x, y, below), ahead: (height - below) / -direction.z, of: 0 })
            }
            Sight::Sky | Sight::Cut(_) => None,
        }
    }

    /// The nearest body, if it stands nearer than `ahead` (m).
    fn body_spot(&self, outlook: &Outlook, direction: DVec3, ahead: f64) -> Option<Spot> {
        let length = direction.length();
        let mut nearest = None;
        let mut ahead = ahead;
        for (number, (distance, body)) in self.bodies.iter().enumerate() {
            if *distance > ahead * length {
                break;
            }
            let range = (body.foot - self.eye).truncate().length();
            let eye = self.eye + DVec3::Z * outlook.drop(range);
            if (body.centre - eye).cross(direction).length() > body.radius * length {
                continue;
            }
            let hit = body.first_hit(eye, direction, 0.0).filter(|hit| hit.distance < ahead);
            if let Some(hit) = hit {
                ahead = hit.distance;
                nearest = Some(Spot { place: eye + direction * ahead, ahead, of: number + 1 });
            }
        }
        nearest
    }
}
