//! What a terrain is made of, before it is checked.

/// The sphere below a terrain, and where its axes stand.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Frame {
    /// Radius of the body (m).
    pub radius: f64,
    /// Latitude of the place at which x and y are 0 (rad).
    pub latitude: f64,
    /// Longitude of the place at which x and y are 0 (rad).
    pub longitude: f64,
    /// Where the origin of the landscape stands in these axes: east, north (m). Banks and lists of the same export count from it.
    pub origin: [f64; 2],
}

/// The range of distances in which a level is drawn, as a suggestion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Range {
    /// Distance at which the range ends (m). It begins where that of the finer level ends.
    pub end: f64,
    /// Share of the range, at its far end, over which the level morphs: 0 to 1.
    pub share: f64,
}

/// A number for each post, row by row from the south: 0 is none, the largest number is all.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Map {
    /// Numbers up to 255.
    U8(Vec<u8>),
    /// Numbers up to 65535.
    U16(Vec<u16>),
}

impl Map {
    /// How many posts it has.
    pub fn len(&self) -> usize {
        match self {
            Self::U8(values) => values.len(),
            Self::U16(values) => values.len(),
        }
    }

    /// Whether there is no post.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Share of a post, 0 to 1.
    ///
    /// # Panics
    /// If there is no such post.
    pub fn share(&self, post: usize) -> f64 {
        match self {
            Self::U8(values) => f64::from(values[post]) / f64::from(u8::MAX),
            Self::U16(values) => f64::from(values[post]) / f64::from(u16::MAX),
        }
    }
}

/// Form of a boulder.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Shape {
    /// A sphere of the radius.
    Sphere,
    /// A cube whose side is the radius.
    Cube,
    /// A convex polyhedron of this many faces; seed and number of the boulder form it.
    Rock(u32),
}

/// A boulder on the terrain.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Boulder {
    /// Its middle: east, north, up (m).
    pub centre: [f64; 3],
    /// Radius, or side of a cube (m).
    pub radius: f64,
    /// Form of the boulder.
    pub shape: Shape,
    /// Seed of its feature.
    pub seed: u64,
    /// Its number in its feature.
    pub number: u64,
    /// Azimuth to which its forward axis is turned, from north towards east (rad).
    pub yaw: f64,
    /// Share of its height below the ground, 0 to 0.9.
    pub burial: f64,
}

/// What a terrain is made of. Axes: x east, y north, z up (m).
#[derive(Debug, Clone, PartialEq)]
pub struct Contents {
    /// Body and axes of the terrain.
    pub frame: Frame,
    /// Order n of the tiles, 1 to 12: `2^n + 1` posts a side.
    pub order: u32,
    /// Places of the posts along x (east) and along y (north), rising (m). A last tile that is cut short has closer posts.
    pub places: [Vec<f64>; 2],
    /// Heights of all posts above the sphere (m), row by row from the south, each from the west.
    pub heights: Vec<f64>,
    /// Step of the heights (m); none keeps every bit.
    pub step: Option<f64>,
    /// Suggested ranges of levels, the finest first; empty for none.
    pub ranges: Vec<Range>,
    /// Share of full light on each post.
    pub light: Option<Map>,
    /// Albedo of each post.
    pub albedo: Option<Map>,
    /// Boulders on the terrain.
    pub boulders: Vec<Boulder>,
    /// Text of the landscape file that the terrain was built from; empty for none.
    pub sidecar: String,
}

impl Contents {
    /// Heights on posts, exact, and nothing else.
    pub fn new(frame: Frame, order: u32, places: [Vec<f64>; 2], heights: Vec<f64>) -> Self {
        Self {
            frame,
            order,
            places,
            heights,
            step: None,
            ranges: Vec::new(),
            light: None,
            albedo: None,
            boulders: Vec::new(),
            sidecar: String::new(),
        }
    }
}
