//! The overlays of one fault each: the sign that each is predicted to have, measured with it and without.

use std::sync::Arc;

use generator::{Generator, Label, PlaneKind, Planes, Session, Stage};
use glam::{DMat3, DVec3};
use lod_mesh::ROW;
use scenario::{Pose, Standing};
use signal::Probe;
use solids::{Body, Kind};

use crate::parameters::configured;
use crate::shots::{draw, pose, sky, stage};

const PIXELS: usize = 64;

/// The table of [`run`](crate::shots::run).
const RUN: &str = "order = 3\nspacing_m = 10\nlevels = 3\nranges_m = [450, 900, 1350]";

/// The generator without a fault and with it, made ready for a stage.
fn pair(fault: &str, stage: &Stage) -> [Box<dyn Session>; 2] {
    let text = ROW.fault(fault).unwrap();
    [None, Some(text)].map(|overlay| {
        let generator: Arc<dyn Generator> = configured(RUN, overlay).unwrap();
        generator.prepare(stage.clone()).unwrap()
    })
}

/// An eye so far (m) above the ground at a place, that looks down.
fn over(stage: &Stage, [north, east]: [f64; 2], above: f64) -> Pose {
    let ground = stage.landscape.at_spacing(north, east, 10.0).unwrap().height;
    pose([north, east, ground + above], 0.0, -90.0)
}

fn cracked(session: &dyn Session, pose: &Pose) -> u64 {
    let mut planes = Planes::new(PIXELS, PIXELS, &[PlaneKind::Intensity]);
    session.frame(0, pose, &mut planes, &mut Probe::off()).unwrap()["cracked_edges"]
}

/// Distance (m) to the drawn ground along the axis.
fn sounding(session: &dyn Session, pose: &Pose) -> f64 {
    session.sounding(0, pose, [pose; 2]).unwrap().unwrap()
}

/// Through the distance at which a tile changes, the ground below a vertex that the next level lacks jumps by what that level loses.
#[test]
fn no_morph_jumps_where_a_tile_takes_another_level() {
    let stage = stage(PIXELS as u32);
    // The middle of the tile is 14 m aside; its level changes where it is 450 m away.
    let middle = stage.landscape.at_spacing(760.0, 760.0, 10.0).unwrap().height;
    let at = |above: f64| pose([750.0, 750.0, middle + above], 0.0, -90.0);
    let change = (450.0 * 450.0 - 200.0_f64).sqrt();
    let jump = |session: &dyn Session| {
        let [near, far] = [-1e-7, 1e-7].map(|more| sounding(session, &at(change + more)));
        (far - near - 2e-7).abs()
    };
    let [without, with] = pair("no-morph", &stage).map(|session| jump(&*session));
    let heights = |place: [f64; 2]| stage.landscape.at_spacing(place[0], place[1], 10.0).unwrap().height;
    let lost = heights([750.0, 750.0]) - (heights([760.0, 740.0]) + heights([740.0, 760.0])) / 2.0;
    assert!(without < 1e-6, "{without}");
    assert!((with - lost.abs()).abs() < 1e-6 && with > 0.01, "{with} {lost}");
}

/// A small ground below a slanting view: cracks of decimetres are whole sampling points there.
#[test]
fn per_tile_shows_sky_between_tiles_of_one_level() {
    let stage = stage(PIXELS as u32);
    let table = "order = 2\nspacing_m = 10\nlevels = 3\nranges_m = [110, 220, 330]";
    let views = (0..200).map(|step| Pose {
        attitude: pose([0.0; 3], 1.8 * f64::from(step), -45.0).attitude,
        ..over(&stage, [500.0 + 3.0 * f64::from(step), 800.0], 40.0 + 0.3 * f64::from(step))
    });
    let views: Vec<Pose> = views.collect();
    let [without, with] = [None, Some(ROW.fault("per-tile").unwrap())].map(|overlay| {
        let session = configured(table, overlay).unwrap().prepare(stage.clone()).unwrap();
        let shown =
            views.iter().map(|pose| [cracked(&*session, pose), sky(&draw(&*session, PIXELS, pose)) as u64]);
        shown.fold([0, 0], |[a, b], [cracked, sky]| [a + cracked, b + sky])
    });
    assert_eq!(without, [0, 0]);
    assert!(with[0] > 1000 && with[1] > 0, "{with:?}");
}

/// Only edges between levels are holes: the levels of a tile change at 450 and 900 m.
#[test]
fn no_stitch_leaves_holes_where_levels_differ() {
    let stage = stage(PIXELS as u32);
    let [near, far] = [over(&stage, [800.0, 800.0], 100.0), over(&stage, [800.0, 800.0], 3000.0)];
    let [without, with] =
        pair("no-stitch", &stage).map(|session| [&near, &far].map(|pose| cracked(&*session, pose)));
    assert_eq!(without, [0, 0]);
    assert!(with[0] > 20 && with[1] == 0, "{with:?}: all tiles have the coarsest level from 3 km");
}

/// The ground with a boulder of 20 m on it.
pub fn with_boulder(foot: DVec3) -> Stage {
    let stage = stage(PIXELS as u32);
    let solid = Arc::new(solids::rocks::shapes(1).unwrap().remove(0));
    let body = Body::place(0, Kind::Rock, &solid, foot, &DMat3::IDENTITY, 20.0);
    let standing = vec![Standing { from: 0.0, until: f64::INFINITY, body }];
    Stage { scenery: Arc::new((*stage.scenery).clone().with_bodies(standing)), ..stage }
}

/// A boulder at the mean radius is nearer or farther by the height of the ground under it.
#[test]
fn mean_radius_moves_boulders_by_the_height_of_the_ground() {
    let bare = stage(PIXELS as u32);
    let height = |place: [f64; 2]| bare.landscape.height(place[0], place[1]).unwrap();
    // A valley: there the boulder hovers, and is seen whole.
    let places =
        (0..1600).map(|number| [f64::from(number % 40), f64::from(number / 40)].map(|at| 20.0 + 39.0 * at));
    let [north, east] = places.min_by(|a, b| height(*a).total_cmp(&height(*b))).unwrap();
    let stage = with_boulder(DVec3::new(north, east, height([north, east])));
    let pose = pose([north, east, 200.0], 0.0, -90.0);
    let top = |session: &dyn Session| {
        let planes = draw(session, PIXELS, &pose);
        let labels = planes.get(PlaneKind::Label).unwrap().iter();
        let rock = labels.map(|label| *label == f32::from(Label::Rock.code()));
        let distances = planes.get(PlaneKind::Distance).unwrap().iter();
        let of_rock =
            distances.zip(rock).filter(|(_, is_rock)| *is_rock).map(|(distance, _)| f64::from(*distance));
        of_rock.fold(f64::INFINITY, f64::min)
    };
    let [without, with] = pair("mean-radius", &stage).map(|session| top(&*session));
    let depth = -height([north, east]);
    assert!(depth > 10.0 && ((without - with) - depth).abs() < 1.0, "{without} {with} {depth}");
}

#[test]
fn coarse_light_keeps_the_ground_and_loses_its_light() {
    let stage = stage(PIXELS as u32);
    let pose = over(&stage, [800.0, 800.0], 200.0);
    let [without, with] = pair("coarse-light", &stage).map(|session| draw(&*session, PIXELS, &pose));
    let difference = |kind: PlaneKind| {
        let pairs = without.get(kind).unwrap().iter().zip(with.get(kind).unwrap());
        let squares = pairs.map(|(a, b)| f64::from((a - b) * (a - b))).sum::<f64>();
        (squares / (PIXELS * PIXELS) as f64).sqrt()
    };
    assert_eq!(difference(PlaneKind::Distance), 0.0);
    // Waves are 60 m and more long; slopes between posts 160 m apart are nearly those of level ground.
    assert!(difference(PlaneKind::Intensity) > 0.1, "{}", difference(PlaneKind::Intensity));
}

/// Straight above a vertex that the next level lacks, what is left of it is a whole number of 255ths.
#[test]
fn one_percent_moves_in_steps_of_a_255th_of_the_pop() {
    let stage = stage(PIXELS as u32);
    let heights = |place: [f64; 2]| stage.landscape.at_spacing(place[0], place[1], 10.0).unwrap().height;
    let whole = heights([750.0, 750.0]);
    let pop = whole - (heights([760.0, 740.0]) + heights([740.0, 760.0])) / 2.0;
    let steps = |session: &dyn Session| {
        let of = |step: u32| {
            let eye = [750.0, 750.0, whole + 300.0 + f64::from(step)];
            let drawn = eye[2] - sounding(session, &pose(eye, 0.0, -90.0));
            255.0 * (whole - drawn) / pop
        };
        (0..100).map(of).map(|step| (step - step.round()).abs()).fold(0.0, f64::max)
    };
    let [without, with] = pair("one-percent", &stage).map(|session| steps(&*session));
    assert!(with < 1e-6 && without > 0.4, "{with} {without}");
}
