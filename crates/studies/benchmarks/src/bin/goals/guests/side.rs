//! A scenario under a generator, made ready.

use std::path::Path;
use std::time::Instant;

use front_door::{Wishes, open};
use generator::{PlaneKind, Planes, Session, Stage};
use rayon::ThreadPool;
use scenario::Pose;
use signal::Probe;

use super::SideChoice;

/// A side of a comparison.
pub struct Side {
    /// The stage that its generator draws.
    pub stage: Stage,
    session: Box<dyn Session>,
    planes: Planes,
    poses: Vec<(u64, Pose)>,
    turn: usize,
}

/// Frames of a mission that a side draws in turns. Chosen: a mesh that is made anew is another one each time.
const FRAMES: u64 = 5;

impl Side {
    /// The side of a choice.
    ///
    /// # Errors
    /// If the scenario cannot be drawn so.
    pub fn new(choice: &SideChoice) -> Result<Self, String> {
        let folder = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../../../scenarios"));
        let path = folder.join(&choice.scenario).with_extension("toml");
        let set = choice.set.iter().map(|(key, value)| (key.clone(), value.clone())).collect();
        let wishes = Wishes { machine: choice.machine.clone(), set, ..Wishes::default() };
        let opened = open(&path, &wishes).map_err(|error| error.to_string())?;
        let stage = opened.stage().map_err(|error| error.to_string())?;
        let (all, count) = (opened.frames(), opened.frames().min(FRAMES));
        let pose = |turn: u64| {
            let frame = if choice.whole { (2 * turn + 1) * all / (2 * count) } else { turn };
            let table = opened.poses(&stage, frame..frame + 1).map_err(|problems| problems.to_string())?;
            Ok((frame, table.rows()[0].pose))
        };
        let poses = (0..count).map(pose).collect::<Result<Vec<_>, String>>()?;
        let colours = [PlaneKind::Intensity, PlaneKind::Red, PlaneKind::Green, PlaneKind::Blue];
        let kinds = if opened.generator.draws_colour(&stage) { &colours[..] } else { &colours[..1] };
        let planes = Planes::new(stage.view.columns as usize, stage.view.lines as usize, kinds);
        let session = opened.generator.prepare(stage.clone()).map_err(|error| error.to_string())?;
        Ok(Self { stage, session, planes, poses, turn: 0 })
    }

    /// Draws its next frame by the threads of `pool`: how long that took (s).
    ///
    /// # Errors
    /// If it cannot be drawn.
    pub fn draw(&mut self, pool: &ThreadPool) -> Result<f64, String> {
        let (frame, pose) = self.poses[self.turn % self.poses.len()];
        self.turn += 1;
        let (session, planes) = (&self.session, &mut self.planes);
        let begin = Instant::now();
        let drawn = pool.install(|| session.frame(frame, &pose, planes, &mut Probe::off()));
        drawn.map(|_| begin.elapsed().as_secs_f64()).map_err(|error| error.to_string())
    }

    /// The last picture that was drawn (intensity), line by line, and the frame with its pose.
    ///
    /// # Errors
    /// If none was drawn.
    pub fn picture(&self) -> Result<(Vec<f32>, u64, Pose), String> {
        let picture = self.planes.get(PlaneKind::Intensity).ok_or("no picture")?.to_vec();
        let (frame, pose) = self.poses[self.turn.checked_sub(1).ok_or("no picture")? % self.poses.len()];
        Ok((picture, frame, pose))
    }

    /// The session that draws.
    pub fn session(&self) -> &dyn Session {
        &*self.session
    }
}
