use super::{Lattice, Layer, Source, Texture, TextureError};
use fearless_simd::prelude::SimdBase;
use fearless_simd::{Level, Simd, dispatch};
use proptest::prelude::{Strategy, any, prop_assert, prop_assert_eq, proptest};
use signal::{Double, LANES, Real, eight};

const ORIGIN: [f64; 2] = [-130.0, 70.0];
const REGION: f64 = 32.0;

/// One layer of amplitude 1 and cell 1 m.
fn texture(source: Source, seed: u64) -> Texture {
    let layer = Layer { cell: 1.0, amplitude: 1.0, range: 100.0 };
    Texture::new(&[layer], source, seed, REGION, ORIGIN).unwrap()
}

fn pattern(source: Source, seed: u64, [x, y]: [f64; 2]) -> f64 {
    texture(source, seed).at(ORIGIN[0] + x, ORIGIN[1] + y, 0.0)
}

fn sources() -> impl Strategy<Value = Source> {
    any::<bool>().prop_map(|stored| if stored { Source::Pattern } else { Source::Random })
}

/// Sums of products of lattice values with those `shift` away.
fn moment(texture: &Texture, shift: [i32; 2]) -> f64 {
    let at = |i: i32, j: i32| texture.at(ORIGIN[0] + f64::from(i), ORIGIN[1] + f64::from(j), 0.0);
    let sum: f64 = (-150..150)
        .flat_map(|i| (-150..150).map(move |j| (i, j)))
        .map(|(i, j)| at(i, j) * at(i + shift[0], j + shift[1]))
        .sum();
    sum / 90_000.0
}

#[test]
fn the_hash_is_white() {
    for seed in 0..4 {
        let texture = texture(Source::Random, seed);
        let at = |k: i32| texture.at(ORIGIN[0] + f64::from(k / 300), ORIGIN[1] + f64::from(k % 300), 0.0);
        let mean = (0..90_000).map(at).sum::<f64>() / 90_000.0;
        // Five standard deviations of 90000 independent values of variance 1/3.
        assert!(mean.abs() < 5.0 * 0.5774 / 300.0, "seed {seed}: mean {mean}");
        let variance = moment(&texture, [0, 0]);
        assert!((variance - 1.0 / 3.0).abs() < 5.0 * 0.298 / 300.0, "seed {seed}: variance {variance}");
        for shift in [[0, 1], [1, 0], [1, 1], [1, -1], [2, 0], [0, 2], [16, 0], [0, 64], [128, 128]] {
            let moment = moment(&texture, shift);
            assert!(moment.abs() < 5.0 * 0.3333 / 300.0, "seed {seed}: {moment} at {shift:?}");
        }
    }
}

#[test]
fn a_stored_region_has_zero_mean() {
    for seed in 0..4 {
        let weight = |k: i32| if k == 0 || k == 32 { 0.5 } else { 1.0 };
        let points = (0..=32).flat_map(|i| (0..=32).map(move |j| (i, j)));
        let sum: f64 = points
            .map(|(i, j)| {
                weight(i) * weight(j) * pattern(Source::Pattern, seed, [f64::from(i), f64::from(j)])
            })
            .sum();
        assert!((sum / 1024.0).abs() < 1e-8, "seed {seed}: {sum}");
    }
}

proptest! {
    /// Within a cell of a line the pattern leaves its value there as `smooth` does: by 3 u^2 of at most 2. So
    /// neither it nor its first derivative jumps; every region boundary is such a line.
    #[test]
    fn no_kink_on_any_lattice_line(
        source in sources(), seed in any::<u64>(), line in -70i32..70, other in -70.0..70.0f64, u in 1e-6..0.5f64,
    ) {
        for along in [false, true] {
            let at = |way: f64| {
                let place = f64::from(line) + way;
                pattern(source, seed, if along { [place, other] } else { [other, place] })
            };
            for way in [u, -u] {
                prop_assert!((at(way) - at(0.0)).abs() <= 6.0 * u * u + 1e-13);
            }
        }
    }

    #[test]
    fn a_stored_region_is_mirrored_at_every_edge(
        seed in any::<u64>(), edge in -3i32..4, way in 0.0..32.0f64, other in -90.0..90.0f64,
    ) {
        let edge = f64::from(edge) * REGION;
        let ahead = pattern(Source::Pattern, seed, [edge + way, other]);
        prop_assert!((ahead - pattern(Source::Pattern, seed, [edge - way, other])).abs() < 1e-12);
        let ahead = pattern(Source::Pattern, seed, [other, edge + way]);
        prop_assert!((ahead - pattern(Source::Pattern, seed, [other, edge - way])).abs() < 1e-12);
    }

    #[test]
    fn bounded_and_repeatable(source in sources(), seed in any::<u64>(), x in -1e5..1e5f64, y in -1e5..1e5f64) {
        let value = pattern(source, seed, [x, y]);
        prop_assert!(value.abs() <= 1.0);
        prop_assert_eq!(value, pattern(source, seed, [x, y]));
    }
}

/// The pattern of one layer at eight places in vectors of a width.
fn side_by_side<S: Real>(vectors: Level, lattice: &Lattice, [x, y]: &[[f64; LANES]; 2]) -> [S; LANES] {
    #[inline(always)]
    fn of<L: Simd, S: Real>(simd: L, lattice: &Lattice, x: &[f64; LANES], y: &[f64; LANES]) -> [S; LANES] {
        let (places, mut out) = ([eight(simd, x), eight(simd, y)], [S::ZERO; LANES]);
        match lattice {
            Lattice::Stored(lattice) => lattice.eight::<L, S>(places).store_slice(&mut out),
            Lattice::Hashed(lattice) => {
                // The same in both halves, one of them from the far end.
                let turned =
                    places.map(|places| eight(simd, &std::array::from_fn(|lane| places[LANES - 1 - lane])));
                let [first, second] = lattice.sixteen::<L, S>([places, turned]).halves();
                first.store_slice(&mut out);
                assert!((0..LANES).all(|lane| out[lane] == second[LANES - 1 - lane]));
            }
        }
        out
    }
    dispatch!(vectors, simd => of(simd, lattice, x, y))
}

proptest! {
    #[test]
    fn eight_are_places_one_by_one(
        seed in any::<u64>(), place in proptest::array::uniform2(-1e5..1e5f64), way in proptest::array::uniform2(-15.0..15.0f64),
    ) {
        let places: [[f64; LANES]; 2] =
            [0, 1].map(|axis| std::array::from_fn(|lane| place[axis] + lane as f64 * way[axis]));
        for (source, vectors) in [Source::Random, Source::Pattern]
            .into_iter()
            .flat_map(|source| [(source, Level::new()), (source, Level::baseline())])
        {
            let texture = texture(source, seed);
            let grain = &texture.grains()[0];
            let double: [f64; LANES] = side_by_side(vectors, grain.lattice(), &places);
            let single: [f32; LANES] = side_by_side(vectors, grain.lattice(), &places);
            for lane in 0..LANES {
                let alone = grain.pattern(places[0][lane], places[1][lane]);
                prop_assert_eq!(double[lane], alone, "{:?}, lane {}", source, lane);
                prop_assert!((f64::from(single[lane]) - alone).abs() < 1e-6, "{source:?}, lane {lane}");
            }
        }
    }
}

#[test]
fn between_lattice_points_the_smooth_step_joins() {
    for source in [Source::Random, Source::Pattern] {
        let at = |x: f64, y: f64| pattern(source, 5, [x, y]);
        let (near, far) = (at(7.0, 9.0), at(8.0, 9.0));
        assert!((at(7.25, 9.0) - (near + 0.15625 * (far - near))).abs() < 1e-14);
        let middle = 0.25 * (near + far + at(7.0, 10.0) + at(8.0, 10.0));
        assert!((at(7.5, 9.5) - middle).abs() < 1e-14);
    }
}

#[test]
fn seeds_and_layers_are_different_patterns_that_never_change() {
    assert_ne!(pattern(Source::Random, 1, [0.0; 2]), pattern(Source::Random, 2, [0.0; 2]));
    assert_ne!(pattern(Source::Pattern, 1, [0.0; 2]), pattern(Source::Pattern, 2, [0.0; 2]));
    let layer = Layer { cell: 1.0, amplitude: 1.0, range: 100.0 };
    let two = Texture::new(&[layer; 2], Source::Random, 1, REGION, ORIGIN).unwrap();
    assert_ne!(two.grains()[0].pattern(3.0, 4.0), two.grains()[1].pattern(3.0, 4.0));
    assert_eq!(pattern(Source::Random, 1, [3.0, -4.0]), PINNED[0]);
    assert_eq!(pattern(Source::Pattern, 1, [3.0, -4.0]), PINNED[1]);
}

/// Pictures are named by their seed.
const PINNED: [f64; 2] = [0.6489851474761963, 0.6673904061317444];

#[test]
fn layers_fade_linearly_to_nothing() {
    let layer = Layer { cell: 0.5, amplitude: 0.2, range: 40.0 };
    let texture = Texture::new(&[layer], Source::Random, 3, REGION, ORIGIN).unwrap();
    let near = texture.at(11.3, 17.9, 0.0);
    assert!((texture.at(11.3, 17.9, 10.0) - 0.75 * near).abs() < 1e-16);
    assert_eq!(texture.at(11.3, 17.9, 40.0), 0.0);
    assert_eq!(texture.at(11.3, 17.9, f64::INFINITY), 0.0);
    let far = Layer { cell: 5.0, amplitude: 0.1, range: 150.0 };
    let both = Texture::new(&[layer, far], Source::Pattern, 3, REGION, ORIGIN).unwrap();
    assert_eq!(both.reach(), 150.0);
    assert!((both.bound() - 0.3).abs() < 1e-16);
    // 32 m in cells of about 5 m: six of 5.33 m.
    assert_eq!(both.grains()[1].layer().cell, REGION / 6.0);
}

#[test]
fn impossible_textures_are_refused() {
    let good = Layer { cell: 1.0, amplitude: 0.1, range: 100.0 };
    let refused = |layers: &[Layer], region_size, origin| {
        Texture::new(layers, Source::Random, 0, region_size, origin).unwrap_err()
    };
    assert_eq!(refused(&[], REGION, ORIGIN), TextureError::LayerCount(0));
    assert_eq!(refused(&[good; 9], REGION, ORIGIN), TextureError::LayerCount(9));
    let cell = refused(&[good, Layer { cell: 0.0, ..good }], REGION, ORIGIN);
    assert_eq!(cell, TextureError::Cell { layer: 1, cell: 0.0 });
    let amplitude = refused(&[Layer { amplitude: 1.1, ..good }], REGION, ORIGIN);
    assert_eq!(amplitude, TextureError::Amplitude { layer: 0, amplitude: 1.1 });
    assert!(matches!(
        refused(&[Layer { range: f64::NAN, ..good }], REGION, ORIGIN),
        TextureError::Range { layer: 0, .. }
    ));
    assert!(matches!(refused(&[good], 0.0, ORIGIN), TextureError::Regions { .. }));
    assert!(matches!(refused(&[good], REGION, [f64::NAN, 0.0]), TextureError::Regions { .. }));
}
