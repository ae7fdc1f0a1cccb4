//! VCD: changes as text, which every viewer reads.

use std::io::{self, BufWriter, Write};

use vcd::{IdCode, SimulationCommand, TimescaleUnit, Value, VarType, Writer};

use crate::changes::{Change, Timeline};
use crate::encoder::Encoder;
use crate::header::Form;
use crate::output::Output;
use crate::record::remark;
use crate::tree::Scope;
use crate::{Header, SweepTraces};

/// Suffix of the number that a pulse tells: an event of VCD has none.
pub const TOLD: &str = "_told";

/// Writes definitions first, and the values of time zero with the first sweep.
pub struct VcdFile {
    header: Header,
    timeline: Timeline,
    variables: Vec<Variable>,
    began: bool,
    out: Writer<BufWriter<Box<dyn Output>>>,
}

/// A wire in the file; of a pulse the event, and the number told at it.
#[derive(Debug, Clone, Copy)]
struct Variable {
    form: Form,
    code: IdCode,
    told: IdCode,
}

impl VcdFile {
    /// Begins a file and writes its definitions.
    pub fn new(header: &Header, output: Box<dyn Output>) -> io::Result<Self> {
        let timeline = Timeline::new(header).map_err(io::Error::other)?;
        let mut out = Writer::new(BufWriter::new(output));
        out.version("lunoid")?;
        out.comment(&plain(&header.title))?;
        for (key, words) in &header.provenance {
            out.comment(&plain(&format!("{key}: {words}")))?;
        }
        out.timescale(1, TimescaleUnit::PS)?;
        for wire in &header.wires {
            out.comment(&plain(&remark(wire)))?;
        }
        let mut variables = vec![None; header.wires.len()];
        define(&mut out, &Scope::of(&header.wires), timeline.forms(), &mut variables)?;
        out.enddefinitions()?;
        let variables = variables.into_iter().flatten().collect();
        Ok(Self { header: header.clone(), timeline, variables, began: false, out })
    }

    fn begin(&mut self, traces: &SweepTraces<'_>) -> io::Result<()> {
        self.out.timestamp(0)?;
        self.out.begin(SimulationCommand::Dumpvars)?;
        for (variable, value) in self.variables.iter().zip(self.timeline.begin(traces)) {
            match variable.form {
                Form::Pulse => self.out.change_real(variable.told, *value)?,
                _ => write_value(&mut self.out, variable, *value)?,
            }
        }
        self.out.end()
    }
}

/// Text for a comment: `$` would begin or end a section, and readers know ASCII alone.
fn plain(text: &str) -> String {
    let known = |c: char| match c {
        '$' => 'S',
        _ if c.is_ascii() && !c.is_control() => c,
        _ => '?',
    };
    text.chars().map(known).collect()
}

fn define(
    out: &mut Writer<impl Write>,
    scope: &Scope,
    forms: &[Form],
    variables: &mut [Option<Variable>],
) -> io::Result<()> {
    for &(name, wire) in &scope.wires {
        let form = forms[wire];
        let code = match form {
            Form::Real => out.add_var(VarType::Real, 64, name, None)?,
            Form::Bit => out.add_var(VarType::Wire, 1, name, None)?,
            Form::Word => out.add_var(VarType::Wire, 32, name, None)?,
            Form::Pulse => out.add_var(VarType::Event, 1, name, None)?,
        };
        let told = match form {
            Form::Pulse => out.add_var(VarType::Real, 64, &format!("{name}{TOLD}"), None)?,
            _ => code,
        };
        variables[wire] = Some(Variable { form, code, told });
    }
    for inner in &scope.scopes {
        out.add_module(inner.name)?;
        define(out, inner, forms, variables)?;
        out.upscope()?;
    }
    Ok(())
}

fn write_value(out: &mut Writer<impl Write>, variable: &Variable, value: f64) -> io::Result<()> {
    match variable.form {
        Form::Real => out.change_real(variable.code, value),
        Form::Bit => out.change_scalar(variable.code, crate::header::is_high(value)),
        Form::Word => out.change_vector(variable.code, bits(value).map(Value::from)),
        Form::Pulse => {
            out.change_scalar(variable.code, true)?;
            out.change_real(variable.told, value)
        }
    }
}

/// A whole number in two's complement, highest bit first.
pub fn bits(value: f64) -> impl Iterator<Item = bool> {
    // The cast takes numbers beyond 32 bits to the last that there is.
    let word = value as i32;
    (0..32).rev().map(move |bit| word >> bit & 1 == 1)
}

impl Encoder for VcdFile {
    fn sweep(&mut self, traces: &SweepTraces<'_>) -> io::Result<()> {
        if !self.began {
            self.begin(traces)?;
            self.began = true;
        }
        let mut now = None;
        for &Change { time, wire, value } in self.timeline.changes(traces) {
            if now != Some(time) {
                self.out.timestamp(time)?;
                now = Some(time);
            }
            write_value(&mut self.out, &self.variables[wire], value)?;
        }
        Ok(())
    }

    fn finish(mut self: Box<Self>) -> io::Result<()> {
        self.out.timestamp(self.timeline.end(&self.header))?;
        self.out.flush()
    }
}
