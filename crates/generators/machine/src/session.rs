//! A frame of the machine, from its pose to its planes.

use control_plane::FramePlan;
use generator::{FrameCounts, FrameError, Omission, PlaneKind, Planes, Session};
use scenario::Pose;
use signal::{Probe, Real, Waveform, Wire};
use signal_plane::{Look, Wanted, wires};

use crate::counts::{MachineCounts, delivery_counts};
use crate::elaborated::Elaborated;
use crate::omissions::omissions;
use crate::picture::Picture;

impl<S: Real> Elaborated<S> {
    /// One frame, and what `look` has seen of it.
    pub fn draw(
        &self,
        frame: u64,
        pose: &Pose,
        planes: &mut Planes,
        look: &impl Look,
    ) -> Result<(FrameCounts, Vec<Waveform>), FrameError> {
        let settings = &self.stage.settings;
        let plan = FramePlan::new(frame, pose, &self.stage, &self.raster.field)?;
        let digital = self.digital_frame(&plan, pose.time);
        let delivery = self.deliver(&plan, &digital, pose.time)?;
        let (columns, wanted) = (planes.columns(), Wanted { look, picture: planes.any() });
        let mut nothing = [];
        let pixels = planes.get_mut(PlaneKind::Intensity).unwrap_or(&mut nothing);
        let groups = match &self.parts.tube {
            Some(tube) if !pixels.is_empty() => {
                let mut store = self.stores.take();
                let groups = self.write(&plan, &delivery, &digital, wanted, &mut store);
                self.keep(tube, &plan, &store);
                let earlier = self.earlier(tube, frame)?;
                self.show(tube, (&plan, pose.yoke), (&mut store, &earlier), columns, pixels);
                self.stores.give_back(store);
                groups
            }
            _ => {
                let picture = Picture::new(self.reading(&plan, pose.yoke, columns), pixels);
                self.write_and_read(&plan, &delivery, &digital, wanted, &picture)
            }
        };
        let regions = plan.visible_regions(self.stage.landscape.level(), settings.range.end);
        let mut total = MachineCounts { regions: regions as u64, ..delivery_counts(&delivery) };
        self.deliveries.give_back(delivery);
        let mut waveforms = Vec::new();
        for group in groups {
            total.add(&group.counts);
            waveforms.extend(group.waveforms);
        }
        Ok((total.into(), waveforms))
    }
}

impl<S: Real> Session for Elaborated<S> {
    fn frame(
        &self,
        frame: u64,
        pose: &Pose,
        planes: &mut Planes,
        probe: &mut Probe,
    ) -> Result<FrameCounts, FrameError> {
        let (counts, waveforms) = self.draw(frame, pose, planes, &*probe)?;
        probe.waveforms.extend(waveforms);
        Ok(counts)
    }

    fn check(&self, frame: u64, pose: &Pose) -> Result<(), FrameError> {
        FramePlan::new(frame, pose, &self.stage, &self.raster.field).map(drop)
    }

    fn omissions(&self) -> Vec<Omission> {
        omissions(&self.stage, &self.list)
    }

    fn wires(&self) -> Vec<Wire> {
        wires(&self.stage, &self.blocks, &self.raster)
    }

    fn direction(&self, frame: u64, pose: &Pose, line: u32) -> Result<Option<[f64; 2]>, FrameError> {
        let plan = FramePlan::new(frame, pose, &self.stage, &self.raster.field)?;
        Ok(Some(plan.direction(line)))
    }
}
