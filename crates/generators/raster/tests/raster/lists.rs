//! Lists miss nothing and do not depend on the order of the triangles.

use std::ops::Range;

use raster::{Lists, Pattern, Screen, Triangle};

use crate::brute_force::is_inside;
use crate::random::Random;
use crate::triangle;

/// Samples of the sub-areas in the triangle's box that do not list it: how many the triangle covers, and how many there are.
fn lost(corners: &[[f64; 2]; 3], lists: &Lists, screen: &Screen, pattern: Pattern) -> [usize; 2] {
    let [mut lost, mut asked] = [0, 0];
    let overlaps = |axis: usize, pixels: Range<u32>| {
        corners.iter().any(|corner| corner[axis] > f64::from(pixels.start) - 0.1)
            && corners.iter().any(|corner| corner[axis] < f64::from(pixels.end) + 0.1)
    };
    for number in (0..screen.sub_areas()).filter(|&number| lists.of(number).is_empty()) {
        let area = screen.sub_area(number);
        if !overlaps(0, area.columns()) || !overlaps(1, area.rows()) {
            continue;
        }
        for pixel in area.rows().flat_map(|row| area.columns().map(move |column| [column, row])) {
            for offset in pattern.offsets() {
                let place = [0, 1].map(|axis| f64::from(pixel[axis]) + f64::from(offset[axis]) / 64.0);
                asked += 1;
                lost += usize::from(is_inside(corners, place));
            }
        }
    }
    [lost, asked]
}

/// Draws random triangles one by one and returns how many samples were looked at; none of them is lost.
fn look_at(triangles: usize) -> usize {
    let mut random = Random(4);
    let screen = Screen::new([40, 40], 8).expect("a screen");
    let mut lists = Lists::default();
    let (mut drawn, mut asked) = (0, 0);
    while drawn < triangles {
        let corners = random.triangle(40.0);
        let Some(triangle) = triangle(corners) else { continue };
        lists.fill(&screen, &[triangle]);
        drawn += 1;
        let [lost, more] = lost(&corners, &lists, &screen, Pattern::ALL[drawn % Pattern::ALL.len()]);
        assert_eq!(lost, 0, "{corners:?}");
        asked += more;
    }
    asked
}

/// `RASTER_TRIANGLES=1000000` makes it the long run.
#[test]
fn no_sample_is_lost_to_a_list() {
    let triangles =
        std::env::var("RASTER_TRIANGLES").map_or(30_000, |count| count.parse().expect("a number"));
    let asked = look_at(triangles);
    println!("{triangles} triangles, {asked} samples of sub-areas that do not list them, none lost");
    assert!(asked > 300 * triangles, "only {asked} samples were looked at");
}

#[test]
fn the_order_of_the_triangles_does_not_matter() {
    let mut random = Random(5);
    let screen = Screen::new([61, 45], 7).expect("a screen");
    let (mut forwards, mut shuffled) = (Lists::default(), Lists::default());
    for _ in 0..50 {
        let triangles: Vec<Triangle> = (0..200).filter_map(|_| triangle(random.triangle(60.0))).collect();
        let mut order: Vec<usize> = (0..triangles.len()).collect();
        (1..order.len()).rev().for_each(|i| order.swap(i, random.below(i as u32 + 1) as usize));
        let in_order: Vec<_> = order.iter().map(|&i| triangles[i]).collect();
        forwards.fill(&screen, &triangles);
        shuffled.fill(&screen, &in_order);
        for number in 0..screen.sub_areas() {
            assert!(forwards.of(number).is_sorted());
            let mut back: Vec<u32> = shuffled.of(number).iter().map(|&i| order[i as usize] as u32).collect();
            back.sort_unstable();
            assert_eq!(back, forwards.of(number));
        }
    }
}

/// Threads share triangles out, and lists of many are put together: each is as long as those of small lots by themselves, and in order. A
/// frame of few triangles after them has its own.
#[test]
fn lists_of_many_triangles_are_those_of_lots() {
    let mut random = Random(6);
    let screen = Screen::new([61, 45], 7).expect("a screen");
    let triangles: Vec<Triangle> = (0..50_000).filter_map(|_| triangle(random.triangle(60.0))).collect();
    let (mut all, mut lot) = (Lists::default(), Lists::default());
    for count in [triangles.len(), 300, 20_000] {
        all.fill(&screen, &triangles[..count]);
        let mut expected = vec![Vec::new(); screen.sub_areas()];
        for (first, triangles) in (0..).step_by(1000).zip(triangles[..count].chunks(1000)) {
            lot.fill(&screen, triangles);
            for (area, list) in expected.iter_mut().enumerate() {
                list.extend(lot.of(area).iter().map(|number| first + number));
            }
        }
        let found: Vec<Vec<u32>> = (0..screen.sub_areas()).map(|area| all.of(area).to_vec()).collect();
        assert!(found == expected, "{count} triangles");
        assert_eq!(all.entries(), expected.iter().map(Vec::len).sum::<usize>());
    }
}

#[test]
fn a_smaller_frame_after_a_larger_one_keeps_nothing_of_it() {
    let mut lists = Lists::default();
    let whole = triangle([[0.0, 0.0], [80.0, 0.0], [0.0, 80.0]]).expect("an area");
    lists.fill(&Screen::new([80, 80], 8).expect("a screen"), &[whole; 5]);
    let screen = Screen::new([16, 8], 8).expect("a screen");
    lists.fill(&screen, &[triangle([[9.0, 1.0], [12.0, 1.0], [9.0, 5.0]]).expect("an area")]);
    assert_eq!((lists.of(0), lists.of(1), lists.entries()), (&[][..], &[0][..], 1));
    lists.fill(&screen, &[]);
    assert_eq!((lists.of(0), lists.of(1)), (&[][..], &[][..]));
}
