//! The default quality against the whole machine: by the closed form it is no worse, for other samples it is the same machine, and where the
//! rule cannot serve, the whole machine draws.

use generator::PlaneKind;
use hardware_model::Economy;
use landscape::Source;
use lunoid_tests::Drawn;

use crate::landscape::set::{Set, bits, craters, rolling, standing_box, sun};

/// Ground with this many craters, with shadows, texture and boxes.
fn scene(seed: u64, count: usize) -> Set {
    let set = Set::over(rolling(seed, 3.0)).under(sun(70.0, 9.0));
    let middle = [set.pose.eye[0] + 60.0, set.pose.eye[1]];
    let set = set.with_craters(craters(seed, count, middle, 60.0, 14.0)).with_texture(Source::Random);
    let set = set.with_shadows();
    let boxes = (0..6).map(|object| {
        let place = set.ahead(12.0 + 9.0 * f64::from(object), f64::from(object) * 7.0 - 20.0);
        standing_box(object, place, 1.0, 1.6)
    });
    let boxes = boxes.collect();
    set.with_bodies(boxes)
}

fn drawn(set: &Set, economy: Economy, samples: u32) -> Drawn {
    let mut set = set.clone();
    (set.stage.settings.economy, set.stage.settings.raster.samples) = (economy, samples);
    set.machine(&[])
}

/// Root mean square of the difference from `exact`, and the share of the pixels that differ by more than two levels of 255.
fn error(picture: &[f32], exact: &[f32]) -> [f64; 2] {
    let off = || picture.iter().zip(exact).map(|(a, b)| f64::from((a - b).abs()));
    let count = picture.len() as f64;
    let squares: f64 = off().map(|off| off * off).sum();
    [(squares / count).sqrt(), off().filter(|off| *off > 2.0 / 255.0).count() as f64 / count]
}

/// The front of error against time: what the default leaves out costs no error, and one instant a step would.
#[test]
fn the_default_is_no_worse_than_the_whole_machine() {
    for (seed, count) in [(1, 24), (2, 24), (3, 90)] {
        let set = scene(seed, count);
        let exact = set.exact();
        let exact = exact.get(PlaneKind::Intensity).expect("asked for");
        let of = |economy| error(&drawn(&set, economy, 300).picture, exact);
        let [normal, fine, draft] = [Economy::Normal, Economy::Bounded, Economy::Instants(1)].map(of);
        println!("seed {seed}, {count} craters: normal {normal:?}, fine {fine:?}, draft {draft:?}");
        assert!(normal[0] <= 1.1 * fine[0] && normal[1] <= 1.2 * fine[1], "{normal:?} {fine:?}");
        assert!(draft[1] > 1.2 * fine[1], "the scene does not tell them apart: {draft:?} {fine:?}");
    }
}

/// Instants stand between the steps of the same machine: words, folds and counts are those of its clock.
#[test]
fn instants_leave_the_digital_side_as_it_is() {
    let set = scene(2, 24);
    let [draft, normal] = [Economy::Instants(1), Economy::Normal].map(|economy| drawn(&set, economy, 300));
    assert!(bits(&draft.picture) != bits(&normal.picture));
    for count in ["sweeps", "samples", "folds", "loads", "late_words"] {
        assert_eq!(draft.counts.get(count), normal.counts.get(count), "{count}");
    }
}

/// A scene without craters and shadows, and a machine whose parts remember, are drawn whole.
#[test]
fn where_instants_win_nothing_the_whole_machine_draws() {
    let bare = Set::over(rolling(5, 4.0)).under(sun(100.0, 15.0));
    let [normal, fine] = [Economy::Normal, Economy::Bounded].map(|economy| drawn(&bare, economy, 300));
    assert!(bits(&normal.picture) == bits(&fine.picture), "bare ground");
    let mut slow = scene(1, 24);
    slow.stage.settings.analog.multiplier.bandwidth = Some(6e4);
    let [normal, fine] = [Economy::Normal, Economy::Bounded].map(|economy| drawn(&slow, economy, 300));
    assert!(bits(&normal.picture) == bits(&fine.picture), "slow multipliers");
}

/// Instants that fall on the samples of a finer clock draw what that clock draws: the range grows straight between steps in both, where
/// the programme has one rate.
#[test]
fn instants_are_the_samples_of_a_finer_clock() {
    let mut set = scene(3, 24);
    set.stage.settings.range.law = scenario::RangeLaw::ConstantRate;
    let by_steps = drawn(&set, Economy::Instants(4), 300);
    // That clock has three samples more, nearer than the first step.
    let by_clock = drawn(&set, Economy::Instants(1), 4 * 300);
    let [rmse, _] = error(&by_steps.picture, &by_clock.picture);
    assert!(rmse < 2e-3, "{rmse}");
}
