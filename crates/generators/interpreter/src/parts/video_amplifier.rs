//! The video amplifier: a lag, of an input that jumps between samples (sheet of the mixing unit).
//!
//! Whoever draws its output from place to place gets, behind each place, the value from which a straight line has the area of the
//! answer up to the next. Behind a jump that can be seen there are three places more.

use super::broken::{Broken, Jump};
use super::series::LagMap;

/// Places behind a jump (time constants).
const BEHIND: [f64; 3] = [0.7, 1.6, 3.0];

/// A jump up to this is not divided: a quarter of one of 256 shades.
const SEEN: f64 = 1.0 / 1024.0;

/// `video`, which is never black, behind a lag of `tau` steps.
pub fn amplified(tau: f64, video: Broken) -> Broken {
    if tau == 0.0 {
        return video;
    }
    let Some(&first) = video.samples.first() else { return video };
    let mut out = Broken { samples: vec![first], jumps: Vec::new() };
    let (mut input, mut output, mut passed) = (first, first, 0);
    for (end, &value) in (1..).zip(&video.samples[1..]) {
        let own = video.jumps[passed..].iter().take_while(|jump| jump.at <= f64::from(end)).count();
        let places = divided(tau, end, &video.jumps[passed..passed + own], value);
        passed += own;
        (input, output) = through(tau, end, [input, output], (&places, value), &mut out.jumps);
        out.samples.push(output);
    }
    out
}

/// Places of the step that ends at sample `end` with the input `value`: its jumps, and those behind them.
fn divided(tau: f64, end: i32, jumps: &[Jump], value: f64) -> Vec<Jump> {
    let last = Jump { at: f64::from(end), before: value, after: value };
    let mut places = Vec::new();
    for (k, jump) in jumps.iter().enumerate() {
        places.push(*jump);
        let next = jumps.get(k + 1).unwrap_or(&last);
        let length = next.at - jump.at;
        if (jump.after - jump.before).abs() > SEEN {
            places.extend(BEHIND.map(|part| part * tau).into_iter().filter(|time| *time < length).map(
                |time| {
                    let there = jump.after + (next.before - jump.after) * (time / length);
                    Jump { at: jump.at + time, before: there, after: there }
                },
            ));
        }
    }
    places
}

/// One step over its places, which become the output's; input and output at its end.
fn through(
    tau: f64,
    end: i32,
    [mut input, mut output]: [f64; 2],
    (places, value): (&[Jump], f64),
    out: &mut Vec<Jump>,
) -> (f64, f64) {
    let mut at = f64::from(end) - 1.0;
    let first = out.len();
    let last = Jump { at: f64::from(end), before: value, after: value };
    for place in places.iter().chain([&last]) {
        let length = (place.at - at).max(0.0);
        let next = LagMap::of(length, tau).step(output, [input, place.before]);
        let area = 0.5 * (input + place.before) * length - tau * (next - output);
        if let Some(jump) = out[first..].last_mut() {
            jump.after = line_of_area(area, length, [output, input], next);
        }
        (at, input, output) = (place.at, place.after, next);
        out.push(Jump { at, before: output, after: output });
    }
    out.pop();
    (input, output)
}

/// Where a straight line over `length` begins that ends at `end` and has this area: between output and input at the begin.
fn line_of_area(area: f64, length: f64, [output, input]: [f64; 2], end: f64) -> f64 {
    if length <= 0.0 {
        return output;
    }
    (2.0 * area / length - end).clamp(output.min(input), output.max(input))
}
