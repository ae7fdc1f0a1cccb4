//! The sector of a vehicle that turns on the spot (hardware section 4.7; artefact A5).

use data_bank::{FrameSupply, corners_of, nearest_first};
use hardware_model::{Channels, Drum, DrumQueue};
use quantities::{radians, sin_cos};

use crate::{OneStore, bank_of, demand};

/// Corners of the level along either side.
const SIZE: usize = 121;
/// Where the vehicle stands, in regions.
const FOOT: [f64; 2] = [60.3, 60.6];
/// One millisecond of a 10 MHz clock.
const MS: u64 = 10_000;
/// 30 frames a second.
const FRAME: u64 = 333_333;

fn direction(degrees: f64) -> [f64; 2] {
    let (sin, cos) = sin_cos(radians(degrees));
    [cos, sin]
}

/// Whether a point lies in the sector that begins at `from` and is `width` degrees wide (less than a half turn).
fn within(point: [f64; 2], from: f64, width: f64, range: f64) -> bool {
    let cross = |a: [f64; 2], b: [f64; 2]| a[0] * b[1] - a[1] * b[0];
    let along = [point[0] - FOOT[0], point[1] - FOOT[1]];
    along[0] * along[0] + along[1] * along[1] <= range * range
        && cross(direction(from), along) >= 0.0
        && cross(along, direction(from + width)) >= 0.0
}

/// Corners of the regions whose middle lies in the sector, nearest first.
fn sector(from: f64, width: f64, range: f64) -> Vec<u32> {
    let regions = (0..SIZE - 1).flat_map(|m| (0..SIZE - 1).map(move |n| [m, n]));
    let met = regions.filter(|&[m, n]| within([m as f64 + 0.5, n as f64 + 0.5], from, width, range));
    let mut corners = corners_of(met, [SIZE; 2]);
    nearest_first(&mut corners, SIZE, FOOT);
    corners
}

/// A turn to the right by `turn` degrees at `speed` degrees a second with a fan of 50 degrees; the supply of every
/// frame, with the azimuth at which its fan begins.
fn turning(drum: Drum, buffer: Option<u32>, range: f64, speed: f64, turn: f64) -> Vec<(f64, FrameSupply)> {
    let mut bank = bank_of(drum, Channels::default(), buffer, [SIZE; 2], 3);
    (0..(turn / speed * 30.0) as u64)
        .map(|frame| {
            let from = speed * frame as f64 / 30.0;
            let corners = sector(from, 50.0, range);
            (from, bank.one(&demand(frame, frame * FRAME, (frame + 1) * FRAME, corners)))
        })
        .collect()
}

fn sum(frames: &[(f64, FrameSupply)], count: impl Fn(&FrameSupply) -> u64) -> f64 {
    frames.iter().map(|(_, supply)| count(supply)).sum::<u64>() as f64
}

/// A drum so fast that every request comes within its frame.
const FAST: Drum =
    Drum { rotation: 100, word: 0.1, record_words: 9, queue: DrumQueue::ShortestLatency, count: 1 };

#[test]
fn new_corners_come_at_half_the_square_of_the_range_times_the_turn_rate() {
    for (range, speed) in [(25.0, 5.0), (25.0, 10.0), (25.0, 50.0), (50.0, 30.0)] {
        let frames = turning(FAST, None, range, speed, 250.0);
        let seconds = frames.len() as f64 / 30.0;
        let rate = sum(&frames, |supply| supply.requests) / seconds;
        let law = range * range * radians(speed) / 2.0;
        // The belt of corners around the regions is counted too: about half a region at the far edge.
        assert!(
            (rate / law - 1.0 - 1.0 / range).abs() < 0.03,
            "{range}, {speed} deg/s: {rate} against {law}"
        );
    }
}

#[test]
fn blocks_of_8_by_8_divide_the_requests_by_about_forty() {
    let requests = |record_words| {
        sum(&turning(Drum { record_words, ..FAST }, None, 50.0, 20.0, 250.0), |supply| supply.requests)
    };
    let ratio = requests(9) / requests(576);
    assert!((30.0..64.0).contains(&ratio), "{ratio}");
}

#[test]
fn a_buffer_of_one_sector_drops_what_lies_behind() {
    let frames = turning(FAST, Some(700 * 9), 25.0, 10.0, 250.0);
    assert!(sum(&frames, |supply| supply.evicted) > 500.0);
    assert_eq!(sum(&frames, |supply| supply.no_room), 0.0);
    let unlimited = turning(FAST, None, 25.0, 10.0, 250.0);
    assert_eq!(sum(&frames, |supply| supply.requests), sum(&unlimited, |supply| supply.requests));
}

/// Of the requests of a turn, the fraction that was given up: the fan had passed before they came. 34 ms, FIFO, one
/// corner a record; the law's utilisation is 1 at 10.6 degrees a second.
fn given_up(speed: f64) -> f64 {
    let drum = Drum { rotation: 34 * MS, word: 50.0, record_words: 9, queue: DrumQueue::Fifo, count: 1 };
    let frames = turning(drum, None, 25.0, speed, 200.0);
    for (from, supply) in &frames {
        for missing in supply.missing.iter().filter(|missing| missing.arrival.is_none()) {
            let at = [missing.item as usize / SIZE, missing.item as usize % SIZE].map(|index| index as f64);
            // While the drum keeps up, what is not there yet lies in the leading half of the fan, or just beside it.
            assert!(speed > 8.0 || within(at, from + 25.0, 90.0, 30.0), "{speed} deg/s: {at:?} at {from}");
        }
    }
    sum(&frames, |supply| supply.cancelled) / sum(&frames, |supply| supply.requests)
}

#[test]
fn the_leading_side_starves_beyond_the_turn_rate_that_fills_the_drum() {
    for speed in [2.0, 5.0, 8.0] {
        assert_eq!(given_up(speed), 0.0, "{speed} deg/s");
    }
    let fractions = [12.0, 16.0, 20.0, 40.0].map(given_up);
    assert!(fractions[0] > 0.05 && fractions.is_sorted(), "{fractions:?}");
}
