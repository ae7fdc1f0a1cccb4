//! Where the document does otherwise than the builder, each by a switch.

/// One thing that the document does in another way.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Switch {
    /// Craters are kept as heights on own posts and resampled, not as closed forms.
    FeatureGrids,
    /// Growth adds heights over distances, without weights, at each iteration.
    GrowthSums,
    /// The run along a curve is divided by the posts between its picks, so it passes its end.
    CurveDivision,
    /// Roughness adds numbers from 0 to 1, which lifts the ground.
    RoughnessLift,
    /// The middles of boulders lie at the mean radius, not on the ground.
    MeanRadiusBoulders,
    /// Distributions are even in angle, which crowds the poles.
    EvenInAngle,
}

impl Switch {
    /// All switches, with the words of the file.
    pub const ALL: [(&'static str, Self); 6] = [
        ("feature-grids", Self::FeatureGrids),
        ("growth-sums", Self::GrowthSums),
        ("curve-division", Self::CurveDivision),
        ("roughness-lift", Self::RoughnessLift),
        ("mean-radius-boulders", Self::MeanRadiusBoulders),
        ("even-in-angle", Self::EvenInAngle),
    ];

    /// Word of the file.
    pub fn word(self) -> &'static str {
        Self::ALL.iter().find(|(_, switch)| *switch == self).map_or("", |(word, _)| word)
    }
}

/// Switches that are on.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Reported {
    bits: u8,
}

impl Reported {
    /// Whether a switch is on.
    pub fn has(self, switch: Switch) -> bool {
        self.bits & (1 << switch as u8) != 0
    }

    /// The same with a switch turned over.
    pub fn turned(self, switch: Switch) -> Self {
        Self { bits: self.bits ^ (1 << switch as u8) }
    }
}

impl FromIterator<Switch> for Reported {
    fn from_iter<I: IntoIterator<Item = Switch>>(switches: I) -> Self {
        switches.into_iter().fold(Self::default(), |on, switch| Self { bits: on.bits | (1 << switch as u8) })
    }
}
