//! Noise, law, phosphor, spot and interlace against closed forms.

use hardware_model::{AnalogParts, MemoryParts, PictureTubeParts};
use parts::time_constant;
use proptest::prelude::{prop_assert, proptest};
use proptest::sample::select;
use rayon::ThreadPoolBuilder;

use super::{PictureTube, ScanRaster};

const COLUMNS: usize = 500;
const LINES: usize = 300;
const RASTER: ScanRaster =
    ScanRaster { columns: COLUMNS, lines: LINES, width: 1.5, refresh: 60.0, showings: 2, active: 0.8 };
const IDEAL: PictureTubeParts = PictureTubeParts::IDEAL;

/// A display of 8 shades of grey, or without noise.
fn display(picture_tube: PictureTubeParts, is_noisy: bool) -> PictureTube {
    let memory = MemoryParts { grey: is_noisy.then_some(8), ..MemoryParts::IDEAL };
    PictureTube::new(&AnalogParts { memory, picture_tube, ..AnalogParts::ideal() }, &RASTER, 1.0, 1970)
}

fn shown(display: &PictureTube, [frame, showing]: [u64; 2], read: &[&[f32]]) -> Vec<f32> {
    let mut light = vec![9.0; COLUMNS * LINES];
    display.show(frame, showing, read, &mut light, &mut Vec::new());
    light
}

fn even(reflectivity: f32) -> Vec<f32> {
    vec![reflectivity; COLUMNS * LINES]
}

fn mean(values: impl Iterator<Item = f64> + Clone) -> f64 {
    values.clone().sum::<f64>() / values.count() as f64
}

fn moments(values: impl Iterator<Item = f64> + Clone) -> [f64; 2] {
    let mean_value = mean(values.clone());
    [mean_value, mean(values.map(|value| (value - mean_value) * (value - mean_value))).sqrt()]
}

/// Correlation of two rows of numbers.
fn correlation(a: &[f32], b: &[f32]) -> f64 {
    let [a, b] = [a, b].map(|row| row.iter().map(|value| f64::from(*value)));
    let ([mean_a, sigma_a], [mean_b, sigma_b]) = (moments(a.clone()), moments(b.clone()));
    mean(a.zip(b).map(|(a, b)| (a - mean_a) * (b - mean_b))) / (sigma_a * sigma_b)
}

/// Mean and deviation of `max(x, 0)`, x normal.
fn rectified(mean: f64, sigma: f64) -> [f64; 2] {
    let z = mean / sigma;
    let below = 0.5 * libm::erfc(-z / 2.0f64.sqrt());
    let density = libm::exp(-0.5 * z * z) / (2.0 * std::f64::consts::PI).sqrt();
    let first = sigma * density + mean * below;
    let second = (mean * mean + sigma * sigma) * below + mean * sigma * density;
    [first, (second - first * first).sqrt()]
}

/// Levels of 255 on a display of exponent 2.2, which undoes the tube's: the drive above the cut-off, and none below.
#[test]
fn noise_is_quiet_in_the_sky_and_full_on_lit_ground() {
    let (cut_off, sigma) = (0.03, 1.0 / 48.0);
    let tube = display(PictureTubeParts { correction: 2.2, gamma: 2.2, cut_off, ..IDEAL }, true);
    let mut deviations = Vec::new();
    for reflectivity in [0.0, 0.05, 0.5] {
        let light = shown(&tube, [3, 1], &[&even(reflectivity)]);
        let levels = light.iter().map(|light| 255.0 * libm::pow(f64::from(*light), 1.0 / 2.2));
        let [mean, deviation] = moments(levels);
        let video = libm::pow(f64::from(reflectivity), 1.0 / 2.2);
        let above = 1.0 - cut_off;
        let expected = rectified((video - cut_off) / above, sigma / above).map(|drive| 255.0 * drive);
        assert!((mean - expected[0]).abs() < 0.05, "{reflectivity}: {mean}, {expected:?}");
        assert!((deviation / expected[1] - 1.0).abs() < 0.02, "{reflectivity}: {deviation}, {expected:?}");
        deviations.push(moments(light.iter().map(|light| f64::from(*light)))[1]);
    }
    // Of the light itself the deviation grows with the light.
    assert!(100.0 * deviations[0] < deviations[1] && 3.0 * deviations[1] < deviations[2], "{deviations:?}");
}

/// Along a line noise has the correlation of the band, and between lines none.
#[test]
fn noise_has_the_band_of_the_amplifier() {
    let bandwidth = 2e6;
    let tube = display(PictureTubeParts { bandwidth: Some(bandwidth), ..IDEAL }, true);
    let light = shown(&tube, [7, 0], &[&even(0.5)]);
    let [mean, deviation] = moments(light.iter().map(|light| f64::from(*light)));
    assert!((mean - 0.5).abs() < 1e-3 && (48.0 * deviation - 1.0).abs() < 0.03, "{mean}, {deviation}");
    let step = 0.8 / (60.0 * LINES as f64 * COLUMNS as f64);
    for steps in 1..6 {
        let pairs = light.chunks(COLUMNS).map(|line| correlation(&line[steps..], &line[..COLUMNS - steps]));
        let found = pairs.sum::<f64>() / LINES as f64;
        let expected = libm::exp(-(steps as f64) * step / time_constant(bandwidth));
        // A line of 500 pixels has its own mean taken off.
        assert!((found - expected).abs() < 0.012, "{steps}: {found}, {expected}");
    }
    let lines = correlation(&light[COLUMNS..], &light[..(LINES - 1) * COLUMNS]);
    assert!(lines.abs() < 0.02, "{lines}");
}

#[test]
fn every_field_has_noise_of_its_own() {
    let tube = display(IDEAL, true);
    let fields = [[4, 0], [4, 1], [5, 0]].map(|field| shown(&tube, field, &[&even(0.5)]));
    for (a, b) in [(0, 1), (1, 2), (0, 2)] {
        let found = correlation(&fields[a], &fields[b]);
        assert!(found.abs() < 4.0 / ((COLUMNS * LINES) as f64).sqrt(), "{found}");
    }
    assert!(tube.repeats_differ() && !display(IDEAL, false).repeats_differ());
}

#[test]
fn a_field_has_its_bits_by_any_number_of_threads() {
    let tube =
        display(PictureTubeParts { gamma: 2.2, bandwidth: Some(4e6), tv_lines: Some(500), ..IDEAL }, true);
    let on = |threads| {
        let pool = ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| shown(&tube, [4, 1], &[&even(0.5)]))
    };
    assert_eq!(on(1), on(3));
}

/// An edge in the video passes the lag: a straight rise of one pixel, then the rest by `e^(-dt / tau)`.
#[test]
fn the_video_has_the_band_of_the_amplifier() {
    let bandwidth = 2e6;
    let tube = display(PictureTubeParts { bandwidth: Some(bandwidth), ..IDEAL }, false);
    let edge: Vec<f32> =
        (0..COLUMNS * LINES).map(|pixel| if pixel % COLUMNS < 200 { 0.3 } else { 0.8 }).collect();
    let line = &shown(&tube, [0, 0], &[&edge])[10 * COLUMNS..11 * COLUMNS];
    let ratio = 0.8 / (60.0 * LINES as f64 * COLUMNS as f64) / time_constant(bandwidth);
    assert!(line[..200].iter().all(|light| (light - 0.3).abs() < 1e-6));
    for (steps, light) in line[200..].iter().enumerate() {
        let rest = 0.5 * (1.0 - libm::exp(-ratio)) / ratio * libm::exp(-ratio * steps as f64);
        assert!((f64::from(*light) - (0.8 - rest)).abs() < 1e-5, "{steps}: {light}");
    }
}

#[test]
fn the_spot_keeps_the_light_and_has_its_width() {
    let tube = display(PictureTubeParts { tv_lines: Some(60), ..IDEAL }, false);
    let mut point = even(0.0);
    point[150 * COLUMNS + 250] = 1.0;
    let light = shown(&tube, [0, 0], &[&point]);
    let sum = |moment: &dyn Fn(f64, f64) -> f64| -> f64 {
        let places = light.iter().enumerate();
        let parts = places.map(|(pixel, light)| {
            let (x, y) = ((pixel % COLUMNS) as f64 - 250.0, (pixel / COLUMNS) as f64 - 150.0);
            moment(x, y) * f64::from(*light)
        });
        parts.sum()
    };
    let whole = sum(&|_, _| 1.0);
    assert!((whole - 1.0).abs() < 1e-4, "{whole}");
    let across_lines = 0.375 / 60.0 * LINES as f64;
    let along_lines = 0.375 / 60.0 * COLUMNS as f64 / 1.5;
    for (found, sigma) in [(sum(&|x, _| x * x), along_lines), (sum(&|_, y| y * y), across_lines)] {
        assert!((found.sqrt() / sigma - 1.0).abs() < 0.01, "{found}, {sigma}");
    }
}

/// A picture that goes dark: of a scan k scans before, `(1 - d) d^k` is left.
#[test]
fn light_decays_between_fields() {
    let decay = 0.05;
    let tube = display(PictureTubeParts { phosphor: decay, ..IDEAL }, false);
    let left = libm::pow(10.0, -1.0 / 60.0 / decay);
    assert_eq!(tube.frames_before(0), 8);
    let (dark, lit) = (even(0.0), even(0.8));
    for age in 0..4 {
        for showing in 0..2 {
            let mut read = vec![dark.as_slice(); age + 1];
            read.push(&lit);
            // The lit frame and all before it are one picture.
            let found = f64::from(shown(&tube, [50, showing], &read)[777]);
            let scans = 2 * age as i32 + showing as i32 + 1;
            let expected = 0.8 * libm::pow(left, f64::from(scans));
            assert!((found - expected).abs() < 2e-5, "{age}, {showing}: {found}, {expected}");
        }
    }
    let still = shown(&tube, [50, 1], &[&lit]);
    assert!(still.iter().all(|light| (light - 0.8).abs() < 1e-6));
}

#[test]
fn a_field_leaves_the_other_lines_to_the_field_before() {
    let tube = display(PictureTubeParts { fields: 2, ..IDEAL }, false);
    let (now, before) = (even(0.7), even(0.2));
    let first = shown(&tube, [6, 0], &[&now, &before]);
    for (line, light) in first.chunks(COLUMNS).enumerate() {
        let expected = if line % 2 == 0 { 0.7 } else { 0.2 };
        assert!(light.iter().all(|light| *light == expected), "{line}");
    }
    assert_eq!((tube.kept_showing(), tube.frames_before(0), tube.frames_before(1)), (1, 1, 0));
    assert_eq!(shown(&tube, [6, 1], &[&now]), now);
}

/// Contrast makes the white of the scenario white; the cut-off takes the dark, and a tube without correction darkens greys.
#[test]
fn light_follows_the_law_of_the_tube() {
    for (correction, gamma, cut_off, white) in
        [(1.0, 1.0, 0.0, 0.45), (2.2, 2.2, 0.05, 1.3), (1.0, 2.5, 0.1, 0.8)]
    {
        let picture_tube = PictureTubeParts { correction, gamma, cut_off, ..IDEAL };
        let parts = AnalogParts { picture_tube, ..AnalogParts::ideal() };
        let tube = PictureTube::new(&parts, &RASTER, white, 1970);
        for reflectivity in [0.0, 0.001, 0.1, 0.3, white, 1.4 * white] {
            let drive = libm::pow(reflectivity / white, 1.0 / correction);
            let expected = white * libm::pow(((drive - cut_off) / (1.0 - cut_off)).max(0.0), gamma);
            let found = f64::from(shown(&tube, [0, 0], &[&even(reflectivity as f32)])[5]);
            assert!(
                (found - expected).abs() < 1e-6 * white,
                "{reflectivity} of {white}: {found}, {expected}"
            );
        }
    }
}

#[test]
fn a_display_without_figures_keeps_every_bit() {
    let picture: Vec<f32> = (0..COLUMNS * LINES).map(|pixel| libm::sinf(pixel as f32).abs()).collect();
    assert_eq!(shown(&display(IDEAL, false), [9, 1], &[&picture]), picture);
}

proptest! {
    #[test]
    fn any_display_shows_light(
        columns in 1usize..9, lines in 1usize..9, fields in 1u32..3, phosphor in 0.0..1.0f64, showings in 1u64..7,
        [gamma, correction] in [1.0..4.0f64, 1.0..4.0], cut_off in 0.0..0.5f64, white in select(vec![1e-6, 0.4, 1e6]),
        bandwidth in proptest::option::of(1.0..1e12f64), tv_lines in proptest::option::of(2u32..5000),
        seed: u64, frame: u64, value in 0.0..2.0f32,
    ) {
        let picture_tube = PictureTubeParts { bandwidth, correction, gamma, cut_off, phosphor, tv_lines, fields };
        let memory = MemoryParts { grey: Some(2), ..MemoryParts::IDEAL };
        let parts = AnalogParts { memory, picture_tube, spread: true, ..AnalogParts::ideal() };
        let tube = PictureTube::new(&parts, &ScanRaster { columns, lines, showings, ..RASTER }, white, seed);
        let (read, mut light) = (vec![value; columns * lines], vec![f32::NAN; columns * lines]);
        tube.show(frame, tube.kept_showing(), &[&read], &mut light, &mut Vec::new());
        prop_assert!(light.iter().all(|light| light.is_finite() && *light >= 0.0), "{light:?}");
    }
}

/// Lines come in the order of time: those of the first field, then those between them; an odd number leaves the second field one short.
#[test]
fn lines_come_field_by_field() {
    let parts = PictureTubeParts { fields: 2, ..IDEAL };
    let raster = ScanRaster { lines: 5, ..RASTER };
    let display =
        PictureTube::new(&AnalogParts { picture_tube: parts, ..AnalogParts::ideal() }, &raster, 0.5, 7);
    assert_eq!(display.lines_scanned(), 6);
    let read: Vec<f32> = (0..5 * COLUMNS).map(|pixel| 0.1 * (pixel / COLUMNS) as f32).collect();
    let first = |number: u32| display.drive(3, number, &read)[COLUMNS / 2];
    let drives: Vec<f64> = (0..6).map(first).collect();
    let expected = [0.0, 0.4, 0.8, 0.2, 0.6, 0.0];
    assert!(
        drives.iter().zip(expected).all(|(found, expected)| (found - expected).abs() < 1e-6),
        "{drives:?}"
    );
    // One field a picture: every showing scans all lines from the top.
    assert_eq!((self::display(IDEAL, false).lines_scanned(), LINES * 2), (600, 600));
}

/// What drives the tube is what lights it: its law over the drive is the light of the line, noise and all.
#[test]
fn the_drive_of_a_line_is_what_lights_it() {
    let parts = PictureTubeParts { correction: 2.2, gamma: 2.5, cut_off: 0.05, fields: 2, ..IDEAL };
    let display = display(parts, true);
    let read: Vec<f32> = (0..LINES * COLUMNS).map(|pixel| (pixel % 97) as f32 / 97.0).collect();
    let light = shown(&display, [4, 1], &[&read]);
    for (number, line) in [(0, 0), (7, 14), (150, 1), (299, 299)] {
        let drive = display.drive(4, number, &read);
        let lit = &light[line * COLUMNS..][..COLUMNS];
        for (drive, light) in drive.iter().zip(lit) {
            let expected = libm::pow(((drive - 0.05) / 0.95).max(0.0), 2.5);
            assert!((expected - f64::from(*light)).abs() < 1e-5, "line {line}: {drive} gives {light}");
        }
    }
    let clean = self::display(parts, false).drive(4, 0, &even(0.3));
    let expected = libm::pow(0.3, 1.0 / 2.2);
    assert!(clean.iter().all(|drive| (drive - expected).abs() < 1e-5), "{}", clean[0]);
}
