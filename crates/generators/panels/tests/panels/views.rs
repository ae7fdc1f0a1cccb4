//! Views from anywhere: no holes, nothing mirrored, any number of threads.

use generator::{Label, PlaneKind};
use panels::{Fineness, Parameters};
use quantities::unit_interval;

use crate::shots::{SIDE, draw, landscape, light, photograph, pose, run, session, sky, stage, waves};

#[test]
fn ground_has_no_holes() {
    let session = session(stage(landscape(6.0), vec![photograph(800, 600.0, waves)], 48, 0.4), run());
    for seed in 0..1000 {
        let random = |word: u64| unit_interval(seed, &[word]);
        // So high and so steep that the picture lies on the ground.
        let eye = [0.35 + 0.3 * random(1), 0.35 + 0.3 * random(2)].map(|share| SIDE * share);
        let pose =
            pose([eye[0], eye[1], 40.0 + 40.0 * random(3)], 360.0 * random(4), -90.0 + 30.0 * random(5));
        assert_eq!(sky(&draw(&*session, 48, &pose)), 0, "seed {seed}: {pose:?}");
    }
}

#[test]
fn nothing_is_mirrored_from_behind_the_eye() {
    let session = session(stage(landscape(0.0), vec![photograph(800, 600.0, waves)], 64, 0.5), run());
    for heading in [0.0, 37.0, 90.0, 200.0] {
        let planes = draw(&*session, 64, &pose([200.0, 200.0, 2.0], heading, 0.0));
        let labels = planes.get(PlaneKind::Label).unwrap();
        let terrain = f32::from(Label::Terrain.code());
        let rows = |rows: std::ops::Range<usize>| rows.flat_map(|row| &labels[64 * row..64 * (row + 1)]);
        assert!(rows(0..32).all(|label| *label != terrain), "ground above the horizon, heading {heading}");
        assert!(rows(34..64).all(|label| *label == terrain), "sky on the ground, heading {heading}");
    }
}

#[test]
fn threads_change_no_bit() {
    let pose = pose([60.0, 80.0, 60.0], 40.0, -20.0);
    let with = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| {
            let stage = stage(landscape(8.0), vec![photograph(800, 600.0, waves)], 64, 0.5);
            light(&draw(&*session(stage, run()), 64, &pose)).to_vec()
        })
    };
    let one = with(1);
    assert!(one.iter().any(|light| *light > 0.0) && with(3) == one);
}

#[test]
fn planes_of_a_slope_are_those_of_any_subdivision() {
    let distance = |cells| {
        let run = Parameters { fineness: Fineness::Cells(cells), spacing: Some(20.0), ..run() };
        let stage = stage(landscape(0.0), vec![photograph(800, 600.0, waves)], 32, 0.5);
        let planes = draw(&*session(stage, run), 32, &pose([100.0, 200.0, 30.0], 10.0, -30.0));
        planes.get(PlaneKind::Distance).unwrap().to_vec()
    };
    let one = distance(1);
    for cells in [4, 14] {
        let apart = distance(cells).iter().zip(&one).map(|(a, b)| ((a - b) / b).abs()).fold(0.0, f32::max);
        assert!(apart < 1e-6, "{cells}: {apart}");
    }
}
