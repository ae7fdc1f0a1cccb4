//! A frame twice: as it is, and as it would be with some late words on time.

use std::collections::BTreeSet;
use std::iter::once;
use std::mem;
use std::ops::Range;
use std::sync::Arc;

use control_plane::{FramePlan, LateOf, LateWords, MachineStage};
use generator::{FrameError, PlaneKind, Planes};
use scenario::{Pose, Scalar};
use signal::Real;
use signal_plane::Wanted;

use crate::again::Again;
use crate::elaborated::{Begun, Elaborated};
use crate::residue::Written;

/// Late words that are to be on time, and what is drawn again for them.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct OnTime {
    /// The words, and what waited for them.
    pub late: LateWords,
    /// Sweeps of its frame that are drawn again; the others are taken over. Words of a fold or a crater change their sweep alone, words
    /// of a shadow boundary all sweeps that are drawn with the same set-up.
    pub again: Range<u32>,
}

/// A machine that draws frames as they are and, beside them, with late words on time.
pub trait Twice: Send + Sync {
    /// The picture of `frame` from `pose`: linear intensity as it is, then with the words on time. The service of the
    /// crossings, the processor and the drums do in both what they did.
    ///
    /// # Errors
    /// If the pose, or that of an earlier frame that a tube still shows, cannot be drawn.
    fn twice(&self, frame: u64, pose: &Pose, on_time: &OnTime) -> Result<[Planes; 2], FrameError>;

    /// Later frames in whose pictures a tube still shows `frame`, the next first; none if neither the storage tube nor the
    /// picture tube keeps anything.
    fn later(&self, frame: u64) -> Vec<u64>;
}

/// Elaborates the machine of `stage` to draw frames twice.
pub fn prepare_twice(stage: MachineStage) -> Box<dyn Twice> {
    match stage.settings.scalar {
        Scalar::F32 => Box::new(Elaborated::<f32>::new(stage)),
        Scalar::F64 => Box::new(Elaborated::<f64>::new(stage)),
    }
}

impl<S: Real> Twice for Elaborated<S> {
    fn twice(&self, frame: u64, pose: &Pose, on_time: &OnTime) -> Result<[Planes; 2], FrameError> {
        let read = self.read_twice(frame, pose, on_time)?;
        let before = self.read_before_twice(frame, on_time)?;
        let raster = &self.stage.settings.raster;
        // The list is that of the frame as it is.
        let list = self.beam_alone(frame, pose)?;
        let show = |(read, before): (Vec<f32>, Vec<Arc<Vec<f32>>>)| {
            let (columns, lines) = (raster.columns as usize, raster.lines as usize);
            let mut planes = Planes::new(columns, lines, &[PlaneKind::Intensity]);
            let light = planes.get_mut(PlaneKind::Intensity).unwrap_or_default();
            match &self.parts.picture_tube {
                Some(tube) => self.show_of(tube, [frame, tube.kept_showing()], (&read, &before), light),
                None => light.copy_from_slice(&read),
            }
            self.draw_spots(&list, light);
            planes
        };
        let [is, would_be] = read;
        let [before_it, before_other] = before;
        Ok([(is, before_it), (would_be, before_other)].map(show))
    }

    fn later(&self, frame: u64) -> Vec<u64> {
        let stored = self.read_in(frame);
        let shows =
            self.parts.picture_tube.as_ref().map_or(0, |tube| tube.frames_before(tube.kept_showing()));
        let all = stored.iter().flat_map(|read| (0..=shows).map(move |age| read + age));
        let later: BTreeSet<u64> = all.filter(|later| *later > frame).collect();
        later.into_iter().collect()
    }
}

impl<S: Real> Elaborated<S> {
    /// Frames whose reading has something of what `frame` wrote: itself, and those of which the storage tube keeps it.
    fn read_in(&self, frame: u64) -> Vec<u64> {
        let later = self.parts.tube.as_ref().map(|tube| tube.later(frame));
        once(frame).chain(later.into_iter().flatten()).collect()
    }

    /// What is read in `frame` from `pose`, as it is and with the words on time.
    fn read_twice(&self, frame: u64, pose: &Pose, on_time: &OnTime) -> Result<[Vec<f32>; 2], FrameError> {
        let raster = &self.stage.settings.raster;
        let columns = raster.columns as usize;
        let plan = FramePlan::new(frame, pose, &self.stage, &self.raster.field)?;
        let written = self.written_twice(frame, pose, None, on_time)?;
        if let Some(tube) = &self.parts.tube {
            self.keep_store(tube, &plan, &written[0].1);
        }
        let earlier = self.earlier_twice(frame, on_time)?;
        let read = |(written, earlier): (Arc<Written>, Vec<Arc<Written>>)| {
            let mut picture = vec![0.0; columns * raster.lines as usize];
            match &self.parts.tube {
                Some(tube) => {
                    let mut store = written.1.clone();
                    self.read_stored(tube, (&plan, pose.yoke), (&mut store, &earlier), columns, &mut picture);
                }
                None => self.reading(&plan, pose.yoke, columns).read_all(&written.1, &mut picture),
            }
            picture
        };
        let [is, would_be] = written;
        let [before_it, before_other] = earlier;
        Ok([(is, before_it), (would_be, before_other)].map(read))
    }

    /// What was read in the frames before `frame` that its picture tube still shows, nearest first.
    fn read_before_twice(&self, frame: u64, on_time: &OnTime) -> Result<[Vec<Arc<Vec<f32>>>; 2], FrameError> {
        let Some(tube) = &self.parts.picture_tube else { return Ok([Vec::new(), Vec::new()]) };
        let is = self.pictures_before(tube, [frame, tube.kept_showing()])?;
        let (course, changed) = (self.stage.scenery.course(), self.read_in(on_time.late.frame));
        let would_be = is.iter().zip(1..).map(|(read, age)| {
            let before = frame - age;
            match course.get(before as usize).filter(|_| changed.contains(&before)) {
                Some(pose) => self.read_twice(before, pose, on_time).map(|[_, other]| Arc::new(other)),
                None => Ok(Arc::clone(read)),
            }
        });
        let would_be = would_be.collect::<Result<_, _>>()?;
        Ok([is, would_be])
    }

    /// What `frame` writes from `pose`, as it is, which may be `known`, and with the words on time: the same store where the
    /// words are of another frame.
    fn written_twice(
        &self,
        frame: u64,
        pose: &Pose,
        known: Option<&Arc<Written>>,
        on_time: &OnTime,
    ) -> Result<[Arc<Written>; 2], FrameError> {
        let mut begun = self.begin(frame, pose)?;
        let draw = || {
            let mut store = Vec::new();
            let wanted = Wanted { look: &(), picture: &self.all_sweeps() };
            self.write(&begun.plan, &begun, wanted, &mut store);
            Arc::new((begun.plan, store))
        };
        let is = known.map_or_else(draw, Arc::clone);
        let mut would_be = Arc::clone(&is);
        if frame == on_time.late.frame {
            self.bring_on_time(on_time.late, pose.time, &mut begun)?;
            let wanted = Wanted { look: &Again(&on_time.again), picture: &(0..0) };
            self.write(&begun.plan, &begun, wanted, &mut Arc::make_mut(&mut would_be).1);
        }
        self.deliveries.give_back(begun.delivery);
        Ok([is, would_be])
    }

    /// Has the words on time in a frame at `time` (s) that has begun. Shadow gates belong to the whole frame, so those are delivered
    /// again.
    fn bring_on_time(&self, late: LateWords, time: f64, begun: &mut Begun) -> Result<(), FrameError> {
        let is_of_gate = matches!(late.of, LateOf::Boundary(_));
        let sweep = if is_of_gate { begun.digital.drawn(late.sweep) } else { late.sweep };
        begun.plan = begun.plan.with_words_on_time(LateWords { sweep, ..late });
        if is_of_gate {
            let other = self.deliver(&begun.plan, &begun.digital, time, self.all_sweeps())?;
            self.deliveries.give_back(mem::replace(&mut begun.delivery, other));
        }
        Ok(())
    }

    /// What the storage tube still holds of earlier frames in the picture of `frame`, nearest first.
    fn earlier_twice(&self, frame: u64, on_time: &OnTime) -> Result<[Vec<Arc<Written>>; 2], FrameError> {
        let Some(tube) = &self.parts.tube else { return Ok([Vec::new(), Vec::new()]) };
        let is = self.earlier(tube, frame)?;
        let late = on_time.late.frame;
        let pose = self.stage.scenery.course().get(late as usize);
        let would_be = is.iter().map(|written| match pose.filter(|_| written.0.frame == late) {
            Some(pose) => {
                let both = self.written_twice(late, pose, Some(written), on_time);
                both.map(|[_, other]| other)
            }
            None => Ok(Arc::clone(written)),
        });
        let would_be = would_be.collect::<Result<_, _>>()?;
        Ok([is, would_be])
    }
}
