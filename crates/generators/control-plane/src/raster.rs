//! What the sweeps write: the screen, or more of it where the yoke turns the picture.

use hardware_model::{Settings, SweepMemoryKind};
use scenario::FieldOfView;
use sweep_memory::{TubeRaster, covering};

/// Field and lines of the raster that is written.
#[derive(Debug, Clone, Copy)]
pub struct WrittenRaster {
    /// Field of view of all sweeps.
    pub field: FieldOfView,
    /// Lines of a sweep.
    pub lines: usize,
}

impl WrittenRaster {
    /// The raster of a run: its lines are as fine as the screen's, and as many more as the corners need.
    pub fn new(settings: &Settings) -> Self {
        let raster = &settings.raster;
        let lines = raster.lines as usize;
        let Some(yoke) = settings.yoke else { return Self { field: raster.field, lines } };
        let field = covering(raster.field, yoke.travel);
        let growth = field.tan_half_height / raster.field.tan_half_height;
        let finer = match settings.sweep_memory {
            SweepMemoryKind::ScanConverter => CELLS_A_LINE,
            SweepMemoryKind::DigitalMemory => 1.0,
        };
        Self { field, lines: (f64::from(raster.lines) * growth * finer).ceil() as usize }
    }

    /// The same on the target of a storage tube, `sweeps` side by side.
    pub fn on_tube(&self, sweeps: u32) -> TubeRaster {
        let width = self.field.tan_half_width / self.field.tan_half_height;
        TubeRaster { sweeps: sweeps as usize, lines: self.lines, width }
    }
}

/// Cells of a sweep in a line of the screen where the yoke turns: a turned line begins and ends between them.
const CELLS_A_LINE: f64 = 4.0;
