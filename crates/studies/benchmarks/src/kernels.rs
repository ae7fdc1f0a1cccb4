//! Named pieces of work: timed by `cargo bench`, their instructions counted by the binary `instructions`.

use std::path::Path;
use std::sync::LazyLock;

use hardware_model::Economy;
use machine::{Prepare, prepare_unprobed};
use rayon::{ThreadPool, ThreadPoolBuilder};
use scenario::Scalar;
use signal::Probe;
use sweep_memory::Memory;

mod before;
mod blocks;
mod frames;
mod group;

/// Work that is made ready once and then run, each time the same.
#[derive(Debug, Clone, Copy)]
pub struct Kernel {
    /// Its name: what it is of, then how.
    pub name: &'static str,
    /// What the kernel does, in words.
    pub about: &'static str,
    make: Make,
}

/// How the work of a kernel is made ready.
#[derive(Debug, Clone, Copy)]
enum Make {
    /// By itself, from nothing.
    Alone(fn() -> Work),
    /// With shadow boundaries, which may be kept in a folder.
    Shadowed(fn(Option<&Path>) -> Work),
}

impl Kernel {
    /// Makes the work ready. Shadow boundaries that are needed stand in the folder `shadows`, which keeps what it did not have. Without a
    /// folder each time computes them.
    pub fn ready(&self, shadows: Option<&Path>) -> Work {
        match self.make {
            Make::Alone(ready) => ready(),
            Make::Shadowed(ready) => ready(shadows),
        }
    }

    /// Whether shadow boundaries are found before the kernel runs.
    pub fn is_shadowed(&self) -> bool {
        matches!(self.make, Make::Shadowed(_))
    }
}

/// A kernel made ready.
pub struct Work {
    /// Samples, words or pixels that it goes through: what its rate is told in.
    pub elements: u64,
    /// Does it once, on the thread that asks, which must be the same for all kernels of a process.
    pub run: Box<dyn FnMut()>,
}

impl Work {
    fn new(elements: u64, run: impl FnMut() + 'static) -> Self {
        Self { elements, run: Box::new(run) }
    }
}

/// All of them: blocks over a group of eight sweeps in the middle of a shipped frame, each fed with what the one before it
/// made; what is brought for a frame; what stands before a mission; whole frames. Pairs that differ in one thing stand side
/// by side.
pub const KERNELS: &[Kernel] = &[
    row("terrain-generator/f32", "eight sweeps of first light", blocks::terrain_generator::<f32>),
    row("terrain-generator/f64", "the same", blocks::terrain_generator::<f64>),
    row(
        "display-projection-processor/f32",
        "eight sweeps of nominal drive, terrain alone",
        blocks::projection::<f32>,
    ),
    row("display-projection-processor/f64", "the same", blocks::projection::<f64>),
    row("sweep-memory/write-f32", "the same, along cubics", blocks::write_beam::<f32>),
    row("sweep-memory/write-f64", "the same", blocks::write_beam::<f64>),
    row("sweep-memory/read-digital", "a picture of stripes", || blocks::read_beam(Memory::Digital, 0.0)),
    row("sweep-memory/read-converter", "the same by a scan converter", || {
        blocks::read_beam(Memory::ScanConverter, 0.0)
    }),
    row("sweep-memory/read-turned", "the same, yoke turned by 0.1 rad", || {
        blocks::read_beam(Memory::ScanConverter, 0.1)
    }),
    row("feature-generator/schedule", "which craters eight sweeps of craters load", blocks::feature_schedule),
    row("feature-generator/f32", "eight sweeps of craters", blocks::feature_generator),
    row("texture-generator/f32", "eight sweeps of craters", blocks::texture_generator),
    shadowed(
        "shadow-controller/gates",
        "gates of remote shadow within 1 m, 525 sweeps of long shadows",
        before::gates,
    ),
    row("polyhedron-generator/frame", "bodies of a frame of full drive", before::polyhedra),
    row("control-plane/ideal", "programs of 64 sweeps of nominal drive", || before::control_plane("ideal")),
    row("control-plane/pra-nominal", "the same with the digital parts of 1970", || {
        before::control_plane("pra-nominal")
    }),
    row(
        "remote-shadow/boundaries",
        "shadow boundaries of long shadows within 1 m",
        before::shadow_boundaries,
    ),
    row("survey/regions", "128 x 128 samples into 32 x 32 regions", || before::survey(128)),
    shadowed("full-drive/ideal", "64 sweeps of frame 0, every block, f32", |shadows| {
        frames::shadowed_part("full-drive", Economy::Bounded, shadows)
    }),
    shadowed("full-drive/preview", "the same, in preview", |shadows| {
        frames::shadowed_part("full-drive", Economy::Instants(1), shadows)
    }),
    shadowed("full-drive/normal", "the same, at the default quality", |shadows| {
        frames::shadowed_part("full-drive", Economy::Normal, shadows)
    }),
    row("nominal-drive/ideal", "64 sweeps of frame 0, two levels, craters, rocks, f32", || {
        frames::part("nominal-drive", "ideal", Scalar::F32, Economy::Bounded)
    }),
    row("nominal-drive/ideal-f64", "the same in f64", || {
        frames::part("nominal-drive", "ideal", Scalar::F64, Economy::Bounded)
    }),
    row("nominal-drive/preview", "the same in f32, in preview", || {
        frames::part("nominal-drive", "ideal", Scalar::F32, Economy::Instants(1))
    }),
    row("nominal-drive/preview-wires", "the same, lag and slew on ten signals", || {
        frames::part("nominal-drive", "pra-wires", Scalar::F32, Economy::Instants(1))
    }),
    row(
        "nominal-drive/preview-parts",
        "the same, 261 parts with a state in each terrain generator, alike",
        || frames::part("nominal-drive", "pra-parts", Scalar::F32, Economy::Instants(1)),
    ),
    row("nominal-drive/parts-of-1970", "the same, each part its own, noise, tubes and yoke", || {
        frames::part("nominal-drive", "pra-nominal", Scalar::F32, Economy::Bounded)
    }),
    row("first-light/no-probe", "frame 0, f32, ideal parts, by a machine without probes", || {
        frames::whole("first-light", prepare_unprobed, Probe::off())
    }),
    row("first-light/probe-off", "the same, by the machine of a replay, probing nothing", || {
        frames::whole("first-light", Prepare::prepare, Probe::off())
    }),
    row("first-light/probe-on", "the same, every signal of one sweep recorded", || {
        frames::whole("first-light", Prepare::prepare, Probe::new(vec!["*".into()], 500..501))
    }),
    shadowed(
        "showpiece/no-probe",
        "frame 0, f32, ideal parts, everything on the ground, by a machine without probes",
        |shadows| frames::shadowed_whole("showpiece", prepare_unprobed, shadows),
    ),
    row("nominal-drive/no-probe", "frame 0, parts of 1970, by a machine without probes", || {
        frames::whole("nominal-drive", prepare_unprobed, Probe::off())
    }),
    row("nominal-drive/probe-off", "the same, by the machine of a replay, probing nothing", || {
        frames::whole("nominal-drive", Prepare::prepare, Probe::off())
    }),
    row("nominal-drive/probe-one", "the same, one signal of one sweep recorded", || {
        frames::whole("nominal-drive", Prepare::prepare, Probe::new(vec!["tg.height".into()], 260..261))
    }),
];

const fn row(name: &'static str, about: &'static str, ready: fn() -> Work) -> Kernel {
    Kernel { name, about, make: Make::Alone(ready) }
}

const fn shadowed(name: &'static str, about: &'static str, ready: fn(Option<&Path>) -> Work) -> Kernel {
    Kernel { name, about, make: Make::Shadowed(ready) }
}

/// The kernel of this name.
pub fn kernel(name: &str) -> Option<&'static Kernel> {
    KERNELS.iter().find(|kernel| kernel.name == name)
}

/// Runs `work` where the thread that asks is the only one: callgrind tells threads apart.
fn alone<T: Send>(work: impl FnOnce() -> T + Send) -> T {
    static ALONE: LazyLock<ThreadPool> = LazyLock::new(|| {
        let pool = ThreadPoolBuilder::new().num_threads(1).use_current_thread().build();
        pool.expect("a process has one such pool")
    });
    ALONE.install(work)
}
