//! What the machine has to do before frame 0, from the same units that a frame has.

use crate::stage::MachineStage;
use dpu::{HOME_SETS, home_load};
use generator::FrameError;
use hardware_model::{CrossingServer, Settings, Yoke};
use remote_shadow::Tile;
use scenario::{BodyShading, Pose};
use timing::Task;

use crate::control_plane::ControlPlane;
use crate::frame_plan::FramePlan;
use crate::sight::vertices;

impl ControlPlane {
    /// The tasks before the mission, in the order in which they are done; those that take no time are left out. `first` is
    /// the pose of frame 0.
    ///
    /// # Errors
    /// If it cannot be drawn.
    pub fn before_mission(&self, first: &Pose) -> Result<Vec<Task>, FrameError> {
        let plan = self.plan(0, first)?;
        let stage = self.stage();
        let Settings { cpu, raster, .. } = &stage.settings;
        let vertices = vertices(stage, self.blocks(), &plan, first.time);
        let mut tasks = vec![
            task("cpu", "sine-table", raster.sweeps.into(), cpu.sine_table(raster.sweeps)),
            // Visibility says which sector is the first.
            task("cpu", "tables", 1, cpu.frame_tables),
        ];
        tasks.extend(self.first_sectors());
        tasks.extend(self.lights(&plan, first.time));
        tasks.push(task("cpu", "vertices", vertices, vertices * cpu.vertex));
        tasks.extend(first_angle(stage, first.yoke));
        tasks.push(self.home_registers());
        tasks.push(task("cpu", "set-up", 1, cpu.sweep_setup));
        tasks.retain(|task| task.ticks > 0);
        Ok(tasks)
    }

    /// Records of the first sector, kind by kind, until the last is in the storage buffer.
    fn first_sectors(&self) -> impl Iterator<Item = Task> {
        let loads = self.first_loads().into_iter();
        loads.map(|(kind, load)| {
            task(&format!("drum.{}", kind.name()), "first-sector", load.delivered, load.latency_max)
        })
    }

    /// What the processor works out of the sun: shadow on the ground that frame 0 can meet, place by place, and a reflectivity for
    /// each face of the mission; with smooth light a brightness for each vertex too, at the cost of a face (inferred: a sum of normals, its
    /// length, and the product with the sun).
    fn lights(&self, plan: &FramePlan, time: f64) -> Vec<Task> {
        let cpu = &self.stage().settings.cpu;
        let shadows = self.blocks().shadows.as_ref().filter(|_| cpu.shadow_place() > 0);
        let foot = [plan.eye[0], plan.eye[1]];
        let tiles = shadows.map_or(0, |shadows| {
            shadows.bank.around(&plan.sun, foot, shadows.reach, Some(plan.edges())).len() as u64
        });
        let places = tiles * Tile::PLACES;
        let bodies = self.stage().scenery.bodies(time);
        let sizes = bodies.map(|body| [body.solid.faces().len() as u64, body.solid.vertices().len() as u64]);
        let [faces, vertices] = sizes.fold([0, 0], |sum, size| [0, 1].map(|of| sum[of] + size[of]));
        let mut tasks = vec![
            task("cpu", "remote-shadows", places, places * cpu.shadow_place()),
            task("cpu", "face-reflectivities", faces, faces * cpu.face()),
        ];
        if self.stage().settings.laws.body_shading == BodyShading::Smooth {
            tasks.push(task("cpu", "vertex-brightnesses", vertices, vertices * cpu.face()));
        }
        tasks
    }

    /// Both levels have a loader of their own, side by side.
    fn home_registers(&self) -> Task {
        let Settings { loader, cpu, .. } = &self.stage().settings;
        let unit = match loader.served_by {
            CrossingServer::WiredPointers => "loader",
            CrossingServer::IoProcessor => "io-processor",
            CrossingServer::CpuInterrupt => "cpu",
        };
        let levels = 1 + u64::from(self.blocks().coarse.is_some());
        task(unit, "home-registers", levels * u64::from(HOME_SETS), home_load(loader, cpu))
    }
}

fn task(unit: &str, task: &str, pieces: u64, ticks: u64) -> Task {
    Task { unit: unit.into(), task: task.into(), pieces, ticks }
}

/// The yoke's motor from the upright picture to the first, if it has any way to go: pulses, or the whole way of one that has
/// no steps.
fn first_angle(stage: &MachineStage, angle: f64) -> Option<Task> {
    let Yoke { step, rate, .. } = stage.settings.yoke?;
    let pulses = if step > 0.0 { (angle / step).abs().round() as u64 } else { 1 };
    let seconds = angle.abs() / rate;
    let ticks = seconds * stage.settings.timebase.master.hertz();
    Some(task("yoke", "first-angle", pulses, ticks.round() as u64))
}
