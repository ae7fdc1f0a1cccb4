//! What the I/O processors bring for a frame before its sweeps run: shadow gates, polyhedra and craters (section 17).

use crate::stage::MachineStage;
use generator::FrameError;
use glam::DVec3;
use hardware_model::ShadowParts;
use landscape::Attitude;
use polyhedron_generator::{Census, Drawn, FaceLight, Field, LeftOut, PolyhedronGenerator, ViewPlane};
use quantities::Tick;
use rayon::prelude::*;
use remote_shadow::{Footings, Outlines, Shade, Tile, UnderSun};
use scenario::{BodyVisibility, ShadowedBodies};
use shadow_controller::{Gate, SEGMENT_WORDS, ShadowController};
use solids::Body;
use std::ops::Range;
use std::sync::Arc;
use sweep_generator::RangeTable;

use crate::absent::Absent;
use crate::blocks::{Blocks, Shadows};
use crate::craters_in_sight::CratersInSight;
use crate::feature_loads::load_timing;
use crate::frame_plan::FramePlan;
use crate::late_words::LateOf;
use crate::raster::WrittenRaster;
use crate::refusal::Refusal;
use crate::sight::InSight;
use crate::ticks::start_of;

/// Data of a frame, by sweep; the buffers are kept from frame to frame.
#[derive(Debug, Default)]
pub struct Delivery {
    /// Shadow gate of each sweep; empty without shadows.
    pub gates: Vec<Gate>,
    /// Polyhedra in display-plane position.
    pub polyhedra: PolyhedronGenerator,
    /// What the bodies took.
    pub census: Census,
    /// Bodies too far to be seen.
    pub left_out: LeftOut,
    /// Craters that can be told; none unless the machine draws a preview.
    pub craters: CratersInSight,
}

/// What deliveries are made from.
pub struct Supply<'a> {
    /// Ground, scenery and settings.
    pub stage: &'a MachineStage,
    /// Blocks that are there.
    pub blocks: &'a Blocks,
    /// Feet and shadows of bodies, found once a body and a sun.
    pub footings: &'a Footings,
    /// Fan, eye and sun of the frame.
    pub plan: &'a FramePlan,
    /// Raster that the sweeps write.
    pub raster: WrittenRaster,
    /// Ground range of each sample, by the ground-range programme.
    pub table: &'a RangeTable,
    /// Vertices that the processor has ready, if it takes any time.
    pub ready: Option<u64>,
    /// Boundaries of shadow that are not in the storage buffer, where any are not.
    pub absent_shadows: Option<&'a Absent>,
    /// Bodies that are not in the storage buffer, ascending.
    pub absent_bodies: &'a [u32],
    /// Sweeps whose shadow gates are wanted; those of others are empty.
    pub gated: Range<u32>,
}

/// The upright view-plane of the frame of `plan`, for what is drawn in display-plane position on `raster`.
pub fn view_plane(stage: &MachineStage, plan: &FramePlan, raster: &WrittenRaster) -> ViewPlane {
    let laws = stage.settings.laws;
    ViewPlane {
        eye: plan.eye,
        heading: plan.heading,
        pitch: plan.pitch,
        projection: laws.projection,
        curvature: laws.curvature,
        tan_half_height: raster.field.tan_half_height,
        lines: raster.lines as f64,
    }
}

/// Outlines of all shadows that the sweeps can meet whose gates are wanted.
struct Cast<'a> {
    /// Those that lie in the shadow bank.
    stored: &'a [&'a Outlines],
    /// Those that the processor works out for the frame.
    own: &'a [Outlines],
}

impl<'a> Cast<'a> {
    fn all(&self) -> Vec<&'a Outlines> {
        self.stored.iter().copied().chain(self.own).collect()
    }
}

/// A boundary of shadow on the ground, shadow to its right.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ShadowBoundary {
    /// From, to: north, east (m).
    pub ends: [[f64; 2]; 2],
    /// From which tick on the storage buffer has it: 0 if it has it as the frame begins; none if not in this frame.
    pub there_from: Option<Tick>,
}

impl Supply<'_> {
    /// Brings what the frame at `time` (s) needs.
    pub fn deliver(&self, time: f64, out: &mut Delivery) {
        let (seen, left_out) = self.in_sight(time);
        let under_sun = self.blocks.shadows.as_ref().map(|shadows| self.under_sun(shadows));
        let Delivery { gates, polyhedra, census, craters, .. } = out;
        let bring_gates = || match (&self.blocks.shadows, &under_sun) {
            (Some(shadows), Some(under_sun)) => {
                self.gates(shadows, &shadows.controller, under_sun, &seen, time, gates);
            }
            _ => gates.clear(),
        };
        let bring_bodies = || {
            if self.blocks.bodies {
                *census = self.project(&seen, under_sun.as_ref(), polyhedra);
            }
        };
        let bring_craters = || {
            if self.blocks.instants.is_some() && self.blocks.features {
                craters.find(self.stage, self.plan);
            }
        };
        // Each has a part that is one thread's. None waits for other threads while it holds what another may ask for.
        rayon::join(bring_gates, || rayon::join(bring_bodies, bring_craters));
        out.left_out = left_out;
    }

    /// Whether the shadow cache could be kept.
    pub fn check_cache(&self) -> Result<(), FrameError> {
        let failure = self.blocks.shadows.as_ref().and_then(|shadows| shadows.bank.take_cache_failure());
        failure.map_or(Ok(()), |error| {
            Err(Refusal::ShadowCache { reason: error.to_string() }.of(self.plan.frame))
        })
    }

    /// Shadow gates alone, as [`deliver`](Self::deliver) brings them, with all that is to be told of their line generators.
    pub fn shadow_gates(&self, time: f64) -> Vec<Gate> {
        let (seen, _) = self.in_sight(time);
        let mut gates = Vec::new();
        if let Some(shadows) = &self.blocks.shadows {
            let controller = ShadowController { tells_lines: true, ..shadows.controller.clone() };
            self.gates(shadows, &controller, &self.under_sun(shadows), &seen, time, &mut gates);
        }
        gates
    }

    /// Bodies that are ready and near enough, and what is too far.
    fn in_sight(&self, time: f64) -> (Vec<u32>, LeftOut) {
        let mut in_sight = InSight::of(self.stage, self.blocks, self.plan, time);
        if let Some(vertices) = self.ready {
            in_sight.keep_ready(self.stage, self.plan, vertices);
        }
        (in_sight.bodies, in_sight.left_out)
    }

    /// Body `number` of the mission.
    fn body(&self, number: u32) -> &Body {
        &self.stage.scenery.standing()[number as usize].body
    }

    fn under_sun<'a>(&'a self, shadows: &'a Shadows) -> UnderSun<'a> {
        let bodies = self.stage.scenery.standing().len();
        self.footings.under(self.plan.sun, bodies, &shadows.bank)
    }

    /// Boundaries of shadow on the ground, of which the gates of the frame are made.
    pub fn shadow_lines(&self, time: f64) -> Vec<ShadowBoundary> {
        let (seen, _) = self.in_sight(time);
        let Some(shadows) = &self.blocks.shadows else { return Vec::new() };
        let lines = |_: &[[f64; 2]], cast: &Cast<'_>| {
            let stored = cast.stored.iter().flat_map(|outlines| boundaries(outlines, self.absent_shadows));
            stored.chain(cast.own.iter().flat_map(|outlines| boundaries(outlines, None))).collect()
        };
        self.with_outlines(shadows, &self.under_sun(shadows), &seen, time, lines)
    }

    fn gates(
        &self,
        shadows: &Shadows,
        controller: &ShadowController,
        under_sun: &UnderSun<'_>,
        seen: &[u32],
        time: f64,
        gates: &mut Vec<Gate>,
    ) {
        if self.gated.is_empty() {
            return gates.clear();
        }
        let (reach, end) = (shadows.reach, self.stage.settings.range.end);
        let timing = |sweep: u32| {
            let place = (self.plan.frame, sweep);
            let rate = self.stage.settings.segment_words?;
            let on_time = self.plan.late_of(sweep).and_then(LateOf::boundary);
            Some(load_timing(self.stage, self.table, place, (SEGMENT_WORDS, rate), on_time))
        };
        let foot = [self.plan.eye[0], self.plan.eye[1]];
        self.with_outlines(shadows, under_sun, seen, time, |directions, cast| {
            let Some(absent) = self.absent_shadows else {
                return controller.gates_by(foot, directions, reach, &cast.all(), timing, gates);
            };
            gates.clear();
            for sweeps in self.spells(absent) {
                let is_wanted = sweeps.start < self.gated.end && self.gated.start < sweeps.end;
                if !is_wanted {
                    gates.resize_with(sweeps.end as usize, Gate::default);
                    continue;
                }
                let there = self.there(cast, absent, sweeps.start);
                let all: Vec<&Outlines> = there.iter().chain(cast.own).collect();
                let directions = &directions[sweeps.start as usize..sweeps.end as usize];
                let mut some = Vec::new();
                let timing = |sweep: u32| timing(sweeps.start + sweep);
                controller.gates_by(foot, directions, reach, &all, timing, &mut some);
                gates.append(&mut some);
            }
        });
        // Beyond the reach no shadow is drawn.
        if reach < end {
            gates.iter_mut().for_each(|gate| gate.end_at(reach));
        }
        // Of what others meet not all was asked for.
        let others = (0..).zip(gates.iter_mut()).filter(|(sweep, _)| !self.gated.contains(sweep));
        others.for_each(|(_, gate)| *gate = Gate::default());
    }

    /// Directions of the sweeps between which all lies that the gates are made of: one more on either side than are wanted, so that
    /// rounding leaves nothing out.
    fn edges(&self, directions: &[[f64; 2]]) -> [[f64; 2]; 2] {
        let last = directions.len() - 1;
        let Range { start, end } = self.gated;
        [directions[(start as usize).saturating_sub(1)], directions[last.min(end as usize)]]
    }

    /// Stored outlines that the storage buffer has as sweep `sweep` begins.
    fn there(&self, cast: &Cast<'_>, absent: &Absent, sweep: u32) -> Vec<Outlines> {
        let start = start_of(self.stage, self.plan.frame, sweep);
        let keeps = |anchor: [f64; 2]| !absent.lacks(anchor, start);
        cast.stored.par_iter().map(|outlines| outlines.only(keeps)).collect()
    }

    /// Runs of sweeps in which the storage buffer lacks the same: what comes during a sweep is there from the next one on.
    fn spells(&self, absent: &Absent) -> Vec<Range<u32>> {
        let arrivals = absent.arrivals();
        let sweeps = self.plan.fan.sweeps;
        let start = |sweep: u32| start_of(self.stage, self.plan.frame, sweep);
        let come = |sweep: u32| arrivals.partition_point(|&arrival| arrival <= start(sweep));
        let begins: Vec<u32> =
            (0..sweeps).filter(|&sweep| sweep == 0 || come(sweep) != come(sweep - 1)).collect();
        let ends = begins.iter().skip(1).copied().chain([sweeps]);
        begins.iter().zip(ends).map(|(&begin, end)| begin..end).collect()
    }

    /// Hands directions of the sweeps, and lists of outlines of all shadows that those can meet whose gates are wanted, to `take`.
    fn with_outlines<T>(
        &self,
        shadows: &Shadows,
        under_sun: &UnderSun<'_>,
        seen: &[u32],
        time: f64,
        take: impl FnOnce(&[[f64; 2]], &Cast<'_>) -> T,
    ) -> T {
        let sweeps = self.plan.fan.sweeps;
        let directions: Vec<[f64; 2]> = (0..sweeps).map(|sweep| self.plan.direction(sweep)).collect();
        let edges = self.edges(&directions);
        let foot = [self.plan.eye[0], self.plan.eye[1]];
        let reach = shadows.reach;
        let (place, scale) = shadows.controller.reading(foot);
        let tiles: Vec<Arc<Tile>> = shadows.bank.around(&self.plan.sun, place, reach / scale, Some(edges));
        let mut cast: Vec<&Outlines> = tiles.iter().map(|tile| &tile.outlines).collect();
        // A map that is read beside its place shows shadows that no sweep meets.
        let all = matches!(self.stage.settings.shadow_controller, ShadowParts::ScanConverter { .. });
        // What falls nearer than the sweeps begin is left out only where it does so all over the fan: wherever it does not, it takes
        // line generators of all sweeps that it crosses.
        let fan = [directions[0], directions[directions.len() - 1]];
        let shades = [(fan, self.table.ranges()[0]), (edges, 0.0)];
        let shades = shades.map(|(edges, start)| Shade::new(foot, edges, start, &self.plan.sun));
        let may_fall = |body: &Body| {
            let place = [body.centre.x, body.centre.y];
            all || shades.iter().all(|shade| shade.may_meet(place, body.radius))
        };
        let meets = |(centre, radius)| all || self.plan.sweeps_of(centre, radius).is_some();
        let of_bodies = seen.par_iter().filter_map(|&number| {
            let body = self.body(number);
            may_fall(body).then(|| under_sun.shadow(number, body, meets)).flatten()
        });
        cast.par_extend(of_bodies);
        let (patches, own) = (self.patches(time), self.own_shadow(shadows, may_fall));
        cast.push(&patches);
        take(&directions, &Cast { stored: &cast, own: &own })
    }

    /// Outlines of the shadow that the vehicle casts on the ground: as of any body, but found anew for every pose.
    fn own_shadow(&self, shadows: &Shadows, may_fall: impl Fn(&Body) -> bool + Sync) -> Vec<Outlines> {
        let FramePlan { eye, roll, pitch, heading, .. } = *self.plan;
        let parts = self.stage.scenery.own_bodies(eye, Attitude { roll, pitch, heading });
        let falling = parts.par_iter().filter(|part| may_fall(part));
        falling.map(|part| shadows.bank.cast_by_body(part, &self.plan.sun)).collect()
    }

    /// Outlines of the track patches that lie at `time`.
    fn patches(&self, time: f64) -> Outlines {
        let patches = self.stage.scenery.patches(time);
        Outlines::of(&patches.iter().map(|patch| patch.corners).collect::<Vec<_>>())
    }

    /// Leaves the spans of bodies in `polyhedra`; returns what they took.
    fn project(
        &self,
        seen: &[u32],
        under_sun: Option<&UnderSun<'_>>,
        polyhedra: &mut PolyhedronGenerator,
    ) -> Census {
        let laws = self.stage.settings.laws;
        let view = view_plane(self.stage, self.plan, &self.raster);
        let tangents: Vec<f64> =
            (0..self.plan.fan.sweeps).map(|sweep| self.plan.fan.tangent(sweep)).collect();
        let field = Field::new(&view, &tangents);
        let drawn = |&number: &u32| {
            let body = self.body(number);
            let aspect = field.aspect(body)?;
            let dark = under_sun.is_some_and(|sun| sun.is_dark(number, body));
            let vanishes = dark && laws.shadowed_bodies == ShadowedBodies::Vanish;
            let hidden = laws.body_visibility == BodyVisibility::AsReported && self.is_hidden(body.foot);
            let absent = self.absent_bodies.binary_search(&number).is_ok();
            (!vanishes && !hidden && !absent).then_some(Drawn { aspect, dark })
        };
        let sun = DVec3::from_array(self.plan.sun.direction());
        let light = FaceLight { sun, shading: laws.body_shading };
        polyhedra.run(&field, &light, seen, drawn)
    }

    /// Whether nearer ground hides a foot point: the rule of the report, at the samples of the sweep through it.
    fn is_hidden(&self, foot: DVec3) -> bool {
        let [x, y, height] = self.plan.eye;
        let (north, east) = (foot.x - x, foot.y - y);
        let range = (north * north + east * east).sqrt();
        let curvature = self.stage.settings.laws.curvature;
        let tangent = |ground: f64, at: f64| (ground - curvature.drop(at) - height) / at;
        let own = tangent(foot.z, range);
        let ranges = self.table.ranges();
        let nearer = ranges.partition_point(|&at| at < range * NEAR_FOOT);
        ranges[..nearer].iter().any(|&at| {
            let ground = self.stage.landscape.height(x + north * at / range, y + east * at / range);
            ground.is_some_and(|ground| tangent(ground, at) > own)
        })
    }
}

/// Boundaries of some outlines, each with the tick from which on it is there.
fn boundaries<'a>(
    outlines: &'a Outlines,
    absent: Option<&'a Absent>,
) -> impl Iterator<Item = ShadowBoundary> + 'a {
    outlines.chains().flat_map(move |[first, last]| {
        let comes = absent.and_then(|absent| absent.comes(outlines.corners().get(first)));
        let there_from = comes.unwrap_or(Some(Tick(0)));
        (first..last).map(move |number| {
            let segment = outlines.segment(number);
            ShadowBoundary { ends: [segment.from, segment.to], there_from }
        })
    })
}

/// Share of the way to a foot point over which ground may hide it: on the last hundredth it is its own ground.
const NEAR_FOOT: f64 = 0.99;
