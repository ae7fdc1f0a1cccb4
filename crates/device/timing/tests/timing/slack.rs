//! Slack and its bins.

use proptest::prelude::{any, proptest};
use timing::{BINS, Slack};

/// The bin by its definition, walking along the edges.
fn bins_that_hold(ticks: i64) -> Vec<usize> {
    let edges = Slack::edges();
    let holds = |bin: usize| (bin == 0 || edges[bin - 1] <= ticks) && (bin == BINS - 1 || ticks < edges[bin]);
    (0..BINS).filter(|&bin| holds(bin)).collect()
}

fn expect_in_its_bin(ticks: i64) {
    let mut slack = Slack::default();
    slack.add(ticks);
    let filled: Vec<_> = (0..BINS).filter(|&bin| slack.bins[bin] != 0).collect();
    assert_eq!(filled, bins_that_hold(ticks), "{ticks}");
    assert_eq!(filled, [Slack::bin_of(ticks)]);
    assert_eq!(slack.missed == 1, filled[0] < BINS / 2, "{ticks}");
}

#[test]
fn bins_part_all_of_time() {
    let edges = Slack::edges();
    assert!(edges.is_sorted_by(|a, b| a < b));
    for around in edges.into_iter().chain([i64::MIN + 1, i64::MAX - 1]) {
        (around - 1..=around + 1).for_each(expect_in_its_bin);
    }
}

#[test]
fn edges_reach_from_one_tick_to_a_million_on_both_sides() {
    let edges = Slack::edges();
    for exponent in 0..=6u32 {
        let decade = 10i64.pow(exponent) as f64;
        for sign in [1.0, -1.0] {
            let near = |&edge: &i64| (0.7..1.42).contains(&(edge as f64 * sign / decade));
            assert_eq!(edges.iter().filter(|edge| near(edge)).count(), 1, "{sign} x {decade}");
        }
    }
    assert!(edges.iter().all(|edge| *edge == 0 || edge.unsigned_abs().is_power_of_two()));
}

#[test]
fn labels_tell_the_edges() {
    let mut slack = Slack::default();
    [-2_000_000, -1, 0, 3, 3].into_iter().for_each(|ticks| slack.add(ticks));
    let filled: Vec<_> = slack.histogram().into_iter().filter(|(_, count)| *count > 0.0).collect();
    let expected = [("< -1048576", 1.0), ("-1..0", 1.0), ("0..1", 1.0), ("1..8", 2.0)];
    assert_eq!(filled, expected.map(|(label, count)| (label.to_owned(), count)));
    assert_eq!(slack.histogram()[BINS - 1].0, ">= 1048576");
}

proptest! {
    #[test]
    fn every_slack_is_in_one_bin(ticks in any::<i64>()) {
        expect_in_its_bin(ticks);
    }

    #[test]
    fn merging_is_adding(first in any::<Vec<i64>>(), second in any::<Vec<i64>>()) {
        let of = |ticks: &[i64]| ticks.iter().fold(Slack::default(), |mut slack, &ticks| {
            slack.add(ticks);
            slack
        });
        let mut merged = of(&first);
        merged.merge(&of(&second));
        assert_eq!(merged, of(&[&first[..], &second[..]].concat()));
        assert_eq!(merged.least, first.iter().chain(&second).min().copied());
    }
}
