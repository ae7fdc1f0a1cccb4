//! The peers, where their packages are here.

use benchmarks::peers::embree::{EyeMesh, PeerScene, Program, Sight};
use benchmarks::peers::{rms, verilator};
use benchmarks::{Choice, TimedScene};
use control_plane::ControlPlane;
use scenario::FieldOfView;

/// Pixels along a side of the picture.
const SIDE: u32 = 64;

/// Level ground 2 m under the eye, and a wall across it 20 m ahead that rises 3 m.
fn wall() -> EyeMesh {
    let (up, back) = ([0.0, 0.0, 1.0], [-1.0, 0.0, 0.0]);
    let ground = [[1.0, -50.0], [100.0, -50.0], [100.0, 50.0], [1.0, 50.0]].map(|[x, y]| [[x, y, -2.0], up]);
    let wall = [[-50.0, -2.0], [-50.0, 1.0], [50.0, 1.0], [50.0, -2.0]].map(|[y, z]| [[20.0, y, z], back]);
    EyeMesh { vertices: ground.into_iter().chain(wall).collect(), faces: vec![[0, 1, 2, 3], [4, 5, 6, 7]] }
}

/// The ray tracer; `None`, said loudly, where a package is missing.
fn embree() -> Option<Program> {
    match Program::compile().expect("the ray tracer compiles") {
        Ok(program) => Some(program),
        Err(skipped) => {
            eprintln!("Embree: {skipped}");
            None
        }
    }
}

#[test]
fn a_wall_throws_the_shadow_of_its_height() {
    let Some(program) = embree() else { return };
    let field = FieldOfView { tan_half_width: 0.5, tan_half_height: 0.5 };
    let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, -1.0]];
    let sight = Sight { size: [SIDE; 2], field, albedo: 0.75, ranges: [5.0, 90.0], axes };
    let mut embree = program.start(&wall(), &sight).unwrap();
    // Ahead behind the wall, halfway up: the shadow begins 3 m before the wall.
    let sun = [0.5f64.sqrt(), 0.0, 0.5f64.sqrt()];
    for packet in [16, 8, 1] {
        assert!(embree.trace(packet, sun).unwrap() > 0.0);
        let picture = embree.picture().unwrap();
        let mut lit = 0;
        for (pixel, &found) in picture.iter().enumerate() {
            let (column, line) = (pixel as u32 % SIDE, pixel as u32 / SIDE);
            let [right, below] =
                [column, line].map(|at| 0.5 * (f64::from(2 * at + 1) / f64::from(SIDE) - 1.0));
            let ahead = 2.0 / below;
            let seen = below > 0.0 && ahead < 17.0 && ahead * (1.0 + right * right).sqrt() > 5.0;
            let expected = if seen { 0.75 * sun[2] as f32 } else { 0.0 };
            assert!((found - expected).abs() < 1e-6, "packet {packet}, line {line}: {found}, not {expected}");
            lit += u32::from(seen);
        }
        assert!(lit > SIDE * 10, "{lit}");
    }
    let wrong = embree.trace(7, sun).map(|_| ());
    assert!(wrong.is_err(), "packets of seven rays: {wrong:?}");
}

#[test]
fn finer_meshes_come_closer_to_the_right_picture() {
    let Some(program) = embree() else { return };
    let scene = PeerScene::new().unwrap();
    assert_eq!((scene.craters(), scene.size()), (388, [799, 459]));
    let right = scene.exact(0.0).unwrap();
    let error = |rings: usize| {
        let (mesh, sight) = scene.mesh(rings / 2, rings);
        let mut embree = program.start(&mesh, &sight).unwrap();
        embree.trace(16, scene.sun(0.0)).unwrap();
        rms(&embree.picture().unwrap(), &right)
    };
    let [coarse, fine] = [256, 768].map(error);
    assert!(fine < 0.6 * coarse && fine < 0.015, "{coarse} {fine}");
}

#[test]
fn both_control_planes_do_the_same_work() {
    let choice = Choice { model: Some("pra-nominal"), ..Choice::default() };
    let scene = TimedScene::shipped("nominal-drive", &choice);
    let plane = ControlPlane::new(scene.stage.clone());
    let stimuli = verilator::Stimuli::new(&scene.stage, &plane, &scene.pose).unwrap();
    let program = match verilator::Program::compile(&stimuli).expect("the control plane compiles") {
        Ok(program) => program,
        Err(skipped) => return eprintln!("Verilator: {skipped}"),
    };
    let mut verilated = program.start(&stimuli).unwrap();
    let ours = verilator::Work::ours(&scene.stage, &plane, &scene.pose).unwrap();
    assert!(ours.folds > 10_000 && ours.late > 0 && ours.longest > 1, "{ours:?}");
    for _ in 0..2 {
        let (seconds, theirs) = verilated.frame().unwrap();
        assert!(seconds > 0.0);
        assert_eq!(ours, theirs);
    }
}
