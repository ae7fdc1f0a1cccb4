//! The circuit of the stage, over one number or several side by side.

use std::ops::Div;

use hardware_model::AnalogParts;
use parts::{Feedthrough, LagStep, LoopLag, Multiplier, Wire};
use signal::Comparable;

use super::figures::{Draw, delay};
use super::{WIRES, span};

/// Least divisor, and least root (share of full scale): the gain of an amplifier without feedback is a thousand.
pub(super) const LEAST: f64 = 1e-3;

/// What a wire of the stage carries.
pub(super) trait Value: Wire<f64> + Comparable + Div<Output = Self> {}

impl<V: Wire<f64> + Comparable> Value for V {}

/// The parts for one step length.
#[derive(Debug, Clone)]
pub(super) struct Stage {
    /// Slope at full scale.
    slope: f64,
    /// Length of the longest normal of slopes in scale.
    span: f64,
    /// Products with the sun's words: north, east, up.
    pub(super) products: [Cell; 3],
    pub(super) squarers: [Cell; 2],
    /// Summers of N.S and of the squares.
    summers: [LagStep<f64>; 2],
    pub(super) root: Root,
    pub(super) divider: Divider,
    /// Voltage of either sign at which wires clip (share of full scale).
    saturation: f64,
    delay: f64,
}

/// A multiplier with its lag.
#[derive(Debug, Clone, Copy)]
pub(super) struct Cell {
    pub multiplier: Multiplier<f64>,
    /// What leaks of a slope past it.
    pub leak: Feedthrough<f64>,
    pub lag: LagStep<f64>,
}

/// A root by a squarer in its feedback: `scale y^2 + offset` is what it is given.
#[derive(Debug, Clone, Copy)]
pub(super) struct Root {
    pub scale: f64,
    pub offset: f64,
    pub lag: LoopLag,
}

/// A divider by a multiplier in its feedback: `scale y d + ex y + ey d + offset` is what it divides.
#[derive(Debug, Clone, Copy)]
pub(super) struct Divider {
    pub scale: f64,
    pub feed_output: f64,
    pub feed_divisor: f64,
    pub offset: f64,
    pub lag: LoopLag,
}

/// Output and input of a part at the sample that went through last.
#[derive(Debug, Clone, Copy)]
struct Held<V> {
    output: V,
    input: V,
}

/// State of the stage.
#[derive(Debug, Clone, Copy)]
pub(super) struct State<V> {
    slopes: [V; 2],
    products: [Held<V>; 3],
    squares: [Held<V>; 2],
    sums: [Held<V>; 2],
    root: Held<V>,
    divider: Held<V>,
    divisor: V,
}

/// Wires of the stage at a sample (shares of full scale).
#[derive(Debug, Clone, Copy)]
pub(super) struct Wires<V> {
    pub products: [V; 3],
    pub squares: [V; 2],
    /// N.S, and the square of |N|.
    pub sums: [V; 2],
    pub root: V,
    pub cosine: V,
}

impl<V: Copy> State<V> {
    /// Everything at `value`; the first step sets it.
    pub fn at_rest(value: V) -> Self {
        let held = Held { output: value, input: value };
        Self {
            slopes: [value; 2],
            products: [held; 3],
            squares: [held; 2],
            sums: [held; 2],
            root: held,
            divider: held,
            divisor: value,
        }
    }
}

impl<V: Value> Held<V> {
    /// The output a step later; at rest it is the input.
    #[inline(always)]
    fn take<const AT_REST: bool>(&mut self, lag: &LagStep<f64>, input: V) -> V {
        self.output = if AT_REST { input } else { lag.step(self.output, self.input, input) };
        self.input = input;
        self.output
    }

    /// The same of a loop; `gain` is that of its feedback, before and now.
    #[inline(always)]
    fn close<const AT_REST: bool>(&mut self, lag: &LoopLag, rest: V, gain: [V; 2]) -> V {
        self.output = if AT_REST { rest } else { lag.step(self.output, [self.input, rest], gain) };
        self.input = rest;
        self.output
    }
}

impl Cell {
    /// The product of `a` and `b` a step later; `change` is that of the slope.
    #[inline(always)]
    fn multiply<V: Value, const AT_REST: bool>(&self, held: &mut Held<V>, [a, b]: [V; 2], change: V) -> V {
        held.take::<AT_REST>(&self.lag, self.multiplier.product(a, b) + self.leak.of_change(change))
    }
}

impl Root {
    #[inline(always)]
    fn of<V: Value>(&self, square: V) -> V {
        let square = (square + square.like(-self.offset)) / square.like(self.scale);
        square.at_least(square.like(LEAST * LEAST)).root()
    }
}

impl Divider {
    /// What is divided by, of a root.
    #[inline(always)]
    fn divisor<V: Value>(&self, root: V) -> V {
        (root * root.like(self.scale) + root.like(self.feed_output)).at_least(root.like(LEAST))
    }

    #[inline(always)]
    fn quotient<V: Value>(&self, dividend: V, root: V, divisor: V) -> V {
        (dividend - root * root.like(self.feed_divisor) + root.like(-self.offset)) / divisor
    }
}

impl Stage {
    /// As the seed draws it, for steps of `h` seconds.
    pub fn new(h: f64, parts: &AnalogParts, seed: u64) -> Self {
        let (figures, draw) = (&parts.reflectivity, Draw::new(h, parts, seed));
        let slope = figures.slope_full_scale;
        Self {
            slope,
            span: span(slope),
            products: [0, 1, 2].map(|number| draw.cell("product", number)),
            squarers: [0, 1].map(|number| draw.cell("square", number)),
            summers: [0, 1].map(|number| draw.summer(number)),
            root: draw.root(),
            divider: draw.divider(),
            saturation: figures.saturation.map_or(f64::INFINITY, |volts| volts / parts.full_scale),
            delay: delay(parts, 1.0 / span(slope)),
        }
    }

    /// Nominal delay over level ground (s).
    pub fn delay(&self) -> f64 {
        self.delay
    }

    /// The wires a step later, under slopes to the north and to the east (m/m) and the words of the sun: north, east, up.
    #[inline(always)]
    pub fn advance<V: Value, const AT_REST: bool>(
        &self,
        state: &mut State<V>,
        slopes: [V; 2],
        words: [V; 3],
    ) -> Wires<V> {
        let full = words[0].like(1.0);
        let (none, in_scale) = (words[0].like(0.0), words[0].like(1.0 / self.slope));
        let (mut products, mut squares) = ([none; 3], [none; 2]);
        for axis in 0..2 {
            let slope = self.clip(slopes[axis] * in_scale);
            let change = if AT_REST { none } else { slope - state.slopes[axis] };
            let (product, square) = (&mut state.products[axis], &mut state.squares[axis]);
            products[axis] =
                self.clip(self.products[axis].multiply::<_, AT_REST>(product, [slope, words[axis]], change));
            squares[axis] = self.clip(self.squarers[axis].multiply::<_, AT_REST>(square, [slope; 2], change));
            state.slopes[axis] = slope;
        }
        products[2] = self.clip(self.products[2].multiply::<_, AT_REST>(
            &mut state.products[2],
            [full, words[2]],
            none,
        ));
        let sums = self.add::<V, AT_REST>(state, products, squares);
        let root = self.root.of(sums[1]);
        let scale = root.like(self.root.scale);
        let gain = [state.root.input * scale, root * scale];
        let root = self.clip(state.root.close::<AT_REST>(&self.root.lag, root, gain));
        let divisor = self.divider.divisor(root);
        let quotient = self.divider.quotient(sums[0], root, divisor);
        let gain = [state.divisor, divisor];
        let cosine = self.clip(state.divider.close::<AT_REST>(&self.divider.lag, quotient, gain));
        state.divisor = divisor;
        Wires { products, squares, sums, root, cosine }
    }

    /// N.S, and the square of |N|.
    #[inline(always)]
    fn add<V: Value, const AT_REST: bool>(
        &self,
        state: &mut State<V>,
        products: [V; 3],
        squares: [V; 2],
    ) -> [V; 2] {
        let one = products[0].like(1.0);
        let (one_over, share) = (1.0 / self.span, self.slope / self.span);
        let facing = products[2] * one.like(one_over) - (products[0] + products[1]) * one.like(share);
        let square = (squares[0] + squares[1]) * one.like(share * share) + one.like(one_over * one_over);
        [
            self.clip(state.sums[0].take::<AT_REST>(&self.summers[0], facing)),
            self.clip(state.sums[1].take::<AT_REST>(&self.summers[1], square)),
        ]
    }

    #[inline(always)]
    fn clip<V: Value>(&self, value: V) -> V {
        value.within(value.like(-self.saturation), value.like(self.saturation))
    }

    /// The wires in their units, in the order of [`crate::LIGHT`].
    pub fn in_units<V: Value>(&self, wires: &Wires<V>) -> [V; WIRES] {
        let (slope, span) = (self.slope, self.span);
        let Wires { products, squares, sums, root, cosine } = *wires;
        let scaled = |value: V, scale: f64| value * value.like(scale);
        [
            scaled(products[0], slope),
            scaled(products[1], slope),
            products[2],
            scaled(sums[0], span),
            scaled(squares[0], slope * slope),
            scaled(squares[1], slope * slope),
            scaled(sums[1], span * span),
            scaled(root, span),
            cosine,
        ]
    }
}
