//! Some of everything in one picture.

use super::*;

/// Some of every kind of effect together.
fn fair() -> Effects {
    let warm = |light: LightPoint| LightPoint { colour: [1.0, 0.8, 0.5], ..light };
    let beam = |light: LightPoint| LightPoint { calligraphic: true, ..light };
    let stars = (0..40).map(|k| {
        let [a, b] = [f64::from(k * 7 % 40), f64::from(k * 11 % 40)].map(|at| at / 40.0 - 0.5);
        LightPoint { id: 10 + k, ..star(DVec3::new(1.0, a, 0.25 + b / 3.0), 0.1 * f64::from(k)) }
    });
    let lamps = [
        lamp([58.0, 102.0, 2.2]),
        warm(lamp([75.0, 97.0, 1.6])),
        beam(lamp([80.0, 104.0, 2.4])),
        beam(warm(lamp([66.0, 96.0, 0.5]))),
    ];
    Effects {
        lights: lamps.into_iter().chain(stars).collect(),
        sheets: vec![curtain(0.4), Sheet { colour: [0.6, 0.4, 0.2], id: 1, ..leaning() }],
        overlays: vec![Overlay {
            id: 0,
            corners: vec![[-1.0, 0.9], [1.0, 0.8], [1.0, 1.0], [-1.0, 1.0]],
            colour: [0.1; 3],
            share: 0.2,
            priority: 0,
        }],
        discs: vec![ball(DVec3::new(1.0, -0.3, 0.2).normalize(), 1.0)],
    }
}

/// A sheet of dust that goes through the curtain.
fn leaning() -> Sheet {
    let corners = [[60.0, 94.0, 0.2], [82.0, 98.0, 0.2], [82.0, 98.0, 4.0], [60.0, 94.0, 4.0]];
    let medium = Medium::Dust { kappa: 0.3, thickness: 1.0 };
    Sheet { corners: corners.map(DVec3::from_array).to_vec(), medium, ..curtain(0.0) }
}

fn session(effects: Effects) -> (Box<dyn Session>, Stage) {
    let stage = Stage { landscape: ground(), scenery: Arc::new(scenery(effects)), view: usual().view() };
    (Exact.prepare(stage.clone()).unwrap(), stage)
}

#[test]
fn any_number_of_threads_gives_the_same_bits_and_so_does_a_column_alone() {
    let (session, stage) = session(fair());
    let pose = Pose { yoke: 0.1, ..pose(EYE, 2.0, 0.0) };
    let picture = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        let mut planes = Planes::new(60, 40, &PlaneKind::ALL);
        pool.install(|| session.frame(0, &pose, &mut planes, &mut Probe::off()).unwrap());
        planes
    };
    let one = picture(1);
    let bits = |planes: &Planes| -> Vec<u32> {
        PlaneKind::ALL
            .iter()
            .flat_map(|&kind| planes.get(kind).unwrap())
            .map(|value| value.to_bits())
            .collect()
    };
    assert_eq!(bits(&one), bits(&picture(2)));
    let columns = Columns::new(stage);
    for column in 0..60 {
        let alone = columns.column(0, &pose, column, &PlaneKind::ALL).unwrap();
        for kind in PlaneKind::ALL {
            let picture: Vec<f32> = one.get(kind).unwrap().iter().skip(column).step_by(60).copied().collect();
            assert_eq!(alone.get(kind).unwrap(), picture, "{column} {}", kind.name());
        }
    }
}

#[test]
fn intensity_is_the_luminance_and_no_value_is_no_number() {
    let found = seen(fair());
    let (mut colours, mut labels) = (0, [0; 3]);
    for index in 0..(PIXELS[0] * PIXELS[1]) as usize {
        let colour = PlaneKind::COLOUR.map(|kind| value(&found, kind, index));
        let intensity = value(&found, PlaneKind::Intensity, index);
        assert!((intensity - luminance(colour)).abs() < 1e-6, "{index}");
        assert!(PlaneKind::ALL.iter().all(|&kind| !value(&found, kind, index).is_nan()));
        colours += usize::from(colour[0] > colour[2] + 1e-3);
        let label = value(&found, PlaneKind::Label, index) as usize;
        if let Some(count) = label.checked_sub(usize::from(Label::Light.code())) {
            labels[count] += 1;
        }
    }
    assert!(colours > 50 && labels.iter().all(|&count| count > 0), "{colours} {labels:?}");
    let (_, stage) = session(fair());
    assert!(stage.is_colourful() && !session(lights(vec![lamp(EYE)])).1.is_colourful());
}
