//! Findings about the listing, each a switch.

/// Which findings of the listing are turned on. The default is the repaired program.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Restrictions {
    /// The picture is the lower left quadrant of the field, on the whole screen.
    pub quadrant: bool,
    /// Stored coordinates, axes and distances have 24 bits.
    pub real4: bool,
    /// Greys are signed bytes, and their mean is cut to a whole number.
    pub signed_bytes: bool,
    /// Greys are averaged over a box of pixels that its diagonal cuts.
    pub box_average: bool,
    /// Axes of the picture come from two posts and the middle of the body.
    pub skewed_axes: bool,
    /// Depth is the Euclidean distance, linear on the screen; 0 means empty.
    pub linear_depth: bool,
    /// Ground behind the eye is projected as if it were before it.
    pub mirror_behind: bool,
    /// Voids have the mean of all known posts.
    pub mean_void: bool,
    /// A panel with a corner beyond the screen is left out.
    pub discard_partial: bool,
    /// Corners are cut to whole pixels, the first of which is 1, and a span has both its ends.
    pub both_ends: bool,
    /// At most 50 x 50 posts, 512 panels, a screen and a photograph of 512 x 512.
    pub limits: bool,
}

/// A switch of [`Restrictions`].
pub type Switch = fn(&mut Restrictions) -> &mut bool;

impl Restrictions {
    /// All switches by the names of their keys, in the order of the specification.
    pub const SWITCHES: [(&str, Switch); 11] = [
        ("quadrant", |all| &mut all.quadrant),
        ("real4", |all| &mut all.real4),
        ("signed_bytes", |all| &mut all.signed_bytes),
        ("box_average", |all| &mut all.box_average),
        ("skewed_axes", |all| &mut all.skewed_axes),
        ("linear_depth", |all| &mut all.linear_depth),
        ("mirror_behind", |all| &mut all.mirror_behind),
        ("mean_void", |all| &mut all.mean_void),
        ("discard_partial", |all| &mut all.discard_partial),
        ("both_ends", |all| &mut all.both_ends),
        ("limits", |all| &mut all.limits),
    ];

    /// All switches on: the program as it is listed.
    pub fn as_written() -> Self {
        Self::SWITCHES.iter().fold(Self::default(), |mut all, (_, switch)| {
            *switch(&mut all) = true;
            all
        })
    }

    /// The finding of a key alone; none where no finding has that key.
    pub fn only(key: &str) -> Option<Self> {
        let (_, switch) = Self::SWITCHES.iter().find(|(name, _)| *name == key)?;
        let mut alone = Self::default();
        *switch(&mut alone) = true;
        Some(alone)
    }

    /// Whether any finding is on.
    pub fn any(mut self) -> bool {
        Self::SWITCHES.iter().any(|(_, switch)| *switch(&mut self))
    }
}
