//! The block of boulders: 68 bytes each.

use crate::bytes::{Numbers, put};
use crate::contents::{Boulder, Shape};

/// Numbers that stand for shapes.
const SPHERE: u32 = 0;
const CUBE: u32 = 1;
/// Faces of a rock stand for its shape: it has 4 at least.
const FEWEST: u32 = 4;

/// Bytes of all boulders.
pub(crate) fn encoded(boulders: &[Boulder]) -> Vec<u8> {
    let mut bytes = Vec::new();
    for boulder in boulders {
        put(&mut bytes, boulder.centre.into_iter().chain([boulder.radius, boulder.yaw, boulder.burial]));
        bytes.extend([boulder.seed, boulder.number].iter().flat_map(|number| number.to_le_bytes()));
        let shape = match boulder.shape {
            Shape::Sphere => SPHERE,
            Shape::Cube => CUBE,
            Shape::Rock(faces) => faces,
        };
        bytes.extend(shape.to_le_bytes());
    }
    bytes
}

/// All boulders; `None` if the bytes are none.
pub(crate) fn decoded(bytes: &[u8]) -> Option<Vec<Boulder>> {
    let mut numbers = Numbers::new(bytes);
    let mut boulders = Vec::new();
    while numbers.left() > 0 {
        boulders.push(boulder(&mut numbers)?);
    }
    Some(boulders)
}

fn boulder(numbers: &mut Numbers) -> Option<Boulder> {
    let [x, y, z, radius, yaw, burial] = numbers.f64s()?;
    let [seed, number] = [numbers.u64()?, numbers.u64()?];
    let shape = match numbers.u32()? {
        SPHERE => Shape::Sphere,
        CUBE => Shape::Cube,
        faces if faces >= FEWEST => Shape::Rock(faces),
        _ => return None,
    };
    Some(Boulder { centre: [x, y, z], radius, shape, seed, number, yaw, burial })
}
