use std::ops::Range;

use quantities::hash_words;
use shard::{Shard, ShardError, block_by_cost, block_by_count};

/// The blocks of all shards.
fn all(of: u32, block: impl Fn(Shard) -> Result<Range<u64>, ShardError>) -> Vec<Range<u64>> {
    (1..=of).map(|number| block(Shard::new(number, of).expect("a shard")).expect("a block")).collect()
}

/// The blocks follow one another from the first frame to the last, none empty.
fn expect_partition(blocks: &[Range<u64>], frames: &Range<u64>) {
    assert_eq!((blocks[0].start, blocks[blocks.len() - 1].end), (frames.start, frames.end));
    assert!(blocks.windows(2).all(|pair| pair[0].end == pair[1].start), "{blocks:?}");
    assert!(blocks.iter().all(|block| !block.is_empty()), "{blocks:?}");
}

#[test]
fn blocks_by_count_are_a_partition_whose_sizes_differ_by_one() {
    for first in [0, 5, u64::MAX - 40] {
        for count in 1..40 {
            let frames = first..first + count;
            for of in 1..=count as u32 {
                let blocks = all(of, |shard| block_by_count(shard, &frames));
                expect_partition(&blocks, &frames);
                let sizes = blocks.iter().map(|block| block.end - block.start);
                assert!(sizes.clone().max().unwrap() - sizes.min().unwrap() <= 1, "{blocks:?}");
            }
        }
    }
    let seven = all(7, |shard| block_by_count(shard, &(0..90)));
    assert_eq!(seven, [0..12, 12..25, 25..38, 38..51, 51..64, 64..77, 77..90]);
}

#[test]
fn blocks_by_cost_are_a_partition_with_the_nearest_cuts() {
    for trial in 0..300_u64 {
        let count = 1 + hash_words(1, &[trial]) % 60;
        let cost: Vec<u64> = (0..count).map(|frame| 1 + hash_words(2, &[trial, frame]) % 10).collect();
        let total: u64 = cost.iter().sum();
        let most = *cost.iter().max().unwrap();
        let frames = 100..100 + count;
        for of in 1..=count as u32 {
            let blocks = all(of, |shard| block_by_cost(shard, &frames, &cost));
            expect_partition(&blocks, &frames);
            // Where shards are long, no cut has to give way to a shard of one frame, and each is the nearest.
            if total / u64::from(of) <= 2 * most {
                continue;
            }
            for (number, block) in (1..).zip(&blocks) {
                let before: u64 = cost[..(block.end - frames.start) as usize].iter().sum();
                let off = (before as f64 - total as f64 * f64::from(number) / f64::from(of)).abs();
                assert!(off <= 0.5 * most as f64, "{number}/{of} of {cost:?}: {off}");
            }
        }
    }
}

#[test]
fn cuts_by_cost_in_closed_form() {
    let by_cost = |cost: &[u64], of| all(of, |shard| block_by_cost(shard, &(0..cost.len() as u64), cost));
    // Ten to one: the first frame weighs as much as the ten behind it.
    assert_eq!(by_cost(&[10, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1], 2), [0..1, 1..11]);
    // A cut in the middle between two frames goes to the earlier.
    assert_eq!(by_cost(&[2, 2, 2], 2), [0..1, 1..3]);
    // One frame has nearly all: the others still have a shard each.
    assert_eq!(by_cost(&[1, 1, 1000, 1, 1], 5), [0..1, 1..2, 2..3, 3..4, 4..5]);
    assert_eq!(by_cost(&[1, 1000, 1, 1, 1], 3), [0..1, 1..2, 2..5]);
    // Frames without cost count as 1, also at the end.
    assert_eq!(by_cost(&[0; 9], 3), [0..3, 3..6, 6..9]);
    assert_eq!(by_cost(&[5, 5, 0, 0, 0], 2), [0..1, 1..5]);
    // Sums beyond 64 bits.
    assert_eq!(by_cost(&[u64::MAX; 4], 2), [0..2, 2..4]);
}

#[test]
fn equal_costs_share_as_counts_do_within_a_frame() {
    for count in 1..60_u64 {
        for of in 1..=count as u32 {
            let cost = vec![7; count as usize];
            for number in 1..=of {
                let shard = Shard::new(number, of).unwrap();
                let by_cost = block_by_cost(shard, &(0..count), &cost).unwrap();
                let by_count = block_by_count(shard, &(0..count)).unwrap();
                assert!(
                    by_cost.end.abs_diff(by_count.end) <= 1,
                    "{shard} of {count}: {by_cost:?} {by_count:?}"
                );
            }
        }
    }
}

#[test]
fn no_shard_is_empty() {
    let shard = Shard::new(2, 5).unwrap();
    let expected = "shard 2/5: the run has 4 frames, expected at most as many shards; give fewer shards";
    assert_eq!(block_by_count(shard, &(3..7)).unwrap_err().to_string(), expected);
    assert_eq!(block_by_cost(shard, &(3..7), &[1; 4]).unwrap_err().to_string(), expected);
}
