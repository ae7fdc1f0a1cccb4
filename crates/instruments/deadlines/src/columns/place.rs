//! From a pixel of the screen to the sweeps it is read from, and to the part of them that it shows.

use std::ops::RangeInclusive;

use hardware_model::{Settings, SweepMemoryKind};
use quantities::sin_cos;
use scenario::{FieldOfView, Pose, Projection};
use sweep_memory::covering;
use sweep_program::Fan;

/// A share in a pixel that no eye and no count of levels finds.
const NO_SHARE: f64 = 1e-3;

/// The read beam over the raster of one pose.
#[derive(Debug, Clone, Copy)]
pub struct Screen {
    fan: Fan,
    kind: SweepMemoryKind,
    /// Sine and cosine of the pitch by which sweeps are oblique.
    pitch: [f64; 2],
    /// Sine and cosine of the yoke's angle.
    yoke: [f64; 2],
    /// Columns and lines of the screen.
    pixels: [usize; 2],
    /// Field of the screen, and that which is written.
    fields: [FieldOfView; 2],
    /// Cells of a sweep.
    cells: usize,
}

/// What the read beam meets at a pixel.
#[derive(Debug, Clone, PartialEq)]
pub struct Spot {
    /// Sweeps that have a share in it.
    pub sweeps: RangeInclusive<u32>,
    /// Its upper edge, in cells from the top of a sweep.
    pub top: f64,
}

impl Screen {
    /// The screen of a run, for sweeps of `cells` cells that were written from `written` and are read under the angle
    /// `yoke` (rad). `None` if no fan covers the pose.
    pub fn new(settings: &Settings, written: &Pose, yoke: f64, cells: usize) -> Option<Self> {
        let (raster, projection) = (&settings.raster, settings.laws.projection);
        let field = settings.yoke.map_or(raster.field, |yoke| covering(raster.field, yoke.travel));
        let pitch = written.attitude.pitch;
        let (sin, cos) = if projection == Projection::Exact { sin_cos(pitch) } else { (0.0, 1.0) };
        let (turn_sin, turn_cos) = if settings.yoke.is_some() { sin_cos(yoke) } else { (0.0, 1.0) };
        Some(Self {
            fan: Fan::covering(projection, pitch, &field, raster.sweeps)?,
            kind: settings.sweep_memory,
            pitch: [sin, cos],
            yoke: [turn_sin, turn_cos],
            pixels: [raster.columns as usize, raster.lines as usize],
            fields: [raster.field, field],
            cells,
        })
    }

    /// What the read beam meets at a pixel.
    pub fn spot(&self, column: usize, line: usize) -> Spot {
        let [field, written] = self.fields;
        let place = |index: usize, count: usize| (2 * index + 1) as f64 / count as f64 - 1.0;
        let x = field.tan_half_width * place(column, self.pixels[0]);
        let y = field.tan_half_height * place(line, self.pixels[1]);
        let [sin, cos] = self.yoke;
        let (x, y) = (cos * x - sin * y, sin * x + cos * y);
        let middle = 0.5 * (y / written.tan_half_height + 1.0) * self.cells as f64;
        let height =
            self.cells as f64 / written.tan_half_height * field.tan_half_height / self.pixels[1] as f64;
        Spot { sweeps: self.sweeps(x, y), top: middle - 0.5 * height }
    }

    /// Returns the number of the rightmost sweep.
    pub fn last_sweep(&self) -> u32 {
        self.fan.sweeps - 1
    }

    fn sweeps(&self, x: f64, y: f64) -> RangeInclusive<u32> {
        let last = f64::from(self.fan.sweeps - 1);
        let cell = |place: f64| place.clamp(0.0, last) as u32;
        if self.kind == SweepMemoryKind::DigitalMemory {
            let across = 0.5 * (x / self.fields[1].tan_half_width + 1.0) * f64::from(self.fan.sweeps);
            return cell((across - NO_SHARE).floor())..=cell((across + NO_SHARE).floor());
        }
        let [sin, cos] = self.pitch;
        let place = self.fan.position(x / (cos + sin * y));
        // Upright, a pixel lies between two sweeps; turned, its beam reaches over four.
        let wider = if self.fields[0] == self.fields[1] && self.yoke[0] == 0.0 { 0.0 } else { 1.0 };
        let (first, end) = ((place + NO_SHARE).floor() - wider, (place - NO_SHARE).ceil() + wider);
        cell(first.min(end))..=cell(first.max(end))
    }
}

#[cfg(test)]
mod tests {
    use hardware_model::{HardwareModel, Settings, SweepMemoryKind, Yoke};
    use landscape::Attitude;
    use quantities::radians;
    use scenario::{Display, FieldOfView, LawWishes, Pose, RasterWishes, Scalar};
    use sweep_memory::{Memory, View, covering};

    use super::Screen;

    const FIELD: FieldOfView = FieldOfView { tan_half_width: 0.466_307_658, tan_half_height: 0.267_949_192 };

    fn settings(kind: SweepMemoryKind, is_turned: bool) -> Settings {
        let wishes =
            RasterWishes { sweeps: Some(20), columns: Some(20), lines: Some(9), ..Default::default() };
        let display = Display { white: 1.0, gamma: 1.0 };
        let model = HardwareModel::ideal();
        let laws = LawWishes::default();
        let settings = Settings::resolve(&model, FIELD, wishes, None, laws, Scalar::F32, display).unwrap();
        let yoke = is_turned.then_some(Yoke { travel: radians(40.0), ..model.yoke });
        Settings { sweep_memory: kind, yoke, ..settings }
    }

    /// Reads a store in which one cell alone is bright.
    fn read(settings: &Settings, screen: &Screen, pose: &Pose, [sweep, cell]: [usize; 2]) -> Vec<f32> {
        let mut store = vec![0.0; 20 * screen.cells];
        store[sweep * screen.cells + cell] = 1.0;
        let raster = settings.yoke.map_or(FIELD, |yoke| covering(FIELD, yoke.travel));
        let (projection, pitch) = (settings.laws.projection, pose.attitude.pitch);
        let view = View { fan: screen.fan, projection, pitch, raster, field: FIELD, yoke: pose.yoke };
        let mut picture = vec![0.0; 20 * 9];
        let memory = match settings.sweep_memory {
            SweepMemoryKind::ScanConverter => Memory::ScanConverter,
            SweepMemoryKind::DigitalMemory => Memory::DigitalTurned,
        };
        memory.read(&store, screen.cells, 20, &view, &mut picture);
        picture
    }

    /// The read-out itself: what a cell makes bright names its sweep, and a cell above the upper edge makes nothing bright.
    #[test]
    fn a_pixel_names_the_sweeps_that_the_read_beam_meets() {
        let kinds = [SweepMemoryKind::ScanConverter, SweepMemoryKind::DigitalMemory];
        for (kind, pitch_deg, yoke_deg) in kinds
            .into_iter()
            .flat_map(|kind| [(kind, 0.0, None), (kind, -12.0, Some(9.0)), (kind, 0.0, Some(0.0))])
        {
            let settings = settings(kind, yoke_deg.is_some());
            let cells = if yoke_deg.is_some() { 31 } else { 9 };
            let attitude = Attitude { roll: 0.0, pitch: radians(pitch_deg), heading: 0.0 };
            let yoke = radians(yoke_deg.unwrap_or(0.0));
            let pose = Pose { time: 0.0, eye: [0.0; 3], attitude, yoke };
            let screen = Screen::new(&settings, &pose, yoke, cells).unwrap();
            let mut bright = 0;
            for (sweep, cell) in (0..20).flat_map(|sweep| (0..cells).map(move |cell| (sweep, cell))) {
                let picture = read(&settings, &screen, &pose, [sweep, cell]);
                for (index, _) in picture.iter().enumerate().filter(|(_, value)| value.abs() > 2e-3) {
                    let spot = screen.spot(index % 20, index / 20);
                    assert!(spot.sweeps.contains(&(sweep as u32)), "{kind:?} sweep {sweep}, {spot:?}");
                    assert!(cell as f64 + 1.0 > spot.top - 0.5, "{kind:?} cell {cell}, {spot:?}");
                    assert!(spot.sweeps.end() - spot.sweeps.start() <= 3, "{spot:?}");
                    bright += 1;
                }
            }
            assert!(bright >= 20 * 9 / 2, "{bright}");
        }
    }
}
