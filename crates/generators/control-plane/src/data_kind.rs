//! Kinds of data that lie in banks (report, figure 15).

/// A kind of data with a bank of its own.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum DataKind {
    /// Corners of the finest level of terrain.
    Fine,
    /// Corners of the coarse level of terrain.
    Coarse,
    /// Features: the craters of the problem area.
    Features,
    /// Boundaries of shadow on the ground.
    Shadows,
    /// Polyhedra: rocks and man-made objects.
    Polyhedra,
}

impl DataKind {
    /// All kinds, in the order in which they share drums.
    pub const ALL: [Self; 5] = [Self::Fine, Self::Coarse, Self::Features, Self::Shadows, Self::Polyhedra];

    /// Its word in the names of units, and of the tables of a state.
    pub fn name(self) -> &'static str {
        ["fine", "coarse", "features", "shadows", "polyhedra"][self as usize]
    }

    /// Number of the level of terrain; none of what is no terrain.
    pub fn level(self) -> Option<usize> {
        match self {
            Self::Fine => Some(0),
            Self::Coarse => Some(1),
            Self::Features | Self::Shadows | Self::Polyhedra => None,
        }
    }
}
