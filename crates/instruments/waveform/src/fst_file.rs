//! FST: changes in binary, for GTKWave and Surfer.

use std::io::{self, BufWriter, Write};

use fst_writer::{
    FstBodyWriter, FstFileType, FstHeaderWriter, FstInfo, FstScopeType, FstSignalId, FstSignalType,
    FstVarDirection, FstVarType, FstWriteError,
};
use signal::Wire;

use crate::changes::{Change, Timeline};
use crate::encoder::Encoder;
use crate::header::{Form, has_volts, is_high};
use crate::output::Output;
use crate::tree::{Scope, path};
use crate::vcd_file::{TOLD, bits};
use crate::{Header, SweepTraces};

type Out = BufWriter<Box<dyn Output>>;

/// Changes that are kept before they are written, in bytes.
const MOST_KEPT: usize = 8 << 20;
/// Scope of what the format cannot say of its variables: full scale, voltage there and value at 0 V, as parameters.
const SCALE: &str = "scale";

/// Writes definitions first, and the values of time zero with the first sweep.
pub struct FstFile {
    header: Header,
    timeline: Timeline,
    variables: Vec<Variable>,
    parameters: Vec<(FstSignalId, f64)>,
    began: bool,
    now: u64,
    /// Pulses that are high now.
    high: Vec<FstSignalId>,
    out: FstBodyWriter<Out>,
}

/// A wire in the file; of a pulse the pulse, one picosecond long, and the number told at it. (An event of FST would seem
/// to come at time zero as well: there every variable has a value.)
#[derive(Debug, Clone, Copy)]
struct Variable {
    form: Form,
    id: FstSignalId,
    told: FstSignalId,
}

impl FstFile {
    /// Begins a file and writes its definitions.
    pub fn new(header: &Header, output: Box<dyn Output>) -> io::Result<Self> {
        let timeline = Timeline::new(header).map_err(io::Error::other)?;
        let info = FstInfo {
            start_time: 0,
            timescale_exponent: -12,
            version: "lunoid".into(),
            date: String::new(),
            file_type: FstFileType::Verilog,
        };
        let mut out = FstHeaderWriter::new(BufWriter::new(output), &info).map_err(told)?;
        let mut variables = vec![None; header.wires.len()];
        let tree = Scope::of(&header.wires);
        define(&mut out, &tree, timeline.forms(), &mut variables).map_err(told)?;
        let parameters = scales(&mut out, &header.wires).map_err(told)?;
        let mut out = out.finish().map_err(told)?;
        // Two pulses of the same number are two pulses.
        out.set_deduplicate(false);
        let variables = variables.into_iter().flatten().collect();
        let (began, now, high) = (false, 0, Vec::new());
        Ok(Self { header: header.clone(), timeline, variables, parameters, began, now, high, out })
    }

    fn begin(&mut self, traces: &SweepTraces<'_>) -> Result<(), FstWriteError> {
        for (id, value) in &self.parameters {
            self.out.signal_change(*id, &value.to_le_bytes())?;
        }
        for (variable, value) in self.variables.iter().zip(self.timeline.begin(traces)) {
            match variable.form {
                Form::Pulse => {
                    self.out.signal_change(variable.id, b"0")?;
                    self.out.signal_change(variable.told, &value.to_le_bytes())?;
                }
                _ => write_value(&mut self.out, variable, *value)?,
            }
        }
        Ok(())
    }

    fn write(&mut self, traces: &SweepTraces<'_>) -> Result<(), FstWriteError> {
        let Self { timeline, variables, now, high, out, .. } = self;
        for &Change { time, wire, value } in timeline.changes(traces) {
            advance(out, now, high, time)?;
            write_value(out, &variables[wire], value)?;
            if variables[wire].form == Form::Pulse {
                high.push(variables[wire].id);
            }
        }
        Ok(())
    }

    fn end(&mut self) -> Result<(), FstWriteError> {
        let end = self.timeline.end(&self.header).max(self.now + 1);
        advance(&mut self.out, &mut self.now, &mut self.high, end)
    }
}

/// Goes on to `time`; pulses end on the way.
fn advance(
    out: &mut FstBodyWriter<Out>,
    now: &mut u64,
    high: &mut Vec<FstSignalId>,
    time: u64,
) -> Result<(), FstWriteError> {
    if time <= *now {
        return Ok(());
    }
    // What is kept can be written between two instants alone.
    if out.size() > MOST_KEPT {
        out.flush()?;
    }
    if !high.is_empty() {
        out.time_change(*now + 1)?;
        high.drain(..).try_for_each(|pulse| out.signal_change(pulse, b"0"))?;
    }
    *now = time;
    out.time_change(time)
}

fn define(
    out: &mut FstHeaderWriter<Out>,
    scope: &Scope,
    forms: &[Form],
    variables: &mut [Option<Variable>],
) -> Result<(), FstWriteError> {
    for &(name, wire) in &scope.wires {
        let form = forms[wire];
        let id = match form {
            Form::Real => real(out, name, FstVarType::Real)?,
            Form::Bit => bit_vector(out, name, FstVarType::Wire, 1)?,
            Form::Word => bit_vector(out, name, FstVarType::Wire, 32)?,
            Form::Pulse => bit_vector(out, name, FstVarType::Wire, 1)?,
        };
        let told = match form {
            Form::Pulse => real(out, &format!("{name}{TOLD}"), FstVarType::Real)?,
            _ => id,
        };
        variables[wire] = Some(Variable { form, id, told });
    }
    for inner in &scope.scopes {
        out.scope(inner.name, "", FstScopeType::Module)?;
        define(out, inner, forms, variables)?;
        out.up_scope()?;
    }
    Ok(())
}

/// Parameters of every wire that carries a voltage, with their values.
fn scales(out: &mut FstHeaderWriter<Out>, wires: &[Wire]) -> Result<Vec<(FstSignalId, f64)>, FstWriteError> {
    let mut parameters = Vec::new();
    out.scope(SCALE, "", FstScopeType::Module)?;
    for wire in wires.iter().filter(|wire| has_volts(wire)) {
        let (scopes, name) = path(wire);
        for scope in scopes.iter().chain([&name]) {
            out.scope(scope, "", FstScopeType::Module)?;
        }
        let values = [("full_scale", wire.full_scale), ("volts", wire.volts), ("datum", wire.datum)];
        for (name, value) in values {
            parameters.push((real(out, name, FstVarType::RealParameter)?, value));
        }
        (0..=scopes.len()).try_for_each(|_| out.up_scope())?;
    }
    out.up_scope()?;
    Ok(parameters)
}

fn real(out: &mut FstHeaderWriter<Out>, name: &str, kind: FstVarType) -> Result<FstSignalId, FstWriteError> {
    out.var(name, FstSignalType::real(), kind, FstVarDirection::Implicit, None)
}

fn bit_vector(
    out: &mut FstHeaderWriter<Out>,
    name: &str,
    kind: FstVarType,
    bits: u32,
) -> Result<FstSignalId, FstWriteError> {
    out.var(name, FstSignalType::bit_vec(bits), kind, FstVarDirection::Implicit, None)
}

fn write_value(out: &mut FstBodyWriter<Out>, variable: &Variable, value: f64) -> Result<(), FstWriteError> {
    let digit = |high: bool| if high { b'1' } else { b'0' };
    match variable.form {
        Form::Real => out.signal_change(variable.id, &value.to_le_bytes()),
        Form::Bit => out.signal_change(variable.id, &[digit(is_high(value))]),
        Form::Word => {
            let mut digits = [b'0'; 32];
            digits.iter_mut().zip(bits(value)).for_each(|(place, bit)| *place = digit(bit));
            out.signal_change(variable.id, &digits)
        }
        Form::Pulse => {
            out.signal_change(variable.id, b"1")?;
            out.signal_change(variable.told, &value.to_le_bytes())
        }
    }
}

fn told(error: FstWriteError) -> io::Error {
    match error {
        FstWriteError::Io(error) => error,
        other => io::Error::other(other),
    }
}

impl Encoder for FstFile {
    fn sweep(&mut self, traces: &SweepTraces<'_>) -> io::Result<()> {
        if !self.began {
            self.begin(traces).map_err(told)?;
            self.began = true;
        }
        self.write(traces).map_err(told)
    }

    fn finish(mut self: Box<Self>) -> io::Result<()> {
        self.end().map_err(told)?;
        self.out.finish().map_err(told)?.flush()
    }
}
