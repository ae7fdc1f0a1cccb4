//! Over which line positions a disc lies on each sweep.

use light_points::Disc;
use sweep_memory::Reading;

/// Discs wider than this (pixels) are not measured by their chords: their light changes by less than a hundredth as they move. Chosen,
/// as in the sampled generator.
const WIDEST_MEASURED: f64 = 32.0;

/// Chords of a disc.
pub(crate) struct Chords {
    /// Sweep, and the line positions between which it lies in the disc; sweeps of the machine alone, ascending.
    pub all: Vec<(u32, [f32; 2])>,
    /// Area (pixels squared) of the strips that all sweeps cover of the disc, those beside the picture too: a lamp that leaves the
    /// picture would grow brighter if only those in it counted. `None` of a disc that is too wide to measure.
    pub area: Option<f64>,
}

impl Chords {
    /// Of a disc about `middle` (pixels).
    pub fn of(disc: &Disc, middle: [f64; 2], reading: &Reading) -> Self {
        let (sweeps, radius) = (i64::from(reading.view.fan.sweeps), disc.diameter / 2.0);
        let is_measured = disc.diameter <= WIDEST_MEASURED;
        let [first, last] = if is_measured { reach(middle, radius, reading) } else { [0, sweeps - 1] };
        let (mut all, mut area) = (Vec::new(), 0.0);
        for sweep in first..=last {
            let Some(ends) = chord(sweep as f64, middle, radius, reading) else { continue };
            area += (ends[1] - ends[0]) * area_of_line(sweep as f64, 0.5 * (ends[0] + ends[1]), reading);
            let is_in_picture = ends[1] > 0.0 && ends[0] < reading.cells as f64;
            if (0..sweeps).contains(&sweep) && is_in_picture {
                all.push((sweep as u32, ends.map(|end| end as f32)));
            }
        }
        Self { all, area: (is_measured && area > 0.0).then_some(area) }
    }
}

/// Space between sweeps (pixels) at a place of the raster.
pub(crate) fn spacing([sweep, line]: [f64; 2], reading: &Reading) -> f64 {
    let [left, right] = [sweep - 0.5, sweep + 0.5].map(|sweep| reading.shown([sweep, line]));
    (0..2).map(|axis| (right[axis] - left[axis]) * (right[axis] - left[axis])).sum::<f64>().sqrt()
}

/// First and last sweep that may meet a disc. Where pixels lie is a quotient of linear functions: outermost at corners of the box.
fn reach(middle: [f64; 2], radius: f64, reading: &Reading) -> [i64; 2] {
    let corners = [[-1.0, -1.0], [-1.0, 1.0], [1.0, -1.0], [1.0, 1.0]];
    let sweep = |[x, y]: [f64; 2]| reading.seen([middle[0] + x * radius, middle[1] + y * radius])[0];
    let fold = |[low, high]: [f64; 2], at: f64| [low.min(at), high.max(at)];
    let [low, high] = corners.map(sweep).into_iter().fold([f64::INFINITY, f64::NEG_INFINITY], fold);
    // Conversion saturates, and no disc of this width spans more sweeps than this.
    let beside = 2 * i64::from(reading.view.fan.sweeps);
    [(low.floor() as i64).max(-beside), (high.ceil() as i64).min(2 * beside)]
}

/// Line positions between which a sweep lies in a disc, from the top.
fn chord(sweep: f64, middle: [f64; 2], radius: f64, reading: &Reading) -> Option<[f64; 2]> {
    let [begin, next] = [0.0, 1.0].map(|line| reading.shown([sweep, line]));
    let along = [0, 1].map(|axis| next[axis] - begin[axis]);
    let away = [0, 1].map(|axis| begin[axis] - middle[axis]);
    let dot = |a: [f64; 2], b: [f64; 2]| a[0] * b[0] + a[1] * b[1];
    let (a, b, c) = (dot(along, along), dot(along, away), dot(away, away) - radius * radius);
    let discriminant = b * b - a * c;
    // What is no number has no chord.
    (discriminant > 0.0).then(|| [-1.0, 1.0].map(|side| (side * discriminant.sqrt() - b) / a))
}

/// Area (pixels squared) of one line of a sweep at a line position.
fn area_of_line(sweep: f64, line: f64, reading: &Reading) -> f64 {
    let across = [sweep - 0.5, sweep + 0.5].map(|sweep| reading.shown([sweep, line]));
    let along = [line - 0.5, line + 0.5].map(|line| reading.shown([sweep, line]));
    let [across, along] = [across, along].map(|[from, to]| [to[0] - from[0], to[1] - from[1]]);
    (across[0] * along[1] - across[1] * along[0]).abs()
}

#[cfg(test)]
mod tests {
    use super::*;
    use scenario::{FieldOfView, Projection};
    use sweep_memory::{Memory, View};
    use sweep_program::Fan;

    fn reading(sweeps: u32, pitch: f64) -> Reading {
        let (projection, field) =
            (Projection::Exact, FieldOfView { tan_half_width: 0.5, tan_half_height: 0.5 });
        let fan = Fan::covering(projection, pitch, &field, sweeps).unwrap();
        let view = View { fan, projection, pitch, raster: field, field, yoke: 0.0 };
        Reading { memory: Memory::ScanConverter, view, cells: 100, columns: 100, lines: 100 }
    }

    #[test]
    fn the_chord_of_a_level_sweep_is_that_of_a_circle() {
        let disc = Disc { diameter: 9.8, intensity: 1.0 };
        let chords = Chords::of(&disc, [50.5, 40.0], &reading(100, 0.0));
        let [first, last] = [chords.all[0].0, chords.all[chords.all.len() - 1].0];
        assert_eq!([first, last], [46, 54]);
        for (sweep, ends) in chords.all {
            let away = f64::from(sweep) - 50.0;
            let half = (4.9 * 4.9 - away * away).sqrt();
            assert!((f64::from(ends[0]) - 40.0 + half).abs() < 1e-5, "{sweep}");
            assert!((f64::from(ends[1]) - 40.0 - half).abs() < 1e-5, "{sweep}");
        }
    }

    /// Many sweeps measure the area itself, level and where the fan is oblique, and as a disc leaves the picture.
    #[test]
    fn chords_measure_the_disc() {
        for pitch in [0.0, -0.3, 0.3] {
            for middle in [[50.0, 50.0], [7.0, 90.0], [0.0, 50.0], [99.0, 3.0]] {
                let disc = Disc { diameter: 12.0, intensity: 1.0 };
                let area = Chords::of(&disc, middle, &reading(4000, pitch)).area.unwrap();
                assert!((area / disc.area() - 1.0).abs() < 1e-3, "{pitch} {middle:?}: {area}");
            }
        }
    }

    #[test]
    fn the_least_disc_meets_a_sweep_wherever_it_lies() {
        for sweeps in [20, 100] {
            let reading = reading(sweeps, 0.2);
            for step in 0..200 {
                let middle = [40.0 + f64::from(step) / 20.0, 61.3];
                let least = 1.5 * spacing(reading.seen(middle), &reading).max(1.0);
                let disc = Disc { diameter: least, intensity: 1.0 };
                assert!(!Chords::of(&disc, middle, &reading).all.is_empty(), "{sweeps} {middle:?}");
            }
        }
    }

    #[test]
    fn a_disc_beside_the_picture_or_of_no_number_has_no_chord() {
        let reading = reading(100, 0.0);
        let all = |middle| Chords::of(&Disc { diameter: 3.0, intensity: 1.0 }, middle, &reading).all;
        for middle in [[-5.0, 50.0], [50.0, 120.0], [1e300, 50.0], [f64::NAN, 50.0]] {
            assert!(all(middle).is_empty(), "{middle:?}");
        }
        let wide = Chords::of(&Disc { diameter: 1e6, intensity: 1.0 }, [50.0, 50.0], &reading);
        assert_eq!((wide.all.len(), wide.area), (100, None));
    }
}
