//! The overlays of one fault each: what it turns on, and the sign that it is predicted to have.

use std::sync::Arc;

use diagnostics::{Layers, Problems, TomlFile};
use generator::{Generator, PlaneKind, Planes};
use panels::ROW;
use signal::Probe;

use crate::moffett::{configured, frame_stage, poses, scenario};
use crate::shots::{draw, landscape, light, photograph, pose, stage, waves};

/// The repaired program over a scenario (TOML), and the same with an overlay.
fn pair(scenario: &str, fault: &str) -> [Arc<dyn Generator>; 2] {
    let repaired = scenario.replace("restrictions = true", "fill = \"edge-buffer\"");
    let problems = Problems::new();
    let texts = [ROW.gear.unwrap().text, &repaired, ROW.fault(fault).unwrap()];
    let files = texts.map(|text| TomlFile::parse("layer", text, &problems).unwrap());
    let with = (ROW.configure)(&Layers::new(files).root(&problems));
    [configured(&repaired).unwrap(), problems.resolve(with).unwrap()]
}

/// Light, distance and share of pixels with ground, seen by the first observer.
struct Seen {
    light: Vec<f32>,
    distance: Vec<f32>,
}

impl Seen {
    fn of(generator: &dyn Generator) -> Self {
        let session = generator.prepare(frame_stage("frame")).unwrap();
        let mut planes = Planes::new(512, 512, &[PlaneKind::Intensity, PlaneKind::Distance]);
        session.frame(0, &poses("moffett")[1], &mut planes, &mut Probe::off()).unwrap();
        let plane = |kind| planes.get(kind).unwrap().to_vec();
        Self { light: plane(PlaneKind::Intensity), distance: plane(PlaneKind::Distance) }
    }

    fn drawn(&self) -> f64 {
        self.distance.iter().filter(|distance| distance.is_finite()).count() as f64
    }

    /// Mean over pixels with ground of a value.
    fn mean(&self, value: &[f32]) -> f64 {
        let ground = self.distance.iter().zip(value).filter(|(distance, _)| distance.is_finite());
        ground.map(|(_, value)| f64::from(*value)).sum::<f64>() / self.drawn()
    }

    /// Mean row of pixels with ground.
    fn row(&self) -> f64 {
        let rows: Vec<f32> = (0..512 * 512).map(|pixel| (pixel / 512) as f32).collect();
        self.mean(&rows)
    }
}

fn seen(fault: &str) -> [Seen; 2] {
    pair(&scenario("moffett"), fault).map(|generator| Seen::of(&*generator))
}

#[test]
fn an_overlay_turns_its_finding_on_and_no_other() {
    let faults = ROW.gear.unwrap().faults;
    assert_eq!(faults.len(), 10);
    for (name, _) in faults {
        let [repaired, with] = pair(&scenario("moffett"), name).map(|generator| generator.record());
        let mut expected = repaired.clone();
        expected[name.replace('-', "_")] = true.into();
        assert_eq!(with, expected, "{name}");
        assert_ne!(with, repaired, "{name}");
    }
}

#[test]
fn quadrant_draws_four_times_as_many_pixels() {
    let [repaired, found] = seen("quadrant");
    let ratio = found.drawn() / repaired.drawn();
    assert!((ratio - 4.0).abs() < 0.1, "{ratio}");
}

#[test]
fn skewed_axes_move_ground_down_by_rows() {
    let [repaired, found] = seen("skewed-axes");
    let rows = found.row() - repaired.row();
    assert!((5.0..9.0).contains(&rows), "{rows}");
}

#[test]
fn linear_depth_puts_ground_farther_by_tenths_of_a_metre() {
    let [repaired, found] = seen("linear-depth");
    let metres = found.mean(&found.distance) - repaired.mean(&repaired.distance);
    assert!((0.05..0.5).contains(&metres), "{metres}");
}

/// Pixels below 128 keep their light to a level. A panel with pixels on both sides of it loses them against each other.
#[test]
fn signed_bytes_cancel_around_128() {
    let scene = "[panels]\nrestrictions = true\nspacing_m = 10\n";
    let eye = pose([60.0, 80.0, 30.0], 40.0, -20.0);
    let [repaired, found] = pair(scene, "signed-bytes").map(|generator| {
        let stage = stage(landscape(3.0), vec![photograph(800, 600.0, waves)], 96, 0.4);
        draw(&*generator.prepare(stage).unwrap(), 96, &eye)
    });
    let pairs =
        || light(&repaired).iter().zip(light(&found)).map(|pair| [pair.0, pair.1].map(|light| 255.0 * light));
    let dark = pairs().filter(|[repaired, _]| *repaired < 110.0);
    assert!(
        dark.clone().count() > 100 && dark.clone().all(|[repaired, found]| (repaired - found).abs() < 1.5)
    );
    let lost = pairs().filter(|[repaired, found]| (repaired - found).abs() > 50.0).count();
    assert!((50..96 * 96 / 2).contains(&lost), "{lost}");
}

#[test]
fn box_average_mixes_a_few_grey_levels() {
    let [repaired, found] = seen("box-average");
    let apart: Vec<f32> =
        found.light.iter().zip(&repaired.light).map(|(found, repaired)| (found - repaired).abs()).collect();
    let levels = 255.0 * repaired.mean(&apart);
    assert!((0.1..20.0).contains(&levels), "{levels}");
}

#[test]
fn discard_partial_loses_pixels_and_real4_and_both_ends_move_few() {
    let [repaired, found] = seen("discard-partial");
    assert!(found.drawn() <= repaired.drawn());
    for (fault, most) in [("real4", 0.15), ("both-ends", 0.30)] {
        let [repaired, found] = seen(fault);
        let other = found.light.iter().zip(&repaired.light).filter(|(found, repaired)| found != repaired);
        let share = other.count() as f64 / repaired.drawn();
        assert!(share > 0.0 && share < most, "{fault}: {share}");
    }
}

/// From the middle of the posts half of them are behind the eye.
#[test]
fn mirror_behind_draws_what_is_behind_the_eye() {
    let text = scenario("moffett");
    let drawn = pair(&text, "mirror-behind").map(|generator| {
        let session = generator.prepare(frame_stage("frame")).unwrap();
        let mut planes = Planes::new(512, 512, &[PlaneKind::Distance]);
        let mut pose = poses("moffett")[1];
        // North of all posts, which lie to the south.
        pose.eye[0] += 6000.0;
        session.frame(0, &pose, &mut planes, &mut Probe::off()).unwrap();
        planes.get(PlaneKind::Distance).unwrap().iter().filter(|distance| distance.is_finite()).count()
    });
    assert!(drawn[0] == 0 && drawn[1] > 1000, "{drawn:?}");
}

/// The upper block is void: harmonically it is as high as the lower block around it; by the mean it is a pit, whose floor and far wall are farther.
#[test]
fn mean_void_makes_a_pit_among_high_posts() {
    let text = scenario("moffett").replace("height_m = 83", "height_m = \"void\"");
    let [repaired, found] = pair(&text, "mean-void").map(|generator| Seen::of(&*generator));
    let metres = found.mean(&found.distance) - repaired.mean(&repaired.distance);
    assert!((0.1..100.0).contains(&metres), "{metres}");
}
