//! Colours: few, and none louder than what is shown.

/// Red, green, blue.
pub(crate) type Colour = [u8; 3];

/// Paper.
pub(crate) const PAPER: Colour = [255, 255, 255];
/// Titles and axes.
pub(crate) const INK: Colour = [34, 34, 34];
/// Facts and tick labels.
pub(crate) const SOFT: Colour = [96, 96, 96];
/// Grid lines.
pub(crate) const FAINT: Colour = [226, 226, 226];
/// Where there is no sample.
pub(crate) const VOID: Colour = [206, 206, 206];
/// Strokes over [`VOID`].
pub(crate) const HATCH: Colour = [168, 168, 168];

/// Traces, in the order in which they are given; told apart by lightness too.
pub(crate) const TRACES: [Colour; 6] =
    [[31, 78, 121], [192, 86, 33], [63, 125, 88], [125, 80, 150], [150, 120, 30], [90, 90, 90]];

/// What came too late.
pub(crate) const LATE: Colour = [196, 40, 40];

/// Heights from low to high: slate, lunar grey, sand, near white.
const HEIGHTS: [Colour; 5] =
    [[92, 108, 126], [136, 145, 151], [176, 174, 167], [211, 203, 184], [246, 242, 231]];

/// Residuals from below to above the fit: blue, white, red, equally dark at both ends.
const RESIDUALS: [Colour; 7] = [
    [33, 82, 145],
    [92, 142, 189],
    [174, 204, 224],
    [247, 247, 245],
    [240, 190, 164],
    [208, 112, 88],
    [150, 38, 48],
];

/// The colour of a height, `share` 0 lowest to 1 highest.
pub(crate) fn of_height(share: f64) -> Colour {
    between(&HEIGHTS, share)
}

/// The colour of a residual, `share` -1 to 1 of the scale's limit.
pub(crate) fn of_residual(share: f64) -> Colour {
    between(&RESIDUALS, 0.5 + 0.5 * share)
}

/// `a` with `share` of `b` over it.
pub(crate) fn mix(a: Colour, b: Colour, share: f64) -> Colour {
    let share = share.clamp(0.0, 1.0);
    std::array::from_fn(|i| byte(f64::from(a[i]) * (1.0 - share) + f64::from(b[i]) * share))
}

/// `colour` under light of strength `light`; above 1 it brightens up to white.
pub(crate) fn lit(colour: Colour, light: f64) -> Colour {
    colour.map(|value| byte(f64::from(value) * light))
}

fn between(stops: &[Colour], share: f64) -> Colour {
    let place = share.clamp(0.0, 1.0) * (stops.len() - 1) as f64;
    let index = (place as usize).min(stops.len() - 2);
    mix(stops[index], stops[index + 1], place - index as f64)
}

fn byte(value: f64) -> u8 {
    (value + 0.5).clamp(0.0, 255.0) as u8
}

#[cfg(test)]
mod tests {
    use super::{HEIGHTS, RESIDUALS, lit, of_height, of_residual};

    #[test]
    fn maps_reach_their_ends_and_their_middle() {
        assert_eq!((of_height(-1.0), of_height(1.0)), (HEIGHTS[0], HEIGHTS[4]));
        assert_eq!(
            (of_residual(-1.0), of_residual(0.0), of_residual(9.0)),
            (RESIDUALS[0], RESIDUALS[3], RESIDUALS[6])
        );
        assert_eq!(lit([200, 100, 0], 2.0), [255, 200, 0]);
    }
}
