//! A mission in which all moves: every frame from its number alone, in any order, by any number of threads.

use std::path::{Path, PathBuf};

use control_plane::MachineStage;
use generator::{FrameCounts, PlaneKind, Planes, Session};
use hardware_model::{HardwareModel, ModelSource};
use machine::Prepare;
use scenario::{Pose, PoseTable, Scenario};
use signal::Probe;

/// Frames of the mission.
const FRAMES: u64 = 12;

const MISSION: &str = r#"
format = 1
title = "All moves"
shows = "A test: sun, objects, tracks and the yoke change from frame to frame."
frames = 12

[landscape.generated]
seed = 3
extent_m = [400, 400]
region_size_m = 40
[landscape.generated.undulation]
rms_height_m = 2
hurst = 0.9
longest_m = 300
shortest_m = 130
waves = 30

[[features.population]]
seed = 1
kind = "fresh"
density_per_m2 = 0.02
smallest_radius_m = 1.5
largest_radius_m = 12
area_m = [60, 100, 200, 300]

[texture]
source = "random"
layer = [{ cell_m = 1.0, amplitude = 0.1, range_m = 40 }]

[sun]
azimuth_deg = 70
elevation_deg = 8
step_s = 0.25
drift = [{ t_s = 1.2, azimuth_deg = 95, elevation_deg = 5 }]

[shadows]

[rocks]
seed = 3
density_per_m2 = 0.01
smallest_m = 0.3
largest_m = 2
area_m = [80, 120, 160, 280]

[[object]]
id = "lm"
model = "lander"
x_m = 120
y_m = 196

[[object]]
id = "flag"
model = "flag"
x_m = 112
y_m = 203
present = false

[[event]]
t_s = 0.3
action = "add"
object = "flag"

[[event]]
t_s = 0.5
action = "move"
object = "lm"
x_m = 124
y_m = 207
heading_deg = 40

[[event]]
t_s = 0.9
action = "delete"
object = "lm"

[tracks]

[path]
keyframes = [
  { t_s = 0, x_m = 100, y_m = 200, heading_deg = 0 },
  { t_s = 1.2, x_m = 94, y_m = 201, heading_deg = 6 },
]

[roll]
display = "yoke"

[raster]
sweeps = 40
samples_per_sweep = 200
update_hz = 10
refresh_hz = 30

[range]
programme = "geometric"
start_m = 2
end_m = 150
"#;

/// Picture (bits) and work of a frame.
type Frame = (Vec<u32>, FrameCounts);

struct Mission {
    stage: MachineStage,
    poses: Vec<Pose>,
}

impl Mission {
    fn new() -> Self {
        Self::by("ideal")
    }

    /// The mission with the parts of a model; the raster is the mission's.
    fn by(machine: &str) -> Self {
        Self::under(machine, &[], MISSION)
    }

    fn under(machine: &str, overlays: &[PathBuf], mission: &str) -> Self {
        Self::of(machine, overlays, mission, FRAMES)
    }

    fn of(machine: &str, overlays: &[PathBuf], mission: &str, frames: u64) -> Self {
        let source = ModelSource::find(machine, Path::new("")).unwrap_or_else(|error| panic!("{error}"));
        let model =
            HardwareModel::load(&source, overlays, &[]).unwrap_or_else(|faults| panic!("{faults}")).model;
        let scenario = Scenario::parse("mission.toml", mission).unwrap_or_else(|faults| panic!("{faults}"));
        let settings = front_door::settings(&scenario, &model).unwrap();
        let stage = front_door::build(&scenario, settings).unwrap_or_else(|error| panic!("{error}"));
        let (update, yoke) = (stage.settings.timebase.update, stage.settings.yoke);
        let table = PoseTable::resolve(&scenario, &stage.landscape, update, yoke, 0..frames);
        let poses =
            table.unwrap_or_else(|error| panic!("{error}")).rows().iter().map(|row| row.pose).collect();
        Self { stage, poses }
    }

    fn session(&self) -> Box<dyn Session> {
        self.stage.clone().prepare()
    }

    fn draw(&self, session: &dyn Session, frame: u64) -> Frame {
        let raster = self.stage.settings.raster;
        let mut planes = Planes::new(raster.columns as usize, raster.lines as usize, &[PlaneKind::Intensity]);
        let pose = &self.poses[frame as usize];
        let counts = session.frame(frame, pose, &mut planes, &mut Probe::off()).unwrap();
        (crate::landscape::set::bits(planes.get(PlaneKind::Intensity).unwrap()), counts)
    }

    fn all(&self, order: impl Iterator<Item = u64>) -> Vec<Frame> {
        let session = self.session();
        let mut frames: Vec<_> = order.map(|frame| (frame, self.draw(&*session, frame))).collect();
        frames.sort_by_key(|(frame, _)| *frame);
        frames.into_iter().map(|(_, drawn)| drawn).collect()
    }
}

fn on<T: Send>(threads: usize, work: impl FnOnce() -> T + Send) -> T {
    rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap().install(work)
}

#[test]
fn every_frame_from_its_number_alone() {
    let mission = Mission::new();
    let forwards = mission.all(0..FRAMES);
    // 5 and 12 have no common factor: each frame once, and suns come back after three others.
    let shuffled = mission.all((0..FRAMES).map(|index| (5 * index + 3) % FRAMES));
    let backwards = mission.all((0..FRAMES).rev());
    assert!(forwards == backwards, "backwards");
    assert!(forwards == shuffled, "in another order");
    for frame in 0..FRAMES {
        let alone = mission.draw(&*mission.session(), frame);
        assert!(alone == forwards[frame as usize], "frame {frame} alone: {:?}", alone.1);
    }
}

#[test]
fn by_any_number_of_threads() {
    let mission = Mission::new();
    let one = on(1, || mission.all(0..FRAMES));
    for threads in [2, 3] {
        assert!(on(threads, || mission.all(0..FRAMES)) == one, "{threads} threads");
    }
}

/// Noise, spread, drums, queues, the processor and what the tubes have left: each by its address or by the frames
/// before, never by what happened to be drawn before.
#[test]
fn machines_of_1970_too() {
    for machine in ["pra-nominal", "pra-frugal", "pra-overloaded"] {
        let mission = Mission::by(machine);
        let one = on(1, || mission.all(0..FRAMES));
        let shuffled = on(2, || mission.all((0..FRAMES).map(|index| (5 * index + 3) % FRAMES)));
        assert!(one == shuffled, "{machine}: in another order, by two threads");
        let last = mission.draw(&*mission.session(), FRAMES - 1);
        assert!(last == one[FRAMES as usize - 1], "{machine}: the last frame alone");
        let ideal = Mission::new();
        let same = ideal.draw(&*ideal.session(), FRAMES - 1).0 == last.0;
        assert!(!same, "{machine} is as good as ideal");
    }
}

/// Artefact 20: each earlier picture is there with its share, 0.4 of the one before it, whatever was drawn before.
#[test]
fn a_sticky_tube_adds_up_the_frames_before() {
    // A turned picture is kept between its neighbours, which is not linear.
    let upright = MISSION.replace("[roll]\ndisplay = \"yoke\"\n", "");
    let light = |frame: &Frame| -> Vec<f32> { frame.0.iter().map(|&bits| f32::from_bits(bits)).collect() };
    let clean = Mission::under("ideal", &[], &upright).all(0..FRAMES);
    let sticky = Mission::under("ideal", &["ghost".into()], &upright);
    for frame in [0, 1, 11] {
        let found = light(&sticky.draw(&*sticky.session(), frame));
        let mut expected = vec![0.0_f64; found.len()];
        for back in 0..=frame.min(7) {
            let share = (0..back).fold(1.0, |share, _| 0.4 * share);
            let earlier = light(&clean[(frame - back) as usize]);
            expected.iter_mut().zip(earlier).for_each(|(sum, value)| *sum += share * f64::from(value));
        }
        let worst = found.iter().zip(&expected).map(|(a, b)| (f64::from(*a) - b).abs()).fold(0.0, f64::max);
        assert!(worst < 1e-5, "frame {frame}: {worst}");
    }
}

/// What lasts from frame to frame lasts to frame 500: residue in the tubes, the angle of the drums, their queues and the
/// storage buffer, the yoke. A frame alone is the same as within a sequence, and as the last of one.
#[test]
fn frame_500_alone() {
    let slow = MISSION
        .replace("frames = 12", "frames = 502")
        .replace("sweeps = 40", "sweeps = 12")
        .replace("samples_per_sweep = 200", "samples_per_sweep = 60")
        .replace("t_s = 1.2, x_m = 94", "t_s = 51, x_m = 94")
        .replace("t_s = 1.2, azimuth_deg", "t_s = 51, azimuth_deg")
        .replace("step_s = 0.25", "step_s = 10");
    // Drums that are too slow for the turn, and tubes that keep two fifths of a picture.
    let faults = ["starve", "ghost"].map(PathBuf::from);
    let mission = Mission::of("pra-nominal", &faults, &slow, 502);
    let sequence = mission.session();
    let drawn: Vec<Frame> = (490..502).map(|frame| mission.draw(&*sequence, frame)).collect();
    let alone = |frame: u64| mission.draw(&*mission.session(), frame);
    assert!(alone(500) == drawn[10], "frame 500 alone");
    let later = mission.session();
    let [second, first] = [501, 500].map(|frame| mission.draw(&*later, frame));
    assert!(second == drawn[11] && first == drawn[10], "frame 501, then frame 500");
    // The tubes do show the frames before: without them the picture is another.
    let clean = Mission::of("pra-nominal", &faults[..1], &slow, 502);
    let without = clean.draw(&*clean.session(), 500);
    assert!(without.0 != drawn[10].0, "nothing is left of earlier frames");
}

/// The mission does what its file says: otherwise the tests above would hold for a still.
#[test]
fn all_moves() {
    let mission = Mission::new();
    let scenery = &mission.stage.scenery;
    let suns: Vec<_> = scenery.suns().iter().map(|(_, sun)| sun.azimuth.to_bits()).collect();
    assert!(suns.len() >= 5 && suns.windows(2).all(|pair| pair[0] != pair[1]), "{suns:?}");
    let at = |frame: usize| mission.poses[frame].time;
    let standing = |frame: usize| scenery.bodies(at(frame)).count();
    let rocks = standing(11) - scenery_parts(&mission, "flag");
    assert!(rocks > 10, "{rocks}");
    let lander = standing(0) - rocks;
    assert!(lander > 0 && standing(3) == rocks + lander + scenery_parts(&mission, "flag"));
    assert!(scenery.patches(at(0)).len() < scenery.patches(at(11)).len());
    assert!(mission.poses.iter().any(|pose| pose.yoke != 0.0));
    let frames = mission.all(0..FRAMES);
    assert!(frames.windows(2).all(|pair| pair[0].0 != pair[1].0), "two frames look the same");
    let counts = &frames[0].1;
    assert!(counts["features"] > 0 && counts["shadow_toggles"] > 0 && counts["bodies"] > 0, "{counts:?}");
}

/// Parts of the flag: bodies that begin to stand at 0.3 s.
fn scenery_parts(mission: &Mission, object: &str) -> usize {
    assert_eq!(object, "flag");
    mission.stage.scenery.standing().iter().filter(|standing| standing.from == 0.3).count()
}
