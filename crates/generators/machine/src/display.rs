//! Pictures that were read, and what the picture tube shows of them.

use std::sync::Arc;

use control_plane::{Delivery, DigitalFrame, FramePlan};
use generator::FrameError;
use picture_tube::PictureTube;
use scenario::Pose;
use signal::Real;
use signal_plane::{Look, Wanted};

use crate::elaborated::Elaborated;
use crate::groups::GroupResult;
use crate::picture::Picture;

/// Frames that are on their way beside one for each thread.
const MORE_FRAMES: usize = 4;

impl<S: Real> Elaborated<S> {
    /// Writes the sweeps of a frame that has begun, and reads them into `picture`, if that has any pixels.
    pub(crate) fn read(
        &self,
        (plan, digital, delivery): &(FramePlan, DigitalFrame, Delivery),
        yoke: f64,
        wanted: Wanted<'_, impl Look>,
        picture: &mut [f32],
    ) -> Result<Vec<GroupResult>, FrameError> {
        let columns = self.stage.settings.raster.columns as usize;
        match &self.parts.tube {
            Some(tube) if !picture.is_empty() => {
                let mut store = self.stores.take();
                let groups = self.write(plan, delivery, digital, wanted, &mut store);
                self.read_stored(tube, plan, yoke, &mut store, columns, picture)?;
                self.stores.give_back(store);
                Ok(groups)
            }
            _ => {
                let picture = Picture::new(self.reading(plan, yoke, columns), picture);
                Ok(self.write_and_read(plan, delivery, digital, wanted, &picture))
            }
        }
    }

    /// The picture that is read in a frame, without anything else of it.
    pub(crate) fn read_alone(&self, frame: u64, pose: &Pose) -> Result<Arc<Vec<f32>>, FrameError> {
        let raster = &self.stage.settings.raster;
        let mut picture = vec![0.0; raster.columns as usize * raster.lines as usize];
        let begun = self.begin(frame, pose)?;
        self.read(&begun, pose.yoke, Wanted { look: &(), picture: true }, &mut picture)?;
        self.deliveries.give_back(begun.2);
        Ok(Arc::new(picture))
    }

    /// The light of a showing of a frame that reads `read`, and of what the tube still shows of earlier ones. Nothing is done
    /// for a picture without pixels.
    pub(crate) fn show(
        &self,
        tube: &PictureTube,
        [frame, showing]: [u64; 2],
        read: Arc<Vec<f32>>,
        light: &mut [f32],
    ) -> Result<(), FrameError> {
        if light.is_empty() {
            return Ok(());
        }
        self.keep(tube, frame, &read);
        let before = (1..=tube.frames_before(showing)).map_while(|age| frame.checked_sub(age));
        let before: Vec<_> =
            before.map_while(|frame| self.read_before(tube, frame)).collect::<Result<_, _>>()?;
        let pictures: Vec<&[f32]> = [&read].into_iter().chain(&before).map(|read| read.as_slice()).collect();
        let mut scratch = self.stores.take();
        tube.show(frame, showing, &pictures, light, &mut scratch);
        self.stores.give_back(scratch);
        Ok(())
    }

    /// The picture that was read in an earlier frame, read again if nobody has kept it; `None` if its pose is not known.
    fn read_before(&self, tube: &PictureTube, frame: u64) -> Option<Result<Arc<Vec<f32>>, FrameError>> {
        if let Some(read) = self.pictures_before.get(frame) {
            return Some(Ok(read));
        }
        let pose = self.stage.scenery.course().get(frame as usize)?;
        let read = self.read_alone(frame, pose);
        Some(read.inspect(|read| self.keep(tube, frame, read)))
    }

    /// Keeps a picture for its repeats, and for frames after it.
    fn keep(&self, tube: &PictureTube, frame: u64, read: &Arc<Vec<f32>>) {
        let most = 2 * tube.frames_before(0) as usize + rayon::current_num_threads() + MORE_FRAMES;
        self.pictures_before.keep(frame, Arc::clone(read), most);
    }
}
