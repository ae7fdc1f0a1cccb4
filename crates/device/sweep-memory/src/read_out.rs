//! The read beam: from sweep space to the picture.

use quantities::sin_cos;
use scenario::{FieldOfView, Projection};
use sweep_program::Fan;

/// What decides where a pixel lies between the sweeps.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct View {
    /// Azimuths of the sweeps.
    pub fan: Fan,
    /// Law by which the sweeps were written.
    pub projection: Projection,
    /// Pitch of the eye (rad).
    pub pitch: f64,
    /// Field of view that was written: that of the screen, or [`covering`] it while the yoke turns.
    pub raster: FieldOfView,
    /// Field of view of the screen.
    pub field: FieldOfView,
    /// Angle by which the yoke turns the picture counter-clockwise (rad): that of a roll with starboard down.
    pub yoke: f64,
}

/// The raster from which a screen of `field` stays filled while the yoke turns by up to half of `travel` (rad)
/// either way: the box around all turned screens.
pub fn covering(field: FieldOfView, travel: f64) -> FieldOfView {
    let (width, height) = (field.tan_half_width, field.tan_half_height);
    FieldOfView {
        tan_half_width: farthest(width, height, 0.5 * travel.abs()),
        tan_half_height: farthest(height, width, 0.5 * travel.abs()),
    }
}

/// Largest `along cos angle + across sin angle` for angles from 0 to `most`: it grows until the corner lies on the axis.
fn farthest(along: f64, across: f64, most: f64) -> f64 {
    if most >= libm::atan2(across, along) {
        return (along * along + across * across).sqrt();
    }
    let (sin, cos) = sin_cos(most);
    along * cos + across * sin
}

impl View {
    /// `tan beta` over X as a function of Y on the view-plane (section 15.3, inverted): oblique sweeps cross a line
    /// at equal distances, which depend on the line.
    pub(crate) fn tangent_over_x(&self) -> impl Fn(f64) -> f64 + use<> {
        let (sin, cos) = match self.projection {
            Projection::Exact => sin_cos(self.pitch),
            Projection::AsReported | Projection::Corrected => (0.0, 1.0),
        };
        move |y| 1.0 / (cos + sin * y)
    }

    /// Psi of section 12: a place (X, Y) of the rolled view-plane on the upright one.
    pub(crate) fn upright(&self) -> impl Fn(f64, f64) -> [f64; 2] + use<> {
        let (sin, cos) = sin_cos(self.yoke);
        move |x, y| [cos * x - sin * y, sin * x + cos * y]
    }

    /// Where the centre of a pixel of a picture of `columns` x `lines` lies in what was written, `cells` a sweep: sweep
    /// and cell, whole numbers at their centres. A scan converter is read between them, a digital memory at the nearest.
    pub fn source(
        &self,
        [columns, lines]: [usize; 2],
        cells: usize,
        [column, line]: [usize; 2],
        tube: bool,
    ) -> [f64; 2] {
        self.source_at([columns, lines], cells, [column, line].map(|pixel| pixel as f64 + 0.5), tube)
    }

    /// The same of any place on the picture (pixels, from its top left corner).
    pub(crate) fn source_at(
        &self,
        [columns, lines]: [usize; 2],
        cells: usize,
        [across, down]: [f64; 2],
        tube: bool,
    ) -> [f64; 2] {
        let y = self.field.tan_half_height * from_middle(down, lines);
        let x = self.field.tan_half_width * from_middle(across, columns);
        let [x, y] = self.upright()(x, y);
        let sweep = match tube {
            true => self.fan.position(x * self.tangent_over_x()(y)),
            false => cell_of(x, self.raster.tan_half_width, self.fan.sweeps as usize),
        };
        [sweep, cell_of(y, self.raster.tan_half_height, cells)]
    }

    /// Whether display lines are the lines that were written.
    pub(crate) fn is_level(&self, written: usize, lines: usize) -> bool {
        self.yoke == 0.0 && self.raster == self.field && written == lines
    }
}

/// Centre of cell `index` of `count`, -1..=1.
pub(crate) fn centre(index: usize, count: usize) -> f64 {
    (2 * index + 1) as f64 / count as f64 - 1.0
}

/// The same of any place among `count` cells, which begin at 0.
fn from_middle(place: f64, count: usize) -> f64 {
    2.0 * place / count as f64 - 1.0
}

/// Where a place on the view-plane lies among `count` cells over -`edge`..=`edge`: the centre of cell n is at n.
pub(crate) fn cell_of(place: f64, edge: f64, count: usize) -> f64 {
    0.5 * ((place / edge + 1.0) * count as f64 - 1.0)
}

/// The cell of `count` in which a place lies.
pub(crate) fn nearest(place: f64, count: usize) -> Option<usize> {
    let cell = (place + 0.5).floor();
    (cell >= 0.0 && cell < count as f64).then_some(cell as usize)
}

#[cfg(test)]
mod tests {
    use super::{View, centre, covering};
    use crate::Memory;
    use quantities::{radians, sin_cos};
    use scenario::{FieldOfView, Projection};
    use sweep_program::Fan;

    const FIELD: FieldOfView =
        FieldOfView { tan_half_width: 0.466307658154998, tan_half_height: 0.26794919243112 };

    fn view(pitch: f64, sweeps: u32) -> View {
        let fan = Fan::covering(Projection::Exact, pitch, &FIELD, sweeps).unwrap();
        View { fan, projection: Projection::Exact, pitch, raster: FIELD, field: FIELD, yoke: 0.0 }
    }

    #[test]
    fn level_sweeps_read_as_written_by_both_memories() {
        let store: Vec<f32> = (0..12).map(|k| k as f32).collect();
        let (mut tube, mut digital) = (vec![0.0; 12], vec![0.0; 12]);
        Memory::ScanConverter.read(&store, 3, 4, &view(0.0, 4), &mut tube);
        Memory::Digital.read(&store, 3, 4, &view(0.0, 4), &mut digital);
        assert_eq!(digital[..4], [0.0, 3.0, 6.0, 9.0]);
        for (tube, digital) in tube.iter().zip(&digital) {
            assert!((tube - digital).abs() < 1e-5);
        }
    }

    #[test]
    fn a_pixel_takes_the_azimuth_of_its_ray() {
        // Each sweep stores its own tan beta; the picture must show that of every pixel's ray.
        let (pitch, sweeps, lines, columns) = (radians(-17.0), 101, 9, 13);
        let view = view(pitch, sweeps);
        let mut store = Vec::new();
        for sweep in 0..sweeps {
            store.extend(std::iter::repeat_n(view.fan.tangent(sweep) as f32, lines));
        }
        let mut picture = vec![0.0; lines * columns];
        Memory::ScanConverter.read(&store, lines, columns, &view, &mut picture);
        for (index, &found) in picture.iter().enumerate() {
            let (line, column) = ((index / columns) as f64, (index % columns) as f64);
            let x = FIELD.tan_half_width * ((2.0 * column + 1.0) / columns as f64 - 1.0);
            let y = FIELD.tan_half_height * ((2.0 * line + 1.0) / lines as f64 - 1.0);
            let (sin, cos) = sin_cos(pitch);
            let expected = x / (cos + y * sin);
            let error = (f64::from(found) - expected).abs();
            assert!(error < 0.006 * view.fan.edge, "pixel {index}: {found} against {expected}");
        }
    }

    #[test]
    fn a_turned_picture_is_what_a_rolled_camera_sees() {
        let (pitch, raster) = (radians(6.0), covering(FIELD, radians(40.0)));
        let fan = Fan::covering(Projection::Exact, pitch, &raster, 601).unwrap();
        let (sweeps, lines, columns, height) = (601, 401, 305, 175);
        for roll in [-20.0, -7.0, 0.0, 13.0, 20.0].map(radians) {
            let view = View { fan, projection: Projection::Exact, pitch, raster, field: FIELD, yoke: roll };
            for ahead in [[1.0, 0.3, -0.1], [1.0, -0.35, 0.2], [1.0, 0.1, 0.15]] {
                // A point in rolled vehicle axes, and the same in those that only pitch: v = Psi v'.
                let (sin, cos) = sin_cos(roll);
                let [u, v, w] = ahead;
                let (v, w) = (cos * v - sin * w, sin * v + cos * w);
                // Its place in the raster by the terrain's axes: azimuth against the heading, line from the top.
                let (sin, cos) = sin_cos(pitch);
                let sweep = fan.position(v / (cos * u + sin * w)).round() as usize;
                let line = (0.5 * ((w / u / raster.tan_half_height + 1.0) * 401.0 - 1.0)).round() as usize;
                let mut store = vec![0.0; sweeps * lines];
                store[sweep * lines + line] = 1.0;
                let mut picture = vec![0.0; columns * height];
                Memory::ScanConverter.read(&store, lines, columns, &view, &mut picture);
                let [x, y] = centroid(&picture, columns);
                let column = 0.5 * ((ahead[1] / FIELD.tan_half_width + 1.0) * 305.0 - 1.0);
                let row = 0.5 * ((ahead[2] / FIELD.tan_half_height + 1.0) * 175.0 - 1.0);
                assert!((x - column).abs() < 1.0 && (y - row).abs() < 1.0, "{x}, {y}: {column}, {row}");
            }
        }
    }

    /// A lone cell that is bright is seen where its place says.
    #[test]
    fn the_source_of_a_pixel_is_what_it_shows() {
        let (pitch, raster) = (radians(6.0), covering(FIELD, radians(40.0)));
        let (sweeps, lines, columns, height) = (301, 201, 61, 35);
        let fan = Fan::covering(Projection::Exact, pitch, &raster, 301).unwrap();
        let view =
            View { fan, projection: Projection::Exact, pitch, raster, field: FIELD, yoke: radians(9.0) };
        for (tube, pixel) in [(true, [13, 20]), (false, [13, 20]), (true, [60, 0]), (false, [0, 34])] {
            let [sweep, cell] = view.source([columns, height], lines, pixel, tube).map(|place| place.round());
            let mut store = vec![0.0; sweeps * lines];
            store[sweep as usize * lines + cell as usize] = 1.0;
            let mut picture = vec![0.0; columns * height];
            let read = if tube { Memory::ScanConverter } else { Memory::DigitalTurned };
            read.read(&store, lines, columns, &view, &mut picture);
            assert!(picture[pixel[1] * columns + pixel[0]] > 0.0, "{pixel:?} by a tube: {tube}");
        }
    }

    fn centroid(picture: &[f32], columns: usize) -> [f64; 2] {
        let mut sums = [0.0; 3];
        for (index, &value) in picture.iter().enumerate() {
            let value = f64::from(value);
            let parts = [value, value * (index % columns) as f64, value * (index / columns) as f64];
            sums.iter_mut().zip(parts).for_each(|(sum, part)| *sum += part);
        }
        [sums[1] / sums[0], sums[2] / sums[0]]
    }

    #[test]
    fn with_starboard_down_the_horizon_rises_to_the_right() {
        let raster = covering(FIELD, radians(40.0));
        let fan = Fan::covering(Projection::Exact, 0.0, &raster, 64).unwrap();
        // Ground below the horizon, which is in the middle.
        let store: Vec<f32> = (0..64 * 40).map(|index| if index % 40 < 20 { 0.0 } else { 1.0 }).collect();
        let view = View {
            fan,
            projection: Projection::Exact,
            pitch: 0.0,
            raster,
            field: FIELD,
            yoke: radians(10.0),
        };
        let (mut tube, mut digital) = (vec![0.0; 50 * 30], vec![0.0; 50 * 30]);
        Memory::ScanConverter.read(&store, 40, 50, &view, &mut tube);
        Memory::DigitalTurned.read(&store, 40, 50, &view, &mut digital);
        for picture in [tube, digital] {
            let ground = |column: usize| (0..30).map(|line| picture[line * 50 + column]).sum::<f32>();
            assert!(ground(49) > ground(25) + 3.0 && ground(25) > ground(0) + 3.0);
        }
    }

    #[test]
    fn the_covering_raster_fills_every_corner_and_no_more() {
        let travel = radians(40.0);
        let raster = covering(FIELD, travel);
        let (mut widest, mut tallest) = (0.0f64, 0.0f64);
        for step in -200..=200 {
            let (sin, cos) = sin_cos(0.5 * travel * f64::from(step) / 200.0);
            for side in [-1.0, 1.0] {
                let (x, y) = (FIELD.tan_half_width, side * FIELD.tan_half_height);
                widest = widest.max((cos * x - sin * y).abs());
                tallest = tallest.max((sin * x + cos * y).abs());
            }
        }
        assert!((raster.tan_half_width - widest).abs() < 1e-12, "{raster:?}, {widest}");
        assert!((raster.tan_half_height - tallest).abs() < 1e-12, "{raster:?}, {tallest}");
        // Section 18: the half diagonal is the most that any travel asks for.
        let any = covering(FIELD, radians(180.0));
        assert!((any.tan_half_width - 0.5378).abs() < 1e-4 && any.tan_half_width == any.tan_half_height);
        assert_eq!(covering(FIELD, 0.0), FIELD);
        let fan = Fan::covering(Projection::Exact, 0.0, &raster, 40).unwrap();
        let mut view =
            View { fan, projection: Projection::Exact, pitch: 0.0, raster, field: FIELD, yoke: 0.0 };
        for step in -20..=20 {
            view.yoke = 0.5 * travel * f64::from(step) / 20.0;
            for read in [Memory::ScanConverter, Memory::DigitalTurned] {
                let mut picture = vec![0.0; 50 * 30];
                read.read(&[1.0; 40 * 30], 30, 50, &view, &mut picture);
                assert!(picture.iter().all(|pixel| *pixel == 1.0), "{}", view.yoke);
            }
        }
        view.yoke = radians(45.0);
        let mut picture = vec![0.0; 50 * 30];
        Memory::ScanConverter.read(&[1.0; 40 * 30], 30, 50, &view, &mut picture);
        assert_eq!(picture[0], 0.0);
    }

    #[test]
    fn the_beam_sees_the_mean_of_the_cells_in_its_line() {
        // Four cells a line, level: every pixel is the mean of its own four, whatever they hold.
        let values: Vec<f32> = (0..40 * 36).map(|cell| (cell * cell % 97) as f32).collect();
        let mut picture = vec![0.0; 40 * 9];
        Memory::ScanConverter.read(&values, 36, 40, &view(0.0, 40), &mut picture);
        for (index, found) in picture.iter().enumerate() {
            let (line, column) = (index / 40, index % 40);
            let mean = values[column * 36 + 4 * line..][..4].iter().sum::<f32>() / 4.0;
            assert!((found - mean).abs() < 1e-3, "{index}: {found}, {mean}");
        }
    }

    #[test]
    fn a_part_of_a_larger_raster_is_read_in_its_place() {
        // Sweeps and lines hold their own tangents; the screen is the inner half.
        let raster = FieldOfView { tan_half_width: 0.8, tan_half_height: 0.6 };
        let field = FieldOfView { tan_half_width: 0.4, tan_half_height: 0.3 };
        let fan = Fan::covering(Projection::Corrected, 0.0, &raster, 80).unwrap();
        let view = View { fan, projection: Projection::Corrected, pitch: 0.0, raster, field, yoke: 0.0 };
        let store: Vec<f32> = (0..80 * 60)
            .map(|index| (fan.tangent((index / 60) as u32) + 10.0 * 0.6 * centre(index % 60, 60)) as f32)
            .collect();
        let mut picture = vec![0.0; 41 * 15];
        Memory::ScanConverter.read(&store, 60, 41, &view, &mut picture);
        for (index, found) in picture.iter().enumerate() {
            let expected = 0.4 * centre(index % 41, 41) + 10.0 * 0.3 * centre(index / 41, 15);
            assert!((f64::from(*found) - expected).abs() < 1e-5, "{index}");
        }
    }
}
