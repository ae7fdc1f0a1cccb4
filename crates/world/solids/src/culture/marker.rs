//! A pyramid on a plinth, for finding one's way.

use super::{Parts, at, boxed};
use crate::Solid;

pub(super) fn parts() -> Parts {
    let mut parts = vec![boxed([-0.65, -0.65, -0.15], [0.65, 0.65, 0.12], 0.7)?];
    let base = [at(-0.5, -0.5, 0.12), at(0.5, -0.5, 0.12), at(0.5, 0.5, 0.12), at(-0.5, 0.5, 0.12)];
    let pyramid = Solid::hull(&[base[0], base[1], base[2], base[3], at(0.0, 0.0, 1.6)], 0.9)?;
    parts.push(pyramid.painted(|normal| if normal.x.abs() > normal.y.abs() { 0.95 } else { 0.2 })?);
    Ok(parts)
}
