//! Where the sampling points of a pixel lie.

use std::f64::consts::SQRT_2;

/// Steps of an offset in a pixel: offsets are whole multiples of 1/64 pixel.
pub const OFFSET_UNIT: u8 = 64;

/// Most sampling points of a pixel: the points are then the bits of one word.
pub(crate) const MOST_SAMPLES: usize = 32;

/// A pattern of sampling points, the same in all pixels.
///
/// `Four`, `Eight` and the shape of `Sixteen` are the standard positions of graphics hardware; the others are regular.
/// EP-0611021 asks for at least one point in a sub-area and leaves the pattern open.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Pattern {
    /// `1`: one point in the middle of the pixel.
    One,
    /// `4`: four points, one in each row and column of quarters.
    Four,
    /// `8`: eight points, one in each row and column of eighths.
    Eight,
    /// `16`: sixteen points, one in each row and column of sixteenths, centred on the pixel.
    Sixteen,
    /// `grid16`: a square grid of 4 x 4 points.
    Grid16,
    /// `lattice32`: thirty-two points of a lattice, one in each row and column.
    Lattice32,
    /// `off-centre16`: `16` as hardware tables give it, in whole sixteenths. It is a fault: all points lie 1/32 pixel too far
    /// left and up, and move every edge by as much.
    OffCentre16,
}

impl Pattern {
    /// Every pattern, the fault last.
    pub const ALL: [Self; 7] =
        [Self::One, Self::Four, Self::Eight, Self::Sixteen, Self::Grid16, Self::Lattice32, Self::OffCentre16];

    /// The name that a file or an option says.
    pub fn name(self) -> &'static str {
        match self {
            Self::One => "1",
            Self::Four => "4",
            Self::Eight => "8",
            Self::Sixteen => "16",
            Self::Grid16 => "grid16",
            Self::Lattice32 => "lattice32",
            Self::OffCentre16 => "off-centre16",
        }
    }

    /// The pattern of a name, if there is one.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|pattern| pattern.name() == name)
    }

    /// Offsets (x, y) from the pixel's top left corner in 1/64 pixel, each 0 to 63; one to 32 of them.
    pub fn offsets(self) -> &'static [[u8; 2]] {
        match self {
            Self::One => &ONE,
            Self::Four => &FOUR,
            Self::Eight => &EIGHT,
            Self::Sixteen => &SIXTEEN,
            Self::Grid16 => &GRID16,
            Self::Lattice32 => &LATTICE32,
            Self::OffCentre16 => &OFF_CENTRE16,
        }
    }

    /// Diameter (pixels) of the widest disc that can lie on the screen without a sampling point inside. Derived: the widest circle
    /// through three points that holds none, as a root of a fraction.
    pub fn widest_miss(self) -> f64 {
        match self {
            Self::One => SQRT_2,
            Self::Four => (5.0f64 / 8.0).sqrt(),
            Self::Eight => (221.0f64 / 800.0).sqrt(),
            Self::Sixteen | Self::OffCentre16 => 4625f64.sqrt() / 176.0,
            Self::Grid16 => SQRT_2 / 4.0,
            Self::Lattice32 => (425.0f64 / 8192.0).sqrt(),
        }
    }
}

const ONE: [[u8; 2]; 1] = from_32nds([[16, 16]]);

const FOUR: [[u8; 2]; 4] = from_32nds([[12, 4], [28, 12], [4, 20], [20, 28]]);

const EIGHT: [[u8; 2]; 8] =
    from_32nds([[18, 10], [14, 22], [26, 18], [10, 6], [6, 26], [2, 14], [22, 30], [30, 2]]);

const SIXTEEN_32NDS: [[u8; 2]; 16] = [
    [19, 19],
    [15, 11],
    [11, 21],
    [25, 15],
    [7, 13],
    [21, 27],
    [27, 23],
    [23, 7],
    [13, 29],
    [17, 3],
    [9, 5],
    [5, 25],
    [1, 17],
    [31, 9],
    [29, 31],
    [3, 1],
];

const SIXTEEN: [[u8; 2]; 16] = from_32nds(SIXTEEN_32NDS);

const OFF_CENTRE16: [[u8; 2]; 16] = {
    let mut offsets = SIXTEEN;
    let mut i = 0;
    while i < offsets.len() {
        offsets[i] = [offsets[i][0] - 2, offsets[i][1] - 2];
        i += 1;
    }
    offsets
};

const GRID16: [[u8; 2]; 16] = {
    let mut offsets = [[0; 2]; 16];
    let mut i = 0;
    while i < offsets.len() {
        offsets[i] = [16 * (i as u8 % 4) + 8, 16 * (i as u8 / 4) + 8];
        i += 1;
    }
    offsets
};

const LATTICE32: [[u8; 2]; 32] = {
    let mut offsets = [[0; 2]; 32];
    let mut k = 0;
    while k < offsets.len() {
        offsets[k] = [2 * k as u8 + 1, 2 * (7 * k as u8 % 32) + 1];
        k += 1;
    }
    offsets
};

const fn from_32nds<const N: usize>(offsets: [[u8; 2]; N]) -> [[u8; 2]; N] {
    let mut finer = [[0; 2]; N];
    let mut i = 0;
    while i < N {
        finer[i] = [2 * offsets[i][0], 2 * offsets[i][1]];
        i += 1;
    }
    finer
}
