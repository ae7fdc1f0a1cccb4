//! The generator made ready for a stage.

use faces::Order;
use generator::{
    Fact, FrameCounts, FrameError, Omission, Planes, PrepareError, Session as GeneratorSession, Stage,
    Weight, check_free_eye, photographs_beside,
};
use glam::DVec3;
use scenario::{FaceList, Pose};
use signal::{Probe, Wire};

use crate::name::NAME;
use crate::parameters::Parameters;
use crate::planes;
use crate::scan_line::{Covers, across, cover, covers, interpolation_word};
use crate::scene::Scene;
use crate::signals;

/// The generator made ready for one stage.
pub(crate) struct Session {
    stage: Stage,
    run: Parameters,
}

impl Session {
    /// Makes ready for `stage`.
    ///
    /// # Errors
    /// If a list has too many faces.
    pub fn new(stage: Stage, run: Parameters) -> Result<Self, PrepareError> {
        for FaceList { group, .. } in stage.scenery.face_lists().of_machines() {
            let faces = group.mesh.faces().len();
            if faces > run.limit as usize {
                return Err(PrepareError::Unsupported {
                    generator: NAME,
                    what: format!("{faces} faces of list {} (at most {})", group.name, run.limit),
                    remedy: "raise faces.limit, or give the list fewer faces".into(),
                });
            }
        }
        // A hull that is whole below the water needs depth, whatever the run asks for.
        let order = if stage.scenery.face_lists().by_depth { Order::Depth } else { run.order };
        Ok(Self { stage, run: Parameters { order, ..run } })
    }

    fn scene(&self, frame: u64, pose: &Pose) -> Result<Scene, FrameError> {
        self.check(frame, pose)?;
        Scene::new(&self.stage, self.run, frame, pose)
    }
}

impl GeneratorSession for Session {
    fn frame(
        &self,
        frame: u64,
        pose: &Pose,
        planes: &mut Planes,
        probe: &mut Probe,
    ) -> Result<FrameCounts, FrameError> {
        let scene = self.scene(frame, pose)?;
        let size = [self.stage.view.columns as usize, self.stage.view.lines as usize];
        let lines = planes::scan_lines(&scene, &self.run, size);
        planes::fill(&scene, &self.run, &lines, planes);
        signals::record(frame, &scene, &lines, probe);
        Ok(planes::counts(&scene, &lines))
    }

    fn check(&self, frame: u64, pose: &Pose) -> Result<(), FrameError> {
        check_free_eye(&self.stage.landscape, frame, pose)
    }

    fn omissions(&self) -> Vec<Omission> {
        let Stage { landscape, scenery, view } = &self.stage;
        let lacks = [
            (!scenery.all_effects().is_empty(), "lights, sheets and discs of the sky"),
            (!scenery.patches(f64::INFINITY).is_empty(), "vehicle tracks"),
            (landscape.texture().is_some(), "texture"),
            (!landscape.silhouettes().is_empty(), "far silhouettes"),
            (view.shadows.is_some(), "remote shadow"),
        ];
        let omission = |what: &str| Omission {
            block: NAME,
            what: what.into(),
            why: "it draws opaque faces".into(),
            weight: Weight::NotModelled,
        };
        let lacks = lacks.into_iter().filter(|(is_there, _)| *is_there).map(|(_, what)| omission(what));
        let told = scenery.face_lists().warnings.iter().map(|warning| Omission {
            block: NAME,
            what: warning.clone(),
            why: "it is allowed, but may not show what was meant".into(),
            weight: Weight::NotModelled,
        });
        lacks.chain(photographs_beside(landscape, NAME)).chain(told).collect()
    }

    fn wires(&self) -> Vec<Wire> {
        signals::wires(&self.stage.view)
    }

    /// The faces at the middle of a pixel, as they win, with list, sun, brightness and depth; then those without a slot on the line.
    fn explain(&self, frame: u64, pose: &Pose, pixel: [usize; 2]) -> Result<Vec<Fact>, FrameError> {
        let scene = self.scene(frame, pose)?;
        let axis = across(&self.run);
        let Covers { drawn: mut found, missed, counts: [crossings, without] } =
            covers(&scene, &self.run, [pixel[axis], pixel[1 - axis]]);
        let mut facts = Vec::new();
        while !found.is_empty() {
            let judged: Vec<_> = found.iter().map(|of_piece| cover(&scene, *of_piece)).collect();
            let Some(first) = self.run.order.seen(&judged) else { break };
            let (piece, [q, brightness]) = found.remove(first);
            let what = if facts.is_empty() { "shown" } else { "behind it" };
            facts.push(Fact::new(what, told(&scene, piece, [q, brightness])));
        }
        if facts.is_empty() {
            facts.push(Fact::new("sky", "no face covers the middle of the pixel"));
        }
        facts.extend(missed.into_iter().map(|(piece, at)| Fact::new("missed", told(&scene, piece, at))));
        if let Some(slots) = self.run.edges_line {
            let told = format!("{crossings} crossings, {slots} slots, {without} missed");
            facts.push(Fact::new("scan line", told));
        }
        facts.push(Fact::new("brightness", format!("linear {}", interpolation_word(self.run.interpolation))));
        Ok(facts)
    }
}

/// A piece in words.
fn told(scene: &Scene, piece: u32, [q, brightness]: [f64; 2]) -> String {
    let of = &scene.pieces[piece as usize];
    let list = &scene.lists[of.list as usize];
    let corners =
        of.spots.iter().map(|spot| format!("{:.4}", spot.brightness)).collect::<Vec<_>>().join(", ");
    let sun = DVec3::from_array(list.sun);
    format!(
        "face {} of {} (list {} of {}): depth {:.3} m, brightness {brightness:.4} between corners {corners}; sun {:.4} north, {:.4} east, {:.4} up{}",
        of.face,
        list.name,
        of.list + 1,
        scene.lists.len(),
        1.0 / q,
        sun.x,
        sun.y,
        sun.z,
        list.level.map_or("", |_| "; laid upon what is behind it")
    )
}
