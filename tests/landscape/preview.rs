//! The preview of a machine against its whole picture: the same light where samples are fine, the same faults, and nobody who looks
//! changes the picture.

use hardware_model::{Economy, Gate, MixingParts, WireParts};
use landscape::{CraterGrain, Source};
use lunoid_tests::Drawn;
use rayon::ThreadPoolBuilder;
use scenario::{FeatureLight, Scalar};

use crate::landscape::set::{Set, bits, craters, rolling, standing_box, sun};

/// Some of everything, but no silhouettes: those are lines that no sample knows.
fn full(seed: u64) -> Set {
    let set = Set::over(rolling(seed, 3.0)).under(sun(70.0, 9.0));
    let middle = [set.pose.eye[0] + 60.0, set.pose.eye[1]];
    let set = set.with_craters(craters(seed, 24, middle, 60.0, 14.0)).with_texture(Source::Random);
    let set =
        set.dressed(|ground| ground.with_crater_grain(CraterGrain::new([2.0, 0.5, 3.0]))).with_shadows();
    let bodies = (0..6).map(|object| {
        let place = set.ahead(12.0 + 9.0 * f64::from(object), f64::from(object) * 7.0 - 20.0);
        standing_box(object, place, 1.0, 1.6)
    });
    let bodies = bodies.collect();
    set.with_bodies(bodies)
}

fn drawn(set: &Set, economy: Economy, samples: u32, signals: &[&str]) -> Drawn {
    let mut set = set.clone();
    (set.stage.settings.economy, set.stage.settings.raster.samples) = (economy, samples);
    set.machine(signals)
}

/// Root mean square of the difference of two pictures.
fn difference(a: &Drawn, b: &Drawn) -> f64 {
    let squares = a.picture.iter().zip(&b.picture).map(|(a, b)| f64::from((a - b) * (a - b)));
    let sum: f64 = squares.sum();
    (sum / a.picture.len() as f64).sqrt()
}

/// Both draw the same landscape, the preview with what samples miss: four times the samples leave less than half of it.
#[test]
fn finer_samples_bring_the_preview_to_the_whole_machine() {
    for seed in [1, 2, 3] {
        let set = full(seed);
        let off = |samples| {
            let [preview, whole] =
                [Economy::Instants(1), Economy::Bounded].map(|economy| drawn(&set, economy, samples, &[]));
            assert!(
                whole.counts["features"] > 0
                    && whole.counts["shadow_toggles"] > 0
                    && whole.counts["bodies"] > 0
            );
            difference(&preview, &whole)
        };
        let [coarse, fine, finest] = [700, 2800, 11_200].map(off);
        println!("seed {seed}: {coarse} {fine} {finest}");
        assert!(
            coarse < 0.02 && fine < 0.5 * coarse && finest < 0.5 * fine,
            "seed {seed}: {coarse} {fine} {finest}"
        );
    }
}

/// The same landscape without anything but terrain: no kinks, no edges, no light but one.
#[test]
fn bare_ground_is_as_good_as_the_same() {
    let mut set = Set::over(rolling(5, 4.0)).under(sun(100.0, 15.0));
    set.stage.settings.scalar = Scalar::F64;
    let [preview, whole] =
        [Economy::Instants(1), Economy::Bounded].map(|economy| drawn(&set, economy, 700, &[]));
    assert!(difference(&preview, &whole) < 1e-3, "{}", difference(&preview, &whole));
}

/// Terrain generators whose every part is slow: what they do shows as it does in the whole machine, and by far outweighs what
/// samples miss.
#[test]
fn slow_parts_of_the_terrain_generator_show_as_they_do_in_the_whole_machine() {
    let mut set = full(1);
    let ideal = drawn(&set, Economy::Instants(1), 2800, &[]);
    let parts = &mut set.stage.settings.analog;
    parts.full_scale = 10.0;
    parts.function_generator.bandwidth = Some(4e4);
    parts.multiplier.bandwidth = Some(6e4);
    (parts.multiplying_dac.bandwidth, parts.multiplying_dac.bits) = (Some(4e4), Some(8));
    (parts.amplifier.gain_bandwidth, parts.amplifier.slew) = (Some(8e5), Some(2e7));
    parts.summer_inputs = Some(6);
    let [preview, whole] =
        [Economy::Instants(1), Economy::Bounded].map(|economy| drawn(&set, economy, 2800, &[]));
    let (fault, error) = (difference(&ideal, &preview), difference(&preview, &whole));
    println!("{fault} {error}");
    assert!(bits(&preview.picture) != bits(&whole.picture), "it is drawn whole");
    assert!(error < 0.005 && fault > 10.0 * error, "{fault} {error}");
}

/// Output amplifiers on all main signals: they lag in the preview as they do in the whole machine, by far more than samples miss.
#[test]
fn output_amplifiers_show_as_they_do_in_the_whole_machine() {
    let mut set = full(1);
    let ideal = drawn(&set, Economy::Instants(1), 2800, &[]);
    set.stage.settings.analog.wires = WireParts { bandwidth: Some(3e4), ..WireParts::IDEAL };
    let [preview, whole] =
        [Economy::Instants(1), Economy::Bounded].map(|economy| drawn(&set, economy, 2800, &[]));
    let (fault, error) = (difference(&ideal, &preview), difference(&preview, &whole));
    println!("{fault} {error}");
    assert!(bits(&preview.picture) != bits(&whole.picture), "it is drawn whole");
    assert!(error < 0.01 && fault > 5.0 * error, "{fault} {error}");
}

/// A stage of slow parts that are off makes the light of the terrain in both; the craters it lights in the preview alone.
#[test]
fn light_of_parts_shows_as_it_does_in_the_whole_machine() {
    let mut set = full(1);
    let ideal = drawn(&set, Economy::Instants(1), 2800, &[]);
    let light = &mut set.stage.settings.analog.reflectivity;
    light.multiplier.error = 0.01;
    light.summer_bandwidth = Some(1e5);
    light.divider.error = 0.01;
    let [preview, whole] =
        [Economy::Instants(1), Economy::Bounded].map(|economy| drawn(&set, economy, 2800, &[]));
    let (fault, error) = (difference(&ideal, &preview), difference(&preview, &whole));
    println!("{fault} {error}");
    assert!(bits(&preview.picture) != bits(&whole.picture), "it is drawn whole");
    assert!(error < 0.01 && fault > 2.5 * error, "{fault} {error}");
}

#[test]
fn words_that_never_come_show_as_they_do_in_the_whole_machine() {
    let mut set = full(1);
    let [clean, _] = [Economy::Instants(1), Economy::Bounded].map(|economy| drawn(&set, economy, 2800, &[]));
    set.stage.settings.loader.stop_after_crossings = Some(2);
    let [preview, whole] =
        [Economy::Instants(1), Economy::Bounded].map(|economy| drawn(&set, economy, 2800, &[]));
    assert_eq!(preview.counts["late_words"], whole.counts["late_words"]);
    assert!(preview.counts["late_words"] > 0);
    let (fault, error) = (difference(&clean, &preview), difference(&preview, &whole));
    assert!(fault > 10.0 * error, "{fault} {error}");
}

#[test]
fn whoever_looks_sees_the_whole_machine_and_changes_no_picture() {
    let set = full(2);
    let alone = drawn(&set, Economy::Instants(1), 700, &[]);
    let looked_at = drawn(&set, Economy::Instants(1), 700, &["*"]);
    let whole = drawn(&set, Economy::Bounded, 700, &["*"]);
    assert!(bits(&alone.picture) == bits(&looked_at.picture));
    assert!(bits(&alone.picture) != bits(&whole.picture));
    assert!(!whole.waveforms.is_empty() && whole.waveforms == looked_at.waveforms);
}

/// Laws that keep features apart from the terrain, and gates that open by light, need the whole machine.
#[test]
fn what_cannot_be_lit_as_one_surface_is_drawn_whole() {
    let mut apart = full(1);
    apart.stage.settings.laws.feature_light = FeatureLight::AsReported;
    let mut keyed = full(1);
    keyed.stage.settings.mixing_unit = MixingParts { gate: Gate::SelfKeyed, threshold: 0.05 };
    let [mut parts, mut noise, mut late] = [full(1), full(1), full(1)];
    parts.stage.settings.analog.comparator.delay = 1e-7;
    noise.stage.settings.analog.amplifier.noise = 5e-3;
    late.stage.settings.analog.reflectivity.delay_mismatch = 5e-8;
    let sets = [
        ("as reported", apart),
        ("self-keyed", keyed),
        ("parts", parts),
        ("noise", noise),
        ("late light", late),
    ];
    for (what, set) in sets {
        let [preview, whole] =
            [Economy::Instants(1), Economy::Bounded].map(|economy| drawn(&set, economy, 700, &[]));
        assert!(bits(&preview.picture) == bits(&whole.picture), "{what}");
    }
}

#[test]
fn threads_change_no_bit() {
    let set = full(3);
    let by = |threads| {
        let pool = ThreadPoolBuilder::new().num_threads(threads).build().expect("a pool of threads");
        pool.install(|| bits(&drawn(&set, Economy::Instants(1), 700, &[]).picture))
    };
    assert!(by(1) == by(3));
}

/// Far craters are left out and counted; what they would change is within the bound that is told.
#[test]
fn craters_that_cannot_be_told_are_counted() {
    let mut set = Set::over(rolling(7, 0.5)).under(sun(70.0, 25.0));
    set.stage.settings.range.end = 400.0;
    let [x, y] = set.foot();
    let set = set.with_craters(craters(7, 3000, [x + 200.0, y], 190.0, 1.5));
    let [preview, whole] =
        [Economy::Instants(1), Economy::Lossless].map(|economy| drawn(&set, economy, 2800, &[]));
    println!("{:?} {:?}", preview.counts, difference(&preview, &whole));
    assert!(preview.counts["craters_left_out"] > 100, "{:?}", preview.counts);
    assert!(preview.counts["features"] < whole.counts["features"]);
    assert_eq!(whole.counts["craters_left_out"], 0);
    let sum: f64 = preview.picture.iter().zip(&whole.picture).map(|(a, b)| f64::from((a - b).abs())).sum();
    assert!(sum < preview.counts["pixels_left_out"] as f64, "{sum} of {}", preview.counts["pixels_left_out"]);
}
