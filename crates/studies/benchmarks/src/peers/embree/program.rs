//! The ray tracer as a process: compiled, fed and asked.

use super::{EyeMesh, Sight};
use crate::peers::drawing::{Compiled, Drawing, Source};

/// What the ray tracer is made of.
static SOURCE: Source = Source {
    program: "embree",
    text: concat!(env!("CARGO_MANIFEST_DIR"), "/peers/embree.cpp"),
    header: "embree3/rtcore.h",
    link: "-lembree3",
    package: ["Embree 3", "libembree-dev (version 3; 3.13 is tried)"],
};

/// The ray tracer, compiled for this processor.
#[derive(Debug)]
pub struct Program(Compiled);

impl Program {
    /// Compiles it. The inner error is a line that names the package that is missing here.
    ///
    /// # Errors
    /// If it cannot be compiled although all packages are here.
    pub fn compile() -> Result<Result<Self, String>, String> {
        Ok(Compiled::new(&SOURCE)?.map(Self))
    }

    /// Starts it over a mesh. It divides space before this returns.
    ///
    /// # Errors
    /// If it cannot be fed or ends early.
    pub fn start(&self, mesh: &EyeMesh, sight: &Sight) -> Result<Embree, String> {
        let (drawing, built) = self.0.start(mesh, sight, "built")?;
        Ok(Embree { drawing, built })
    }
}

/// The ray tracer over one mesh, waiting for questions.
#[derive(Debug)]
pub struct Embree {
    drawing: Drawing,
    built: f64,
}

impl Embree {
    /// How long it took to divide space (s).
    pub fn built(&self) -> f64 {
        self.built
    }

    /// Traces a frame by packets of 16, 8 or 1 rays under a sun of this direction (north, east, up): its time (s).
    ///
    /// # Errors
    /// If it does not answer so.
    pub fn trace(&mut self, packet: u32, [north, east, up]: [f64; 3]) -> Result<f64, String> {
        self.drawing.seconds(&format!("trace {packet} {north} {east} {up}"))
    }

    /// Traces a frame of a mesh whose vertices have light of their own, by packets of 16, 8 or 1 rays: its time (s).
    ///
    /// # Errors
    /// If it does not answer so.
    pub fn show(&mut self, packet: u32) -> Result<f64, String> {
        self.drawing.seconds(&format!("show {packet}"))
    }

    /// Gives it a texture of `size` (columns, lines): light line by line from the top. [`Self::drape`] looks it up.
    ///
    /// # Errors
    /// If it cannot be handed over.
    pub fn texture(&mut self, size: [usize; 2], lights: &[f32]) -> Result<(), String> {
        self.drawing.texture(size, lights)
    }

    /// Traces a frame of a mesh whose vertices have a pixel I, J of the texture in place of a normal, by packets of 16, 8 or 1 rays: its
    /// time (s).
    ///
    /// # Errors
    /// If it does not answer so.
    pub fn drape(&mut self, packet: u32) -> Result<f64, String> {
        self.drawing.seconds(&format!("drape {packet}"))
    }

    /// Traces one ray from each vertex to the sun of this direction (north, east, up), from `lift` (m) on, by packets of 16, 8 or 1 rays: the
    /// time (s). The picture must have a pixel for each vertex; it is 1 where nothing is in the way, else 0.
    ///
    /// # Errors
    /// If it does not answer so.
    pub fn light(&mut self, packet: u32, [north, east, up]: [f64; 3], lift: f64) -> Result<f64, String> {
        self.drawing.seconds(&format!("light {packet} {north} {east} {up} {lift}"))
    }

    /// Divides space anew, of quality `low`, `medium` or `high`: the time (s).
    ///
    /// # Errors
    /// If it does not answer so.
    pub fn divide(&mut self, quality: &str) -> Result<f64, String> {
        self.drawing.seconds(&format!("divide {quality}"))
    }

    /// Reflectivity of the last frame, line by line from the top left.
    ///
    /// # Errors
    /// If it does not write as many numbers as the picture has pixels.
    pub fn picture(&mut self) -> Result<Vec<f32>, String> {
        self.drawing.picture()
    }
}
