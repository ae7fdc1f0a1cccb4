//! What the page of trust rests on: a command each.

/// One piece of evidence.
#[derive(Debug, Clone, Copy)]
pub struct Evidence {
    /// Name of its file in `docs/trust/`.
    pub name: &'static str,
    /// Title, which says what it shows.
    pub title: &'static str,
    /// The command; what it prints is kept.
    pub command: &'static str,
    /// What stands on the page, from what was kept.
    pub form: Form,
}

/// How what a command has printed is shown.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Form {
    /// A table of `lunoid cartridge run --json`.
    Cartridges,
    /// A table of `lunoid lockstep --json`.
    Lockstep,
    /// A table of the file that `awake --json` writes.
    Awake,
    /// A table of the tracefile that `cargo llvm-cov --lcov` prints.
    Coverage,
    /// The lines that it printed.
    Lines,
    /// The tests that it ran, with how each ended.
    Tests,
}

/// All of it, in the order of the page: closed forms first, then a second computation, then what is only unchanged.
pub const EVIDENCE: &[Evidence] = &[
    Evidence {
        name: "cartridges",
        title: "Scenes whose answer is known in closed form",
        command: "cargo run --quiet -p lunoid -- cartridge run --json",
        form: Form::Cartridges,
    },
    Evidence {
        name: "lockstep-f64",
        title: "A second engine in lockstep: random scenes, machine in f64",
        command: "cargo run --quiet -p lunoid -- lockstep --random 200 --seed 0 --json",
        form: Form::Lockstep,
    },
    Evidence {
        name: "lockstep-more",
        title: "The same: a thousand more",
        command: "cargo run --quiet -p lunoid -- lockstep --random 1000 --seed 1000 --json",
        form: Form::Lockstep,
    },
    Evidence {
        name: "lockstep-shipped",
        title: "The same: shipped scenarios under every shipped model",
        command: "cargo test --quiet -p lunoid-tests --test lockstep_long -- --nocapture long_",
        form: Form::Lines,
    },
    Evidence {
        name: "relations",
        title: "Relations that must hold for any scene, and the determinism matrix",
        command: "cargo test --quiet -p lunoid-tests --test relations -- --nocapture",
        form: Form::Lines,
    },
    Evidence {
        name: "determinism",
        title: "Shipped scenarios by every build and every way of the command",
        command: "cargo run --quiet -p lunoid-tests --example determinism",
        form: Form::Lines,
    },
    Evidence {
        name: "endurance",
        title: "A hundred thousand frames, memory flat to one percent",
        command: "cargo run --quiet -p lunoid-tests --example endurance -- 100000",
        form: Form::Lines,
    },
    Evidence {
        name: "kills",
        title: "Killed at random moments and resumed",
        command: "cargo test --quiet -p lunoid --test long_runs -- --nocapture long_two",
        form: Form::Lines,
    },
    Evidence {
        name: "disks",
        title: "Every file operation made to fail",
        command: "cargo test --quiet -p lunoid --test long_runs -- --nocapture long_every",
        form: Form::Lines,
    },
    Evidence {
        name: "hostile",
        title: "Damaged and hostile files",
        command: "cargo test --quiet -p lunoid-tests --test hostile_long -- --nocapture long_",
        form: Form::Lines,
    },
    Evidence {
        name: "elevation",
        title: "Elevation files as GDAL reads them",
        command: "env LUNOID_GDAL_PYTHON=../../../runs/gdal/bin/python cargo test --quiet --workspace --test elevation -- --nocapture as_gdal_reads_them",
        form: Form::Lines,
    },
    Evidence {
        name: "attacks",
        title: "Attacks on folders, records, locks and limits",
        command: "cargo test --workspace --test bad_input attacks",
        form: Form::Tests,
    },
    Evidence {
        name: "fuzz",
        title: "Readers under a fuzzer that is led by coverage",
        command: "tests/fuzz/run 40",
        form: Form::Lines,
    },
    Evidence {
        name: "awake",
        title: "Deliberate breaks, and the test that caught each",
        command: "cargo run --quiet -p lunoid-tests --bin awake -- --json docs/trust/awake.json",
        form: Form::Awake,
    },
    Evidence {
        name: "awake-as-released",
        title: "Breaks of every kind of event, without debug assertions and overflow checks",
        command: "cargo run --quiet -p lunoid-tests --bin awake -- --profile release --of crates/device/dpu --of crates/device/data-bank \
                  --of crates/generators/control-plane/src/event_list --json docs/trust/awake-as-released.json",
        form: Form::Awake,
    },
    Evidence {
        name: "coverage",
        title: "Lines and branches of laws and parts that their tests reach",
        command: "env RUSTC_BOOTSTRAP=1 cargo llvm-cov --branch --lcov -p features -p parts -p landscape -p sweep-generator \
                  -p terrain-generator -p display-projection-processor",
        form: Form::Coverage,
    },
    Evidence {
        name: "mutants",
        title: "Law files changed by a mutation tool",
        command: "cargo mutants --workspace --file crates/world/photometry/src/lib.rs --file crates/world/landscape/src/lunoid.rs \
                  --file crates/device/sweep-generator/src/ramps.rs \
                  --file crates/device/display-projection-processor/src/deflection.rs --timeout 60 --cap-lints true --output target",
        form: Form::Lines,
    },
    Evidence {
        name: "mutants-craters",
        title: "Craters, registers and the table of ranges changed by a mutation tool",
        command: "cargo mutants --workspace --file crates/world/features/src/crater.rs --file crates/device/terrain-generator/src/registers.rs \
                  --file crates/device/sweep-generator/src/range_table.rs --timeout 60 --cap-lints true --output target",
        form: Form::Lines,
    },
    Evidence {
        name: "supply",
        title: "Licences of all that is linked",
        command: "cargo test --quiet -p lunoid-tests --test house licences -- --nocapture",
        form: Form::Lines,
    },
];
