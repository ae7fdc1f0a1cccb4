//! Steps of linear parts by the power series of their differential equations.
//!
//! A step is cut into pieces that are short against the part's time constant. Over a piece the input is a straight line, and each
//! coefficient of the output's series follows from the one before; the series is summed until nothing is left of it.

/// Coefficients of a series: with pieces of at most half a time constant the last is below 1e-20 of the first.
const ORDERS: usize = 20;

/// Pieces are at most this long (time constants, radians).
const PIECE: f64 = 0.5;

/// Beyond so many time constants nothing is left of the start of a step.
const FORGOTTEN: f64 = 45.0;

/// What a step makes of output and input: `y1 = keep y0 + from u0 + to u1`.
#[derive(Debug, Clone, Copy, Default)]
pub struct LagMap {
    /// Weight of the output at the start of the step.
    pub keep: f64,
    /// Weight of the input at the start of the step.
    pub from: f64,
    /// Weight of the input at the end of the step.
    pub to: f64,
}

impl LagMap {
    /// Of `tau y' = u - y` over `time`, in the unit of `tau`.
    pub fn of(time: f64, tau: f64) -> Self {
        if time == 0.0 {
            return Self { keep: 1.0, from: 0.0, to: 0.0 };
        }
        if tau == 0.0 {
            return Self { keep: 0.0, from: 0.0, to: 1.0 };
        }
        let ratio = time / tau;
        if ratio > FORGOTTEN {
            return Self { keep: 0.0, from: 1.0 / ratio, to: 1.0 - 1.0 / ratio };
        }
        let answer = |y: f64, input: [f64; 2]| lag(y, input, ratio);
        Self { keep: answer(1.0, [0.0; 2]), from: answer(0.0, [1.0, 0.0]), to: answer(0.0, [0.0, 1.0]) }
    }

    /// Output at the end of the step.
    pub fn step(&self, y: f64, [u0, u1]: [f64; 2]) -> f64 {
        self.keep * y + self.from * u0 + self.to * u1
    }
}

/// The output after `ratio` time constants.
fn lag(mut y: f64, [u0, u1]: [f64; 2], ratio: f64) -> f64 {
    let pieces = (ratio / PIECE).ceil();
    let (r, climb) = (ratio / pieces, (u1 - u0) / pieces);
    for piece in 0..pieces as usize {
        let input = [u0 + climb * piece as f64, climb];
        let (mut coefficient, mut sum) = (y, y);
        for order in 0..ORDERS {
            let driven = input.get(order).copied().unwrap_or(0.0);
            coefficient = r * (driven - coefficient) / (order + 1) as f64;
            sum += coefficient;
        }
        y = sum;
    }
    y
}

/// What a step makes of the output of two poles, of its rate (by the step) and of the input at both ends: rows of output and rate.
#[derive(Debug, Clone, Copy)]
pub struct TwoPoleMap([[f64; 4]; 2]);

impl TwoPoleMap {
    /// Of `y'' + 2 z w y' + w^2 y = w^2 u` over `time`; `1 / w` is `inverse`, in the unit of `time`.
    pub fn of(time: f64, inverse: f64, damping: f64) -> Self {
        let poles = [time / inverse, damping];
        Self::by_columns(|state, [u0, u1]| two_poles(state, poles, u0, [u1 - u0, 0.0]))
    }

    /// The same for an input that goes from `u0` to `u1` by a lag of `tau`, in the unit of `time`.
    pub fn settling(time: f64, inverse: f64, damping: f64, tau: f64) -> Self {
        // The lag is followed over this share of the step; after it the input is `u1`.
        let lagged = if time > 0.0 { (FORGOTTEN * tau / time).min(1.0) } else { 0.0 };
        let angle = time / inverse;
        let over = |share: f64, [y, rate]: [f64; 2], input: f64, drive: [f64; 2]| match share > 0.0 {
            true => {
                let [y, rate] = two_poles([y, rate * share], [angle * share, damping], input, drive);
                [y, rate / share]
            }
            false => [y, rate],
        };
        let fade = lagged * time / tau;
        Self::by_columns(|state, [u0, u1]| {
            over(1.0 - lagged, over(lagged, state, u0, [fade * u1, fade]), u1, [0.0; 2])
        })
    }

    /// Each column is what `step` makes of a one in its place: output, rate, and input at both ends.
    fn by_columns(step: impl Fn([f64; 2], [f64; 2]) -> [f64; 2]) -> Self {
        let columns = [0, 1, 2, 3].map(|one| {
            let [y, rate, u0, u1] = [0, 1, 2, 3].map(|place| if place == one { 1.0 } else { 0.0 });
            step([y, rate], [u0, u1])
        });
        Self([0, 1].map(|row| columns.map(|column| column[row])))
    }

    /// Output and rate at the end of the step.
    pub fn step(&self, [y, rate]: [f64; 2], [u0, u1]: [f64; 2]) -> [f64; 2] {
        self.0.map(|row| row[0] * y + row[1] * rate + row[2] * u0 + row[3] * u1)
    }
}

/// Output and rate after a stretch, of two poles of an angle and a damping; both rates are by the stretch. `input` is what drives them as
/// it begins, and by the stretch it changes as `climb - fade input`.
fn two_poles(
    [mut y, rate]: [f64; 2],
    [angle, damping]: [f64; 2],
    mut input: f64,
    [climb, fade]: [f64; 2],
) -> [f64; 2] {
    let pieces = (angle.max(fade) / PIECE).ceil().max(1.0);
    let [w, climb, fade] = [angle, climb, fade].map(|whole| whole / pieces);
    let mut rate = rate / pieces;
    for _ in 0..pieces as usize {
        let (mut coefficients, mut driven) = ([y, rate], input);
        let mut sums = [y + rate, rate];
        for order in 0..ORDERS {
            let [below, last] = coefficients;
            let (first, second) = ((order + 1) as f64, (order + 2) as f64);
            let next = (w * w * (driven - below) - 2.0 * damping * w * first * last) / (first * second);
            coefficients = [last, next];
            sums = [sums[0] + next, sums[1] + second * next];
            let constant = if order == 0 { climb } else { 0.0 };
            driven = (constant - fade * driven) / first;
            input += driven;
        }
        [y, rate] = sums;
    }
    [y, rate * pieces]
}
