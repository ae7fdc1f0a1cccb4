//! Spot, registration and residue in closed form.

use std::f64::consts::PI;

use hardware_model::MemoryParts;
use parts::Spread;
use proptest::prelude::{prop_assert, proptest};

use super::{Tube, TubeRaster, memory_frames};

const SWEEPS: usize = 300;
const LINES: usize = 240;
const RASTER: TubeRaster = TubeRaster { sweeps: SWEEPS, lines: LINES, width: 1.5 };

fn tube(parts: MemoryParts) -> Tube {
    Tube::new(&parts, RASTER, 1970)
}

fn sharp(tv_lines: u32) -> MemoryParts {
    MemoryParts { tv_lines: Some(tv_lines), ..MemoryParts::IDEAL }
}

fn store(value: impl Fn(f64, f64) -> f64) -> Vec<f32> {
    let cells = (0..SWEEPS).flat_map(|sweep| (0..LINES).map(move |line| (sweep as f64, line as f64)));
    cells.map(|(sweep, line)| value(sweep, line) as f32).collect()
}

fn read(tube: &Tube, frame: u64, mut store: Vec<f32>) -> Vec<f32> {
    tube.read(frame, &mut store, &mut Vec::new());
    store
}

/// Half of the swing along a column or row of the middle.
fn swing(store: &[f32], across: bool) -> f64 {
    let values: Vec<f32> =
        (60..180).map(|k| if across { store[k * LINES + 100] } else { store[100 * LINES + k] }).collect();
    let most = values.iter().copied().fold(f32::MIN, f32::max);
    let least = values.iter().copied().fold(f32::MAX, f32::min);
    f64::from(most - least) / 2.0
}

#[test]
fn half_of_the_finest_pattern_is_left_in_both_directions() {
    // 200 sweeps and 240 lines a height: a quarter of a cycle a cell is 50 or 60 cycles a height.
    for (lines, across) in [(120, false), (100, true)] {
        let waves = store(|sweep, line| 0.5 + 0.5 * libm::cos(0.5 * PI * if across { sweep } else { line }));
        let found = swing(&read(&tube(sharp(lines)), 0, waves), across);
        assert!((found - 0.25).abs() < 0.004, "{lines}: {found}");
        let coarse =
            store(|sweep, line| 0.5 + 0.5 * libm::cos(0.25 * PI * if across { sweep } else { line }));
        let found = swing(&read(&tube(sharp(lines)), 0, coarse), across);
        // The response is a Gaussian: half the frequency has its fourth root.
        assert!((found - 0.5 * 0.5f64.sqrt().sqrt()).abs() < 0.004, "{lines}: {found}");
    }
}

#[test]
fn an_edge_spreads_as_the_integral_of_the_spot() {
    let edge = read(&tube(sharp(60)), 0, store(|_, line| if line < 120.0 { 0.0 } else { 1.0 }));
    let sigma = 0.375 / 60.0 * 240.0;
    for line in 100..140 {
        // The sum over cells is the integral from edge to edge of cells.
        let expected = 0.5 * libm::erfc((119.5 - line as f64) / (sigma * 2.0f64.sqrt()));
        assert!((f64::from(edge[150 * LINES + line]) - expected).abs() < 0.005, "{line}");
    }
}

#[test]
fn a_spot_much_smaller_than_a_cell_takes_nothing_away() {
    for lines in [300, 500, 900, 2000, 100_000] {
        let seen = read(&tube(sharp(lines)), 0, store(|sweep, _| if sweep == 150.0 { 1.0 } else { 0.0 }));
        let (middle, beside) = (seen[150 * LINES + 9], seen[151 * LINES + 9]);
        assert!(seen.iter().all(|value| (0.0..=1.0).contains(value)), "{lines}");
        assert!((middle + 2.0 * beside - 1.0).abs() < 0.02, "{lines}: {middle}, {beside}");
        assert!(lines < 100_000 || middle > 0.9999, "{middle}");
    }
}

#[test]
fn an_even_picture_is_even_to_its_borders() {
    let parts = MemoryParts { registration: 0.03, ..sharp(300) };
    let seen = read(&tube(parts), 0, vec![0.6; SWEEPS * LINES]);
    assert!(seen.iter().all(|value| (value - 0.6).abs() < 1e-6));
}

/// Where the reading beam stands at cell (150, 120), in cells from there, by ramps.
fn displacement(tube: &Tube, frame: u64, at: [usize; 2]) -> [f64; 2] {
    let [sweep, line] = at;
    let cell = sweep * LINES + line;
    let across = read(tube, frame, store(|sweep, _| sweep))[cell];
    let along = read(tube, frame, store(|_, line| line))[cell];
    [f64::from(across) - sweep as f64, f64::from(along) - line as f64]
}

#[test]
fn registration_is_a_field_that_stays() {
    let parts = MemoryParts { registration: 0.007, ..sharp(300) };
    let tube = tube(parts);
    let spread = Spread::new(1970);
    let deviate = |part: &str| 0.007 * spread.deviate(&format!("sweep-memory.{part}"), 0);
    for at in [[150, 120], [60, 60], [240, 200]] {
        let found = displacement(&tube, 3, at);
        let places = [[at[0] as f64 - 149.5, 200.0], [at[1] as f64 - 119.5, 240.0]];
        for ((found, axis), [from_middle, height]) in found.iter().zip(["across", "along"]).zip(places) {
            let expected =
                deviate(&format!("shift-{axis}")) * height + deviate(&format!("scale-{axis}")) * from_middle;
            // Spots much smaller than a cell are placed to a tenth of it.
            assert!((found - expected).abs() < 0.1, "{axis} at {at:?}: {found}, {expected}");
        }
        assert_eq!(found, displacement(&tube, 4, at));
        let told = RASTER.read_at(&parts, 1970, 3, at.map(|cell| cell as f64));
        let off = [0, 1].map(|axis| (told[axis] - at[axis] as f64 - found[axis]).abs());
        assert!(off.iter().all(|off| *off < 0.1), "{at:?}: {told:?}, {found:?}");
    }
}

#[test]
fn two_tubes_take_turns() {
    let pair = tube(MemoryParts { registration: 0.02, tubes: 2, ..MemoryParts::IDEAL });
    let places: Vec<_> = (0..4).map(|frame| displacement(&pair, frame, [150, 120])).collect();
    assert_eq!((places[0], places[1]), (places[2], places[3]));
    assert!((places[0][1] - places[1][1]).abs() > 0.2, "{places:?}");
    let residue = |tubes| tube(MemoryParts { erase_residual: 0.08, tubes, ..MemoryParts::IDEAL });
    assert_eq!(residue(1).earlier(7).collect::<Vec<_>>(), [6, 5]);
    assert_eq!(residue(2).earlier(7).collect::<Vec<_>>(), [5, 3]);
    assert_eq!(residue(2).earlier(3).collect::<Vec<_>>(), [1]);
    assert_eq!(residue(2).earlier(1).count(), 0);
    assert_eq!(residue(2).later(3).collect::<Vec<_>>(), [5, 7]);
    assert!(residue(2).later(3).all(|later| residue(2).earlier(later).any(|frame| frame == 3)));
}

#[test]
fn a_picture_fades_by_the_residual_with_every_frame_and_stays_in_its_place() {
    let tube = tube(MemoryParts { erase_residual: 0.4, ..MemoryParts::IDEAL });
    let picture = store(|sweep, line| 0.001 * sweep + 0.002 * line);
    let dark = vec![0.0; picture.len()];
    let mut left = 1.0;
    for age in 1..=tube.memory_frames() {
        left *= 0.4;
        let mut earlier = vec![dark.as_slice(); age - 1];
        earlier.push(&picture);
        let mut now = dark.clone();
        tube.combine(&mut now, &earlier);
        for (now, before) in now.iter().zip(&picture) {
            assert!((f64::from(*now) - left * f64::from(*before)).abs() < 1e-6);
        }
    }
}

#[test]
fn what_is_forgotten_is_below_half_a_grey_level() {
    for (residual, frames) in
        [(0.0, 0), (0.0005, 0), (0.02, 1), (0.08, 2), (0.15, 3), (0.4, 7), (0.9, 16), (1.0, 16)]
    {
        assert_eq!(memory_frames(residual), frames, "{residual}");
        if frames < 16 {
            let forgotten: f64 = (frames + 1..300).map(|age| libm::pow(residual, age as f64)).sum();
            assert!(1.582 * forgotten * 255.0 <= 0.5, "{residual}");
        }
    }
}

#[test]
fn a_tube_without_faults_keeps_every_bit() {
    let picture = store(|sweep, line| libm::sin(sweep * line));
    let tube = tube(MemoryParts { tubes: 2, ..MemoryParts::IDEAL });
    let mut seen = picture.clone();
    tube.combine(&mut seen, &[]);
    assert_eq!(read(&tube, 1, seen), picture);
    assert_eq!(tube.memory_frames(), 0);
}

proptest! {
    #[test]
    fn any_tube_reads_any_raster(
        sweeps in 1usize..9, lines in 1usize..9, tv_lines in proptest::option::of(1u32..5000),
        registration in 0.0..3.0f64, tubes in 0u32..3, seed: u64, frame: u64,
    ) {
        let parts = MemoryParts { tv_lines, registration, tubes, ..MemoryParts::IDEAL };
        let raster = TubeRaster { sweeps, lines, width: 1.7 };
        let mut store = vec![0.5; sweeps * lines];
        let tube = Tube::new(&parts, raster, seed);
        tube.read(frame, &mut store, &mut Vec::new());
        prop_assert!(store.iter().all(|value| (value - 0.5).abs() < 1e-5), "{store:?}");
    }
}
