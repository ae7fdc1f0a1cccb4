//! A long run: frames of a small raster, one after another, with the memory of the process before and after.
//!
//! `cargo run -p lunoid-tests --example endurance -- 100000` draws so many frames of a random landscape and fails if the
//! resident memory has grown by more than 1 % since the first tenth of them. It reads `/proc`, so it runs on Linux.

use machine::Prepare;
use std::process::ExitCode;
use std::time::Instant;

use generator::{PlaneKind, Planes};
use lunoid_tests::{ComparedScene, random};
use quantities::radians;
use scenario::Scalar;
use signal::Probe;

/// Largest growth of memory.
const GROWTH: f64 = 0.01;

/// Resident memory of this process (kB).
fn resident() -> Option<f64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix("VmRSS:"))?;
    line.trim().strip_suffix(" kB")?.parse().ok()
}

fn main() -> ExitCode {
    let asked =
        std::env::args().nth(1).and_then(|count| count.parse::<u64>().ok()).filter(|&count| count >= 100);
    let Some(frames) = asked else {
        eprintln!("expected the number of frames, 100 or more");
        return ExitCode::from(2);
    };
    let mut scene = ComparedScene { scalar: Scalar::F32, ..random::landscape(3) };
    (scene.sweeps, scene.samples, scene.lines) = (16, 64, 24);
    let session = scene.stage().prepare();
    let mut planes = Planes::new(16, 24, &[PlaneKind::Intensity]);
    let (begun, mut early) = (Instant::now(), None);
    for frame in 0..frames {
        let mut pose = scene.pose();
        pose.time = frame as f64 / 30.0;
        pose.attitude.heading += radians(0.37) * frame as f64;
        session.frame(frame, &pose, &mut planes, &mut Probe::off()).expect("the eye stays where it is");
        if frame == frames / 10 {
            early = resident();
        }
    }
    let (Some(early), Some(late)) = (early, resident()) else {
        eprintln!("this system does not say how much memory a process has");
        return ExitCode::from(1);
    };
    let growth = late / early - 1.0;
    let seconds = begun.elapsed().as_secs_f64();
    println!(
        "{frames} frames in {seconds:.0} s: {early} kB at a tenth, {late} kB at the end, {:+.3} %",
        100.0 * growth
    );
    ExitCode::from(u8::from(growth > GROWTH))
}
