//! How a picture builds up: which sweep completes each pixel.

use rayon::iter::{IntoParallelIterator, ParallelIterator};

use crate::{DriveError, Viewpoint};

impl Viewpoint<'_> {
    /// The sweep that completes each pixel, line after line: the later of the two between which the pixel lies, as yoke, pitch and projection
    /// of the frame put it. A pixel beyond the first or the last sweep has that sweep. Errors of registration are left out.
    ///
    /// # Errors
    /// If the hybrid machine does not draw, or the pose cannot be drawn.
    pub fn completing_sweeps(&self) -> Result<Vec<u16>, DriveError> {
        let Self { drive, bench, frame, pose } = self;
        if !drive.opened.is_machine() {
            let title = format!("{} has no sweeps that build up a picture", drive.drawn_by());
            return Err(DriveError::asked(drive.file(), title, "a hardware model"));
        }
        let raster = &bench.machine.settings.raster;
        let [columns, lines] = [raster.columns, raster.lines].map(|count| count as usize);
        let last = f64::from(raster.sweeps.saturating_sub(1));
        drive.pool.install(|| {
            let sweeps = bench.control().sweeps(*frame, pose);
            let sweeps = sweeps.map_err(|error| DriveError::of(drive.file(), &error))?;
            let of_line = |line: usize| {
                let sweeps = &sweeps;
                let place = move |column| sweeps.place_of(pose, [column, line])[0];
                (0..columns)
                    .map(place)
                    .map(|place| place.ceil().clamp(0.0, last) as u16)
                    .collect::<Vec<u16>>()
            };
            Ok((0..lines).into_par_iter().flat_map_iter(of_line).collect())
        })
    }
}
