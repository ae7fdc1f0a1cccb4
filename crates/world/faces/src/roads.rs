//! Two roads to one sea: renumbered normals under a fixed sun, or fixed normals under a turned sun.

/// What changes from frame to frame.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Animate {
    /// The sun of the group (reported: as delivered).
    Sun,
    /// The numbers of the normals (reported: too slow).
    Normals,
}

impl Animate {
    /// Memory words written in a frame for one list of `vertices` vertices: 3 for the sun, or 3 for each normal (reported).
    pub fn words(self, vertices: u64) -> u64 {
        match self {
            Self::Sun => 3,
            Self::Normals => 3 * vertices,
        }
    }
}

/// Steps of a table of `count` normals that lie nearest to a part of a turn of the sun, in [0, 1).
pub fn steps_of(part: f64, count: u32) -> u32 {
    (part * f64::from(count) + 0.5).floor() as u32 % count
}

/// Number of the normal that shows under a fixed sun what `number` shows under a sun turned by `steps` of `count`.
pub fn renumbered(number: u32, steps: u32, count: u32) -> u32 {
    let (number, steps, count) = (u64::from(number), u64::from(steps % count), u64::from(count));
    ((number + count - steps) % count) as u32
}
