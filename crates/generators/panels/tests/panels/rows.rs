//! Probes of a row, and what explains a pixel: against the planes of the same frame.

use generator::{PlaneKind, Planes, Session};
use panels::ROW;
use scenario::Pose;
use signal::Probe;

use crate::moffett::{configured, frame_stage, poses, scenario};
use crate::shots::{landscape, panels, photograph, pose, run, stage, waves};

/// Planes of a frame, and the waveforms of a row by the order of their signals.
fn looked(session: &dyn Session, size: usize, pose: &Pose, line: u32) -> (Planes, Vec<(String, Vec<f64>)>) {
    let kinds = [PlaneKind::Intensity, PlaneKind::Label, PlaneKind::Distance];
    let mut planes = Planes::new(size, size, &kinds);
    let mut probe = Probe::new(vec!["*".into()], line..line + 1);
    session.frame(0, pose, &mut planes, &mut probe).unwrap();
    assert!(probe.waveforms.iter().all(|wave| wave.sweep == line && wave.values.len() == size));
    let named = probe.waveforms.into_iter().map(|wave| (wave.signal.name.to_owned(), wave.values));
    (planes, named.collect())
}

fn wave<'w>(waves: &'w [(String, Vec<f64>)], name: &str) -> &'w [f64] {
    let found = waves.iter().find(|(known, _)| known == name);
    &found.unwrap_or_else(|| panic!("{name} was not recorded")).1
}

/// Values of a plane in a row.
fn row(planes: &Planes, kind: PlaneKind, line: u32) -> &[f32] {
    let (plane, columns) = (planes.get(kind).unwrap(), planes.columns());
    &plane[line as usize * columns..][..columns]
}

#[test]
fn a_row_of_the_program_is_that_of_its_planes() {
    let session = configured(&scenario("moffett")).unwrap().prepare(frame_stage("frame")).unwrap();
    let (pose, line) = (poses("moffett")[1], 110);
    let (planes, waves) = looked(&*session, 512, &pose, line);
    assert_eq!(
        waves.iter().map(|(name, _)| name.as_str()).collect::<Vec<_>>(),
        ROW.signals.iter().map(|signal| signal.name).collect::<Vec<_>>()
    );
    let all = ["panel", "depth", "grey", "source_i", "source_j", "writes"];
    let [panel, depth, grey, i, j, writes] = all.map(|name| wave(&waves, &format!("panels.{name}")));
    let (light, distance) =
        (row(&planes, PlaneKind::Intensity, line), row(&planes, PlaneKind::Distance, line));
    let mut several = 0;
    for column in 0..512 {
        if distance[column].is_infinite() {
            assert_eq!([panel[column], depth[column], i[column], writes[column]], [-1.0, 0.0, -1.0, 0.0]);
            continue;
        }
        assert_eq!([depth[column] as f32, grey[column] as f32], [distance[column], light[column]]);
        assert!((0.0..176.0).contains(&panel[column]) && writes[column] >= 1.0);
        assert!([i, j].iter().all(|at| (0.0..512.0).contains(&at[column])));
        several += usize::from(writes[column] > 1.0);
    }
    assert!(several > 3, "{several}");
    let seen = panel.iter().position(|panel| *panel >= 0.0).unwrap();
    let told = session.explain(0, &pose, [seen, line as usize]).unwrap();
    assert!(told[0].value.starts_with(&format!("{};", panel[seen])), "{told:?}");
}

#[test]
fn a_row_of_the_scene_sampler_tells_where_its_light_comes_from() {
    // The photograph looks straight down from 600 m: a place x, y has pixel I, J of 0.6 m, J downward from the north.
    let make = || stage(landscape(3.0), vec![photograph(800, 600.0, waves)], 96, 0.4);
    let session = generator::Generator::prepare(&panels(run()), make()).unwrap();
    let (pose, line) = (pose([60.0, 80.0, 30.0], 40.0, -20.0), 60);
    let (planes, waves) = looked(&*session, 96, &pose, line);
    assert!(waves.iter().all(|(name, _)| name != "panels.writes" && name != "panels.void"));
    let [panel, depth, grey, i, j] = ["panel", "depth", "grey", "source_i", "source_j"]
        .map(|name| wave(&waves, &format!("panels.{name}")));
    let (light, distance) =
        (row(&planes, PlaneKind::Intensity, line), row(&planes, PlaneKind::Distance, line));
    let mut seen = 0;
    for column in 0..96 {
        if panel[column] < 0.0 {
            continue;
        }
        assert!((depth[column] / f64::from(distance[column]) - 1.0).abs() < 1e-6, "{column}");
        assert!(
            (grey[column] - f64::from(light[column])).abs() < 0.02,
            "{column}: {} {}",
            grey[column],
            light[column]
        );
        // The light there is that of the waves at the photograph's pixel.
        assert!((grey[column] - waves_at(i[column], j[column])).abs() < 0.02, "{column}");
        seen += 1;
    }
    assert!(seen > 50, "{seen}");
}

fn waves_at(i: f64, j: f64) -> f64 {
    waves(i / 800.0, j / 800.0)
}

#[test]
fn a_pixel_of_the_program_names_what_lost_to_it() {
    let session = configured(&scenario("moffett")).unwrap().prepare(frame_stage("frame")).unwrap();
    let pose = poses("moffett")[1];
    let (_, waves) = looked(&*session, 512, &pose, 110);
    let writes = wave(&waves, "panels.writes");
    let column = writes.iter().position(|writes| *writes == 2.0).unwrap();
    let facts = session.explain(0, &pose, [column, 110]).unwrap();
    let told = |what: &str| -> Vec<&str> {
        facts.iter().filter(|fact| fact.what == what).map(|fact| fact.value.as_str()).collect()
    };
    assert_eq!(told("written"), ["2 times"]);
    assert!(told("lost").iter().any(|lost| lost.contains("written before, and covered")), "{facts:?}");
    assert!(told("photograph")[0].contains("pixel I"));
    let sky = session.explain(0, &pose, [5, 500]).unwrap();
    assert_eq!((sky.len(), sky[0].value.as_str()), (1, "none"));
}
