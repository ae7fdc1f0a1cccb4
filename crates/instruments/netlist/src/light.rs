//! The stage that makes light of slopes as a circuit: a node a wire.

use std::fmt::Write;

use interpreter::parts::LightStage;
use interpreter::parts::light_stage::MultiplierFigures;

use crate::sources::{lag, straight};
use crate::written::{Netlist, Node};

/// Nodes of the light whose waveforms are kept, with the signals of the machine that they are.
pub const LIGHT: [(&str, &str); 8] = [
    ("pn", "tg.light.product.n"),
    ("pe", "tg.light.product.e"),
    ("fc", "tg.light.facing"),
    ("qn", "tg.light.square.n"),
    ("qe", "tg.light.square.e"),
    ("sq", "tg.light.squares"),
    ("rt", "tg.light.root"),
    ("cs", "tg.light.cosine"),
];

/// Least root and divisor, as the parts have them.
const LEAST: f64 = 1e-3;

/// What is written as a circuit.
#[derive(Debug, Clone, Copy)]
pub struct LightCircuit<'a> {
    /// First line of the file.
    pub title: &'a str,
    /// The stage with its figures.
    pub stage: &'a LightStage,
    /// Slopes to the north and to the east at the samples of the machine (m/m).
    pub slopes: &'a [Vec<f64>; 2],
    /// Unit vector to the sun: north, east, up.
    pub to_sun: [f64; 3],
    /// Length of a sample (s).
    pub step: f64,
}

/// The circuit of the light.
pub fn of_light(circuit: &LightCircuit<'_>) -> Netlist {
    let LightCircuit { stage, step, .. } = *circuit;
    let (s, r) = (stage.scale, stage.span);
    let scales = [s, s, r, s * s, s * s, r * r, r, 1.0];
    let node = |((name, signal), full_scale): (&(&'static str, &str), f64)| Node {
        name,
        signal: (*signal).to_owned(),
        full_scale,
    };
    Netlist {
        text: text(circuit),
        nodes: LIGHT.iter().zip(scales).map(node).collect(),
        edges: Vec::new(),
        step,
        begins: 0,
        last: circuit.slopes[0].len().saturating_sub(1),
    }
    .ended()
}

fn text(circuit: &LightCircuit<'_>) -> String {
    let LightCircuit { title, stage, to_sun, step, .. } = *circuit;
    let mut text = format!("* {}\n", title.replace('\n', " "));
    for (axis, name) in ["n", "e"].into_iter().enumerate() {
        text += &straight(&format!("s{name}"), &seen(circuit, axis));
        clipped(&format!("a{name}"), &format!("v(s{name})/{:.15e}", stage.scale), stage, &mut text);
        let input = format!("v(a{name})");
        let product = format!("{:.15e}", to_sun[axis]);
        multiplier((circuit, &stage.products[axis]), &format!("m{name}"), [&input, &product], &mut text);
        multiplier((circuit, &stage.squarers[axis]), &format!("w{name}"), [&input, &input], &mut text);
    }
    let up = format!("{:.15e}", to_sun[2]);
    multiplier((circuit, &stage.products[2]), "mu", ["1", &up], &mut text);
    let (s, r) = (stage.scale, stage.span);
    summer(circuit, (0, "fa"), &format!("(v(mu)-{s:.15e}*(v(mn)+v(me)))/{r:.15e}"), &mut text);
    let squares = format!("(1+{:.15e}*(v(wn)+v(we)))/{:.15e}", s * s, r * r);
    summer(circuit, (1, "ss"), &squares, &mut text);
    let [scale, offset, tau] = stage.root;
    let square = format!("max(v(ss)-{offset:.15e},{:.15e})", scale * LEAST * LEAST);
    // The bandwidth is that of a root of full scale, where the squarer has a slope of two.
    let rate = format!("0.5*({square}-{scale:.15e}*v(yr)*v(yr))");
    solved("r", (tau * step, &rate), &format!("sqrt({square}/{scale:.15e})"), stage, &mut text);
    let [scale, feed_output, feed_divisor, offset, tau] = stage.divider;
    let divisor = format!("max({scale:.15e}*v(or)+{feed_output:.15e},{LEAST:.15e})");
    let divided = format!("(v(fa)-{feed_divisor:.15e}*v(or)-{offset:.15e})");
    let rate = format!("({divided}-{divisor}*v(yc))");
    solved("c", (tau * step, &rate), &format!("{divided}/{divisor}"), stage, &mut text);
    outputs(stage, &mut text);
    text
}

/// A slope as the stage sees it, ahead of the beam: instants (s) and slopes.
fn seen(circuit: &LightCircuit<'_>, axis: usize) -> Vec<[f64; 2]> {
    let (slopes, ahead) = (&circuit.slopes[axis], circuit.stage.ahead);
    let at = |sample: usize| slopes[sample.min(slopes.len() - 1)];
    let before = ahead.floor() as usize;
    let first = at(before) + (at(before + 1) - at(before)) * (ahead - ahead.floor());
    let later = slopes.iter().enumerate().skip(before + 1);
    let points = later.map(|(sample, slope)| [(sample as f64 - ahead) * circuit.step, *slope]);
    [[0.0, first]].into_iter().chain(points).collect()
}

/// A node that is `value` as far as it does not clip.
fn clipped(node: &str, value: &str, stage: &LightStage, text: &mut String) {
    let limit = stage.saturation;
    let _ = if limit == f64::INFINITY {
        writeln!(text, "B{node} {node} 0 V={value}")
    } else {
        writeln!(text, "B{node} {node} 0 V=min(max({value},-{limit:.15e}),{limit:.15e})")
    };
}

/// A multiplier of `a` and `b` up to node `out`; it leaks of `a`.
fn multiplier(
    (circuit, figures): (&LightCircuit<'_>, &MultiplierFigures),
    out: &str,
    [a, b]: [&str; 2],
    text: &mut String,
) {
    let MultiplierFigures { gain, feed, offset, bend, leak, tau } = *figures;
    let mut value = format!("{:.15e}*{a}*{b}", 1.0 + gain);
    let _ =
        write!(value, "+{:.15e}*{a}+{:.15e}*{b}+{offset:.15e}+{bend:.15e}*{a}*(1-{a}*{a})", feed[0], feed[1]);
    if leak != 0.0 && a.starts_with("v(") {
        let _ = write!(value, "+{:.15e}*ddt({a})", leak * circuit.step);
    }
    let _ = writeln!(text, "Bi{out} i{out} 0 V={value}");
    lag(&format!("i{out}"), &format!("l{out}"), tau * circuit.step, text);
    clipped(out, &format!("v(l{out})"), circuit.stage, text);
}

/// Summer `number` up to node `out`.
fn summer(circuit: &LightCircuit<'_>, (number, out): (usize, &str), value: &str, text: &mut String) {
    let _ = writeln!(text, "Bi{out} i{out} 0 V={value}");
    lag(&format!("i{out}"), &format!("l{out}"), circuit.stage.summers[number] * circuit.step, text);
    clipped(out, &format!("v(l{out})"), circuit.stage, text);
}

/// A loop up to node `o`: `y` before the clip moves by `rate` over its time constant, and comes to rest at `rest`.
fn solved(name: &str, (tau, rate): (f64, &str), rest: &str, stage: &LightStage, text: &mut String) {
    let _ = if tau > 0.0 {
        // A nanofarad, as amplifiers that slew have it.
        writeln!(
            text,
            "By{name} 0 y{name} I=1e-9*{rate}/{tau:.15e}\nCy{name} y{name} 0 1e-9\n.nodeset v(y{name})=0.5"
        )
    } else {
        writeln!(text, "By{name} y{name} 0 V={rest}")
    };
    clipped(&format!("o{name}"), &format!("v(y{name})"), stage, text);
}

/// The wires in the units of the machine's signals.
fn outputs(stage: &LightStage, text: &mut String) {
    let (s, r) = (stage.scale, stage.span);
    let nodes = [
        ("mn", s),
        ("me", s),
        ("fa", r),
        ("wn", s * s),
        ("we", s * s),
        ("ss", r * r),
        ("or", r),
        ("oc", 1.0),
    ];
    for ((out, _), (node, scale)) in LIGHT.iter().zip(nodes) {
        let _ = writeln!(text, "B{out} {out} 0 V=v({node})*{scale:.15e}");
    }
}
