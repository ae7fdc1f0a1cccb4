//! What a sweep cuts out of a face.

/// The part of a face that lies on one sweep.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Span {
    /// Upper end: line position from the top of the picture.
    pub top: f32,
    /// Lower end, at or below the upper.
    pub bottom: f32,
    /// Reflectivity of the face at its upper end, 0..=1.
    pub reflectivity: f32,
    /// How reflectivity changes from line to line downwards (1/line): 0 on a face whose light is flat.
    pub ramp: f32,
    /// Inverse horizontal range from the eye (1/m), at top and bottom. Between them it is `depth` over a linear
    /// function.
    pub near: [f32; 2],
    /// Inverse distance along the view axis (1/m), at top and bottom; linear in line position between them.
    pub depth: [f32; 2],
    /// Index of the body in the order in which bodies were given.
    pub body: u32,
    /// The object that the body is a part of.
    pub object: u32,
    /// Horizontal range of the object's foot point (m).
    pub foot_range: f32,
}

impl Span {
    /// Inverse distance along the view axis (1/m) at a share of the way from top to bottom.
    pub fn depth_at(&self, share: f32) -> f32 {
        self.depth[0] + share * (self.depth[1] - self.depth[0])
    }

    /// Inverse distance along the view axis (1/m) at a line position.
    #[inline(always)]
    pub(crate) fn depth_on(&self, line: f32) -> f32 {
        self.depth[0] + (self.depth[1] - self.depth[0]) / (self.bottom - self.top) * (line - self.top)
    }

    /// Inverse ground range (1/m) at a share of the way from top to bottom: range over depth is linear.
    pub fn near_at(&self, share: f32) -> f32 {
        let stretch = [self.depth[0] / self.near[0], self.depth[1] / self.near[1]];
        self.depth_at(share) / (stretch[0] + share * (stretch[1] - stretch[0]))
    }

    /// Reflectivity at a line position of the span.
    #[inline(always)]
    pub(crate) fn reflectivity_on(&self, line: f32) -> f32 {
        self.reflectivity + self.ramp * (line - self.top)
    }

    /// Whether another goes on where it ends, as a part of the same object.
    #[inline(always)]
    pub(crate) fn goes_on(&self, below: &Self) -> bool {
        self.bottom == below.top && self.object == below.object
    }

    /// Line position at a share of the way from top to bottom.
    pub fn line_at(&self, share: f32) -> f32 {
        if share < 1.0 { self.top + share * (self.bottom - self.top) } else { self.bottom }
    }
}
