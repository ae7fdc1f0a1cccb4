//! Faces of a frame on the screen, as a judge of sampling draws them.

/// Everything of a frame that consists of faces and discs, in no order.
pub struct FaceScene {
    /// Polygons on the screen, each convex.
    pub faces: Vec<ScreenFace>,
    /// Looks of the faces.
    pub looks: Looks,
    /// Share of their nearness by which two faces may differ and still be equally near; 0 for none.
    pub coincidence: f64,
}

/// How the face of a number looks at a place on the screen (pixels).
pub type Looks = Box<dyn Fn(usize, [f64; 2]) -> Look + Send + Sync>;

/// A convex polygon on the screen, in one plane in space.
#[derive(Debug, Clone, PartialEq)]
pub struct ScreenFace {
    /// Corners (pixels, x to the right, y down), around it in either direction.
    pub corners: Vec<[f64; 2]>,
    /// How near it is: `q = 1 / w` (1/m), w the depth, is `q[0] x + q[1] y + q[2]` at x, y. Larger is nearer.
    pub q: [f64; 3],
    /// Which of two faces that are equally near is seen: the higher.
    pub priority: i32,
    /// Which of two of one priority is seen: the lower.
    pub id: u32,
}

/// What a face does to light at a place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Look {
    /// Light that it sends itself (linear red, green, blue, at least 0).
    pub light: [f64; 3],
    /// Share of light from behind that it lets through, 0 to 1 each (red, green, blue).
    pub translucency: [f64; 3],
}

impl ScreenFace {
    /// How near it is (1/m) at a place on the screen (pixels).
    pub fn nearness(&self, [x, y]: [f64; 2]) -> f64 {
        self.q[0] * x + self.q[1] * y + self.q[2]
    }
}
