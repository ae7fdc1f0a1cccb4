//! The same bits by any number of threads, probed or not, in any order of frames (trust 3.11), over the full landscape and
//! with real parts.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use control_plane::MachineStage;
use generator::{PlaneKind, Planes, Session};
use hardware_model::{HardwareModel, ModelSource, Settings, WireParts};
use lunoid_tests::shipped::folder;
use lunoid_tests::{ComparedScene, random};
use machine::Prepare;
use quantities::radians;
use rayon::ThreadPoolBuilder;
use scenario::{Pose, Scalar};
use signal::Probe;

const FRAMES: u64 = 3;

fn pose(scene: &ComparedScene, frame: u64) -> Pose {
    let mut pose = scene.pose();
    pose.time = frame as f64 / 30.0;
    pose.attitude.heading += radians(3.0) * frame as f64;
    pose
}

/// Bits of a frame: counters and picture.
fn frame(session: &dyn Session, scene: &ComparedScene, number: u64, probed: bool) -> String {
    let pose = pose(scene, number);
    let mut planes = Planes::new(scene.sweeps as usize, scene.lines as usize, &[PlaneKind::Intensity]);
    let mut probe = if probed { Probe::new(vec!["*".into()], 3..17) } else { Probe::off() };
    let counts = session.frame(number, &pose, &mut planes, &mut probe).unwrap();
    assert_eq!(probed, !probe.waveforms.is_empty());
    let picture = planes.get(PlaneKind::Intensity).unwrap();
    let bits: Vec<u32> = picture.iter().map(|value| value.to_bits()).collect();
    // A frame has one showing here, which is what is kept of it.
    session.repeat(number, &pose, 0, &mut planes).unwrap();
    let again = planes.get(PlaneKind::Intensity).unwrap();
    assert!(again.iter().map(|value| value.to_bits()).eq(bits.iter().copied()));
    format!("{counts:?} {bits:?}")
}

/// What came out of drawing the frames of a stage, and by which ways.
fn all_ways(scene: &ComparedScene, stage: &MachineStage) -> BTreeMap<Vec<String>, Vec<String>> {
    let mut found: BTreeMap<Vec<String>, Vec<String>> = BTreeMap::new();
    let mut note = |way: String, frames: Vec<String>| found.entry(frames).or_default().push(way);
    for threads in [1, 2, 3, 8] {
        let pool = ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| {
            let session = stage.clone().prepare();
            for probed in [false, true] {
                let forward: Vec<_> = (0..FRAMES).map(|k| frame(&*session, scene, k, probed)).collect();
                let mut backward: Vec<_> =
                    (0..FRAMES).rev().map(|k| frame(&*session, scene, k, probed)).collect();
                backward.reverse();
                note(format!("{threads} threads, probed {probed}, forward"), forward);
                note(format!("{threads} threads, probed {probed}, backward"), backward);
            }
            let alone = |k: u64| frame(&*stage.clone().prepare(), scene, k, false);
            note(format!("{threads} threads, alone"), (0..FRAMES).map(alone).collect());
        });
    }
    found
}

#[test]
fn one_outcome_of_every_way() {
    let nominal = ModelSource::find("pra-nominal", &folder()).unwrap();
    let nominal = HardwareModel::load(&nominal, &[], &[]).unwrap().model;
    for (seed, scalar) in [(6000, Scalar::F32), (6001, Scalar::F64), (6002, Scalar::F32), (6003, Scalar::F32)]
    {
        let mut scene = ComparedScene { scalar, ..random::landscape(seed) };
        scene.sweeps = 29;
        scene.samples = scene.samples.min(200);
        let ideal = scene.stage();
        // What tubes still show depends on the frames before, which the scenery tells.
        let course: Vec<_> = (0..FRAMES).map(|frame| pose(&scene, frame)).collect();
        let scenery = Arc::new((*ideal.scenery).clone().with_course(course));
        let ideal = MachineStage { scenery, ..ideal };
        let settings = Settings { analog: nominal.analog.clone(), ..ideal.settings.clone() };
        let mut slow = ideal.clone();
        slow.settings.analog.wires = WireParts { bandwidth: Some(2e4), slew: Some(2e4), ..WireParts::IDEAL };
        let mut nominal = MachineStage { settings, ..ideal.clone() };
        // Slow enough for every frame to show those before.
        nominal.settings.analog.picture_tube.phosphor = 0.1;
        for (what, stage) in [("ideal", ideal), ("slow wires", slow), ("parts of pra-nominal", nominal)] {
            let outcomes = all_ways(&scene, &stage);
            let ways: Vec<_> = outcomes.values().collect();
            assert_eq!(ways.len(), 1, "seed {seed}, {scalar:?}, {what}: {ways:#?}");
            println!(
                "{what}, {scalar:?}, seed {seed}: {} ways of drawing {FRAMES} frames, one outcome",
                ways[0].len()
            );
            let frames: BTreeSet<_> = outcomes.keys().flatten().collect();
            assert_eq!(frames.len(), FRAMES as usize, "seed {seed}, {what}: frames are alike");
        }
    }
}
