//! Draws: even, independent of one another, and each a function of its number and name alone.

use dataset::{Counter, Draw, Plan, Split};

use crate::scene::{PLAN, Scene};

fn counter(sample: u64) -> Counter {
    Counter { seed: 7, sample, attempt: 0 }
}

/// Sum of (found - expected)^2 / expected over equal cells.
fn chi_squared(cells: &[u64]) -> f64 {
    let expected = cells.iter().sum::<u64>() as f64 / cells.len() as f64;
    cells.iter().map(|found| (*found as f64 - expected) * (*found as f64 - expected) / expected).sum()
}

#[test]
fn shares_are_even() {
    let mut cells = [0_u64; 64];
    let shares: Vec<f64> = (0..64_000).map(|sample| counter(sample).share("x_m")).collect();
    shares.iter().for_each(|share| cells[(share * 64.0) as usize] += 1);
    // 63 degrees of freedom: above 103.4 once in a thousand, below 34.6 too.
    let found = chi_squared(&cells);
    assert!((34.6..103.4).contains(&found), "{found}");
    let mean = shares.iter().sum::<f64>() / shares.len() as f64;
    // Three deviations of the mean of 64 000: 3 / sqrt(12 * 64 000).
    assert!((mean - 0.5).abs() < 0.0035, "{mean}");
}

/// The counters of two draws, of a number.
type Pair = fn(u64) -> [Counter; 2];

#[test]
fn quantities_samples_attempts_and_seeds_are_independent() {
    let pairs: [(&str, Pair, [&str; 2]); 4] = [
        ("names", |sample| [counter(sample); 2], ["x_m", "y_m"]),
        ("samples", |sample| [counter(sample), counter(sample + 1)], ["x_m", "x_m"]),
        ("attempts", |sample| [counter(sample), Counter { attempt: 1, ..counter(sample) }], ["x_m", "x_m"]),
        ("seeds", |sample| [counter(sample), Counter { seed: 8, ..counter(sample) }], ["x_m", "x_m"]),
    ];
    for (what, pair, names) in pairs {
        let mut cells = vec![0_u64; 256];
        for sample in 0..64_000 {
            let [one, other] = pair(sample);
            let at = [one.share(names[0]), other.share(names[1])].map(|share| (share * 16.0) as usize);
            cells[16 * at[0] + at[1]] += 1;
        }
        // 255 degrees of freedom: above 330.5 once in a thousand, below 190.9 too.
        let found = chi_squared(&cells);
        assert!((190.9..330.5).contains(&found), "{what}: {found}");
    }
}

#[test]
fn values_keep_to_their_ranges_and_meet_both_ends() {
    let of =
        |draw: &Draw| -> Vec<String> { (0..2000).map(|sample| draw.value(counter(sample), "k")).collect() };
    let numbers: Vec<f64> =
        of(&Draw::Number([-3.0, 5.0])).iter().map(|value| value.parse().unwrap()).collect();
    assert!(numbers.iter().all(|number| (-3.0..=5.0).contains(number)));
    assert!(numbers.iter().any(|number| *number < -2.9) && numbers.iter().any(|number| *number > 4.9));
    let mut whole = of(&Draw::Whole([4, 6]));
    whole.sort();
    whole.dedup();
    assert_eq!(whole, ["4", "5", "6"]);
    let mut words = of(&Draw::OneOf(vec!["a".into(), "b".into()]));
    words.sort();
    words.dedup();
    assert_eq!(words, ["a", "b"]);
    assert_eq!(Draw::Number([2.0, 2.0]).value(counter(1), "k"), "2.0");
}

#[test]
fn a_draw_is_pinned() {
    // BLAKE3 of the domain, seed 7, sample 73 214, attempt 0 and the name: it must never change.
    assert_eq!(counter(73_214).word("x_m"), counter(73_214).word("x_m"));
    let bytes: Vec<u8> =
        [b"lunoid.dataset/1 draw\0".as_slice(), &7_u64.to_le_bytes(), &73_214_u64.to_le_bytes()]
            .into_iter()
            .chain([0_u32.to_le_bytes().as_slice(), b"x_m"])
            .flatten()
            .copied()
            .collect();
    let hash = run_record::hash(&bytes);
    let first = (0..8).map(|at| u8::from_str_radix(&hash[2 * at..2 * at + 2], 16).unwrap());
    let expected = first.enumerate().map(|(at, byte)| u64::from(byte) << (8 * at)).sum::<u64>();
    assert_eq!(counter(73_214).word("x_m"), expected);
}

#[test]
fn splits_have_their_shares() {
    let plan = Plan { draws: 10_000, ..Scene::new(PLAN).plan() };
    let mut counts = [0_u64; 3];
    (0..plan.samples()).for_each(|sample| counts[plan.split(sample) as usize] += 1);
    let share = |split: Split| counts[split as usize] as f64 / plan.samples() as f64;
    // Four deviations of a share of 30 000.
    for (split, expected) in Split::ALL.into_iter().zip([0.5, 0.25, 0.25]) {
        assert!((share(split) - expected).abs() < 0.0116, "{split:?}: {}", share(split));
    }
}

#[test]
fn a_quantity_that_is_added_changes_no_other_draw() {
    let (plan, more) =
        (Scene::new(PLAN).plan(), PLAN.replace("[pose]", "\"display_white\" = [1, 2]\n[pose]"));
    let more = more.replace("display_white", "scenario.display.white");
    let more = Scene::new(&more.replace("draws = 3", "draws = 5")).plan();
    for sample in 0..plan.samples() {
        let (one, other) = (plan.wanted(sample), more.wanted(sample));
        assert_eq!((one.of, one.split, one.frame), (other.of, other.split, other.frame));
        let kept: Vec<_> =
            other.drawn.iter().filter(|(key, _)| key != "scenario.display.white").cloned().collect();
        assert!(one.drawn == kept && other.drawn.len() == kept.len() + 1, "{:?}", other.drawn);
    }
}

#[test]
fn combinations_take_turns_and_more_draws_come_behind() {
    let plan = Scene::new(PLAN).plan();
    let all: Vec<_> = plan.all().collect();
    assert_eq!(all.len(), 3);
    assert!((0..plan.samples()).all(|sample| plan.combination(sample) == all[(sample % 3) as usize]));
    let machines = Scene::new(&PLAN.replace("\"ideal\"", "\"ideal\", \"pra-frugal\"")).plan();
    let found: Vec<_> = machines.all().map(|of| [of.scenario, of.machine, of.fault]).collect();
    assert_eq!(found, [[0, 0, 0], [0, 0, 1], [0, 0, 2], [0, 1, 0], [0, 1, 1], [0, 1, 2]]);
}
