//! The pixel that shows a place of a sweep.

use machine::FrameSweeps;
use scenario::Pose;

/// Steps after which the search for a pixel ends: the way from pixel to sweep is nearly straight.
const STEPS: usize = 12;

/// The pixel whose centre is nearest to line `line` of sweep `sweep`; none if that is beyond the picture of `size` columns
/// and lines.
pub fn pixel_of(
    sweeps: &FrameSweeps<'_>,
    pose: &Pose,
    size: [u32; 2],
    [sweep, line]: [f64; 2],
) -> Option<[usize; 2]> {
    // The middle of a cell lies half a line below its upper edge.
    let wanted = [sweep, line - 0.5];
    let place = |pixel: [usize; 2]| sweeps.read_at(pose, pixel);
    let clamp = |value: f64, axis: usize| value.round().clamp(0.0, f64::from(size[axis].max(2) - 2)) as usize;
    let mut pixel = [size[0] as usize / 2, size[1] as usize / 2];
    for _ in 0..STEPS {
        pixel = [clamp(pixel[0] as f64, 0), clamp(pixel[1] as f64, 1)];
        let [here, right, below] = [pixel, [pixel[0] + 1, pixel[1]], [pixel[0], pixel[1] + 1]].map(place);
        let step = solve(
            [right[0] - here[0], below[0] - here[0]],
            [right[1] - here[1], below[1] - here[1]],
            [wanted[0] - here[0], wanted[1] - here[1]],
        )?;
        let next = [pixel[0] as f64 + step[0], pixel[1] as f64 + step[1]];
        if step.iter().all(|way| way.abs() <= 0.5) {
            break;
        }
        pixel = [clamp(next[0], 0), clamp(next[1], 1)];
    }
    nearest(pixel, size, wanted, place)
}

/// Of a pixel and those around it the one nearest to `wanted`, if it is as near as a neighbour can be.
fn nearest(
    [x, y]: [usize; 2],
    size: [u32; 2],
    wanted: [f64; 2],
    place: impl Fn([usize; 2]) -> [f64; 2],
) -> Option<[usize; 2]> {
    let columns = x.saturating_sub(2)..(x + 3).min(size[0] as usize);
    let lines = || y.saturating_sub(2)..(y + 3).min(size[1] as usize);
    let near = columns.flat_map(|x| lines().map(move |y| [x, y])).map(|pixel| {
        let found = place(pixel);
        let away = [0, 1].map(|axis| (found[axis] - wanted[axis]).abs());
        (away[0] + away[1], away, pixel)
    });
    let (_, away, pixel) = near.reduce(|best, next| if next.0 < best.0 { next } else { best })?;
    // Neither a column of several sweeps nor a line of several cells is farther than this from its pixel.
    (away.iter().all(|way| *way <= 2.0)).then_some(pixel)
}

/// Solves `a.x = c0`, `b.x = c1`.
fn solve(a: [f64; 2], b: [f64; 2], c: [f64; 2]) -> Option<[f64; 2]> {
    let determinant = a[0] * b[1] - a[1] * b[0];
    let step = [(c[0] * b[1] - a[1] * c[1]) / determinant, (a[0] * c[1] - c[0] * b[0]) / determinant];
    step.iter().all(|way| way.is_finite()).then_some(step)
}
