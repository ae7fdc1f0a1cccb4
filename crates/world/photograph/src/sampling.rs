//! The bilinear look-up between the centres of pixels.

use picture::GreyPicture;

/// The value of a picture at a continuous pixel I, J, with the values of its codes by `value`; none outside the picture.
pub fn bilinear(picture: &GreyPicture, [i, j]: [f64; 2], value: impl Fn(u16) -> f64) -> Option<f64> {
    let (left, right, across) = between(i, picture.columns())?;
    let (above, below, down) = between(j, picture.lines())?;
    let row = |line: usize| {
        let [from, to] = [left, right].map(|column| value(picture.code(column, line)));
        from + across * (to - from)
    };
    let (from, to) = (row(above), row(below));
    Some(from + down * (to - from))
}

/// The two centres on both sides of a place along an axis of `count` pixels, and the share of the second.
fn between(at: f64, count: usize) -> Option<(usize, usize, f64)> {
    if !(0.0..count as f64).contains(&at) {
        return None;
    }
    let last = (count - 1) as f64;
    let from_centre = (at - 0.5).clamp(0.0, last);
    let first = from_centre.floor();
    Some((first as usize, (first + 1.0).min(last) as usize, from_centre - first))
}
