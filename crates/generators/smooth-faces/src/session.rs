//! The generator made ready for a stage.

use generator::{
    FaceScene, Fact, FrameCounts, FrameError, Omission, Planes, PrepareError, Session as GeneratorSession,
    Stage, Weight, check_free_eye, photographs_beside,
};
use glam::DVec3;
use scenario::Pose;
use signal::{Probe, Wire};

use crate::hardware::{Hardware, Kind};
use crate::judged;
use crate::list::List;
use crate::name::NAME;
use crate::parameters::Parameters;
use crate::piece::Piece;
use crate::planes;
use crate::prepared::Prepared;
use crate::scan_line::{Covers, cover, covers, interpolation_word, lost_covers};
use crate::scene::Scene;
use crate::signals;

/// The generator made ready for one stage.
pub(crate) struct Session {
    prepared: Prepared,
}

impl Session {
    /// Makes ready for `stage`.
    ///
    /// # Errors
    /// As [`Prepared::new`].
    pub fn new(stage: Stage, run: Parameters, hardware: Hardware) -> Result<Self, PrepareError> {
        Ok(Self { prepared: Prepared::new(stage, run, hardware)? })
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
        let Prepared { run, .. } = &self.prepared;
        let scene = Scene::new(&self.prepared, frame, pose)?;
        Ok(planes::draw(&scene, run, self.prepared.size(), planes, (frame, probe)))
    }

    fn check(&self, frame: u64, pose: &Pose) -> Result<(), FrameError> {
        check_free_eye(&self.prepared.stage.landscape, frame, &self.prepared.seen(frame, pose)?.1)
    }

    fn omissions(&self) -> Vec<Omission> {
        let Stage { landscape, scenery, view } = &self.prepared.stage;
        let lacks = [
            (!scenery.all_effects().is_empty(), "lights, sheets and discs of the sky"),
            (!scenery.patches(f64::INFINITY).is_empty(), "vehicle tracks"),
            (landscape.texture().is_some(), "texture"),
            (!landscape.silhouettes().is_empty(), "far silhouettes"),
            (view.shadows.is_some(), "remote shadow"),
            (
                scenery.has_laws_of_objects(),
                "laws of reflection of objects (`object.photometry`); their faces return Lambert's light",
            ),
            (
                scenery.face_lists().open_sea.is_some(),
                "sea of true waves (`sea.waves`): `exact` alone has it",
            ),
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
        signals::wires(&self.prepared.stage.view)
    }

    /// The faces at the middle of a pixel, as they win, with list, sun, brightness and depth; then those without a slot on the line or in
    /// the frame, and what is late of the first.
    fn explain(&self, frame: u64, pose: &Pose, pixel: [usize; 2]) -> Result<Vec<Fact>, FrameError> {
        let Prepared { run, .. } = &self.prepared;
        let scene = Scene::new(&self.prepared, frame, pose)?;
        let axis = run.across();
        let Covers { drawn: mut found, missed, counts: [crossings, without] } =
            covers(&scene, run, [pixel[axis], pixel[1 - axis]]);
        let mut facts = Vec::new();
        let mut late = Vec::new();
        while !found.is_empty() {
            let judged: Vec<_> = found.iter().map(|of_piece| cover(&scene, *of_piece)).collect();
            let Some(first) = run.order.seen(&judged) else { break };
            let (piece, [q, brightness]) = found.remove(first);
            let of = &scene.pieces[piece as usize];
            let what = if facts.is_empty() { "shown" } else { "behind it" };
            if facts.is_empty() {
                late = late_facts(&scene.lists[of.list as usize], self.prepared.seen(frame, pose)?.0);
            }
            facts.push(Fact::new(what, told(&scene, of, [q, brightness])));
        }
        if facts.is_empty() {
            facts.push(Fact::new("sky", "no face covers the middle of the pixel"));
        }
        let missed = missed.into_iter().map(|(piece, at)| (&scene.pieces[piece as usize], at));
        facts.extend(missed.map(|(piece, at)| Fact::new("missed", told(&scene, piece, at))));
        let lost = lost_covers(&scene, run, [pixel[axis], pixel[1 - axis]]);
        facts.extend(lost.into_iter().map(|(piece, at)| Fact::new("lost", told(&scene, piece, at))));
        facts.extend(late);
        if let Some(slots) = scene.slots {
            let told = format!("{crossings} crossings, {slots} slots, {without} missed");
            facts.push(Fact::new("scan line", told));
        }
        facts.push(Fact::new("brightness", format!("linear {}", interpolation_word(run.interpolation))));
        Ok(facts)
    }

    fn faces(&self, frame: u64, pose: &Pose) -> Result<Option<FaceScene>, FrameError> {
        Ok(judged::faces(Scene::new(&self.prepared, frame, pose)?, &self.prepared.run))
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
