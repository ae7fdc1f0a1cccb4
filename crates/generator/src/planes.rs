//! Named planes: what a frame is made of.

/// What a plane holds, one f32 a pixel.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PlaneKind {
    /// Linear reflectivity, 0 = black sky or shadow. Sky is 0.
    Intensity,
    /// Ground range at the pixel centre (m); infinity where there is sky.
    Range,
}

impl PlaneKind {
    /// Name in files.
    pub fn name(self) -> &'static str {
        match self {
            Self::Intensity => "intensity",
            Self::Range => "range",
        }
    }
}

/// One plane, row by row from the top left.
#[derive(Debug, Clone, PartialEq)]
pub struct Plane {
    /// What it holds.
    pub kind: PlaneKind,
    /// `lines * columns` values.
    pub values: Vec<f32>,
}

/// The planes that a caller wants filled.
#[derive(Debug, Clone, PartialEq)]
pub struct Planes {
    columns: usize,
    lines: usize,
    planes: Vec<Plane>,
}

impl Planes {
    /// Planes of `columns` x `lines` pixels, one for each of `kinds`, all zero.
    pub fn new(columns: usize, lines: usize, kinds: &[PlaneKind]) -> Self {
        let plane = |&kind| Plane { kind, values: vec![0.0; columns * lines] };
        Self { columns, lines, planes: kinds.iter().map(plane).collect() }
    }

    /// Pixels in a row.
    pub fn columns(&self) -> usize {
        self.columns
    }

    /// Rows.
    pub fn lines(&self) -> usize {
        self.lines
    }

    /// The values of `kind`, if it was asked for.
    pub fn get(&self, kind: PlaneKind) -> Option<&[f32]> {
        self.planes.iter().find(|plane| plane.kind == kind).map(|plane| plane.values.as_slice())
    }

    /// The values of `kind` to fill, if it was asked for.
    pub fn get_mut(&mut self, kind: PlaneKind) -> Option<&mut [f32]> {
        self.planes.iter_mut().find(|plane| plane.kind == kind).map(|plane| plane.values.as_mut_slice())
    }
}
