//! Named pieces of work: timed by `cargo bench`, their instructions counted by the binary `instructions`.

use std::sync::LazyLock;

use hardware_model::Economy;
use machine::{HybridMachine, UnprobedMachine};
use rayon::{ThreadPool, ThreadPoolBuilder};
use scenario::Scalar;
use signal::Probe;

mod before;
mod blocks;
mod frames;
mod group;

/// Work that is made ready once and then run, each time the same.
#[derive(Debug, Clone, Copy)]
pub struct Kernel {
    /// Its name: what it is of, then how.
    pub name: &'static str,
    /// What it does.
    pub about: &'static str,
    /// Makes it ready.
    pub ready: fn() -> Work,
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
    Kernel {
        name: "terrain-generator/f32",
        about: "eight sweeps of first light",
        ready: blocks::terrain_generator::<f32>,
    },
    Kernel { name: "terrain-generator/f64", about: "the same", ready: blocks::terrain_generator::<f64> },
    Kernel {
        name: "display-projection-processor/f32",
        about: "eight sweeps of nominal drive, terrain alone",
        ready: blocks::projection::<f32>,
    },
    Kernel { name: "display-projection-processor/f64", about: "the same", ready: blocks::projection::<f64> },
    Kernel {
        name: "sweep-memory/write-f32",
        about: "the same, along cubics",
        ready: blocks::write_beam::<f32>,
    },
    Kernel { name: "sweep-memory/write-f64", about: "the same", ready: blocks::write_beam::<f64> },
    Kernel {
        name: "sweep-memory/read-digital",
        about: "a picture of stripes",
        ready: || blocks::read_beam(sweep_memory::Memory::Digital, 0.0),
    },
    Kernel {
        name: "sweep-memory/read-converter",
        about: "the same by a scan converter",
        ready: || blocks::read_beam(sweep_memory::Memory::ScanConverter, 0.0),
    },
    Kernel {
        name: "sweep-memory/read-turned",
        about: "the same, yoke turned by 0.1 rad",
        ready: || blocks::read_beam(sweep_memory::Memory::ScanConverter, 0.1),
    },
    Kernel {
        name: "feature-generator/schedule",
        about: "which craters eight sweeps of craters load",
        ready: blocks::feature_schedule,
    },
    Kernel {
        name: "feature-generator/f32",
        about: "eight sweeps of craters",
        ready: blocks::feature_generator,
    },
    Kernel {
        name: "texture-generator/f32",
        about: "eight sweeps of craters",
        ready: blocks::texture_generator,
    },
    Kernel {
        name: "shadow-controller/gates",
        about: "gates of remote shadow within 1 m, 525 sweeps of long shadows",
        ready: before::gates,
    },
    Kernel {
        name: "polyhedron-generator/frame",
        about: "bodies of a frame of full drive",
        ready: before::polyhedra,
    },
    Kernel {
        name: "control-plane/ideal",
        about: "programs of 64 sweeps of nominal drive",
        ready: || before::control_plane("ideal"),
    },
    Kernel {
        name: "control-plane/pra-nominal",
        about: "the same with the digital parts of 1970",
        ready: || before::control_plane("pra-nominal"),
    },
    Kernel {
        name: "remote-shadow/boundaries",
        about: "shadow boundaries of long shadows within 1 m",
        ready: before::shadow_boundaries,
    },
    Kernel {
        name: "survey/regions",
        about: "128 x 128 samples into 32 x 32 regions",
        ready: || before::survey(128),
    },
    Kernel {
        name: "full-drive/ideal",
        about: "64 sweeps of frame 0, every block, f32",
        ready: || frames::part("full-drive", "ideal", Scalar::F32, Economy::Bounded),
    },
    Kernel {
        name: "full-drive/swift",
        about: "the same, swiftly",
        ready: || frames::part("full-drive", "ideal", Scalar::F32, Economy::Swift),
    },
    Kernel {
        name: "nominal-drive/ideal",
        about: "64 sweeps of frame 0, two levels, craters, rocks, f32",
        ready: || frames::part("nominal-drive", "ideal", Scalar::F32, Economy::Bounded),
    },
    Kernel {
        name: "nominal-drive/ideal-f64",
        about: "the same in f64",
        ready: || frames::part("nominal-drive", "ideal", Scalar::F64, Economy::Bounded),
    },
    Kernel {
        name: "nominal-drive/swift",
        about: "the same in f32, swiftly",
        ready: || frames::part("nominal-drive", "ideal", Scalar::F32, Economy::Swift),
    },
    Kernel {
        name: "nominal-drive/swift-wires",
        about: "the same, lag and slew on ten signals",
        ready: || frames::part("nominal-drive", "pra-wires", Scalar::F32, Economy::Swift),
    },
    Kernel {
        name: "nominal-drive/swift-parts",
        about: "the same, 261 parts with a state in each terrain generator, alike",
        ready: || frames::part("nominal-drive", "pra-parts", Scalar::F32, Economy::Swift),
    },
    Kernel {
        name: "nominal-drive/parts-of-1970",
        about: "the same, each part its own, noise, tubes and yoke",
        ready: || frames::part("nominal-drive", "pra-nominal", Scalar::F32, Economy::Bounded),
    },
    Kernel {
        name: "first-light/no-probe",
        about: "frame 0, f32, ideal parts, by a machine without probes",
        ready: || frames::whole("first-light", &UnprobedMachine, Probe::off()),
    },
    Kernel {
        name: "first-light/probe-off",
        about: "the same, by the machine of a replay, probing nothing",
        ready: || frames::whole("first-light", &HybridMachine, Probe::off()),
    },
    Kernel {
        name: "first-light/probe-on",
        about: "the same, every signal of one sweep recorded",
        ready: || frames::whole("first-light", &HybridMachine, Probe::new(vec!["*".into()], 500..501)),
    },
    Kernel {
        name: "showpiece/no-probe",
        about: "frame 0, f32, ideal parts, everything on the ground, by a machine without probes",
        ready: || frames::whole("showpiece", &UnprobedMachine, Probe::off()),
    },
    Kernel {
        name: "nominal-drive/no-probe",
        about: "frame 0, parts of 1970, by a machine without probes",
        ready: || frames::whole("nominal-drive", &UnprobedMachine, Probe::off()),
    },
    Kernel {
        name: "nominal-drive/probe-off",
        about: "the same, by the machine of a replay, probing nothing",
        ready: || frames::whole("nominal-drive", &HybridMachine, Probe::off()),
    },
];

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
