//! Bodies that are near enough to be drawn (section 12; economy).

use crate::stage::MachineStage;
use glam::DVec3;
use polyhedron_generator::{LeftOut, Sight};
use rayon::iter::{IndexedParallelIterator, ParallelIterator};
use rayon::slice::ParallelSlice;
use scenario::{FieldOfView, Standing};
use solids::Body;

use crate::blocks::Blocks;
use crate::frame_plan::FramePlan;

/// Bodies that are looked at together.
const TOGETHER: usize = 1024;

/// The bodies of a frame, by their numbers in the list of the mission, and what is too far to be seen.
#[derive(Debug, Default)]
pub(crate) struct InSight {
    pub bodies: Vec<u32>,
    pub left_out: LeftOut,
}

impl InSight {
    /// Bodies that stand at `time` (s).
    pub fn of(stage: &MachineStage, blocks: &Blocks, plan: &FramePlan, time: f64) -> Self {
        if !blocks.bodies {
            return Self::default();
        }
        let sight = stage.settings.economy.leaves_out_small_bodies().then(|| sight(stage));
        let eye = DVec3::from_array(plan.eye);
        let some = |(number, standing): (usize, &[Standing])| {
            let mut left_out = LeftOut::default();
            let mut is_seen = |Standing { from, until, body }: &Standing| {
                let stands = *from <= time && time < *until;
                stands && sight.is_none_or(|sight| sight.resolves(eye, body, &mut left_out))
            };
            let numbered = ((number * TOGETHER) as u32..).zip(standing);
            let bodies: Vec<u32> =
                numbered.filter(|(_, standing)| is_seen(standing)).map(|(number, _)| number).collect();
            (bodies, left_out)
        };
        let (mut bodies, mut left_out) = (Vec::new(), LeftOut::default());
        let all: Vec<_> = stage.scenery.standing().par_chunks(TOGETHER).enumerate().map(some).collect();
        bodies.reserve_exact(all.iter().map(|(some, _)| some.len()).sum());
        for (some, left) in all {
            bodies.extend(some);
            left_out.bodies += left.bodies;
            left_out.cells += left.cells;
        }
        left_out.cells *= pixels_a_cell(stage) * with_shadow(blocks, plan);
        Self { bodies, left_out }
    }

    /// Of the bodies of the sector only those that a processor has ready which came as far as `vertices`, the nearest first. It
    /// has nothing to do for the others, whose shadows may fall into the sector.
    pub fn keep_ready(&mut self, stage: &MachineStage, plan: &FramePlan, vertices: u64) {
        let body = |number: u32| &stage.scenery.standing()[number as usize].body;
        let eye = DVec3::from_array(plan.eye);
        let distance = |number: u32| body(number).centre.distance(eye);
        let bodies = std::mem::take(&mut self.bodies);
        let edges = plan.edges();
        let (mut ahead, beside): (Vec<u32>, _) =
            bodies.into_iter().partition(|&number| is_ahead(eye, edges, body(number)));
        ahead.sort_by(|&a, &b| distance(a).total_cmp(&distance(b)));
        let mut left = vertices;
        ahead.retain(|&number| {
            let count = body(number).vertices().len() as u64;
            let is_ready = count <= left;
            left = if is_ready { left - count } else { 0 };
            is_ready
        });
        self.bodies = beside;
        self.bodies.extend(ahead);
        self.bodies.sort_unstable();
    }
}

/// Whether a body reaches into the sector between two directions, as seen from `eye` (m).
pub(crate) fn is_ahead(eye: DVec3, [[ln, le], [rn, re]]: [[f64; 2]; 2], body: &Body) -> bool {
    let [north, east] = [body.centre.x - eye.x, body.centre.y - eye.y];
    let (right_of_left, left_of_right) = (ln * east - le * north, north * re - east * rn);
    right_of_left > -body.radius && left_of_right > -body.radius
}

/// Vertices that the processor transforms for the frame at `time` (s): those of bodies that are as large as a resolution
/// cell and in the sector of the sweeps, whatever else is drawn for the sake of economy.
pub fn vertices(stage: &MachineStage, blocks: &Blocks, plan: &FramePlan, time: f64) -> u64 {
    if !blocks.bodies {
        return 0;
    }
    let (eye, sight, mut beyond) = (DVec3::from_array(plan.eye), sight(stage), LeftOut::default());
    // Once a frame: the compiler does not always see that all bodies have the same.
    let edges = plan.edges();
    let mut is_wanted = |body: &Body| is_ahead(eye, edges, body) && sight.resolves(eye, body, &mut beyond);
    stage.scenery.bodies(time).filter(|body| is_wanted(body)).map(|body| body.vertices().len() as u64).sum()
}

/// From which size on bodies are told.
pub(crate) fn sight(stage: &MachineStage) -> Sight {
    let raster = stage.settings.raster;
    Sight::new(f64::from(raster.lines), 2.0 * libm::atan(raster.field.tan_half_height))
}

/// Most pixels of the screen in a square resolution cell, which is as wide as a line is high: not less than 1, and
/// more in the corners, where a pixel subtends less.
pub(crate) fn pixels_a_cell(stage: &MachineStage) -> f64 {
    let raster = stage.settings.raster;
    let FieldOfView { tan_half_width, tan_half_height } = raster.field;
    let columns = f64::from(raster.columns) / tan_half_width;
    let squeeze = (columns * tan_half_height / f64::from(raster.lines)).max(1.0);
    let corner = 1.0 + tan_half_width * tan_half_width + tan_half_height * tan_half_height;
    squeeze * corner * corner.sqrt()
}

/// What a body can darken beside itself: its shadow on level ground, `1 / sin e` times its own outline.
fn with_shadow(blocks: &Blocks, plan: &FramePlan) -> f64 {
    blocks.shadows.as_ref().map_or(1.0, |_| 1.0 + 1.0 / libm::sin(plan.sun.elevation))
}
