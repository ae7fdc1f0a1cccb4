//! The generator made ready for a stage.

use faces::Order;
use generator::{
    Fact, FrameCounts, FrameError, Omission, Planes, PrepareError, Session as GeneratorSession, Stage,
    Weight, check_free_eye, photographs_beside,
};
use glam::DVec3;
use scenario::{FaceList, Pose};
use signal::{Probe, Wire};

use crate::frame_lists;
use crate::hardware::{Hardware, Kind};
use crate::name::NAME;
use crate::parameters::Parameters;
use crate::piece::Piece;
use crate::planes;
use crate::scan_line::{Covers, across, cover, covers, interpolation_word, lost_covers};
use crate::scene::{List, Scene};
use crate::schedule::Schedule;
use crate::signals;

/// The generator made ready for one stage.
pub(crate) struct Session {
    pub stage: Stage,
    pub run: Parameters,
    pub hardware: Hardware,
    pub schedule: Schedule,
}

impl Session {
    /// Makes ready for `stage`.
    ///
    /// # Errors
    /// If a list has too many faces, or pictures are late and the stage does not have the course of the mission.
    pub fn new(stage: Stage, run: Parameters, hardware: Hardware) -> Result<Self, PrepareError> {
        let lists = frame_lists::drawn(&stage, &run);
        for FaceList { group, .. } in &lists {
            let faces = group.mesh.faces().len();
            if faces > run.limit as usize {
                return Err(PrepareError::Unsupported {
                    generator: NAME,
                    what: format!("{faces} faces of list {} (at most {})", group.name, run.limit),
                    remedy: "raise faces.limit, or give the list fewer faces".into(),
                });
            }
        }
        if run.delayed && hardware.delay_frames > 0 && stage.scenery.course().is_empty() {
            return Err(PrepareError::Unsupported {
                generator: NAME,
                what: "delayed pictures without the frames before".into(),
                remedy: "give the stage the course of its mission".into(),
            });
        }
        let schedule = Schedule::new(&stage, &lists, &run, &hardware);
        // A hull that is whole below the water needs depth, whatever the run asks for.
        let order = if stage.scenery.face_lists().by_depth { Order::Depth } else { run.order };
        Ok(Self { run: Parameters { order, ..run }, stage, hardware, schedule })
    }

    /// Columns and lines of the screen.
    pub fn size(&self) -> [usize; 2] {
        [self.stage.view.columns as usize, self.stage.view.lines as usize]
    }

    /// Samples of a scan line.
    pub fn samples(&self) -> usize {
        self.size()[1 - across(&self.run)]
    }

    /// The frame whose state the picture of `frame` shows, with its pose: its own from `pose`, or an earlier one where pictures are late.
    ///
    /// # Errors
    /// If that is not a frame of the mission.
    pub fn seen(&self, frame: u64, pose: &Pose) -> Result<(u64, Pose), FrameError> {
        if !self.run.delayed || self.hardware.delay_frames == 0 {
            return Ok((frame, *pose));
        }
        let earlier = frame.saturating_sub(u64::from(self.hardware.delay_frames));
        let pose = self.stage.scenery.course().get(earlier as usize).copied();
        let reason = || {
            format!("frame {earlier}, which it shows, is not among those of the mission; choose one of those")
        };
        Ok((earlier, pose.ok_or_else(|| FrameError::Refused { frame, reason: reason() })?))
    }

    /// The frame that shows in the picture of `frame`.
    ///
    /// # Errors
    /// If it cannot be drawn.
    pub fn scene(&self, frame: u64, pose: &Pose) -> Result<Scene, FrameError> {
        let (seen, pose) = self.seen(frame, pose)?;
        check_free_eye(&self.stage.landscape, frame, &pose)?;
        Scene::new(self, seen, &pose)
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
        let lines = planes::scan_lines(&scene, &self.run, self.size());
        planes::fill(&scene, &self.run, &lines, planes);
        signals::record(frame, &scene, &self.run, &lines, probe);
        Ok(planes::counts(&scene, &lines))
    }

    fn check(&self, frame: u64, pose: &Pose) -> Result<(), FrameError> {
        check_free_eye(&self.stage.landscape, frame, &self.seen(frame, pose)?.1)
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

    /// The faces at the middle of a pixel, as they win, with list, sun, brightness and depth; then those without a slot on the line or in
    /// the frame, and what is late of the first.
    fn explain(&self, frame: u64, pose: &Pose, pixel: [usize; 2]) -> Result<Vec<Fact>, FrameError> {
        let scene = self.scene(frame, pose)?;
        let axis = across(&self.run);
        let Covers { drawn: mut found, missed, counts: [crossings, without] } =
            covers(&scene, &self.run, [pixel[axis], pixel[1 - axis]]);
        let mut facts = Vec::new();
        let mut late = Vec::new();
        while !found.is_empty() {
            let judged: Vec<_> = found.iter().map(|of_piece| cover(&scene, *of_piece)).collect();
            let Some(first) = self.run.order.seen(&judged) else { break };
            let (piece, [q, brightness]) = found.remove(first);
            let of = &scene.pieces[piece as usize];
            let what = if facts.is_empty() { "shown" } else { "behind it" };
            if facts.is_empty() {
                late = late_facts(&scene.lists[of.list as usize], self.seen(frame, pose)?.0);
            }
            facts.push(Fact::new(what, told(&scene, of, [q, brightness])));
        }
        if facts.is_empty() {
            facts.push(Fact::new("sky", "no face covers the middle of the pixel"));
        }
        let missed = missed.into_iter().map(|(piece, at)| (&scene.pieces[piece as usize], at));
        facts.extend(missed.map(|(piece, at)| Fact::new("missed", told(&scene, piece, at))));
        let lost = lost_covers(&scene, &self.run, [pixel[axis], pixel[1 - axis]]);
        facts.extend(lost.into_iter().map(|(piece, at)| Fact::new("lost", told(&scene, piece, at))));
        facts.extend(late);
        if let Some(slots) = scene.slots {
            let told = format!("{crossings} crossings, {slots} slots, {without} missed");
            facts.push(Fact::new("scan line", told));
        }
        facts.push(Fact::new("brightness", format!("linear {}", interpolation_word(self.run.interpolation))));
        Ok(facts)
    }
}

/// What a list shows of frames before `frame`.
fn late_facts(list: &List, frame: u64) -> Vec<Fact> {
    let late = Kind::ALL.into_iter().zip(list.shown).filter(|(_, shown)| *shown != frame);
    late.map(|(kind, shown)| {
        Fact::new("late", format!("{} of {}: that of frame {shown}", kind.word(), list.name))
    })
    .collect()
}

/// A piece in words.
fn told(scene: &Scene, of: &Piece, [q, brightness]: [f64; 2]) -> String {
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
