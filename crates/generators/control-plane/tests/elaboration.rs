//! Which blocks a stage asks for, which of them have parts, and what a record says of the others.

use std::sync::Arc;

use control_plane::{Block, Elaboration, MachineStage};
use features::{Crater, Features, Shape};
use glam::{DMat3, DVec3};
use hardware_model::{Economy, Forced, HardwareModel, LevelSwitch, Settings, ShadowFineness, Yoke};
use landscape::{Bank, Landscape, Layer, Level, Photometry, Source, Sun, Texture};
use scenario::{Display, FieldOfView, LawWishes, RasterWishes, Scalar, Scenery, Standing};
use solids::{Body, Kind, Solid};

const SUN: Sun = Sun { azimuth: 0.3, elevation: 0.6 };

fn level(size: f64) -> Level {
    Level::new(size, [0.0; 2], [3, 3], vec![[0.0; 9]; 9]).expect("a level")
}

/// Level ground on the ideal machine: nothing has any work but the blocks that every picture needs.
fn plain() -> MachineStage {
    let field = FieldOfView { tan_half_width: 0.4, tan_half_height: 0.3 };
    let (raster, laws) = (RasterWishes::default(), LawWishes::default());
    let display = Display { white: 1.0, gamma: 1.0 };
    let settings =
        Settings::resolve(&HardwareModel::ideal(), field, raster, None, laws, Scalar::F32, display)
            .expect("the ideal model is consistent");
    let bank = Bank::new("test", vec![level(10.0)], None).expect("a bank");
    MachineStage {
        landscape: Arc::new(Landscape::new(bank, 0.5)),
        scenery: Arc::new(Scenery::still(SUN)),
        settings,
    }
}

fn changed(change: impl FnOnce(&mut MachineStage)) -> Elaboration {
    let mut stage = plain();
    change(&mut stage);
    Elaboration::new(&stage)
}

fn with_settings(change: impl FnOnce(&mut Settings)) -> Elaboration {
    changed(|stage| change(&mut stage.settings))
}

fn with_ground(change: impl FnOnce(Landscape) -> Landscape) -> Elaboration {
    changed(|stage| stage.landscape = Arc::new(change(Landscape::clone(&stage.landscape))))
}

const ALL: [Block; 13] = [
    Block::Terrain,
    Block::Features,
    Block::Shadows,
    Block::Texture,
    Block::Bodies,
    Block::SecondLevel,
    Block::Silhouettes,
    Block::Yoke,
    Block::Mixing,
    Block::Beam,
    Block::Memory,
    Block::PictureTube,
    Block::Amplifiers,
];

fn there(list: &Elaboration) -> Vec<Block> {
    ALL.into_iter().filter(|block| list.has(*block)).collect()
}

fn of_parts(list: &Elaboration) -> Vec<Block> {
    ALL.into_iter().filter(|block| list.has_parts(*block)).collect()
}

/// What is always there.
const BARE: [Block; 5] = [Block::Terrain, Block::Beam, Block::Memory, Block::PictureTube, Block::Amplifiers];

#[test]
fn level_ground_on_the_ideal_machine_needs_five_blocks_and_no_parts() {
    let list = changed(|_| {});
    assert_eq!(there(&list), BARE);
    assert_eq!(of_parts(&list), []);
    assert!(list.instants().is_none());
    let said: Vec<_> = list.omissions().into_iter().map(|omission| (omission.block, omission.what)).collect();
    let absent = [
        ("feature-generator", "sub-generators and VS1"),
        ("shadow-controller", "line generators and VS2"),
        ("texture-generator", "texture and its adder"),
        ("polyhedron-generator", "polyhedra and VS3"),
        ("terrain-generator", "second level and its switch"),
        ("terrain-generator", "profiles of far mountains"),
        ("display", "turning yoke"),
    ];
    assert_eq!(said[..7], absent.map(|(block, what)| (block, what.to_owned())));
    assert!(said[7..].contains(&("sweep-memory", "spot, exposure, residue".to_owned())), "{said:?}");
}

#[test]
fn each_thing_in_a_scene_brings_its_block() {
    let bowl = Crater::new([15.0, 15.0], Shape::Bowl { r1: 2.0 }, 0.1, 0.0).expect("a bowl");
    let solid = Arc::new(Solid::boxed(-DVec3::ONE, DVec3::ONE, 0.5).expect("a cube"));
    let body = Body::place(0, Kind::Culture, &solid, DVec3::ONE, &DMat3::IDENTITY, 1.0);
    let standing = vec![Standing { from: 0.0, until: 9.0, body }];
    let yoke = Yoke { step: 0.0, rate: 1.0, travel: 3.0, natural: None, damping: 1.0 };
    let cases = [
        (with_ground(|ground| ground.with_features(Features::new(vec![bowl]))), Block::Features, true),
        (with_settings(|settings| settings.shadows = Some(ShadowFineness::default())), Block::Shadows, true),
        (
            changed(|stage| stage.scenery = Arc::new(Scenery::still(SUN).with_bodies(standing.clone()))),
            Block::Bodies,
            false,
        ),
        (with_settings(|settings| settings.yoke = Some(yoke)), Block::Yoke, false),
    ];
    for (list, block, mixes) in cases {
        let mut expected = BARE.to_vec();
        expected.push(block);
        expected.extend(mixes.then_some(Block::Mixing));
        expected.sort_by_key(|block| ALL.iter().position(|known| known == block));
        assert_eq!(there(&list), expected);
    }
}

#[test]
fn a_second_level_needs_a_switch_and_ground() {
    let two = |stage: &mut MachineStage| {
        let bank = Bank::new("test", vec![level(10.0), level(40.0)], None).expect("a bank");
        stage.landscape = Arc::new(Landscape::new(bank, 0.5));
    };
    let switch = Some(LevelSwitch { range: 20.0, blend: 5.0 });
    let has = |list: Elaboration| list.has(Block::SecondLevel);
    assert!(!has(changed(two)));
    assert!(!has(with_settings(|settings| settings.levels = switch)));
    assert!(has(changed(|stage| {
        two(stage);
        stage.settings.levels = switch;
    })));
}

/// Only Lambert's light never exceeds full scale.
#[test]
fn another_law_of_reflection_needs_the_clip_of_the_mixing_unit() {
    let list = with_ground(|ground| ground.with_photometry(Photometry::LommelSeeliger));
    assert!(list.has(Block::Mixing) && !list.has_parts(Block::Mixing));
}

#[test]
fn a_figure_of_a_part_brings_the_parts_of_its_block_alone() {
    type Change = fn(&mut Settings);
    let cases: [(Change, Block); 6] = [
        (|settings| settings.analog.multiplier.bandwidth = Some(6e4), Block::Terrain),
        (|settings| settings.analog.wires.bandwidth = Some(1e5), Block::Amplifiers),
        (|settings| settings.analog.video_switch.time = 1e-6, Block::Mixing),
        (|settings| settings.analog.memory.erase_residual = 0.1, Block::Memory),
        (|settings| settings.analog.memory.grey = Some(8), Block::PictureTube),
        (|settings| settings.analog.picture_tube.gamma = 2.2, Block::PictureTube),
    ];
    for (change, block) in cases {
        let list = with_settings(change);
        assert!(of_parts(&list).contains(&block), "{block:?}: {:?}", of_parts(&list));
        let unrelated = [Block::Terrain, Block::Memory].into_iter().filter(|other| *other != block);
        unrelated.for_each(|other| assert!(!list.has_parts(other), "{block:?} brings parts of {other:?}"));
    }
}

#[test]
fn what_is_forced_runs_without_work() {
    let forced = |what| with_settings(|settings| settings.economy = Economy::LosslessBut(what));
    assert!(forced(Forced::Bodies).has(Block::Bodies));
    assert!(forced(Forced::Mixing).has(Block::Mixing) && !forced(Forced::Mixing).has(Block::Features));
    let everything = with_settings(|settings| settings.economy = Economy::Everything);
    assert!(
        everything.has(Block::Features) && everything.has(Block::Bodies) && everything.has(Block::Mixing)
    );
    assert!(!everything.has(Block::Texture), "there is no pattern that it could add");
}

#[test]
fn instants_are_for_ideal_parts_beside_those_of_the_terrain() {
    let instants = |change: fn(&mut Settings)| {
        with_settings(|settings| {
            settings.economy = Economy::Instants(4);
            change(settings);
        })
        .instants()
    };
    assert_eq!(instants(|_| {}), Some(4));
    assert_eq!(instants(|settings| settings.analog.multiplier.bandwidth = Some(6e4)), Some(1));
    assert_eq!(instants(|settings| settings.analog.video_switch.time = 1e-6), None);
}

#[test]
fn texture_brings_its_adder() {
    let texture =
        Texture::new(&[Layer { cell: 1.0, amplitude: 0.1, range: 50.0 }], Source::Random, 1, 10.0, [0.0; 2])
            .expect("a texture");
    let list = with_ground(|ground| ground.with_texture(Some(texture)));
    assert!(list.has(Block::Texture) && list.has(Block::Mixing) && !list.has(Block::Features));
}
