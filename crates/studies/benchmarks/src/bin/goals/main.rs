//! The whole table of goals: frames, missions, the control plane by itself, memory, start-up, an analog chain against ngspice,
//! the ground against a ray tracer.

mod built;
mod guests;
mod photographs;
mod row;

use std::env;
use std::path::Path;
use std::process::{Command, ExitCode};
use std::time::Instant;

use benchmarks::around::{Mission, surveyed};
use benchmarks::chain::{Outputs, Stepped, difference, simulate};
use benchmarks::mesh::trace;
use benchmarks::startup::{begin, prepare};
use benchmarks::{Choice, FrameTimes, KERNELS, STANDARD, TimedScene, Work, frame_times, instructions_of};
use clap::{Args, Parser, Subcommand};
use control_plane::ControlPlane;
use exact::Exact;
use generator::{Generator, PlaneKind, Session};
use hardware_model::Economy;
use landscape::Attitude;
use machine::Prepare;
use scenario::{Curvature, Laws, PixelRule, Pose, Projection, Scalar};
use signal::{LANES, Lanes, Probe, Real};
use sweep_program::SweepProgram;

use guests::SideChoice;

/// Measure the table of goals: all of it, or one part.
#[derive(Debug, Parser)]
struct Arguments {
    #[command(subcommand)]
    part: Option<Part>,
}

#[derive(Debug, Clone, Subcommand)]
enum Part {
    /// Whole frames, as `speed` tells them.
    Frames,
    /// Block by block, and what stands before a frame or a mission: what `instructions` counts, timed.
    Kernels,
    /// Whole missions: the ground, the first frame with its shadow boundaries, all others; and a survey.
    Missions,
    /// Programs of all sweeps of a frame, by the control plane alone.
    Control,
    /// Peak memory of a process that draws three frames of a scene.
    Memory,
    /// A bank of a million corners and a million craters: from nothing to the first frame.
    Startup,
    /// An analog chain by exact steps and by ngspice.
    Circuit,
    /// The ground as finer and finer meshes by POV-Ray, against the machine at equal error.
    Mesh,
    /// Ground with cast shadows by Embree, against the machine at equal error.
    Embree,
    /// Folds, loads and queues of a frame by Verilator, against the control plane.
    Verilator,
    /// Light map and viewshed of built ground, against Embree and xarray-spatial.
    Built,
    /// Photographs over ground: voids, a drape against Embree, memory.
    Photographs,
    /// The other generators against themselves, the judge and Embree.
    Guests {
        /// Rows whose quantity has these words alone.
        #[arg(default_value = "")]
        words: String,
    },
    /// Peak memory of the other generators.
    GuestMemory,
    /// Instructions of a frame of the other generators, by callgrind.
    GuestCounts,
    /// Peak memory (MB) of this process after three frames of a side.
    #[command(hide = true)]
    GuestPeak(SideArguments),
    /// Two frames of a side, the second counted: what is run under callgrind.
    #[command(hide = true)]
    GuestCounted(SideArguments),
    /// Peak memory (KiB) of this process after three frames of a shipped scenario under ideal parts.
    #[command(hide = true)]
    Peak {
        scenario: String,
        /// On the standard raster, not on the scenario's own.
        #[arg(long)]
        standard: bool,
    },
    /// Times and peak memory of this process beginning with a scenario.
    #[command(hide = true)]
    Begin {
        scenario: String,
        #[arg(long)]
        preview: bool,
    },
}

/// Arguments of a process that draws one side.
#[derive(Debug, Clone, Args)]
struct SideArguments {
    scenario: String,
    #[arg(long)]
    machine: Option<String>,
    #[arg(long = "set", value_parser = key_value)]
    set: Vec<(String, String)>,
}

impl SideArguments {
    fn choice(&self) -> SideChoice {
        let Self { scenario, machine, set } = self.clone();
        SideChoice { scenario, machine, set: set.into_iter().collect(), whole: false }
    }
}

fn main() -> ExitCode {
    let parts = match Arguments::parse().part {
        None => vec![
            Part::Frames,
            Part::Kernels,
            Part::Missions,
            Part::Control,
            Part::Memory,
            Part::Startup,
            Part::Circuit,
            Part::Mesh,
            Part::Embree,
            Part::Verilator,
            Part::Built,
            Part::Photographs,
            Part::Guests { words: String::new() },
            Part::GuestMemory,
            Part::GuestCounts,
        ],
        Some(part) => vec![part],
    };
    match parts.iter().try_for_each(run) {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("error: {message}");
            ExitCode::FAILURE
        }
    }
}

fn run(part: &Part) -> Result<(), String> {
    match part {
        Part::Frames => frames(),
        Part::Kernels => kernels(),
        Part::Missions => missions(),
        Part::Control => control(),
        Part::Memory => memory(),
        Part::Startup => startup(),
        Part::Circuit => circuit(),
        Part::Mesh => mesh(),
        Part::Embree => embree(),
        Part::Verilator => verilator(),
        Part::Built => {
            println!("{}", built::table()?);
            Ok(())
        }
        Part::Photographs => {
            let choice =
                |scenario: &str| SideChoice { scenario: scenario.to_owned(), ..SideChoice::default() };
            println!("{}", photographs::table(|scenario| guest_peak(&choice(scenario)))?);
            Ok(())
        }
        Part::Guests { words } => {
            println!("{}", guests::table(words)?);
            Ok(())
        }
        Part::GuestMemory => {
            println!("{}", guests::memory_table(guest_peak)?);
            Ok(())
        }
        Part::GuestCounts => {
            println!("{}", guests::counted_table(guest_count)?);
            Ok(())
        }
        Part::GuestPeak(side) => {
            println!("{}", guests::peak(&side.choice())?);
            Ok(())
        }
        Part::GuestCounted(side) => guests::draw_counted(&side.choice()),
        Part::Peak { scenario, standard } => peak(scenario, *standard),
        Part::Begin { scenario, preview } => {
            let economy = if *preview { Economy::Instants(1) } else { Economy::Bounded };
            tell_beginning(Path::new(scenario), economy)
        }
    }
}

/// Least and median of the times of `work` (s), after once to warm up.
fn times(repetitions: usize, mut work: impl FnMut()) -> [f64; 2] {
    work();
    let mut times: Vec<f64> = (0..repetitions)
        .map(|_| {
            let begin = Instant::now();
            work();
            begin.elapsed().as_secs_f64()
        })
        .collect();
    times.sort_unstable_by(f64::total_cmp);
    [times[0], times[repetitions / 2]]
}

/// Repetitions of every frame.
const FRAMES: usize = 5;

fn frames() -> Result<(), String> {
    println!("{}", FrameTimes::table(&frame_times(&[], FRAMES, &[1, 2])?));
    Ok(())
}

/// Repetitions of every kernel.
const TURNS: usize = 15;

/// Whole frames of other rasters among them are left out: `frames` has them on one that all share.
fn kernels() -> Result<(), String> {
    println!(
        "| kernel, one thread | what | elements | us | least | ns an element |\n|---|---|---|---|---|---|"
    );
    for kernel in KERNELS.iter().filter(|kernel| !kernel.name.contains("probe")) {
        let Work { elements, mut run } = kernel.ready(None);
        let [least, median] = times(TURNS, &mut *run);
        println!(
            "| {} | {} | {elements} | {:.1} | {:.1} | {:.2} |",
            kernel.name,
            kernel.about,
            median * 1e6,
            least * 1e6,
            median * 1e9 / elements as f64
        );
    }
    println!();
    Ok(())
}

/// Samples along a side of what is surveyed.
const SURVEYED: usize = 1024;

fn missions() -> Result<(), String> {
    println!(
        "| mission, ideal, f32, two threads | frames | ground, s | first frame, s | all others, s | frames/s | x real time |\n|---|---|---|---|---|---|---|"
    );
    let pool = rayon::ThreadPoolBuilder::new().num_threads(2).build().map_err(|error| error.to_string())?;
    for economy in [Economy::Bounded, Economy::Instants(1)] {
        let choice =
            Choice { model: Some("ideal"), scalar: Some(Scalar::F32), raster: Some(STANDARD), economy };
        for name in ["first-light", "nominal-drive", "showpiece"] {
            let mission = Mission::draw(name, &choice, &pool)?;
            println!(
                "| {}{name} | {} | {:.2} | {:.2} | {:.2} | {:.1} | {:.2} |",
                if economy == Economy::Instants(1) { "preview " } else { "" },
                mission.frames,
                mission.ground,
                mission.first,
                mission.others,
                mission.rate(),
                mission.real_time()
            );
        }
    }
    let seconds = surveyed(SURVEYED, &pool)?;
    println!("\nA survey of {SURVEYED} x {SURVEYED} samples, two threads: {seconds:.2} s\n");
    Ok(())
}

/// Frames of the control plane that are timed.
const REPETITIONS: usize = 99;

fn control() -> Result<(), String> {
    println!(
        "| control plane, one thread | sweeps | folds and loads | ms a frame | least |\n|---|---|---|---|---|"
    );
    for (scenario, model) in
        [("nominal-drive", "pra-nominal"), ("nominal-drive", "ideal"), ("showpiece", "ideal")]
    {
        let choice = Choice { model: Some(model), ..Choice::default() };
        let (plane, scene) = (
            ControlPlane::new(TimedScene::shipped(scenario, &choice).stage),
            TimedScene::shipped(scenario, &choice),
        );
        let count = scene.stage.settings.raster.sweeps;
        let mut programs = Vec::new();
        let mut write = |look: &mut dyn FnMut(&[SweepProgram])| {
            let sweeps = plane.sweeps(0, &scene.pose).expect("drawn by the tests");
            for sweep in 0..count {
                sweeps.write_programs(sweep, &mut programs);
                look(&programs);
            }
        };
        let [least, median] = times(REPETITIONS, || write(&mut |_| {}));
        let mut written = 0;
        write(&mut |programs| {
            written += programs.iter().map(|program| program.events().count()).sum::<usize>()
        });
        assert!(written > 0);
        println!("| {scenario}, {model} | {count} | {written} | {:.2} | {:.2} |", median * 1e3, least * 1e3);
    }
    println!();
    Ok(())
}

fn memory() -> Result<(), String> {
    println!("| peak memory of a process, MB | standard raster | its own |\n|---|---|---|");
    for scenario in ["first-light", "nominal-drive", "showpiece"] {
        let peak = |arguments: &[&str]| {
            let kib: f64 = apart(arguments)?.trim().parse().map_err(|_| "no peak".to_owned())?;
            Ok::<_, String>(kib * 1024.0 / 1e6)
        };
        let [standard, own] = [peak(&["peak", scenario, "--standard"])?, peak(&["peak", scenario])?];
        println!("| {scenario}, ideal | {standard:.1} | {own:.1} |");
    }
    println!();
    Ok(())
}

fn peak(scenario: &str, standard: bool) -> Result<(), String> {
    let raster = standard.then_some(STANDARD);
    let scene = TimedScene::shipped(scenario, &Choice { model: Some("ideal"), raster, ..Choice::default() });
    let (mut planes, pose) = (scene.planes(), scene.pose);
    let session = scene.stage.prepare();
    for _ in 0..3 {
        session.frame(0, &pose, &mut planes, &mut Probe::off()).map_err(|error| error.to_string())?;
    }
    println!("{}", replay::peak_memory().ok_or("this system does not tell the peak")?);
    Ok(())
}

/// A key and its value, as `--set` takes them.
fn key_value(written: &str) -> Result<(String, String), String> {
    let pair = written.split_once('=').ok_or("expected KEY=VALUE")?;
    Ok((pair.0.to_owned(), pair.1.to_owned()))
}

/// Arguments by which a process of its own does `part` with a side.
fn of_side(part: &str, choice: &SideChoice) -> Vec<String> {
    let machine = choice.machine.iter().flat_map(|machine| ["--machine".to_owned(), machine.clone()]);
    let set = choice.set.iter().flat_map(|(key, value)| ["--set".to_owned(), format!("{key}={value}")]);
    [part.to_owned(), choice.scenario.clone()].into_iter().chain(machine).chain(set).collect()
}

/// Peak memory (MB) of a side in a process of its own.
fn guest_peak(choice: &SideChoice) -> Result<f64, String> {
    let arguments = of_side("guest-peak", choice);
    let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
    apart(&arguments)?.trim().parse().map_err(|_| "no peak".to_owned())
}

/// Instructions of a frame of a side in a process of its own.
fn guest_count(choice: &SideChoice) -> Result<u64, String> {
    let program = env::current_exe().map_err(|error| error.to_string())?;
    let count = instructions_of(&program, "frame", &of_side("guest-counted", choice));
    count.map(|count| count.instructions).map_err(|error| error.to_string())
}

fn startup() -> Result<(), String> {
    println!(
        "| craters | landscape s | machine s | first frame ms | next ms | peak MB |\n|---|---|---|---|---|---|"
    );
    for craters in [0, 1_000_000] {
        let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
        let scenario = prepare(folder.path(), craters)?.display().to_string();
        // Files are in memory after the first time: what is left is our own work.
        apart(&["begin", &scenario])?;
        println!("| {craters} | {}", apart(&["begin", &scenario])?.trim());
        println!("| {craters}, in preview | {}", apart(&["begin", &scenario, "--preview"])?.trim());
    }
    println!();
    Ok(())
}

fn tell_beginning(scenario: &Path, economy: Economy) -> Result<(), String> {
    let took = begin(scenario, economy)?;
    let peak = replay::peak_memory().map_or(f64::NAN, |kib| kib as f64 * 1024.0 / 1e6);
    println!(
        "{:.2} | {:.2} | {:.1} | {:.1} | {peak:.0} |",
        took.landscape,
        took.machine,
        took.frame * 1e3,
        took.next * 1e3
    );
    Ok(())
}

/// What this program prints when it is called so: in a process of its own, whose peak is its own.
fn apart(arguments: &[&str]) -> Result<String, String> {
    let program = env::current_exe().map_err(|error| error.to_string())?;
    let ended = Command::new(program).args(arguments).output().map_err(|error| error.to_string())?;
    let said = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    if ended.status.success() { Ok(said(&ended.stdout)) } else { Err(said(&ended.stderr)) }
}

/// Meridians and rings of the meshes, coarse to fine; POV-Ray reads the finest for most of a minute.
const SIDES: [usize; 6] = [64, 128, 256, 512, 1024, 2048];

fn mesh() -> Result<(), String> {
    let choice = Choice {
        model: Some("ideal"),
        scalar: Some(Scalar::F32),
        raster: Some(STANDARD),
        ..Choice::default()
    };
    let mut scene = TimedScene::shipped("first-light", &choice);
    let raster = scene.stage.settings.raster;
    println!(
        "| first light, {} x {} pixels, two threads | triangles | rms error | ms | of the whole machine's | of the preview's | reading and all, s |\n|---|---|---|---|---|---|---|",
        raster.columns, raster.lines
    );
    // What a camera over flat ground sees, at the centre of each pixel.
    let laws = &mut scene.stage.settings.laws;
    *laws = Laws {
        projection: Projection::Exact,
        curvature: Curvature::None,
        pixel_rule: PixelRule::Centre,
        ..*laws
    };
    let pose =
        Pose { attitude: Attitude { pitch: 0.0, roll: 0.0, ..scene.pose.attitude }, yoke: 0.0, ..scene.pose };
    let pool = rayon::ThreadPoolBuilder::new().num_threads(2).build().map_err(|error| error.to_string())?;
    let drawn = |session: Box<dyn Session>, repetitions| {
        let mut planes = scene.planes();
        let [least, _] = pool.install(|| {
            times(repetitions, || {
                session.frame(0, &pose, &mut planes, &mut Probe::off()).expect("drawn by the tests");
            })
        });
        let picture = planes.get(PlaneKind::Intensity).ok_or("no picture")?.to_vec();
        Ok::<_, String>((picture, least))
    };
    let by = |economy| {
        let mut stage = scene.stage.clone();
        stage.settings.economy = economy;
        stage.prepare()
    };
    let exact = Exact.prepare(scene.stage.stage()).map_err(|error| error.to_string())?;
    let (right, _) = drawn(exact, 1)?;
    let (picture, whole) = drawn(by(Economy::Bounded), 15)?;
    let (sketch, preview) = drawn(by(Economy::Instants(1)), 15)?;
    let rms = |picture: &[f32]| benchmarks::peers::rms(picture, &right);
    let error = rms(&picture);
    for (name, error, seconds) in [("", error, whole), (", in preview", rms(&sketch), preview)] {
        let [of_whole, of_preview] = [whole, preview].map(|machine| seconds / machine);
        println!(
            "| hybrid machine, ideal, f32{name} | | {error:.2e} | {:.1} | {of_whole:.2} times | {of_preview:.2} times | |",
            seconds * 1e3
        );
    }
    for side in SIDES {
        let Some(traced) = trace(&scene, &pose, side)? else {
            println!("| POV-Ray is not here | | | | | | |");
            break;
        };
        let found = rms(&traced.picture);
        let [of_whole, of_preview] = [whole, preview].map(|machine| traced.seconds / machine);
        println!(
            "| POV-Ray, {side} x {side} | {} | {found:.2e} | {:.0} | {of_whole:.1} times | {of_preview:.1} times | {:.1} |",
            traced.triangles,
            traced.seconds * 1e3,
            traced.whole
        );
        if found <= error {
            break;
        }
    }
    println!();
    Ok(())
}

fn embree() -> Result<(), String> {
    println!("{}", benchmarks::peers::embree::table()?);
    Ok(())
}

fn verilator() -> Result<(), String> {
    println!("{}", benchmarks::peers::verilator::table()?);
    Ok(())
}

/// Rasters of 50 ns of the comparison: 400 µs, a hundred rises and falls.
const RASTERS: usize = 8001;

fn circuit() -> Result<(), String> {
    let mut right = Outputs::<f64>::default();
    Stepped::new(256, RASTERS).run(&mut right);
    let right = right.m;
    println!(
        "| analog chain, 400 us | chains | rms error | largest | s a chain | of ngspice's default |\n|---|---|---|---|---|---|"
    );
    let Some(default) = simulate(1, RASTERS, None)? else {
        println!("| ngspice is not here | | | | | |\n");
        return Ok(());
    };
    let tell = |name: &str, chains: usize, [rms, most]: [f64; 2], seconds: f64| {
        let (a_chain, times) = (seconds / chains as f64, default.seconds * chains as f64 / seconds);
        println!("| {name} | {chains} | {rms:.1e} | {most:.1e} | {a_chain:.3e} | {times:.1} times |");
    };
    tell("ngspice, default", 1, difference(&default.m, &right, 1), default.seconds);
    for (chains, reltol) in [(LANES, None), (1, Some(1e-4)), (1, Some(1e-5)), (1, Some(1e-6))] {
        if let Some(run) = simulate(chains, RASTERS, reltol)? {
            let name = reltol.map_or("default".to_owned(), |reltol| format!("reltol {reltol:e}"));
            tell(&format!("ngspice, {name}"), chains, difference(&run.m, &right, chains), run.seconds);
        }
    }
    for a_raster in [1, 2, 4, 16] {
        let name = |scalar: &str| format!("exact steps of {} ns, {scalar}", 50.0 / a_raster as f64);
        let (error, seconds) = stepped::<f32>(a_raster, &right);
        tell(&name("f32"), LANES, error, seconds);
        let (error, seconds) = stepped::<f64>(a_raster, &right);
        tell(&name("f64"), LANES, error, seconds);
    }
    println!();
    Ok(())
}

/// Error of eight chains side by side, and their time (s).
fn stepped<S: Real>(a_raster: usize, right: &[Lanes<f64>]) -> ([f64; 2], f64) {
    let (chains, mut out) = (Stepped::<S>::new(a_raster, RASTERS), Outputs::default());
    let [least, _] = times(9, || chains.run(&mut out));
    assert!(out.held.iter().all(|held| !held.is_empty()));
    (difference(&out.m, right, LANES), least)
}
