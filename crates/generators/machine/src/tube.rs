//! Pictures out of stores: how they are read, and what a storage tube has left of earlier ones.

use std::sync::Arc;

use control_plane::FramePlan;
use generator::FrameError;
use hardware_model::SweepMemoryKind;
use signal::Real;
use signal_plane::Wanted;
use sweep_memory::{Memory, Reading, Tube, View};

use crate::elaborated::Elaborated;
use crate::residue::Written;

impl<S: Real> Elaborated<S> {
    /// What the read beam makes of `store`, which was written by `plan`, and of what `tube` has left of `earlier` ones, under
    /// the angle `yoke` (rad). A picture lies in its tube where it was written: each is read by its own fan and pitch.
    pub(crate) fn read_stored(
        &self,
        tube: &Tube,
        (plan, yoke): (&FramePlan, f64),
        (store, earlier): (&mut [f32], &[Arc<Written>]),
        columns: usize,
        picture: &mut [f32],
    ) {
        let mut scratch = self.stores.take();
        let pictures: Vec<Vec<f32>> = earlier
            .iter()
            .map(|written| {
                let (mut store, mut left) = (written.1.clone(), vec![0.0; picture.len()]);
                tube.read(plan.frame, &mut store, &mut scratch);
                self.reading(&written.0, yoke, columns).read_all(&store, &mut left);
                left
            })
            .collect();
        tube.read(plan.frame, store, &mut scratch);
        self.reading(plan, yoke, columns).read_all(store, picture);
        tube.combine(picture, &pictures.iter().map(Vec::as_slice).collect::<Vec<_>>());
        self.stores.give_back(scratch);
    }

    /// Keeps what was written by `plan` as long as `tube` may show it.
    pub(crate) fn keep_store(&self, tube: &Tube, plan: &FramePlan, store: &[f32]) {
        if tube.memory_frames() > 0 {
            let most = 2 * tube.memory_frames() + 2;
            self.stores_before.keep(plan.frame, Arc::new((*plan, store.to_vec())), most);
        }
    }

    /// What was written in the frames that `tube` still shows in `frame`, nearest first.
    pub(crate) fn earlier(&self, tube: &Tube, frame: u64) -> Result<Vec<Arc<Written>>, FrameError> {
        tube.earlier(frame).map_while(|frame| self.written(frame)).collect()
    }

    /// What was written in an earlier frame, drawn again if nobody has kept it; `None` if its pose is not known.
    pub(crate) fn written(&self, frame: u64) -> Option<Result<Arc<Written>, FrameError>> {
        if let Some(written) = self.stores_before.get(frame) {
            return Some(Ok(written));
        }
        let pose = self.stage.scenery.course().get(frame as usize)?;
        let draw = || {
            let begun = self.begin(frame, pose)?;
            let mut store = Vec::new();
            let wanted = Wanted { look: &(), picture: &self.all_sweeps() };
            self.write(&begun.plan, &begun, wanted, &mut store);
            self.deliveries.give_back(begun.delivery);
            Ok(Arc::new((begun.plan, store)))
        };
        Some(draw())
    }

    /// How a picture of so many columns is read.
    pub(crate) fn reading(&self, plan: &FramePlan, yoke: f64, columns: usize) -> Reading {
        let settings = &self.stage.settings;
        let memory = match (settings.sweep_memory, settings.yoke) {
            (SweepMemoryKind::ScanConverter, _) => Memory::ScanConverter,
            (SweepMemoryKind::DigitalMemory, None) => Memory::Digital,
            (SweepMemoryKind::DigitalMemory, Some(_)) => Memory::DigitalTurned,
        };
        let view = View {
            fan: plan.fan,
            projection: settings.laws.projection,
            pitch: plan.pitch,
            raster: self.raster.field,
            field: settings.raster.field,
            yoke,
        };
        let (cells, lines) = (self.raster.lines, settings.raster.lines as usize);
        Reading { memory, view, cells, columns, lines }
    }
}
