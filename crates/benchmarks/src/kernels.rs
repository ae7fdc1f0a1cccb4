//! Named pieces of work whose instructions are counted.

use generator::Generator;
use machine::{HybridMachine, UnprobedMachine};
use signal::Probe;

use crate::{Choice, Scene};

/// Work that is made ready once and then run, each time the same.
#[derive(Debug, Clone, Copy)]
pub struct Kernel {
    /// Its name: what it is of, then how.
    pub name: &'static str,
    /// What it does.
    pub about: &'static str,
    /// Makes it ready.
    pub ready: fn() -> Box<dyn FnMut()>,
}

/// All of them. Pairs that differ in one thing stand side by side.
pub const KERNELS: &[Kernel] = &[
    Kernel {
        name: "first-light/no-probe",
        about: "frame 0, f32, ideal parts, by a machine without probes",
        ready: || frame("first-light", &UnprobedMachine, Probe::off()),
    },
    Kernel {
        name: "first-light/probe-off",
        about: "the same, by the machine of a replay, probing nothing",
        ready: || frame("first-light", &HybridMachine, Probe::off()),
    },
    Kernel {
        name: "first-light/probe-on",
        about: "the same, every signal of one sweep recorded",
        ready: || frame("first-light", &HybridMachine, Probe::new(vec!["*".into()], 500..501)),
    },
    Kernel {
        name: "showpiece/no-probe",
        about: "frame 0, f32, ideal parts, everything on the ground, by a machine without probes",
        ready: || frame("showpiece", &UnprobedMachine, Probe::off()),
    },
    Kernel {
        name: "nominal-drive/no-probe",
        about: "frame 0, parts of 1970, by a machine without probes",
        ready: || frame("nominal-drive", &UnprobedMachine, Probe::off()),
    },
    Kernel {
        name: "nominal-drive/probe-off",
        about: "the same, by the machine of a replay, probing nothing",
        ready: || frame("nominal-drive", &HybridMachine, Probe::off()),
    },
];

/// The kernel of this name.
pub fn kernel(name: &str) -> Option<&'static Kernel> {
    KERNELS.iter().find(|kernel| kernel.name == name)
}

/// A whole frame of a shipped scenario, to finished planes, on the thread that asks for it: callgrind tells threads apart.
fn frame(scenario: &str, generator: &dyn Generator, mut probe: Probe) -> Box<dyn FnMut()> {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).use_current_thread().build();
    let pool = pool.expect("a process runs one kernel");
    let scene = pool.install(|| Scene::shipped(scenario, &Choice::default()));
    let (mut planes, pose) = (scene.planes(), scene.pose);
    let session = generator.prepare(scene.stage).expect("the machine draws what is shipped");
    Box::new(move || {
        let counts = pool.install(|| session.frame(0, &pose, &mut planes, &mut probe));
        assert!(counts.expect("drawn by the tests").samples > 0);
        probe.waveforms.clear();
    })
}
