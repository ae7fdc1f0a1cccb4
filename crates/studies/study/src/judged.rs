//! Pictures of a generator against those of the judge, frame by frame.
//!
//! **Law.** Both draw each frame from the same pose. Where both pixels show something, the error of distance is that of the generator less that of
//! the judge (m). The error of light is the difference of the two pictures in grey levels of 255, over all pixels. A pixel that shows sky
//! in one picture alone lies on the *outline*: it counts there, and in no distance.

use generator::{FrameError, PlaneKind, Planes, Session};
use scenario::{Pose, View};
use serde::Serialize;
use signal::Probe;

use crate::levels::Size;

/// Grey levels of full light.
const WHITE: f64 = 255.0;

/// The planes that are compared.
const KINDS: [PlaneKind; 2] = [PlaneKind::Intensity, PlaneKind::Distance];

/// A frame of a generator against the judge.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct JudgedFrame {
    /// Number of the frame.
    pub frame: u64,
    /// Time of the frame (s).
    pub t_s: f64,
    /// Pixels that show something in both pictures.
    pub pixels: u64,
    /// Pixels that show sky in one picture alone.
    pub outline: u64,
    /// Mean distance in the picture of the judge (m); 0 without pixels.
    pub distance_m: f64,
    /// Distances off the judge (m).
    pub metres: Size,
    /// Column and line of the pixel with the worst distance.
    pub worst_at: [usize; 2],
    /// Light off the judge (grey levels of 255).
    pub greys: Size,
}

/// Draws a frame by a generator and by the judge, each made ready for `view`, and compares them.
///
/// # Errors
/// If either cannot draw it.
pub fn judged_frame(
    [own, judge]: [&dyn Session; 2],
    view: &View,
    frame: u64,
    pose: &Pose,
) -> Result<JudgedFrame, FrameError> {
    let drawn = |session: &dyn Session| -> Result<Planes, FrameError> {
        let mut planes = Planes::new(view.columns as usize, view.lines as usize, &KINDS);
        session.frame(frame, pose, &mut planes, &mut Probe::off())?;
        Ok(planes)
    };
    let both = [drawn(own)?, drawn(judge)?];
    let [greys, distances] =
        KINDS.map(|kind| both.each_ref().map(|planes| planes.get(kind).unwrap_or_default()));
    let compared = compared(distances, view.columns as usize);
    let off = greys[0].iter().zip(greys[1]).map(|(own, right)| WHITE * (f64::from(*own) - f64::from(*right)));
    Ok(JudgedFrame { frame, t_s: pose.time, greys: size(off), ..compared })
}

/// Two planes of distances, that of the generator first; light is left open.
fn compared([own, right]: [&[f32]; 2], columns: usize) -> JudgedFrame {
    let is_sky = |distance: f32| distance == PlaneKind::Distance.sky();
    let pairs = || own.iter().zip(right).map(|(own, right)| (*own, *right)).enumerate();
    let shown = || pairs().filter(|(_, (own, right))| !is_sky(*own) && !is_sky(*right));
    let off = |(own, right): (f32, f32)| f64::from(own) - f64::from(right);
    let worst =
        shown().max_by(|a, b| off(a.1).abs().total_cmp(&off(b.1).abs())).map_or(0, |(pixel, _)| pixel);
    let pixels = shown().count() as u64;
    let sum: f64 = shown().map(|(_, (_, right))| f64::from(right)).sum();
    JudgedFrame {
        frame: 0,
        t_s: 0.0,
        pixels,
        outline: pairs().filter(|(_, (own, right))| is_sky(*own) != is_sky(*right)).count() as u64,
        distance_m: sum / pixels.max(1) as f64,
        metres: size(shown().map(|(_, pair)| off(pair))),
        worst_at: [worst % columns.max(1), worst / columns.max(1)],
        greys: Size { rms: 0.0, worst: 0.0 },
    }
}

/// Root mean square and largest size of some errors.
fn size(errors: impl Iterator<Item = f64>) -> Size {
    let [count, squares, worst] = errors.fold([0.0; 3], |[count, squares, worst]: [f64; 3], error| {
        [count + 1.0, squares + error * error, worst.max(error.abs())]
    });
    Size { rms: (squares / count.max(1.0)).sqrt(), worst }
}

#[cfg(test)]
mod tests {
    use generator::PlaneKind;

    use super::compared;
    use crate::levels::Size;

    #[test]
    fn distances_count_where_both_show_something() {
        let sky = PlaneKind::Distance.sky();
        let own = [10.0, 20.0, 33.0, sky, 50.0, sky];
        let right = [10.0, 24.0, 30.0, 40.0, sky, sky];
        let found = compared([&own, &right], 3);
        assert_eq!((found.pixels, found.outline, found.worst_at), (3, 2, [1, 0]));
        assert_eq!(found.metres, Size { rms: (25.0f64 / 3.0).sqrt(), worst: 4.0 });
        assert!((found.distance_m - 64.0 / 3.0).abs() < 1e-12);
        let none = compared([&[sky], &[sky]], 1);
        assert_eq!((none.pixels, none.distance_m, none.metres.rms), (0, 0.0, 0.0));
    }
}
