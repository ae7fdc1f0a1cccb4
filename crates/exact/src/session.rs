//! `exact` as a generator: checks the pose, draws the columns.

use generator::{
    FrameCounts, FrameError, Generator, Omission, PlaneKind, Planes, PrepareError,
    Session as GeneratorSession, Stage,
};
use landscape::Landscape;
use quantities::degrees;
use rayon::prelude::*;
use scenario::Pose;
use signal::{Probe, Signal};

use crate::column::{Column, Frame, Pixel};
use crate::{Ceilings, Outlook, View};

/// |pitch| + half the vertical field of view stays below this (deg): nadir and zenith lie outside the picture.
const PITCH_LIMIT_DEG: f64 = 80.0;

/// The generator that error is measured against; see the crate's data sheet.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Exact;

impl Generator for Exact {
    fn name(&self) -> &'static str {
        "exact"
    }

    fn signals(&self) -> &'static [Signal] {
        &[]
    }

    fn prepare(&self, stage: Stage) -> Result<Box<dyn GeneratorSession>, PrepareError> {
        let ceilings = Ceilings::new(stage.landscape.level());
        Ok(Box::new(Session { stage, ceilings }))
    }
}

struct Session {
    stage: Stage,
    ceilings: Ceilings,
}

impl GeneratorSession for Session {
    /// The raster is that of `planes`; nothing can be probed.
    fn frame(
        &self,
        frame: u64,
        pose: &Pose,
        planes: &mut Planes,
        _probe: &mut Probe,
    ) -> Result<FrameCounts, FrameError> {
        check_eye(&self.stage.landscape, frame, pose)?;
        self.check_pitch(frame, pose)?;
        let (columns, rays): (Vec<_>, Vec<u64>) = self.columns(pose, planes).into_iter().unzip();
        fill(planes, PlaneKind::Intensity, &columns, |pixel| pixel.intensity);
        fill(planes, PlaneKind::Range, &columns, |pixel| pixel.range);
        Ok(FrameCounts { samples: rays.into_iter().sum(), ..FrameCounts::default() })
    }

    fn omissions(&self) -> Vec<Omission> {
        Vec::new()
    }
}

impl Session {
    /// Pixels of each column from left to right, top line first, and the rays that they took.
    fn columns(&self, pose: &Pose, planes: &Planes) -> Vec<(Vec<Pixel>, u64)> {
        let Stage { landscape, scenery, settings } = &self.stage;
        let sun = &scenery.sun(pose.time);
        let (laws, field) = (settings.laws, settings.raster.field);
        let first = settings.range.at_sample(0, settings.raster.samples as usize);
        let ranges = [first, settings.range.end];
        let outlook = &Outlook::new(landscape.level(), &self.ceilings, pose.eye, laws.curvature, ranges);
        let view = &View::new(laws.projection, &pose.attitude);
        let half_height = field.tan_half_height;
        let frame = Frame { outlook, view, landscape, sun, half_height, lines: planes.lines() };
        let count = planes.columns() as f64;
        let draw = |column: usize| {
            let x = field.tan_half_width * (2.0 * column as f64 + 1.0 - count) / count;
            Column::new(frame, x).draw(laws.pixel_rule)
        };
        (0..planes.columns()).into_par_iter().map(draw).collect()
    }

    fn check_pitch(&self, frame: u64, pose: &Pose) -> Result<(), FrameError> {
        let half_field = degrees(libm::atan(self.stage.settings.raster.field.tan_half_height));
        let pitch_deg = degrees(pose.attitude.pitch);
        match pitch_deg.abs() + half_field < PITCH_LIMIT_DEG {
            true => Ok(()),
            false => Err(FrameError::Pitch { frame, pitch_deg, limit_deg: PITCH_LIMIT_DEG }),
        }
    }
}

fn check_eye(landscape: &Landscape, frame: u64, pose: &Pose) -> Result<(), FrameError> {
    let [x, y, height] = pose.eye;
    let ground = landscape.height(x, y).ok_or(FrameError::OutsideProblemArea { frame, x, y })?;
    match height > ground {
        true => Ok(()),
        false => Err(FrameError::EyeUnderGround { frame, below: ground - height }),
    }
}

fn fill(planes: &mut Planes, kind: PlaneKind, columns: &[Vec<Pixel>], value: fn(&Pixel) -> f64) {
    let Some(values) = planes.get_mut(kind) else { return };
    for (line, row) in values.chunks_mut(columns.len().max(1)).enumerate() {
        for (target, column) in row.iter_mut().zip(columns) {
            *target = value(&column[line]) as f32;
        }
    }
}
