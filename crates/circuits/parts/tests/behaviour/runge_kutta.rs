//! An independent integrator: Dormand and Prince, fifth order, its step chosen so that each one's error stays below a
//! tolerance. It knows nothing of exponentials, events or modes.

const A: [&[f64]; 6] = [
    &[1.0 / 5.0],
    &[3.0 / 40.0, 9.0 / 40.0],
    &[44.0 / 45.0, -56.0 / 15.0, 32.0 / 9.0],
    &[19372.0 / 6561.0, -25360.0 / 2187.0, 64448.0 / 6561.0, -212.0 / 729.0],
    &[9017.0 / 3168.0, -355.0 / 33.0, 46732.0 / 5247.0, 49.0 / 176.0, -5103.0 / 18656.0],
    &[35.0 / 384.0, 0.0, 500.0 / 1113.0, 125.0 / 192.0, -2187.0 / 6784.0, 11.0 / 84.0],
];
const C: [f64; 6] = [0.2, 0.3, 0.8, 8.0 / 9.0, 1.0, 1.0];
/// Fifth order less fourth order.
const E: [f64; 7] =
    [71.0 / 57600.0, 0.0, -71.0 / 16695.0, 71.0 / 1920.0, -17253.0 / 339200.0, 22.0 / 525.0, -1.0 / 40.0];

/// State at `end` of `x' = f(t, x)` from `x` at `t = 0`; each step is off by less than `tolerance`.
pub fn integrate<const N: usize>(
    mut x: [f64; N],
    end: f64,
    tolerance: f64,
    f: impl Fn(f64, &[f64; N]) -> [f64; N],
) -> [f64; N] {
    let (mut t, mut h) = (0.0, end / 64.0);
    while t < end {
        h = h.min(end - t);
        let (whole, mut error) = step(&x, t, h, &f);
        // A kink can fool one estimate; two halves see it from elsewhere.
        let (middle, first) = step(&x, t, h / 2.0, &f);
        let (next, second) = step(&middle, t + h / 2.0, h / 2.0, &f);
        error = error.max(first).max(second);
        error = whole.iter().zip(&next).fold(error, |most, (a, b)| most.max((a - b).abs()));
        // A kink is crossed with steps that nothing can go wrong in.
        if error <= tolerance || h < end * 1e-13 {
            x = next;
            t = if h == end - t { end } else { t + h };
        }
        let factor = 0.9 * libm::pow(tolerance / error.max(tolerance * 1e-6), 0.2);
        h *= factor.clamp(0.2, 4.0);
    }
    x
}

fn step<const N: usize>(
    x: &[f64; N],
    t: f64,
    h: f64,
    f: &impl Fn(f64, &[f64; N]) -> [f64; N],
) -> ([f64; N], f64) {
    let mut slopes = vec![f(t, x)];
    let mut at = *x;
    for (weights, share) in A.iter().zip(C) {
        at = moved(x, h, weights, &slopes);
        slopes.push(f(t + share * h, &at));
    }
    let off = moved(&[0.0; N], h, &E, &slopes);
    (at, off.iter().fold(0.0, |most, off| most.max(off.abs())))
}

fn moved<const N: usize>(x: &[f64; N], h: f64, weights: &[f64], slopes: &[[f64; N]]) -> [f64; N] {
    std::array::from_fn(|i| x[i] + h * weights.iter().zip(slopes).map(|(w, slope)| w * slope[i]).sum::<f64>())
}

#[test]
fn the_integrator_follows_a_pendulum_of_small_swing() {
    let [x, v] = integrate([1.0, 0.0], 10.0, 1e-14, |_, &[x, v]| [v, -x]);
    crate::assert_near(x, libm::cos(10.0), 1e-12);
    crate::assert_near(v, -libm::sin(10.0), 1e-12);
}
