//! A machine at the start of a sweep: what it remembers there, and how it goes on.
//!
//! All else at that place follows from the mission and the place alone: the programs of the sweeps, the registers, the noise.

use std::ops::Range;
use std::sync::Arc;

use control_plane::{FramePlan, MachineStage};
use generator::{FrameError, PlaneKind, Planes, Session};
use scenario::{Pose, Scalar};
use signal::Real;
use signal_plane::Wanted;

use crate::again::Again;
use crate::elaborated::{Begun, Elaborated};

/// What a machine remembers at the start of a sweep. Values are linear reflectivity, without unit.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Memory {
    /// What the sweeps of the frame have written so far, sweep by sweep.
    pub rows: Vec<f32>,
    /// What was written in earlier frames and still lies in a storage tube: frame and whole store, ascending.
    pub stores: Vec<(u64, Arc<Vec<f32>>)>,
    /// What was read in earlier frames and still glows on the picture tube: frame and picture, ascending.
    pub pictures: Vec<(u64, Arc<Vec<f32>>)>,
}

/// How much is in a [`Memory`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Sizes {
    /// Sweeps of a frame.
    pub sweeps: u32,
    /// Values that a sweep writes.
    pub cells: usize,
    /// Columns and lines of a picture.
    pub pixels: [usize; 2],
}

/// A machine that can stop at the start of a sweep and go on there.
pub trait Resumes: Session {
    /// How much the machine remembers.
    fn sizes(&self) -> Sizes;

    /// Earlier frames whose stores, and those whose pictures, the machine remembers in `frame`.
    fn remembered(&self, frame: u64) -> [Range<u64>; 2];

    /// Puts stores and pictures in: whatever needs them from now on takes these.
    fn remember(&self, memory: &Memory);

    /// What the machine remembers at the start of sweep `sweep` of `frame`, which is seen from `pose`. `known` has rows of
    /// the frame that are written already, from its first sweep on.
    ///
    /// # Errors
    /// If the pose, or that of an earlier frame, cannot be drawn.
    fn memory(&self, place: (u64, u32), pose: &Pose, known: &[f32]) -> Result<Memory, FrameError>;

    /// Draws the rest of `frame`, whose first sweeps wrote `rows`, and returns its picture: linear intensity.
    ///
    /// # Errors
    /// If the pose, or that of an earlier frame that a tube still shows, cannot be drawn.
    fn go_on(&self, frame: u64, pose: &Pose, rows: &[f32]) -> Result<Planes, FrameError>;
}

/// Elaborates the machine of `stage` so that it can stop and go on.
pub fn prepare_resumes(stage: MachineStage) -> Box<dyn Resumes> {
    match stage.settings.scalar {
        Scalar::F32 => Box::new(Elaborated::<f32>::new(stage)),
        Scalar::F64 => Box::new(Elaborated::<f64>::new(stage)),
    }
}

impl<S: Real> Resumes for Elaborated<S> {
    fn sizes(&self) -> Sizes {
        let raster = &self.stage.settings.raster;
        let pixels = [raster.columns as usize, raster.lines as usize];
        Sizes { sweeps: raster.sweeps, cells: self.raster.lines, pixels }
    }

    fn remembered(&self, frame: u64) -> [Range<u64>; 2] {
        let stored = self.parts.tube.as_ref().and_then(|tube| tube.later(0).last());
        let shown = self.parts.picture_tube.as_ref().map(|tube| tube.frames_before(0));
        [stored, shown].map(|frames| frame.saturating_sub(frames.unwrap_or(0))..frame)
    }

    fn remember(&self, memory: &Memory) {
        for (frame, store) in &memory.stores {
            self.remember_store(*frame, store);
        }
        if let Some(tube) = &self.parts.picture_tube {
            memory.pictures.iter().for_each(|(frame, read)| self.keep_picture(tube, *frame, read));
        }
    }

    fn memory(&self, (frame, sweep): (u64, u32), pose: &Pose, known: &[f32]) -> Result<Memory, FrameError> {
        self.draw_remembered(frame)?;
        let [stores, pictures] = self.remembered(frame);
        let store = |frame| Some((frame, Arc::new(self.stores_before.get(frame)?.1.clone())));
        let picture = |frame| Some((frame, self.pictures.get(frame)?));
        let begun = self.begin(frame, pose)?;
        let memory = Memory {
            stores: stores.filter_map(store).collect(),
            pictures: pictures.filter_map(picture).collect(),
            rows: self.rows(&begun, sweep, known),
        };
        self.deliveries.give_back(begun.delivery);
        Ok(memory)
    }

    fn go_on(&self, frame: u64, pose: &Pose, rows: &[f32]) -> Result<Planes, FrameError> {
        let Sizes { sweeps, pixels: [columns, lines], .. } = self.sizes();
        let begun = self.begin(frame, pose)?;
        let mut store = self.rows(&begun, sweeps, rows);
        let mut planes = Planes::new(columns, lines, &[PlaneKind::Intensity]);
        let light = planes.get_mut(PlaneKind::Intensity).unwrap_or_default();
        match &self.parts.tube {
            Some(tube) => {
                self.keep_store(tube, &begun.plan, &store);
                let earlier = self.earlier(tube, frame)?;
                self.read_stored(tube, (&begun.plan, pose.yoke), (&mut store, &earlier), columns, light);
            }
            None => self.reading(&begun.plan, pose.yoke, columns).read_all(&store, light),
        }
        self.deliveries.give_back(begun.delivery);
        if let Some(tube) = &self.parts.picture_tube {
            self.show(tube, [frame, tube.kept_showing()], Arc::new(light.to_vec()), light)?;
        }
        self.draw_spots(&self.beam_alone(frame, pose)?, light);
        Ok(planes)
    }
}

impl<S: Real> Elaborated<S> {
    /// Keeps a store of an earlier frame, whose pose the mission knows, as long as the storage tube may show it.
    fn remember_store(&self, frame: u64, store: &[f32]) {
        let pose = self.stage.scenery.course().get(frame as usize);
        let plan = pose.map(|pose| FramePlan::new(frame, pose, &self.stage, &self.raster.field));
        if let (Some(tube), Some(Ok(plan))) = (&self.parts.tube, plan) {
            self.keep_store(tube, &plan, store);
        }
    }

    /// Draws what the machine remembers of frames before `frame` and nobody has kept, the earliest first: each then finds
    /// what it needs itself.
    fn draw_remembered(&self, frame: u64) -> Result<(), FrameError> {
        let [stores, pictures] = self.remembered(frame);
        let missing = pictures.clone().find(|earlier| self.pictures.get(*earlier).is_none());
        let first = missing.map_or(stores.start, |earlier| self.remembered(earlier)[0].start);
        for earlier in first.min(stores.start)..frame {
            match &self.parts.picture_tube {
                Some(tube) if pictures.contains(&earlier) => {
                    self.read_before(tube, earlier).transpose()?;
                }
                _ => {}
            }
            self.draw_store(earlier)?;
        }
        Ok(())
    }

    /// Draws the store of an earlier frame if nobody has kept it, and keeps it.
    fn draw_store(&self, frame: u64) -> Result<(), FrameError> {
        let Some(tube) = self.parts.tube.as_ref().filter(|tube| tube.memory_frames() > 0) else {
            return Ok(());
        };
        if let Some(written) = self.written(frame).transpose()? {
            self.keep_store(tube, &written.0, &written.1);
        }
        Ok(())
    }

    /// What the first `count` sweeps of a frame write; those that are `known` are not drawn.
    fn rows(&self, begun: &Begun, count: u32, known: &[f32]) -> Vec<f32> {
        let values = count as usize * self.raster.lines;
        let known = &known[..known.len().min(values)];
        let rest = (known.len() / self.raster.lines) as u32..count;
        if rest.is_empty() {
            return known.to_vec();
        }
        let mut store = Vec::new();
        let wanted = Wanted { look: &Again(&rest), picture: &(0..0) };
        self.write(&begun.plan, begun, wanted, &mut store);
        store.truncate(values);
        store[..known.len()].copy_from_slice(known);
        store
    }
}
