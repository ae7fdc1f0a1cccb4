//! Broken profiles against their own dense integral.

use proptest::prelude::{any, prop_assert, proptest};
use scenario::PixelRule;
use signal::{Break, Breaks, LANES, Lanes};

use crate::{Beam, BeamBreaks, FarStroke, Steps, write_group};

const LINES: usize = 130;
const SAMPLES: usize = 16;
/// Places of the dense evaluation in a step.
const DENSE: usize = 4000;

/// A profile over the samples: smooth between rims, with light that jumps at rims and edges of shadow.
struct Scene {
    /// Line position and intensity at a place, before shadow; the rim at which the piece begins is a place of it.
    piece: fn(usize, f64) -> [f64; 2],
    /// Rims between the pieces.
    rims: Vec<f64>,
    /// Where shadow begins and ends, in turn.
    edges: Vec<f64>,
}

impl Scene {
    fn at(&self, piece: usize, dark: bool, t: f64) -> [f64; 2] {
        let [position, light] = (self.piece)(piece, t);
        [position, if dark { 0.0 } else { light }]
    }

    fn passed(places: &[f64], t: f64) -> usize {
        places.iter().filter(|&&place| place <= t).count()
    }

    fn sample(&self, t: f64) -> [f64; 2] {
        self.at(Self::passed(&self.rims, t), Self::passed(&self.edges, t) % 2 == 1, t)
    }

    /// Highest line position up to a place.
    fn held(&self, t: f64) -> f64 {
        let dense = (0..=(t * 500.0) as usize).map(|k| self.sample(k as f64 / 500.0)[0]);
        let rims = self.rims.iter().filter(|&&rim| rim <= t).map(|&rim| self.sample(rim)[0]);
        dense.chain(rims).fold(self.sample(t)[0], f64::min)
    }

    fn drawn(&self) -> Vec<f32> {
        let samples = || (0..SAMPLES).map(|k| k as f64);
        let lanes =
            |values: &dyn Fn(f64) -> f64| samples().map(|t| Lanes::splat(values(t))).collect::<Vec<_>>();
        let position = lanes(&|t| self.sample(t)[0]);
        let line = lanes(&|t| self.held(t));
        let intensity = lanes(&|t| self.sample(t)[1]);
        let entry: Vec<_> = (0..SAMPLES).map(|k| Lanes::splat(entry(&position, &line, k))).collect();
        let mut places: Vec<(f64, bool)> = self.rims.iter().map(|&rim| (rim, true)).collect();
        places.extend(self.edges.iter().map(|&edge| (edge, false)));
        places.sort_by(|a, b| a.0.total_cmp(&b.0));
        let breaks: Breaks<f64> = every(places.iter().map(|&(t, bend)| self.side(t, bend)).collect());
        let bends = every(places.iter().map(|place| place.1).collect());
        let at_bends = every(places.iter().map(|&(t, _)| self.sample(t)[0]).collect());
        let held = every(places.iter().map(|&(t, _)| self.held(t)).collect());
        let broken = BeamBreaks { breaks: &breaks, bends: &bends, position: &at_bends, line: &held };
        let beam = Beam {
            position: &position,
            line: &line,
            entry: &entry,
            intensity: &intensity,
            breaks: Some(broken),
            far: None,
        };
        let mut rows = vec![0.0; LANES * LINES];
        write_group(&beam, Steps::Curved, PixelRule::LineMean, LINES, &mut Vec::new(), &mut rows);
        assert!(rows.chunks_exact(LINES).all(|row| row == &rows[..LINES]));
        rows.truncate(LINES);
        rows
    }

    fn side(&self, t: f64, bend: bool) -> Break<f64> {
        let (piece, dark) = (Self::passed(&self.rims, t), Self::passed(&self.edges, t) % 2 == 1);
        let before = if bend { self.at(piece - 1, dark, t) } else { self.at(piece, !dark, t) };
        let sample = t.ceil() as usize;
        let share = t - (sample - 1) as f64;
        Break { sample, share, height: 0.0, before: before[1], after: self.at(piece, dark, t)[1] }
    }

    /// Line means by plain summation of what rises above everything before.
    fn integrated(&self) -> Vec<f64> {
        let mut rows = vec![0.0; LINES];
        let mut held = self.sample(0.0)[0];
        for k in 1..=(SAMPLES - 1) * DENSE {
            let [position, _] = self.sample(k as f64 / DENSE as f64);
            let light = self.sample((k as f64 - 0.5) / DENSE as f64)[1].max(0.0);
            if position < held {
                let middle = 0.5 * (position + held);
                if (0.0..LINES as f64).contains(&middle) {
                    rows[middle as usize] += light * (held - position);
                }
                held = position;
            }
        }
        rows
    }

    fn assert_drawn(&self, tolerance: f64) {
        for (line, (found, expected)) in self.drawn().iter().zip(self.integrated()).enumerate() {
            let error = (f64::from(*found) - expected).abs();
            assert!(error < tolerance, "line {line}: {found} against {expected}");
        }
    }
}

fn every<T: Clone>(values: Vec<T>) -> [Vec<T>; LANES] {
    std::array::from_fn(|_| values.clone())
}

fn entry(position: &[Lanes<f64>], line: &[Lanes<f64>], k: usize) -> f64 {
    let (Some(before), now) = (k.checked_sub(1), position[k][0]) else { return 0.0 };
    let (below, held) = (position[before][0], line[before][0]);
    if below > held && now < held { (below - held) / (below - now) } else { 0.0 }
}

/// A slope up to a rim, a bowl behind it whose far wall comes back into sight, and its far rim.
fn crater(piece: usize, t: f64) -> [f64; 2] {
    let near = |t: f64| 120.0 - 8.0 * t - 0.4 * t * t;
    let bowl = |t: f64| near(5.37) + 6.0 * (t - 5.37) - 1.9 * (t - 5.37) * (t - 5.37);
    match piece {
        0 => [near(t), 0.3 + 0.03 * t + 0.008 * t * t],
        1 => [bowl(t), 0.1 + 0.09 * (t - 5.37) + 0.01 * (t - 5.37) * (t - 5.37)],
        _ => [bowl(9.62) - 3.0 * (t - 9.62) - 0.5 * (t - 9.62) * (t - 9.62), 0.4 + 0.02 * (t - 9.62)],
    }
}

#[test]
fn rims_lie_where_they_lie() {
    Scene { piece: crater, rims: vec![5.37, 9.62], edges: vec![] }.assert_drawn(0.004);
}

#[test]
fn edges_of_shadow_lie_where_they_lie() {
    // Ends beside a begin, in the step of a rim before and behind it, in neighbouring steps, two in one step.
    for edges in [
        vec![2.4, 3.6],
        vec![1.5, 2.5, 3.5, 4.5],
        vec![5.1, 9.1],
        vec![5.6, 9.7],
        vec![9.3, 9.55],
        vec![3.2, 3.4, 3.7, 3.9],
        vec![5.05, 5.2, 8.9, 9.9, 12.3],
    ] {
        Scene { piece: crater, rims: vec![5.37, 9.62], edges }.assert_drawn(0.006);
    }
}

#[test]
fn a_narrow_rim_within_one_step_is_drawn_to_its_top() {
    fn ridge(piece: usize, t: f64) -> [f64; 2] {
        let ground = 100.0 - 5.0 * t;
        match piece {
            0 | 3 => [ground, 0.5],
            1 => [ground - 12.0 * (t - 6.2), 0.9],
            _ => [ground - 3.6 + 9.0 * (t - 6.5), 0.1],
        }
    }
    // Within a step of the summation.
    Scene { piece: ridge, rims: vec![6.2, 6.5, 6.9], edges: vec![] }.assert_drawn(0.003);
}

#[test]
fn no_curve_reaches_across_a_bend_in_sight() {
    fn scarp(piece: usize, t: f64) -> [f64; 2] {
        let line = match piece {
            0 => 120.0 - 2.0 * t,
            1 => 113.0 - 14.0 * (t - 3.5) - 0.3 * (t - 3.5) * (t - 3.5),
            _ => 52.2 - 1.5 * (t - 7.5) - 0.2 * (t - 7.5) * (t - 7.5),
        };
        [line, 0.1 + 0.2 * (t - 1.5 * (t / 1.5).floor().min(9.0))]
    }
    // The light is a sawtooth over whole pieces of three half steps: edges in pairs where it jumps.
    let jumps = (1..10).map(|k| 1.5 * f64::from(k));
    let edges = jumps.flat_map(|jump| [jump - 1e-7, jump + 1e-7]).collect();
    Scene { piece: scarp, rims: vec![3.5, 7.5], edges }.assert_drawn(0.006);
}

#[test]
fn a_straight_profile_comes_back_with_its_own_light() {
    fn valley(piece: usize, t: f64) -> [f64; 2] {
        let line = match piece {
            0 => 100.0 - 6.0 * t,
            1 => 73.0 + 10.0 * (t - 4.5),
            _ => 90.0 - 7.0 * (t - 6.2),
        };
        [line, 0.06 * t]
    }
    Scene { piece: valley, rims: vec![4.5, 6.2], edges: vec![8.9, 9.5] }.assert_drawn(0.004);
}

#[test]
fn an_edge_of_shadow_does_not_move_the_line() {
    let shape = |piece, t| [crater(piece, t)[0], 1.0];
    let scene = |edges| Scene { piece: shape, rims: vec![5.37, 9.62], edges };
    let lit = scene(vec![]).drawn();
    // Edges in pairs: the beam is cut for next to no time.
    let pairs = [3.3, 5.2, 9.8].map(|edge| [edge, edge + 1e-7]);
    for (row, lit) in scene(pairs.concat()).drawn().iter().zip(&lit) {
        assert!((row - lit).abs() < 1e-4, "{row} against {lit}");
    }
}

#[test]
fn breaks_at_samples_do_no_harm() {
    let scene = Scene { piece: crater, rims: vec![5.37, 9.62], edges: vec![3.0, 4.0, 11.0, 12.0] };
    scene.assert_drawn(0.006);
}

#[test]
fn silhouettes_rise_behind_the_ground() {
    let line = [9.0, 6.5].map(Lanes::splat);
    let entry = [0.0; 2].map(Lanes::splat);
    let intensity = [1.0; 2].map(Lanes::splat);
    let stroke = |line, intensity| FarStroke { line, intensity };
    let far = every(vec![stroke(4.0, 0.25), stroke(5.0, 0.9), stroke(2.0, 0.5)]);
    let beam = Beam {
        position: &line,
        line: &line,
        entry: &entry,
        intensity: &intensity,
        breaks: None,
        far: Some(&far),
    };
    let mut rows = vec![0.0; 10];
    write_group(&beam, Steps::Curved, PixelRule::LineMean, 10, &mut Vec::new(), &mut rows);
    assert_eq!(rows, [0.0, 0.0, 0.5, 0.5, 0.25, 0.25, 0.625, 1.0, 1.0, 0.0]);
}

proptest! {
    #[test]
    fn coverage_is_conserved_over_breaks(
        position in proptest::collection::vec(-20.0..60.0f64, 2..40),
        places in proptest::collection::vec((any::<u16>(), 0.0..=1.0f64, -20.0..60.0f64, any::<bool>()), 0..60),
    ) {
        let mut places: Vec<_> = places
            .into_iter()
            .map(|(sample, share, at, bend)| (1 + usize::from(sample) % (position.len() - 1), share, at, bend))
            .collect();
        places.sort_by(|a, b| (a.0, a.1).partial_cmp(&(b.0, b.1)).unwrap());
        let (mut line, mut held_at) = (vec![position[0]], Vec::new());
        let mut held = position[0];
        for (sample, &position) in position.iter().enumerate().skip(1) {
            for place in places.iter().filter(|place| place.0 == sample) {
                held = if place.3 { held.min(place.2) } else { held };
                held_at.push(held);
            }
            held = held.min(position);
            line.push(held);
        }
        let splat = |values: &[f64]| values.iter().map(|&value| Lanes::splat(value)).collect::<Vec<_>>();
        let (positions, lines) = (splat(&position), splat(&line));
        let entry: Vec<_> = (0..line.len()).map(|k| Lanes::splat(entry(&positions, &lines, k))).collect();
        let side = |place: &(usize, f64, f64, bool)| Break {
            sample: place.0,
            share: place.1,
            height: 0.0,
            before: 1.0,
            after: 1.0,
        };
        let breaks: Breaks<f64> = every(places.iter().map(side).collect());
        let bends = every(places.iter().map(|place| place.3).collect());
        let at_bends = every(places.iter().map(|place| place.2).collect());
        let held_at = every(held_at);
        let broken = BeamBreaks { breaks: &breaks, bends: &bends, position: &at_bends, line: &held_at };
        let intensity = vec![Lanes::splat(1.0); line.len()];
        let beam = Beam {
            position: &positions,
            line: &lines,
            entry: &entry,
            intensity: &intensity,
            breaks: Some(broken),
            far: None,
        };
        let mut rows = vec![0.0; 60];
        write_group(&beam, Steps::Curved, PixelRule::LineMean, 60, &mut Vec::new(), &mut rows);
        let covered: f64 = rows.iter().map(|&row| f64::from(row)).sum();
        let expected = line[0].max(0.0) - line[line.len() - 1].max(0.0);
        prop_assert!((covered - expected).abs() < 1e-3, "{} against {}", covered, expected);
        prop_assert!(rows.iter().all(|row| (0.0..=1.0 + 1e-4).contains(row)));
    }
}
