//! Small detail of the foreground (section 13): a law of place and range, the same for the machine and `exact`.

/// Texture of the ground: layers of different grain, added to reflectivity.
#[derive(Debug, Clone, PartialEq)]
pub struct Texture {
    /// From the coarsest to the finest, or in any order.
    pub layers: Vec<Layer>,
    /// Where the numbers come from.
    pub source: Source,
    /// Names the pattern.
    pub seed: u64,
}

/// One grain size.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Layer {
    /// Distance between lattice points (m).
    pub cell: f64,
    /// Largest deviation of reflectivity, either way.
    pub amplitude: f64,
    /// Ground range at which it has faded to nothing (m).
    pub range: f64,
}

/// Where texture comes from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Source {
    /// A pattern over one region, mirrored at its edges: used in every region (variant 1).
    Pattern,
    /// A repeatable pseudo-random routine over the whole ground (variant 2).
    Random,
}
