//! Colour, and albedo from place to place.

use std::sync::Arc;

use crate::scenes::{landscape, laws, place, plane, planes, pose, settings, sun, value};
use generator::{PlaneKind, Planes};
use landscape::{AlbedoMap, Landscape, Layer, Source, Texels, Texture};
use quantities::luminance;
use scenario::{Curvature, Laws, PixelRule, Projection, Scenery, TextureInShadow};

const PIXELS: [u32; 2] = [40, 30];

fn mapped(texels: Texels, size: [usize; 2]) -> Arc<Landscape> {
    let map = AlbedoMap::new([60.0, 60.0, 140.0, 140.0], size, texels).unwrap();
    Arc::new((*landscape(plane(50.0, [4, 4], 0.0, [0.0; 2]), 0.5)).clone().with_albedo_map(Some(map)))
}

/// Straight down from 100 m over the middle of the map.
fn from_above(ground: &Arc<Landscape>, rule: PixelRule) -> Planes {
    let settings =
        settings(PIXELS[0], PIXELS[1], laws(Projection::Exact, Curvature::None, rule), [1.0, 150.0]);
    planes(ground, Scenery::still(sun(90.0, 30.0)), &settings, &pose([100.0, 100.0, 100.0], -90.0, 0.0))
}

fn channels(found: &Planes, index: usize) -> [f64; 3] {
    PlaneKind::COLOUR.map(|kind| value(found, kind, index))
}

/// Level ground returns its albedo times sin e.
#[test]
fn a_checkerboard_of_colours_is_seen_where_it_lies() {
    let [white, red] = [[1.0, 0.75, 0.5], [0.25, 0.0, 0.125f32]];
    let texels = (0..16).map(|k| if (k / 4 + k % 4) % 2 == 0 { white } else { red }).collect();
    let ground = mapped(Texels::Colour(texels), [4, 4]);
    let found = from_above(&ground, PixelRule::Centre);
    let settings = settings(
        PIXELS[0],
        PIXELS[1],
        laws(Projection::Exact, Curvature::None, PixelRule::Centre),
        [1.0, 150.0],
    );
    let pose = pose([100.0, 100.0, 100.0], -90.0, 0.0);
    let (mut centres, mut outside) = (0, 0);
    for index in 0..(PIXELS[0] * PIXELS[1]) as usize {
        let [x, y] = place(&settings, &pose, index, value(&found, PlaneKind::Range, index));
        let expected = checked([x, y], [white, red]);
        for (channel, expected) in channels(&found, index).into_iter().zip(expected) {
            assert!((channel - 0.5 * expected).abs() < 1e-6, "{x} {y}: {channel} {expected}");
        }
        centres += usize::from((expected[0] - 0.25).abs() < 0.1);
        outside += usize::from(expected == [0.5; 3]);
    }
    // Near the middle of dark fields: 162 m2 of the map are seen, at 4.17 m2 a pixel, so 39 pixels but for those on edges.
    assert!((35..=43).contains(&centres) && outside > 100, "{centres} {outside}");
}

/// Four fields of 20 m a side, north above, mixed between their centres in proportion; 0.5 beside them.
fn checked([x, y]: [f64; 2], fields: [[f32; 3]; 2]) -> [f64; 3] {
    if (x - 100.0).abs() > 40.0 || (y - 100.0).abs() > 40.0 {
        return [0.5; 3];
    }
    let field = |line: i32, column: i32| {
        fields[((line.clamp(0, 3) + column.clamp(0, 3)) % 2) as usize].map(f64::from)
    };
    let (down, right) = ((140.0 - x) / 20.0 - 0.5, (y - 60.0) / 20.0 - 0.5);
    let (line, column) = (down.floor(), right.floor());
    std::array::from_fn(|channel| {
        let of = |i: i32, j: i32| field(line as i32 + i, column as i32 + j)[channel];
        let (v, u) = (down - line, right - column);
        (1.0 - v) * ((1.0 - u) * of(0, 0) + u * of(0, 1)) + v * ((1.0 - u) * of(1, 0) + u * of(1, 1))
    })
}

#[test]
fn intensity_is_the_luminance_of_colour_and_the_channel_of_grey() {
    for rule in [PixelRule::Centre, PixelRule::LineMean] {
        let texels = (0..64).map(|k| [0.015 * k as f32, 0.5, 1.0 - 0.015 * k as f32]).collect();
        let coloured = from_above(&mapped(Texels::Colour(texels), [8, 8]), rule);
        let grey =
            from_above(&mapped(Texels::Grey((0..64).map(|k| 0.015 * k as f32).collect()), [8, 8]), rule);
        let mut colours = 0;
        for index in 0..(PIXELS[0] * PIXELS[1]) as usize {
            let colour = channels(&coloured, index);
            let intensity = value(&coloured, PlaneKind::Intensity, index);
            assert!((intensity - luminance(colour)).abs() < 1e-7, "{index}");
            colours += usize::from(colour[0] != colour[1]);
            let intensity = value(&grey, PlaneKind::Intensity, index);
            assert_eq!(channels(&grey, index), [intensity; 3], "{index}");
        }
        assert!(colours > 500, "{colours}");
    }
}

/// Two fields of equal luminance: their edge is no edge in grey, and the quadrature must follow it all the same.
#[test]
fn the_mean_of_a_line_follows_an_edge_of_colour_alone() {
    let level = (0.2126 / 0.7152) as f32;
    // A hundred lines of texels: an edge of 0.8 m, less than a line, in the middle.
    let texels = (0..100).map(|line| if line < 50 { [1.0, 0.0, 0.0] } else { [0.0, level, 0.0] }).collect();
    let found = from_above(&mapped(Texels::Colour(texels), [1, 100]), PixelRule::LineMean);
    let height = 2.0 * libm::tan(quantities::radians(15.0)) * 100.0 / 30.0;
    let column = 20;
    let seen = |kind| -> Vec<f64> {
        (0..30).map(|line| value(&found, kind, line * PIXELS[0] as usize + column)).collect()
    };
    let (red, intensity) = (seen(PlaneKind::Red), seen(PlaneKind::Intensity));
    // Line 15 begins at the nadir, in the middle of the slope from one field to the other.
    let share = 0.4 * 0.5 * 0.5 / height;
    assert!((red[14] - 0.5 * (1.0 - share)).abs() < 2e-4, "{} {share}", red[14]);
    assert!((red[15] - 0.5 * share).abs() < 2e-4, "{} {share}", red[15]);
    assert_eq!((red[10], red[20]), (0.5, 0.0));
    for line in 10..20 {
        assert!((intensity[line] - 0.5 * 0.2126).abs() < 1e-6, "{line}");
    }
}

/// Texture darkens and brightens a colour and does not shift it: its luminance is that of texture on grey ground.
#[test]
fn texture_has_the_colour_of_the_ground() {
    let red = [0.75, 0.25, 0.0625];
    let layers = [Layer { cell: 3.0, amplitude: 0.1, range: 500.0 }];
    let texture = Texture::new(&layers, Source::Random, 11, 50.0, [0.0; 2]).unwrap();
    for law in [TextureInShadow::On, TextureInShadow::Off] {
        let laws =
            Laws { texture_in_shadow: law, ..laws(Projection::Exact, Curvature::None, PixelRule::Centre) };
        let settings = settings(PIXELS[0], PIXELS[1], laws, [1.0, 150.0]);
        let drawn = |texels| {
            let ground = Landscape::clone(&mapped(texels, [1, 1])).with_texture(Some(texture.clone()));
            let (scenery, pose) = (Scenery::still(sun(90.0, 30.0)), pose([100.0, 100.0, 100.0], -90.0, 0.0));
            planes(&Arc::new(ground), scenery, &settings, &pose)
        };
        let coloured = drawn(Texels::Colour(vec![red.map(|channel| channel as f32)]));
        let grey = drawn(Texels::Grey(vec![luminance(red) as f32]));
        let (mut grains, mut dark) = (0, 0);
        // The map fills the picture from top to bottom, and not from side to side.
        for index in (0..(PIXELS[0] * PIXELS[1]) as usize).filter(|index| (5..35).contains(&(index % 40))) {
            let expected = value(&grey, PlaneKind::Intensity, index);
            let colour = channels(&coloured, index);
            for (channel, share) in colour.into_iter().zip(red) {
                assert!(
                    (channel - expected * share / luminance(red)).abs() < 1e-6,
                    "{law:?} {index}: {colour:?}"
                );
            }
            grains += usize::from((expected - 0.5 * luminance(red)).abs() > 0.02);
            dark += usize::from(expected < 0.5 * luminance(red) - 0.05);
        }
        assert!(grains > 300 && dark > 50, "{grains} {dark}");
    }
}
