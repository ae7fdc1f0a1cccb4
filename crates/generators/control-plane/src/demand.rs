//! What the frames of a mission ask their data banks for (hardware section 4.7).

use data_bank::{Demand, Piece, corners_of, nearest_first};
use dpu::Sector;
use feature_generator::CRATER_WORDS;
use glam::DVec3;
use hardware_model::{BankPlace, KindBank};
use landscape::Level;
use polyhedron_generator::LeftOut;
use remote_shadow::{Footings, Outlines};
use scenario::{BodyShading, Pose};
use shadow_controller::SEGMENT_WORDS;
use solids::Body;
use std::collections::BTreeSet;

use crate::blocks::Blocks;
use crate::data_kind::DataKind;
use crate::frame_plan::{FramePlan, turned};
use crate::raster::WrittenRaster;
use crate::sight::{InSight, is_ahead, sight};
use crate::squares::{Chains, SquareGrid, Stored, record_by_record};
use crate::stage::MachineStage;
use crate::ticks::frame_ticks;

/// Words of a vertex: its three coordinates; with smooth light its brightness too.
const VERTEX_WORDS: usize = 3;
const SMOOTH_VERTEX_WORDS: usize = VERTEX_WORDS + 1;

/// Words of a face: its reflectivity.
const FACE_WORDS: usize = 1;

/// Time between two directories of the shadow bank (s of the mission): which square has how many records under the sun of that moment.
/// Chosen: a sun that moves draws new boundaries for every frame, but moves them into another square in hours.
const SHADOW_DIRECTORY: f64 = 1.0;

/// The squares of a kind, and what lies in them for the whole mission.
#[derive(Debug)]
pub(crate) struct Layout {
    pub grid: SquareGrid,
    pub bank: KindBank,
    /// Nothing of shadows, whose boundaries move with the sun and with the eye.
    pub chains: Chains,
}

/// How the kinds beside terrain lie in their banks; none of a kind that has none.
#[derive(Debug)]
pub(crate) struct Layouts([Option<Layout>; 3]);

/// Where the data of a kind lie.
pub(crate) fn place(stage: &MachineStage, kind: DataKind) -> BankPlace {
    let banks = &stage.settings.kind_banks;
    match kind {
        DataKind::Fine => BankPlace::Apart,
        DataKind::Coarse => banks.coarse,
        DataKind::Features => banks.features.place,
        DataKind::Shadows => banks.shadows.place,
        DataKind::Polyhedra => banks.polyhedra.place,
    }
}

/// Whether a kind has anything to bring, from drums.
pub(crate) fn has_bank(stage: &MachineStage, blocks: &Blocks, kind: DataKind) -> bool {
    let has_data = match kind {
        DataKind::Fine => true,
        DataKind::Coarse => blocks.coarse.is_some(),
        DataKind::Features => blocks.features && !stage.landscape.features().is_empty(),
        DataKind::Shadows => blocks.shadows.is_some(),
        DataKind::Polyhedra => blocks.bodies,
    };
    has_data && place(stage, kind) != BankPlace::Local && stage.settings.data_banks.drum.is_some()
}

impl Layouts {
    /// The layouts of a mission.
    pub fn new(stage: &MachineStage, blocks: &Blocks) -> Self {
        let MachineStage { landscape, scenery, settings } = stage;
        let layout = |kind: DataKind, bank: KindBank, stored: &mut dyn Iterator<Item = Stored>| {
            has_bank(stage, blocks, kind).then(|| {
                let grid = SquareGrid::new(landscape.level(), &bank);
                Layout { grid, bank, chains: Chains::new(&grid, bank.record_words, stored) }
            })
        };
        let banks = settings.kind_banks;
        let craters = landscape.features().craters();
        let mut features = (0..craters.len() as u32).map(|crater| stored_crater(craters.circle(crater)));
        let vertex_words = match settings.laws.body_shading {
            BodyShading::Flat => VERTEX_WORDS,
            BodyShading::Smooth => SMOOTH_VERTEX_WORDS,
        };
        let mut bodies = scenery.standing().iter().map(|standing| stored_body(&standing.body, vertex_words));
        Self([
            layout(DataKind::Features, banks.features, &mut features),
            layout(DataKind::Shadows, banks.shadows, &mut std::iter::empty()),
            layout(DataKind::Polyhedra, banks.polyhedra, &mut bodies),
        ])
    }

    /// The layout of a kind, if it has a bank and is no terrain.
    pub fn of(&self, kind: DataKind) -> Option<&Layout> {
        match kind {
            DataKind::Fine | DataKind::Coarse => None,
            DataKind::Features => self.0[0].as_ref(),
            DataKind::Shadows => self.0[1].as_ref(),
            DataKind::Polyhedra => self.0[2].as_ref(),
        }
    }
}

fn stored_crater((centre, outer): ([f64; 2], f64)) -> Stored {
    let [low, high] = [-outer, outer].map(|reach| centre.map(|place| place + reach));
    Stored { anchor: centre, low, high, words: CRATER_WORDS }
}

fn stored_body(body: &Body, vertex_words: usize) -> Stored {
    let centre = [body.centre.x, body.centre.y];
    let [low, high] = [-body.radius, body.radius].map(|reach| centre.map(|place| place + reach));
    let words = vertex_words * body.solid.vertices().len() + FACE_WORDS * body.solid.faces().len();
    Stored { anchor: [body.foot.x, body.foot.y], low, high, words: words as u32 }
}

/// Each of some outlines, as it lies in the shadow bank.
fn stored_outlines(outlines: &Outlines) -> impl Iterator<Item = Stored> {
    outlines.chains().map(|[first, last]| {
        let corners = || (first..=last).map(|number| outlines.corners().get(number));
        let bound = |start: f64, of: fn(f64, f64) -> f64| {
            corners().fold([start; 2], |bound, corner| [of(bound[0], corner[0]), of(bound[1], corner[1])])
        };
        Stored {
            anchor: outlines.corners().get(first),
            low: bound(f64::INFINITY, f64::min),
            high: bound(f64::NEG_INFINITY, f64::max),
            words: SEGMENT_WORDS.saturating_mul((last - first) as u32),
        }
    })
}

/// Who asks: the frames of a mission.
#[derive(Clone, Copy)]
pub(crate) struct Asking<'a> {
    pub stage: &'a MachineStage,
    pub blocks: &'a Blocks,
    pub raster: &'a WrittenRaster,
    pub footings: &'a Footings,
    pub layouts: &'a Layouts,
}

/// What a frame can meet: its view, and how far beside it (rad).
struct View<'a> {
    plan: FramePlan,
    pose: &'a Pose,
    margin: f64,
}

impl Asking<'_> {
    /// What frame `frame` asks of each of `kinds`, the nearest first, with the way that the view turns until the drum has come round
    /// once and a half.
    pub fn demand(&self, kinds: &[DataKind], frame: u64) -> Demand {
        let [start, end] = frame_ticks(self.stage, frame);
        let view = self.view(frame, end.0 - start.0);
        let wants =
            kinds.iter().map(|&kind| view.as_ref().map_or_else(Vec::new, |view| self.wants(kind, view)));
        Demand { frame, start, end, wants: wants.collect() }
    }

    /// The view of a frame of `ticks` ticks; none if it cannot be drawn.
    fn view(&self, frame: u64, ticks: u64) -> Option<View<'_>> {
        let course = self.stage.scenery.course();
        let pose = |frame: u64| course.get((frame as usize).min(course.len().saturating_sub(1)));
        let now = pose(frame)?;
        let turn = pose(frame.saturating_sub(1)).map_or(0.0, |before| turned(before, now));
        let rotation = self.stage.settings.data_banks.drum.map_or(0, |drum| drum.rotation);
        // Orders are given as frames begin: one a little short of a frame away is a frame away.
        let margin = turn.abs() * (1.5 * rotation as f64 / ticks as f64).ceil();
        let plan = FramePlan::new(frame, now, self.stage, &self.raster.field).ok()?;
        Some(View { plan, pose: now, margin })
    }

    fn wants(&self, kind: DataKind, view: &View<'_>) -> Vec<Piece> {
        let levels = self.stage.landscape.bank().levels();
        if let Some(level) = kind.level() {
            return self.corners(&levels[level], level, view);
        }
        let Some(layout) = self.layouts.of(kind) else { return Vec::new() };
        let mut pieces = match kind {
            DataKind::Shadows => self.shadows(layout, view),
            DataKind::Polyhedra => self.bodies(layout, view),
            _ => layout.chains.met_by(&view.sector(self.stage.settings.range.end), layout.bank.record_words),
        };
        layout.grid.nearest_first(&mut pieces, view.foot());
        match kind {
            DataKind::Features => record_by_record(&pieces, layout.grid.count()),
            _ => pieces,
        }
    }

    /// Ground range up to which a level is drawn in the frame of `plan` (m).
    fn reach(&self, number: usize, plan: &FramePlan) -> f64 {
        let end = self.stage.settings.range.end;
        match (number, &self.blocks.coarse) {
            (0, Some(_)) => plan.switch.range.min(end),
            _ => end,
        }
    }

    fn corners(&self, level: &Level, number: usize, view: &View<'_>) -> Vec<Piece> {
        let foot = level.in_regions(view.plan.eye[0], view.plan.eye[1]);
        let edges = view.plan.edges_beside(view.margin);
        let sector = Sector { foot, edges, range: self.reach(number, &view.plan) / level.region_size() };
        let mut corners = corners_of(sector.regions(level), level.corners());
        nearest_first(&mut corners, level.corners()[1], foot);
        corners.into_iter().map(Piece::one).collect()
    }

    /// Squares with boundaries of shadow that the frame can meet, by the last directory: those of the ground, of bodies and of tracks.
    /// The vehicle's own shadow comes from the processor, for every frame anew.
    fn shadows(&self, layout: &Layout, view: &View<'_>) -> Vec<Piece> {
        let Some(shadows) = &self.blocks.shadows else { return Vec::new() };
        let (foot, time) = (view.foot(), view.pose.time);
        let sun = self.stage.scenery.sun(SHADOW_DIRECTORY * (time / SHADOW_DIRECTORY).floor());
        let (place, scale) = shadows.controller.reading(foot);
        let edges = view.plan.edges_beside(view.margin);
        let tiles = shadows.bank.around(&sun, place, shadows.reach / scale, edges);
        let standing = self.stage.scenery.standing();
        let under_sun = self.footings.under(sun, standing.len(), &shadows.bank);
        let bodies = InSight::of(self.stage, self.blocks, &view.plan, time).bodies.into_iter();
        let cast =
            bodies.filter_map(|number| under_sun.shadow(number, &standing[number as usize].body, |_| true));
        let patches: Vec<_> = self.stage.scenery.patches(time).iter().map(|patch| patch.corners).collect();
        let patches = Outlines::of(&patches);
        let outlines = tiles.iter().map(|tile| &tile.outlines).chain(cast).chain([&patches]);
        let chains = Chains::new(&layout.grid, layout.bank.record_words, outlines.flat_map(stored_outlines));
        chains.met_by(&view.sector(shadows.reach), layout.bank.record_words)
    }

    /// Records with bodies that the frame draws, or would draw if the view turned by the margin.
    fn bodies(&self, layout: &Layout, view: &View<'_>) -> Vec<Piece> {
        let (eye, sight, mut beyond) =
            (DVec3::from_array(view.plan.eye), sight(self.stage), LeftOut::default());
        let leaves_out = self.stage.settings.economy.leaves_out_small_bodies();
        let (edges, time) = (view.plan.edges_beside(view.margin), view.pose.time);
        let mut is_wanted = |body: &Body| {
            edges.is_none_or(|edges| is_ahead(eye, edges, body))
                && (!leaves_out || sight.resolves(eye, body, &mut beyond))
        };
        let standing = self.stage.scenery.standing().iter().enumerate();
        let there = standing.filter(|(_, standing)| standing.from <= time && time < standing.until);
        let wanted = there.filter(|(_, standing)| is_wanted(&standing.body));
        let records: BTreeSet<u32> =
            wanted.flat_map(|(number, standing)| layout.records_of_body(number, &standing.body)).collect();
        records.into_iter().map(Piece::one).collect()
    }
}

impl Layout {
    /// Records that hold body `number` of the mission.
    pub fn records_of_body(&self, number: usize, body: &Body) -> impl Iterator<Item = u32> + use<> {
        self.chains.records_of(&self.grid, number, [body.foot.x, body.foot.y])
    }
}

impl View<'_> {
    /// Foot of the eye: north, east (m).
    fn foot(&self) -> [f64; 2] {
        [self.plan.eye[0], self.plan.eye[1]]
    }

    /// The ground of the view with its margin, out to `range` (m).
    fn sector(&self, range: f64) -> Sector {
        Sector { foot: self.foot(), edges: self.plan.edges_beside(self.margin), range }
    }
}
