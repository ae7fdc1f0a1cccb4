//! What explanations and waveforms tell, and what is refused.

use faces::{Pattern, SeaState};
use generator::{Generator, PlaneKind, Planes};
use glam::DVec3;
use signal::Probe;
use smooth_faces::{Hardware, Parameters, SmoothFaces};

use crate::shots::{
    PIXELS, draw, from_above, gear, light, run, sea, sea_list, session, session_on, square, stage,
};

#[test]
fn a_pixel_tells_what_is_shown_and_what_is_behind_it() {
    let sea = sea(SeaState::Moderate, Pattern::Random { seed: 1 });
    let over = square("raft", DVec3::new(150.0, 100.0, 5.0), 20.0, 1, [1.0; 3]);
    let session = session(stage(vec![over, sea_list(&sea)]), run());
    let facts = session.explain(0, &from_above(), [30, 30]).unwrap();
    let [shown, behind] =
        ["shown", "behind it"].map(|what| &facts.iter().find(|fact| fact.what == what).expect(what).value);
    assert!(shown.contains("of raft (list 1 of 2)") && shown.contains("depth 115.000 m"), "{shown}");
    assert!(behind.contains("of sea (list 2 of 2)") && behind.contains("depth 120.000 m"), "{behind}");
    let sky = session.explain(0, &crate::shots::pose([150.0, 100.0, 5.5], 0.0, 60.0), [30, 30]).unwrap();
    assert_eq!(sky[0].what, "sky");
}

/// With 24 slots every pixel that differs tells a face without a slot, every face told is missing, and lines tell all misses.
#[test]
fn a_streak_leads_to_its_face_and_a_miss_to_its_streak() {
    let sea = sea(SeaState::High, Pattern::Random { seed: 1 });
    let eye = crate::shots::pose([10.0, 100.0, 30.0], 0.0, -20.0);
    let with = |edges_line| session_on(stage(vec![sea_list(&sea)]), run(), Hardware { edges_line, ..gear() });
    let (all, few) = (with(None), with(Some(24)));
    let ((whole, _), (streaked, counts)) = (draw(&*all, 0, &eye), draw(&*few, 0, &eye));
    let red = |planes: &Planes| planes.get(PlaneKind::Red).unwrap().to_vec();
    let (whole, streaked) = (red(&whole), red(&streaked));
    let (mut on_lines, mut streaks) = (0, 0);
    for column in 0..PIXELS {
        for line in 0..PIXELS {
            let facts = few.explain(0, &eye, [column, line]).unwrap();
            let of = |what: &str| facts.iter().filter(|fact| fact.what == what).collect::<Vec<_>>();
            let pixel = line * PIXELS + column;
            assert_eq!(of("missed").len(), usize::from(whole[pixel] != streaked[pixel]), "{column} {line}");
            if let [missed] = of("missed")[..] {
                let shown = &all.explain(0, &eye, [column, line]).unwrap()[0];
                assert_eq!((shown.what.as_str(), &shown.value), ("shown", &missed.value));
                streaks += 1;
            }
            if line == 0 {
                let told = &of("scan line")[0].value;
                on_lines += told.rsplit(", ").next().unwrap().replace(" missed", "").parse::<u64>().unwrap();
            }
        }
    }
    assert_eq!(on_lines, counts["missed"]);
    assert!(streaks > 100, "{streaks}");
}

#[test]
fn a_scan_line_is_the_column_of_the_picture() {
    let sea = sea(SeaState::Moderate, Pattern::Random { seed: 1 });
    let session = session(stage(vec![sea_list(&sea)]), run());
    let mut probe = Probe::new(vec!["faces.*".into()], 17..18);
    let mut planes = Planes::new(PIXELS, PIXELS, &[PlaneKind::Intensity]);
    session.frame(3, &from_above(), &mut planes, &mut probe).unwrap();
    let of = |name: &str| &probe.waveforms.iter().find(|wave| wave.signal.name == name).unwrap().values;
    let picture = light(&*session, 3, &from_above());
    let column: Vec<f64> = (0..PIXELS).map(|line| f64::from(picture[line * PIXELS + 17])).collect();
    let intensity = of("faces.intensity");
    assert!(intensity.iter().zip(&column).all(|(wave, pixel)| (wave - pixel).abs() < 1e-7));
    assert!(of("faces.present").iter().all(|present| *present == 1.0));
    // Brightness climbs by the ramp from sample to sample of one face.
    let (ramp, edges) = (of("faces.ramp"), of("faces.edges"));
    let inside = (1..PIXELS).filter(|at| edges[*at] == edges[at - 1] && ramp[*at] == ramp[at - 1]);
    let climbs = inside.map(|at| (intensity[at] - intensity[at - 1] - ramp[at]).abs());
    let (most, count) = climbs.fold((0.0_f64, 0), |(most, count), climb| (most.max(climb), count + 1));
    assert!(most < 1e-9 && count > 20, "{most} {count}");
}

/// With 24 slots the count of crossings ends at what the line has started, and never falls.
#[test]
fn crossings_are_counted_along_the_line() {
    let sea = sea(SeaState::High, Pattern::Random { seed: 1 });
    let eye = crate::shots::pose([10.0, 100.0, 30.0], 0.0, -20.0);
    let counted = |edges_line| {
        let hardware = Hardware { edges_line, ..gear() };
        let session = session_on(stage(vec![sea_list(&sea)]), run(), hardware);
        let mut probe = Probe::new(vec!["faces.edges".into()], 0..PIXELS as u32);
        let mut planes = Planes::new(PIXELS, PIXELS, &[PlaneKind::Intensity]);
        session.frame(0, &eye, &mut planes, &mut probe).unwrap();
        assert!(probe.waveforms.iter().all(|wave| wave.values.is_sorted()));
        probe.waveforms.iter().map(|wave| *wave.values.last().unwrap()).collect::<Vec<_>>()
    };
    let clocked = |edges_line| {
        let hardware = Hardware { edges_line, ..gear() };
        let clocked = smooth_faces::Clocked::new(stage(vec![sea_list(&sea)]), run(), hardware).unwrap();
        let tasks = generator::Timed::frame(&clocked, 0, &eye).unwrap().tasks;
        tasks.iter().find(|task| task.task == "ramps").unwrap().pieces as f64
    };
    for slots in [None, Some(24)] {
        let ends = counted(slots);
        assert_eq!(ends.iter().sum::<f64>(), clocked(slots));
        assert!(slots.is_none_or(|slots| ends.iter().all(|end| *end <= f64::from(slots))), "{ends:?}");
    }
}

#[test]
fn too_many_faces_are_refused_with_both_numbers() {
    let sea = sea(SeaState::Moderate, Pattern::Random { seed: 1 });
    let parameters = Parameters { limit: 100, ..run() };
    let Err(refused) = (SmoothFaces { parameters, hardware: gear() }).prepare(stage(vec![sea_list(&sea)]))
    else {
        panic!("it was made ready")
    };
    let text = refused.to_string();
    assert!(text.contains("600 faces of list sea") && text.contains("at most 100"), "{text}");
}
