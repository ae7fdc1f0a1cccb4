//! Pictures that were read, and what the picture tube shows of them.

use std::sync::Arc;

use generator::FrameError;
use picture_tube::PictureTube;
use scenario::Pose;
use signal::Real;
use signal_plane::{Look, Wanted};

use crate::elaborated::{Begun, Elaborated};
use crate::groups::GroupResult;
use crate::picture::Picture;

/// Frames that are on their way beside one for each thread.
const MORE_FRAMES: usize = 4;

impl<S: Real> Elaborated<S> {
    /// Writes the sweeps of a frame that has begun, and reads them into `picture`, if that has any pixels: all of it, or where no
    /// tube keeps it the tiles whose sweeps are all wanted.
    pub(crate) fn read(
        &self,
        begun: &Begun,
        yoke: f64,
        wanted: Wanted<'_, impl Look>,
        picture: &mut [f32],
    ) -> Result<Vec<GroupResult>, FrameError> {
        let (plan, columns) = (&begun.plan, self.stage.settings.raster.columns as usize);
        match &self.parts.tube {
            Some(tube) if !picture.is_empty() => {
                let mut store = self.stores.take();
                let groups = self.write(plan, begun, wanted, &mut store);
                self.keep_store(tube, plan, &store);
                let earlier = self.earlier(tube, plan.frame)?;
                self.read_stored(tube, (plan, yoke), (&mut store, &earlier), columns, picture);
                self.stores.give_back(store);
                Ok(groups)
            }
            _ => {
                let picture = Picture::new(self.reading(plan, yoke, columns), picture, wanted.picture);
                Ok(self.write_and_read(begun, wanted, &picture))
            }
        }
    }

    /// The picture that is read in a frame, without anything else of it.
    pub(crate) fn read_alone(&self, frame: u64, pose: &Pose) -> Result<Arc<Vec<f32>>, FrameError> {
        let raster = &self.stage.settings.raster;
        let mut picture = vec![0.0; raster.columns as usize * raster.lines as usize];
        let begun = self.begin(frame, pose)?;
        self.read(&begun, pose.yoke, Wanted { look: &(), picture: &self.all_sweeps() }, &mut picture)?;
        self.deliveries.give_back(begun.delivery);
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
        self.keep_picture(tube, frame, &read);
        let before = self.pictures_before(tube, [frame, showing])?;
        self.show_of(tube, [frame, showing], (&read, &before), light);
        Ok(())
    }

    /// The light of a showing of a frame that reads `read`, with what was read in the frames `before`, nearest first.
    pub(crate) fn show_of(
        &self,
        tube: &PictureTube,
        [frame, showing]: [u64; 2],
        (read, before): (&[f32], &[Arc<Vec<f32>>]),
        light: &mut [f32],
    ) {
        let pictures: Vec<&[f32]> =
            [read].into_iter().chain(before.iter().map(|read| read.as_slice())).collect();
        let mut scratch = self.stores.take();
        tube.show(frame, showing, &pictures, light, &mut scratch);
        self.stores.give_back(scratch);
    }

    /// The pictures that were read before a frame and count in this showing of it, nearest first.
    pub(crate) fn pictures_before(
        &self,
        tube: &PictureTube,
        [frame, showing]: [u64; 2],
    ) -> Result<Vec<Arc<Vec<f32>>>, FrameError> {
        let before = (1..=tube.frames_before(showing)).map_while(|age| frame.checked_sub(age));
        before.map_while(|frame| self.read_before(tube, frame)).collect()
    }

    /// The picture that was read in an earlier frame, read again if nobody has kept it; `None` if its pose is not known.
    pub(crate) fn read_before(
        &self,
        tube: &PictureTube,
        frame: u64,
    ) -> Option<Result<Arc<Vec<f32>>, FrameError>> {
        if let Some(read) = self.pictures.get(frame) {
            return Some(Ok(read));
        }
        let pose = self.stage.scenery.course().get(frame as usize)?;
        let read = self.read_alone(frame, pose);
        Some(read.inspect(|read| self.keep_picture(tube, frame, read)))
    }

    /// Keeps a picture for its repeats, and for frames after it.
    pub(crate) fn keep_picture(&self, tube: &PictureTube, frame: u64, read: &Arc<Vec<f32>>) {
        let most = 2 * tube.frames_before(0) as usize + rayon::current_num_threads() + MORE_FRAMES;
        self.pictures.keep(frame, Arc::clone(read), most);
    }
}
