//! Both ladders, step by step, and the fastest settings in turns.

use std::fmt::Write as _;

use super::scene::Machine;
use super::{Embree, PeerScene, Program, Setting};
use crate::peers::{median, rms};

/// Largest root mean square of the difference from `exact`, in reflectivity.
const CLOSE: f64 = 0.0085;
/// Frames of each step of a ladder.
const STEPS: usize = 7;
/// Frames of each side in the last comparison.
const TURNS: usize = 21;
/// Meridians and rings of the meshes.
const MESHES: [[usize; 2]; 10] = [
    [256, 512],
    [384, 768],
    [512, 1024],
    [448, 1152],
    [512, 1056],
    [512, 1088],
    [512, 1152],
    [384, 1280],
    [448, 1280],
    [640, 1280],
];
/// Rays of a packet.
const PACKETS: [u32; 3] = [16, 8, 1];
/// Sweeps a frame that are tried.
const SWEEPS: [u32; 3] = [320, 400, 533];
/// Samples a sweep and instants a step.
const STEPPED: [(u32, Option<u32>); 6] =
    [(500, Some(4)), (1000, Some(2)), (1000, Some(3)), (1000, Some(4)), (2000, Some(1)), (1000, None)];
/// How fine shadows are tried.
const SHADOWS: [[f64; 2]; 4] = [[0.5, 2e-3], [1.0, 4e-3], [2.0, 8e-3], [4.0, 16e-3]];

/// A setting of the ray tracer: meridians and rings, rays of a packet.
type Traced = ([usize; 2], u32);

/// A step of a ladder: which setting, and the median of its times (s).
#[derive(Debug, Clone, Copy)]
struct Best<T> {
    setting: T,
    seconds: f64,
}

impl<T> Best<T> {
    /// Takes a setting that is close enough and faster than the one so far.
    fn offer(best: &mut Option<Self>, setting: T, error: f64, seconds: f64) {
        if error <= CLOSE && best.as_ref().is_none_or(|known| seconds < known.seconds) {
            *best = Some(Self { setting, seconds });
        }
    }
}

/// Both ladders and what the fastest settings of both come to, as tables in Markdown; one line where a package is missing.
///
/// # Errors
/// If something cannot be drawn, or no setting of a side is close enough.
pub fn table() -> Result<String, String> {
    let program = match Program::compile()? {
        Ok(program) => program,
        Err(skipped) => return Ok(format!("| Embree | {skipped} |\n")),
    };
    let scene = PeerScene::new()?;
    let right = scene.exact(0.0)?;
    let [columns, lines] = scene.size();
    let mut text = format!(
        "Ground of {} craters, {columns} x {lines} pixels, cast shadows, two threads; an error of at most {CLOSE} is close enough\n\n\
         | Embree: meridians x rings | faces | packet | rms error | ms | space divided, s |\n|---|---|---|---|---|---|\n",
        scene.craters()
    );
    let traced = climb_embree(&program, &scene, &right, &mut text)?;
    text += "\n| machine, ideal, f32 | rms error | ms | with a new sun, ms |\n|---|---|---|---|\n";
    let drawn = climb_machine(&scene, &right, &mut text)?;
    let none = || format!("no setting has an error of at most {CLOSE}:\n{text}");
    let (Some(traced), [Some(still), Some(moved)]) = (traced, drawn) else { return Err(none()) };
    let ([meridians, rings], packet) = traced.setting;
    let (mesh, sight) = scene.mesh(meridians, rings);
    let embree = program.start(&mesh, &sight)?;
    let mut pair = Pair { scene: &scene, embree, packet };
    text += "\n| two threads, medians in turns | machine, ms | rms error | Embree, ms | rms error | times as fast |\n|---|---|---|---|---|---|\n";
    text += &pair.compare("one sun", &still.setting, |_| 0.0)?;
    // Time 0 has a sun that the ladders know.
    text += &pair.compare("a new sun each frame", &moved.setting, |turn| (turn + 1) as f64)?;
    Ok(text)
}

/// Every mesh by every packet: the fastest that is close enough.
fn climb_embree(
    program: &Program,
    scene: &PeerScene,
    right: &[f32],
    text: &mut String,
) -> Result<Option<Best<Traced>>, String> {
    let (mut best, sun) = (None, scene.sun(0.0));
    for [meridians, rings] in MESHES {
        let (mesh, sight) = scene.mesh(meridians, rings);
        let mut embree = program.start(&mesh, &sight)?;
        for packet in PACKETS {
            embree.trace(packet, sun)?;
            let times = (0..STEPS).map(|_| embree.trace(packet, sun)).collect::<Result<Vec<f64>, _>>()?;
            let (error, seconds) = (rms(&embree.picture()?, right), median(times));
            Best::offer(&mut best, ([meridians, rings], packet), error, seconds);
            let _ = writeln!(
                text,
                "| {meridians} x {rings} | {} | {packet} | {error:.5} | {:.2} | {:.2} |",
                mesh.faces.len(),
                seconds * 1e3,
                embree.built()
            );
        }
    }
    Ok(best)
}

/// Every setting of the machine: the fastest that is close enough, where boundaries are made before and under a new sun.
fn climb_machine(
    scene: &PeerScene,
    right: &[f32],
    text: &mut String,
) -> Result<[Option<Best<Setting>>; 2], String> {
    let (mut still, mut moved) = (None, None);
    let steps = SWEEPS.into_iter().flat_map(|sweeps| STEPPED.map(|stepped| (sweeps, stepped)));
    for (sweeps, (samples, instants)) in steps {
        for shadows in SHADOWS {
            let setting = Setting { raster: [sweeps, samples], instants, shadows };
            let mut machine = scene.machine(&setting);
            machine.draw(0.0)?;
            let times = (0..STEPS).map(|_| machine.draw(0.0)).collect::<Result<Vec<f64>, _>>()?;
            let (error, seconds) = (rms(&machine.picture()?, right), median(times));
            let suns = (1..=2).map(|sun| machine.draw(f64::from(sun)));
            let fresh = suns.collect::<Result<Vec<f64>, _>>()?.into_iter().fold(f64::INFINITY, f64::min);
            Best::offer(&mut still, setting, error, seconds);
            Best::offer(&mut moved, setting, error, fresh);
            let _ = writeln!(
                text,
                "| {} | {error:.5} | {:.2} | {:.1} |",
                setting.name(),
                seconds * 1e3,
                fresh * 1e3
            );
        }
    }
    Ok([still, moved])
}

/// Both sides, made ready.
struct Pair<'a> {
    scene: &'a PeerScene,
    embree: Embree,
    packet: u32,
}

impl Pair<'_> {
    /// A row of the comparison: frames in turns, each under the sun of `time` (s) of its turn.
    fn compare(&mut self, name: &str, setting: &Setting, time: fn(usize) -> f64) -> Result<String, String> {
        let mut machine = self.scene.machine(setting);
        machine.draw(0.0)?;
        self.embree.trace(self.packet, self.scene.sun(0.0))?;
        let (mut drawn, mut traced) = (Vec::new(), Vec::new());
        for turn in 0..TURNS {
            drawn.push(machine.draw(time(turn))?);
            traced.push(self.embree.trace(self.packet, self.scene.sun(time(turn)))?);
        }
        let [of_machine, of_embree] = self.errors(&machine, time(TURNS - 1))?;
        let (drawn, traced) = (median(drawn), median(traced));
        Ok(format!(
            "| {name}: machine at {} | {:.2} | {of_machine:.5} | {:.2} | {of_embree:.5} | {:.2} |\n",
            setting.name(),
            drawn * 1e3,
            traced * 1e3,
            traced / drawn
        ))
    }

    /// Errors of the last frame of both, which was drawn under the sun of `time` (s).
    fn errors(&mut self, machine: &Machine<'_>, time: f64) -> Result<[f64; 2], String> {
        let right = self.scene.exact(time)?;
        Ok([rms(&machine.picture()?, &right), rms(&self.embree.picture()?, &right)])
    }
}
