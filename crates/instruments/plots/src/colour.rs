//! Colours: few, and none louder than what is shown.

/// Red, green and blue, 0 to 255 each.
pub(crate) type Colour = [u8; 3];

/// Colour of the paper.
pub(crate) const PAPER: Colour = [255, 255, 255];
/// Colour of titles and axes.
pub(crate) const INK: Colour = [34, 34, 34];
/// Facts and tick labels.
pub(crate) const SOFT: Colour = [96, 96, 96];
/// Colour of grid lines.
pub(crate) const FAINT: Colour = [226, 226, 226];
/// Where there is no sample.
pub(crate) const VOID: Colour = [206, 206, 206];
/// Colour of the strokes over [`VOID`].
pub(crate) const HATCH: Colour = [168, 168, 168];

/// Traces, in the order in which they are given; told apart by lightness too.
pub(crate) const TRACES: [Colour; 6] =
    [[31, 78, 121], [192, 86, 33], [63, 125, 88], [125, 80, 150], [150, 120, 30], [90, 90, 90]];

/// Dashes of as many traces as there are colours, of as many more, and of those after them.
const DASHES: [Option<[f32; 2]>; 3] = [None, Some([6.0, 3.0]), Some([2.0, 2.0])];

/// The dash, if any, that tells a trace from the one before it of the same colour.
pub(crate) fn dash(index: usize) -> Option<[f32; 2]> {
    DASHES[(index / TRACES.len()).min(DASHES.len() - 1)]
}

/// What came too late.
pub(crate) const LATE: Colour = [196, 40, 40];

/// The colours of a page: paper, what is written on it, and traces.
#[derive(Debug, PartialEq)]
pub(crate) struct Palette {
    pub paper: Colour,
    /// Colour of titles and axes.
    pub ink: Colour,
    /// Facts and tick labels.
    pub soft: Colour,
    /// Colour of grid lines.
    pub faint: Colour,
    /// Ground of what is blanked.
    pub shade: Colour,
    /// Traces, in the order in which they are given.
    pub traces: [Colour; 6],
    /// Registers: yellow, green, black, red. They keep their names for people who see no red or no green.
    pub registers: [Colour; 4],
    /// What came too late, or is not there.
    pub late: Colour,
    /// Colour of both cursors.
    pub cursor: Colour,
}

/// Palette of dark ink on white paper.
pub(crate) const LIGHT: Palette = Palette {
    paper: PAPER,
    ink: INK,
    soft: SOFT,
    faint: FAINT,
    shade: [229, 233, 240],
    traces: [[0, 60, 140], [222, 74, 0], [10, 148, 100], [128, 40, 205], [76, 36, 24], [120, 124, 190]],
    registers: [[232, 184, 0], [0, 148, 110], [40, 40, 40], [208, 74, 0]],
    late: LATE,
    cursor: [176, 0, 96],
};

/// Palette of bright phosphor on dark glass.
pub(crate) const DARK: Palette = Palette {
    paper: [18, 21, 26],
    ink: [236, 236, 230],
    soft: [168, 174, 182],
    faint: [46, 51, 59],
    shade: [32, 37, 45],
    traces: [
        [130, 184, 255],
        [239, 140, 0],
        [80, 200, 110],
        [166, 112, 190],
        [244, 244, 60],
        [240, 240, 214],
    ],
    registers: [[240, 208, 40], [50, 222, 140], [122, 132, 156], [236, 104, 40]],
    late: [255, 96, 88],
    cursor: [255, 120, 190],
};

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
    use super::{Colour, DARK, HEIGHTS, LIGHT, RESIDUALS, lit, of_height, of_residual};

    /// What people without the long or without the middle cones see, of linear light (Machado and others, 2009).
    const BLIND: [[[f64; 3]; 3]; 2] = [
        [[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216], [-0.003882, -0.048116, 1.051998]],
        [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.011820, 0.042940, 0.968881]],
    ];

    fn light([r, g, b]: Colour) -> [f64; 3] {
        [r, g, b].map(|code| {
            let share = f64::from(code) / 255.0;
            if share <= 0.04045 { share / 12.92 } else { libm::pow((share + 0.055) / 1.055, 2.4) }
        })
    }

    /// Codes of what the blind of `matrix` see.
    fn seen(colour: Colour, matrix: &[[f64; 3]; 3]) -> [f64; 3] {
        let light = light(colour);
        matrix.map(|row| {
            let v: f64 = row.iter().zip(light).map(|(a, b)| a * b).fold(0.0, |sum, part| sum + part);
            let v = v.clamp(0.0, 1.0);
            255.0 * if v <= 0.0031308 { 12.92 * v } else { 1.055 * libm::pow(v, 1.0 / 2.4) - 0.055 }
        })
    }

    fn contrast(a: Colour, b: Colour) -> f64 {
        let [mut a, mut b] = [a, b].map(|colour| {
            let [r, g, b] = light(colour);
            0.2126 * r + 0.7152 * g + 0.0722 * b + 0.05
        });
        if a < b {
            std::mem::swap(&mut a, &mut b);
        }
        a / b
    }

    #[test]
    fn traces_and_registers_are_told_apart_without_red_and_without_green() {
        for palette in [&LIGHT, &DARK] {
            for colours in [&palette.traces[..], &palette.registers] {
                for (index, &a) in colours.iter().enumerate() {
                    for &b in &colours[..index] {
                        for matrix in &BLIND {
                            let [a, b] = [a, b].map(|colour| seen(colour, matrix));
                            let apart =
                                a.iter().zip(b).map(|(a, b)| (a - b) * (a - b)).fold(0.0, |s, d| s + d);
                            assert!(apart.sqrt() > 60.0, "{a:?} and {b:?}: {:.0}", apart.sqrt());
                        }
                    }
                }
            }
        }
    }

    #[test]
    fn what_is_written_stands_out_from_the_paper() {
        for palette in [&LIGHT, &DARK] {
            for (colour, least) in
                [(palette.ink, 7.0), (palette.soft, 4.5), (palette.cursor, 4.5), (palette.late, 4.5)]
            {
                assert!(contrast(colour, palette.paper) > least, "{colour:?}");
            }
            assert!(palette.traces.iter().all(|&trace| contrast(trace, palette.paper) > 3.0));
        }
    }

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
