//! The circuit of an array: a node a wire.

use std::fmt::Write;

use interpreter::parts::Array;
use interpreter::parts::chain::{is_turned, units};
use interpreter::parts::figures::{AmplifierFigures, CellFigures, PEAKS, TERMS, UNITS};
use interpreter::parts::ramp::{carry, level_of, word_for};

use crate::sources::{Level, lag, stairs, straight};
use crate::written::{Netlist, Node};

/// Nodes of an array whose waveforms are kept, with the signals of the machine that they are; `{}` is the level in a name.
pub const ARRAY: [(&str, &str); 7] = [
    ("rx", "sweep.{}x"),
    ("ry", "sweep.{}y"),
    ("fx0", "tg.{}fn.x.g0"),
    ("fy3", "tg.{}fn.cy.g0"),
    ("height", "tg.{}sum.height"),
    ("slopeu", "tg.{}sum.u"),
    ("slopev", "tg.{}sum.v"),
];

/// Ascending powers of the basis functions of section 5.2, then of their slopes.
const POWERS: [[f64; 6]; 6] = [
    [1.0, 0.0, 0.0, -10.0, 15.0, -6.0],
    [0.0, 1.0, 0.0, -6.0, 8.0, -3.0],
    [0.0, 0.0, 0.5, -1.5, 1.5, -0.5],
    [0.0, 0.0, -30.0, 60.0, -30.0, 0.0],
    [1.0, 0.0, -18.0, 32.0, -15.0, 0.0],
    [0.0, 1.0, -4.5, 6.0, -2.5, 0.0],
];

/// What is written as a circuit.
#[derive(Debug, Clone, Copy)]
pub struct Circuit<'a> {
    /// First line of the file.
    pub title: &'a str,
    /// The array as the sweep drives it.
    pub array: &'a Array,
    /// Points of broken lines of function generators ([`interpreter::parts::Drawn`]).
    pub broken_lines: &'a [Vec<f64>],
    /// What stands before the names of its signals, behind the block: `coarse.`, or nothing.
    pub level: &'a str,
}

/// The circuit of an array.
pub fn of_array(circuit: &Circuit<'_>) -> Netlist {
    let array = circuit.array;
    let node = |(number, (name, signal)): (usize, &(&'static str, &str))| Node {
        name,
        signal: signal.replace("{}", circuit.level),
        full_scale: full_scale(array, number),
    };
    Netlist {
        text: text(circuit),
        nodes: ARRAY.iter().enumerate().map(node).collect(),
        edges: edges(array),
        step: array.figures.step,
        begins: array.begins,
        last: (array.accumulators.len() as i64 - 1 + array.begins) as usize,
    }
    .ended()
}

/// Instants at which a word or the polarity changes, or a ramp folds (steps from the first sample).
fn edges(array: &Array) -> Vec<f64> {
    let words = array.words.taken.iter().flatten().flatten().map(|word| word.at);
    let turns = array.words.turns.iter().map(|(at, _)| *at);
    let corners = array.corners.iter().flatten();
    let folds = corners.filter(|[_, value]| *value == 0.0 || *value == 1.0).map(|[at, _]| *at);
    let mut edges: Vec<f64> = words.chain(turns).chain(folds).filter(|at| at.is_finite()).collect();
    edges.sort_by(f64::total_cmp);
    edges
}

/// Full scale of a node of [`ARRAY`]: of ramps and function generators 1.
fn full_scale(array: &Array, node: usize) -> f64 {
    let scales = &array.figures.scales;
    match node {
        0..=3 => 1.0,
        4 => scales.height,
        _ => scales.slope / array.region_size,
    }
}

/// All parts of an array, and its outputs.
fn text(circuit: &Circuit<'_>) -> String {
    let Circuit { title, array, .. } = *circuit;
    let mut text = format!("* {}\n", title.replace('\n', " "));
    for axis in 0..2 {
        ramp(circuit, axis, &mut text);
        functions(circuit, axis, &mut text);
        polarity(array, axis, &mut text);
    }
    for sum in 0..3 {
        for term in 0..TERMS {
            cell(circuit, sum, term, &mut text);
        }
        tree(array, sum, &mut text);
    }
    outputs(array, &mut text);
    text
}

impl Circuit<'_> {
    /// Seconds of an instant in steps from the first sample.
    fn seconds(&self, at: f64) -> f64 {
        (at - self.array.begins as f64) * self.array.figures.step
    }
}

/// Accumulator, converter and smoother, up to node `rx` or `ry`.
fn ramp(circuit: &Circuit<'_>, axis: usize, text: &mut String) {
    let array = circuit.array;
    let (figures, name) = (&array.figures.ramps[axis], ["x", "y"][axis]);
    let settled = format!("s{name}");
    match figures.bits {
        None => {
            let corner = |[at, value]: &[f64; 2]| [circuit.seconds(*at), *value];
            let points: Vec<_> = array.corners[axis].iter().map(corner).collect();
            *text += &straight(&format!("a{name}"), &points);
            lag(&format!("a{name}"), &settled, 0.0, text);
        }
        Some(bits) => {
            let mut before = None;
            let levels = array.accumulators.iter().zip(0..).map(|(accumulators, number)| {
                let word = word_for(accumulators[axis], bits);
                let rises = before.is_none_or(|before| word > before);
                let area = before.map_or(0.0, |before| figures.glitch * carry(before, word, bits));
                before = Some(word);
                let at = f64::from(number) * array.figures.step;
                Level {
                    at,
                    level: level_of(word, bits, figures.nonlinearity),
                    pulse: if rises { area } else { -area },
                }
            });
            *text += &stairs(&format!("a{name}"), &levels.collect::<Vec<_>>());
            lag(&format!("a{name}"), &settled, figures.settle, text);
        }
    }
    let out = format!("r{name}");
    if figures.smoother > 0.0 {
        // Damping 0.8: R sqrt(C / L) / 2.
        let s = figures.smoother;
        let _ = writeln!(
            text,
            "Eb{name} b{name} 0 {settled} 0 1\nRm{name} b{name} c{name} 1.6\nLm{name} c{name} {out} {s:.15e}\nCm{name} {out} 0 {s:.15e}"
        );
    } else {
        lag(&settled, &out, 0.0, text);
    }
}

/// Function generators of an axis: `gx0` in front of its lag, `fx0` behind it.
fn functions(circuit: &Circuit<'_>, axis: usize, text: &mut String) {
    let name = ["x", "y"][axis];
    for unit in 0..UNITS {
        let fed = if unit / 3 % 2 == 0 { format!("v(r{name})") } else { format!("(1-v(r{name}))") };
        let curve = 3 * (unit / 6) + unit % 3;
        let figures = &circuit.array.figures.functions[axis][unit];
        let value = match circuit.broken_lines.get(curve) {
            Some(points) => broken(&fed, points),
            None => polynomial(&fed, &POWERS[curve].map(|power| power / PEAKS[curve])),
        };
        let bow = 4.0 * figures.bow;
        let _ = writeln!(text, "Bg{name}{unit} g{name}{unit} 0 V={value}+{bow:.15e}*{fed}*(1-{fed})");
        lag(&format!("g{name}{unit}"), &format!("f{name}{unit}"), figures.tau, text);
    }
}

/// A line through points at equal distances over 0..=1.
fn broken(fed: &str, points: &[f64]) -> String {
    let last = (points.len() - 1) as f64;
    let mut text = format!("pwl({fed}");
    for (number, point) in points.iter().enumerate() {
        if number % 6 == 0 {
            text += "\n+ ";
        }
        let _ = write!(text, ",{:.12e},{point:.15e}", number as f64 / last);
    }
    text + ")"
}

/// A polynomial of ascending powers, by Horner's scheme.
fn polynomial(fed: &str, powers: &[f64; 6]) -> String {
    let [first, rest @ ..] = powers;
    let inner = rest.iter().rev().fold(String::new(), |inner, power| match inner.as_str() {
        "" => format!("{power:.15e}"),
        inner => format!("({power:.15e}+{fed}*{inner})"),
    });
    format!("({first:.15e}+{fed}*{inner})")
}

/// Polarity of an axis, `px` or `py`: 1 or -1.
fn polarity(array: &Array, axis: usize, text: &mut String) {
    let mut polarity = array.polarity[axis];
    let mut levels = vec![Level { at: 0.0, level: polarity, pulse: 0.0 }];
    for (at, _) in array.words.turns.iter().filter(|(_, turned)| *turned == axis) {
        polarity = -polarity;
        let at = (at - array.begins as f64) * array.figures.step;
        if at <= 0.0 {
            levels.clear();
        }
        levels.push(Level { at, level: polarity, pulse: 0.0 });
    }
    *text += &stairs(["px", "py"][axis], &levels);
}

/// A factor with its sign, and its rate without the turns: what the lag of the function generator says of it.
fn factor(array: &Array, axis: usize, unit: usize) -> [String; 2] {
    let name = ["x", "y"][axis];
    let sign = match (is_turned(unit), unit / 3 % 2) {
        (false, _) => String::new(),
        (true, 0) => format!("*v(p{name})"),
        (true, _) => format!("*(-v(p{name}))"),
    };
    let tau = array.figures.functions[axis][unit].tau;
    let rate = if tau > 0.0 {
        format!("((v(g{name}{unit})-v(f{name}{unit})){sign}/{tau:.15e})")
    } else {
        format!("ddt(v(f{name}{unit}){sign})")
    };
    [format!("(v(f{name}{unit}){sign})"), rate]
}

/// A multiplier and its D/A: `m` its product, `d` what the D/A makes of it, `o` with what leaks past.
fn cell(circuit: &Circuit<'_>, sum: usize, term: usize, text: &mut String) {
    let array = circuit.array;
    let (step, begins) = (array.figures.step, array.begins as f64);
    let CellFigures { gain, feed, offset, bend, leak, tau, converter_tau, past, .. } =
        array.figures.cells[sum][term];
    let [x, y] = units(sum, term);
    let ([a, rate], [b, _]) = (factor(array, 0, x), factor(array, 1, y));
    let id = format!("{sum}_{term}");
    let _ = write!(text, "Bn{id} n{id} 0 V={:.15e}*{a}*{b}", 1.0 + gain);
    if feed != [0.0; 2] || offset != 0.0 || bend != 0.0 {
        let _ = write!(
            text,
            "+{:.15e}*{a}+{:.15e}*{b}+{offset:.15e}+{bend:.15e}*{a}*(1-{a}*{a})",
            feed[0], feed[1]
        );
    }
    if leak != 0.0 {
        let _ = write!(text, "+{leak:.15e}*{rate}");
    }
    *text += "\n";
    lag(&format!("n{id}"), &format!("m{id}"), tau, text);
    let mut levels: Vec<Level> = Vec::new();
    for word in &array.words.taken[sum][term] {
        let at = (word.at - begins) * step;
        if at <= 0.0 {
            levels.clear();
        }
        levels.push(Level { at, level: word.weight, pulse: word.pulse });
    }
    *text += &stairs(&format!("w{id}"), &levels);
    let _ = writeln!(text, "Bq{id} q{id} 0 V=v(m{id})*v(w{id})");
    lag(&format!("q{id}"), &format!("d{id}"), converter_tau, text);
    let leaks = match (past, tau) {
        (0.0, _) => String::new(),
        (past, 0.0) => format!("+{past:.15e}*ddt(v(m{id}))"),
        (past, tau) => format!("+{:.15e}*(v(n{id})-v(m{id}))", past / tau),
    };
    let _ = writeln!(text, "Bo{id} o{id} 0 V=v(d{id}){leaks}");
}

/// A summing tree, up to node `t0`, `t1` or `t2`.
fn tree(array: &Array, sum: usize, text: &mut String) {
    let inputs = array.figures.inputs;
    let mut nodes: Vec<String> = (0..TERMS).map(|term| format!("o{sum}_{term}")).collect();
    for (stage, amplifiers) in array.figures.trees[sum].iter().enumerate() {
        let mut out = Vec::new();
        for (number, figures) in amplifiers.iter().enumerate() {
            let first = inputs * number;
            let last = (first + inputs).min(nodes.len());
            let id = format!("{sum}_{stage}_{number}");
            let _ = writeln!(text, "Bu{id} u{id} 0 V={}", added(&nodes[first..last]));
            amplifier(figures, &id, text);
            out.push(format!("z{id}"));
        }
        nodes = out;
    }
    let _ = writeln!(text, "Bt{sum} t{sum} 0 V={}", added(&nodes));
}

fn added(nodes: &[String]) -> String {
    nodes.iter().map(|node| format!("v({node})")).collect::<Vec<_>>().join("+")
}

/// An amplifier from node `u` to node `z`: `y` its output before the clip, `e` its stored overload.
fn amplifier(figures: &AmplifierFigures, id: &str, text: &mut String) {
    let AmplifierFigures { tau, slew, saturation, recovery } = *figures;
    if tau == 0.0 || slew == f64::INFINITY {
        lag(&format!("u{id}"), &format!("y{id}"), tau, text);
    } else {
        // A nanofarad: rates of full scales a second are nanoamperes.
        let _ = writeln!(
            text,
            "By{id} 0 y{id} I=1e-9*min(max((v(u{id})-v(y{id}))/{tau:.15e},-{slew:.15e}),{slew:.15e})\nCy{id} y{id} 0 1e-9"
        );
    }
    if saturation == f64::INFINITY {
        let _ = writeln!(text, "Bz{id} z{id} 0 V=v(y{id})");
        return;
    }
    let clipped = |value: &str| format!("min(max({value},-{saturation:.15e}),{saturation:.15e})");
    let beyond = format!("v(y{id})-{}", clipped(&format!("v(y{id})")));
    if recovery > 0.0 {
        let _ = writeln!(
            text,
            "Bx{id} x{id} 0 V={beyond}\nRe{id} x{id} e{id} 1\nCe{id} e{id} 0 {recovery:.15e}\nBz{id} z{id} 0 V={}",
            clipped(&format!("v(y{id})+v(e{id})"))
        );
    } else {
        let _ = writeln!(text, "Bz{id} z{id} 0 V={}", clipped(&format!("v(y{id})")));
    }
}

/// The sums in the units of the machine's signals.
fn outputs(array: &Array, text: &mut String) {
    let (scales, d) = (&array.figures.scales, array.region_size);
    let _ = writeln!(
        text,
        "Bheight height 0 V=v(t0)*{:.15e}+{:.15e}\nBslopeu slopeu 0 V=v(t1)*{:.15e}\nBslopev slopev 0 V=v(t2)*{:.15e}",
        scales.height,
        scales.datum + array.trim,
        scales.slope / d,
        scales.slope / d
    );
}
