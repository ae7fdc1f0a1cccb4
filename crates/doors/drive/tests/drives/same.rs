//! Frame, truth, signals and explanations are those of the crates that the command calls.

use std::fs;

use drive::{Codes, Drive};
use exact::Columns;
use explain::{Inquiry, facts};
use files::{Npy, write_npz};
use machine::{ControlPlane, Prepare};
use scope::{Look, Looking};

use crate::scene::{FREE, Scene};

/// One hardware model with memory, one without, and generators beside the hybrid machine.
const MACHINES: [&str; 5] = ["ideal", "pra-overloaded", "exact", "lunsim", "sampled"];

#[test]
fn frames_have_the_pixels_of_a_run() {
    for machine in MACHINES {
        let scene = Scene::new("", &FREE).by(machine);
        let (hashes, _) = scene.run(&scene.path(), None);
        let drive = scene.drive();
        assert_eq!(drive.frames() as usize, hashes.len());
        // Any order.
        for frame in [2, 0, 3, 1] {
            assert_eq!(
                drive.frame(frame).unwrap().hash(),
                hashes[frame as usize],
                "{machine}, frame {frame}"
            );
        }
    }
}

#[test]
fn results_do_not_depend_on_threads() {
    let scene = Scene::new("", &[]).by("pra-nominal");
    let hash = |threads| scene.drive_with(threads).frame(3).unwrap().hash();
    assert_eq!(hash(1), hash(5));
}

#[test]
fn truth_has_the_arrays_of_a_run() {
    const NAMES: &str = "range,height,normal,reflectivity,shadow,label,distance";
    let scene = Scene::new("", &[]);
    let (_, run) = scene.run(&scene.path(), Some(NAMES));
    let truth = scene.drive().truth(2, "all").unwrap();
    let names: Vec<&str> = truth.planes.iter().map(|plane| plane.name).collect();
    assert_eq!(names.join(","), NAMES);
    let arrays: Vec<(&str, Npy)> = truth
        .planes
        .iter()
        .map(|plane| {
            let array = match &plane.values {
                Codes::Numbers(numbers) => Npy::new(plane.shape.clone(), numbers.clone()),
                Codes::Codes(codes) => Npy::new(plane.shape.clone(), codes.clone()),
            };
            (plane.name, array.unwrap())
        })
        .collect();
    let own = scene.folder.path().join("own.npz");
    write_npz(&own, arrays.iter().map(|(name, array)| (*name, array))).unwrap();
    assert_eq!(fs::read(own).unwrap(), fs::read(run.join("truth/frame-000002.npz")).unwrap());
    assert_eq!((truth.planes[0].bound, truth.planes[5].bound), (6e-8, 0.0));
    assert_eq!(truth.planes[5].codes[..3], ["sky", "terrain", "feature"]);
}

#[test]
fn signals_are_those_of_the_session() {
    let scene = Scene::new("", &[]).by("pra-nominal");
    let patterns: Vec<String> = ["mu.height", "dpp.*", "tg.*.hold"].map(str::to_owned).into();
    let traces = scene.drive().probe(&patterns, 1, 17..19).unwrap();
    let opened = front_door::open(&scene.path(), &scene.wishes).unwrap_or_else(|error| panic!("{error}"));
    let stage = opened.stage().unwrap_or_else(|error| panic!("{error}"));
    let pose = opened.poses(&stage, 1..2).unwrap().rows()[0].pose;
    let pool = rayon::ThreadPoolBuilder::new().num_threads(2).build().unwrap();
    let session = opened.generator.prepare(stage).unwrap();
    let look = Look { session: &*session, pool: &pool, frame: 1, pose: &pose, raster: [40, 40] };
    let waveforms = look.at(patterns, 17..19).unwrap();
    let mut compared = 0;
    for trace in &traces.signals {
        let own = waveforms.iter().filter(|wave| wave.signal.name == trace.signal.name);
        let values: Vec<f64> = own.clone().flat_map(|wave| wave.values.clone()).collect();
        let times: Vec<f64> = own.flat_map(|wave| wave.times.clone()).collect();
        if !traces.left_out.contains(&trace.signal.name) {
            assert_eq!((&trace.values, &trace.times), (&values, &times), "{}", trace.signal.name);
            compared += values.len();
        }
    }
    assert!(compared > 900, "{compared}");
    assert_eq!((traces.place, traces.places.len()), ("sweep.range", 160));
    assert!(traces.places[..80].is_sorted() && traces.places[0] >= 2.0);
}

/// A star takes what is there; a name takes the signal, which is then 0 throughout.
#[test]
fn a_wire_that_is_not_there_is_zero() {
    let traces = Scene::new("", &[]).drive().probe(&["txg.texture".to_owned()], 0, 3..4).unwrap();
    assert_eq!(traces.left_out, ["txg.texture"]);
    assert!(traces.signals[0].values.iter().all(|value| *value == 0.0));
    assert_eq!(traces.signals[0].values.len(), 80);
}

#[test]
fn explanations_are_those_of_the_inquiry() {
    let scene = Scene::new("", &[("loader.access_ns", "90000")]).by("pra-nominal");
    let drive = scene.drive();
    let opened = front_door::open(&scene.path(), &scene.wishes).unwrap_or_else(|error| panic!("{error}"));
    let machine = opened.machine_stage().unwrap_or_else(|error| panic!("{error}"));
    let session = machine.clone().prepare();
    let (control, exact) = (ControlPlane::new(machine.clone()), Columns::new(machine.stage()));
    let inquiry = Inquiry::new(&machine, session.as_ref(), &control, Some(&exact));
    let pose = opened.poses(&machine.stage(), 2..3).unwrap().rows()[0].pose;
    let mut late = 0;
    for pixel in [[3, 22], [20, 20], [20, 15], [39, 18], [20, 2]] {
        let told = inquiry.explain(2, &pose, pixel).unwrap();
        let own = drive.explain(2, pixel).unwrap();
        assert_eq!((own.text, own.because), (told.text(), told.because.clone()), "{pixel:?}");
        assert_eq!(own.document, serde_json::to_value(&told).unwrap());
        let is_late = told.late.iter().any(|late| late.in_force);
        assert_eq!(own.cause.starts_with("late word: tg."), is_late, "{}", own.cause);
        late += u32::from(is_late);
    }
    assert!(late > 0);
    guest_explanations();
}

fn guest_explanations() {
    let scene = Scene::new("", &[]).by("sampled");
    let opened = front_door::open(&scene.path(), &scene.wishes).unwrap_or_else(|error| panic!("{error}"));
    let stage = opened.stage().unwrap_or_else(|error| panic!("{error}"));
    let pose = opened.poses(&stage, 1..2).unwrap().rows()[0].pose;
    let session = opened.generator.prepare(stage.clone()).unwrap();
    let told = facts(&*opened.generator, &*session, &stage.view, (1, &pose), [20, 18]).unwrap();
    let own: std::sync::Arc<Drive> = scene.drive();
    let own = own.explain(1, [20, 18]).unwrap();
    assert_eq!(own.document["facts"], serde_json::to_value(&told).unwrap());
    assert_eq!(own.because.len(), told.len());
}
