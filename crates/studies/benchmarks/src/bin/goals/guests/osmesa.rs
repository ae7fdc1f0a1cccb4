//! OSMesa, OpenGL in software, over the faces that a generator has on the screen.

use benchmarks::peers::drawing::{Compiled, Drawing, Source};
use benchmarks::peers::embree::{EyeMesh, Sight};

/// The program that draws by OSMesa.
static SOURCE: Source = Source {
    program: "osmesa",
    text: concat!(env!("CARGO_MANIFEST_DIR"), "/peers/osmesa.cpp"),
    header: "GL/osmesa.h",
    link: "-lOSMesa",
    package: ["OSMesa", "libosmesa6-dev (Mesa 22.3 is tried)"],
};

/// OSMesa over one mesh: one vertex buffer, one draw call, one sample a pixel.
pub struct OsMesa(Drawing);

impl OsMesa {
    /// OSMesa over a mesh whose vertices have light of their own. The inner error is a line that names the package that is missing here.
    ///
    /// # Errors
    /// If it cannot be compiled although all packages are here, cannot be fed, or ends early.
    pub fn new(mesh: &EyeMesh, sight: &Sight) -> Result<Result<Self, String>, String> {
        let compiled = match Compiled::new(&SOURCE)? {
            Ok(compiled) => compiled,
            Err(skipped) => return Ok(Err(skipped)),
        };
        let (drawing, _) = compiled.start(mesh, sight, "ready")?;
        Ok(Ok(Self(drawing)))
    }

    /// Gives it a texture of `size` (columns, lines): light line by line from the top. From then on each vertex has its place on the
    /// texture (pixel I, J) in place of a normal.
    ///
    /// # Errors
    /// If it cannot be handed over.
    pub fn texture(&mut self, size: [usize; 2], lights: &[f32]) -> Result<(), String> {
        self.0.texture(size, lights)
    }

    /// Draws a frame up to its read-back, from a vertex buffer that is filled anew or from the one that is there: its time (s).
    ///
    /// # Errors
    /// If it does not answer so.
    pub fn show(&mut self, anew: bool) -> Result<f64, String> {
        self.0.seconds(if anew { "show anew" } else { "show" })
    }

    /// Light of the last frame, line by line from the top left, in steps of 1/255.
    ///
    /// # Errors
    /// If it does not write as many numbers as the picture has pixels.
    pub fn picture(&mut self) -> Result<Vec<f32>, String> {
        self.0.picture()
    }
}

#[cfg(test)]
mod tests {
    use benchmarks::peers::embree::{EyeMesh, Sight};
    use scenario::FieldOfView;

    use super::OsMesa;

    /// A square 4 m ahead, 2 m a side, fills the middle quarter of a field of 90 degrees by half; its light runs from left to right. A
    /// smaller one before it hides it.
    #[test]
    fn the_nearer_of_two_squares_is_seen() {
        let square = |ahead: f32, half: f32, light: [f32; 2]| {
            [[-half, -half], [half, -half], [half, half], [-half, half]]
                .map(|[right, down]| [[ahead, right, down], [light[usize::from(right > 0.0)], 0.0, 0.0]])
        };
        let vertices = [square(2.0, 0.25, [0.0; 2]), square(4.0, 1.0, [0.2, 1.0])].concat();
        let mesh = EyeMesh { vertices, faces: vec![[0, 1, 2, 3], [4, 5, 6, 7]] };
        let field = FieldOfView { tan_half_width: 0.5, tan_half_height: 0.5 };
        let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let sight = Sight { size: [64; 2], field, albedo: 1.0, ranges: [0.0, 1e9], axes };
        let mut osmesa = match OsMesa::new(&mesh, &sight).expect("OSMesa compiles") {
            Ok(osmesa) => osmesa,
            Err(skipped) => return eprintln!("OSMesa: {skipped}"),
        };
        for anew in [false, true] {
            assert!(osmesa.show(anew).unwrap() > 0.0);
            let picture = osmesa.picture().unwrap();
            for (pixel, found) in picture.into_iter().enumerate() {
                let [column, line] = [pixel % 64, pixel / 64];
                let is_in =
                    |reach: usize| [column, line].iter().all(|at| (32 - reach..32 + reach).contains(at));
                let ramp = 0.2 + 0.8 * (column as f32 + 0.5 - 16.0) / 32.0;
                let expected = if is_in(16) && !is_in(8) { ramp } else { 0.0 };
                assert!((found - expected).abs() < 0.005, "{column}, {line}: {found}, not {expected}");
            }
        }
    }
}
