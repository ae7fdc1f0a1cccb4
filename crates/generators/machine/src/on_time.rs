//! A frame twice: as it is, and as it would be with some late words on time.

use std::ops::Range;
use std::sync::Arc;

use control_plane::{FramePlan, LateCrossing, MachineStage};
use generator::{FrameError, PlaneKind, Planes};
use scenario::{Pose, Scalar};
use signal::{Real, Waveform};
use signal_plane::{Look, Recorded, Wanted};

use crate::elaborated::Elaborated;
use crate::residue::Written;

/// Late words that are to be on time, and what is drawn again for them.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct OnTime {
    /// The fold that found them missing.
    pub late: LateCrossing,
    /// Sweeps of its frame that are drawn again; the others are taken over. Words of a sweep change that sweep alone.
    pub again: Range<u32>,
}

/// A machine that draws frames as they are and, beside them, with late words on time.
pub trait Twice: Send + Sync {
    /// The picture of `frame` from `pose`: linear intensity as it is, then with the words on time. The service of the
    /// crossings, the processor and the drums do in both what they did.
    ///
    /// # Errors
    /// If the pose, or that of an earlier frame that the tube still shows, cannot be drawn.
    fn twice(&self, frame: u64, pose: &Pose, on_time: &OnTime) -> Result<[Planes; 2], FrameError>;

    /// Later frames in whose pictures the tube still shows `frame`, the next first; none without a tube that keeps anything.
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
        let raster = &self.stage.settings.raster;
        let (columns, lines) = (raster.columns as usize, raster.lines as usize);
        let plan = FramePlan::new(frame, pose, &self.stage, &self.raster.field)?;
        let written = self.written_twice((&plan, pose.time), None, on_time)?;
        if let Some(tube) = &self.parts.tube {
            self.keep(tube, &plan, &written[0].1);
        }
        let earlier = self.earlier_twice(frame, on_time)?;
        let show = |(written, earlier): (Arc<Written>, Vec<Arc<Written>>)| {
            let mut planes = Planes::new(columns, lines, &[PlaneKind::Intensity]);
            let picture = planes.get_mut(PlaneKind::Intensity).unwrap_or_default();
            match &self.parts.tube {
                Some(tube) => {
                    self.show(tube, (&plan, pose.yoke), (&mut written.1.clone(), &earlier), columns, picture)
                }
                None => self.reading(&plan, pose.yoke, columns).read_all(&written.1, picture),
            }
            planes
        };
        let [is, would_be] = written;
        let [before_it, before_other] = earlier;
        Ok([(is, before_it), (would_be, before_other)].map(show))
    }

    fn later(&self, frame: u64) -> Vec<u64> {
        self.parts.tube.as_ref().map_or_else(Vec::new, |tube| tube.later(frame).collect())
    }
}

impl<S: Real> Elaborated<S> {
    /// What the frame of `plan` at `time` (s) writes, as it is, which may be `known`, and with the words on time: the same
    /// store where the words are of another frame.
    fn written_twice(
        &self,
        (plan, time): (&FramePlan, f64),
        known: Option<&Arc<Written>>,
        on_time: &OnTime,
    ) -> Result<[Arc<Written>; 2], FrameError> {
        self.prepared(plan, time, |delivery, digital| {
            let draw = || {
                let mut store = Vec::new();
                let wanted = Wanted { look: &(), picture: true };
                self.write(plan, delivery, digital, wanted, &mut store);
                Arc::new((*plan, store))
            };
            let is = known.map_or_else(draw, Arc::clone);
            let mut would_be = Arc::clone(&is);
            if plan.frame == on_time.late.frame {
                let other = plan.with_words_on_time(on_time.late);
                let wanted = Wanted { look: &Again(&on_time.again), picture: false };
                self.write(&other, delivery, digital, wanted, &mut Arc::make_mut(&mut would_be).1);
            }
            [is, would_be]
        })
    }

    /// What the tube still holds of earlier frames in the picture of `frame`, nearest first.
    fn earlier_twice(&self, frame: u64, on_time: &OnTime) -> Result<[Vec<Arc<Written>>; 2], FrameError> {
        let Some(tube) = &self.parts.tube else { return Ok([Vec::new(), Vec::new()]) };
        let is = self.earlier(tube, frame)?;
        let late = on_time.late.frame;
        let pose = self.stage.scenery.course().get(late as usize);
        let would_be = is.iter().map(|written| match pose.filter(|_| written.0.frame == late) {
            Some(pose) => {
                let both = self.written_twice((&written.0, pose.time), Some(written), on_time);
                both.map(|[_, other]| other)
            }
            None => Ok(Arc::clone(written)),
        });
        let would_be = would_be.collect::<Result<_, _>>()?;
        Ok([is, would_be])
    }
}

/// Looks at no signal, and has these sweeps drawn.
struct Again<'a>(&'a Range<u32>);

impl Look for Again<'_> {
    fn wants_any_of(&self, sweeps: Range<u32>) -> bool {
        sweeps.start < self.0.end && self.0.start < sweeps.end
    }

    fn look<S: Real>(&self, _: &Recorded<'_, S>, _: usize, _: u32, _: &mut Vec<Waveform>) {}
}
