//! A session of sigrok: analog channels in volts, gates and pulses as logic.

use std::io::{self, Write};

use crate::encoder::Encoder;
use crate::header::{Form, is_high, volts};
use crate::held::{hold, pulses};
use crate::output::Output;
use crate::zipped::{Zip, begin, options};
use crate::{Header, SweepTraces};

/// One chunk a sweep and channel. The time of sigrok is sample number by rate: the retrace is there, with what stands.
pub struct SigrokFile {
    header: Header,
    /// Places in the header of the wires that are logic, and of those that are analog.
    logic: Vec<usize>,
    analog: Vec<usize>,
    chunk: u32,
    values: Vec<f64>,
    told: Vec<Option<f64>>,
    bytes: Vec<u8>,
    zip: Zip,
}

impl SigrokFile {
    /// Writes version and metadata.
    pub fn new(header: &Header, output: Box<dyn Output>) -> io::Result<Self> {
        let is_logic =
            |place: &usize| matches!(Form::of(&header.wires[*place].signal), Form::Bit | Form::Pulse);
        let (logic, analog): (Vec<usize>, Vec<usize>) = (0..header.wires.len()).partition(is_logic);
        let zip = begin(output);
        let (values, told, bytes) = (Vec::new(), Vec::new(), Vec::new());
        let mut file = Self { header: header.clone(), logic, analog, chunk: 0, values, told, bytes, zip };
        file.member("version", b"2")?;
        let metadata = file.metadata();
        file.member("metadata", metadata.as_bytes())?;
        Ok(file)
    }

    fn metadata(&self) -> String {
        let name = |place: &usize| self.header.wires[*place].signal.name;
        let rate = self.header.timebase.sample_rate().hertz().round();
        let mut text = "[global]\nsigrok version=0.5.2\n\n[device 1]\n".to_owned();
        if !self.logic.is_empty() {
            text += &format!("capturefile=logic-1\nunitsize={}\n", self.unit_size());
        }
        text += &format!("total probes={}\nsamplerate={rate} Hz\n", self.logic.len());
        text += &format!("total analog={}\n", self.analog.len());
        let probes = self.logic.iter().enumerate();
        text.extend(probes.map(|(place, wire)| format!("probe{}={}\n", place + 1, name(wire))));
        let channels = self.analog.iter().enumerate();
        text.extend(channels.map(|(place, wire)| format!("analog{}={}\n", self.channel(place), name(wire))));
        text
    }

    /// Bytes that hold the logic of a sample.
    fn unit_size(&self) -> usize {
        self.logic.len().div_ceil(8)
    }

    /// Number of an analog channel: they are counted on from the logic.
    fn channel(&self, place: usize) -> usize {
        self.logic.len() + place + 1
    }

    fn member(&mut self, name: &str, bytes: &[u8]) -> io::Result<()> {
        self.zip.start_file(name, options(bytes.len() as u64))?;
        self.zip.write_all(bytes)
    }

    fn write_logic(&mut self, traces: &SweepTraces<'_>) -> io::Result<()> {
        let (samples, unit) = (self.header.samples(), self.unit_size());
        let mut bytes = std::mem::take(&mut self.bytes);
        bytes.clear();
        bytes.resize(samples * unit, 0);
        for bit in 0..self.logic.len() {
            self.fill_logic(traces, self.logic[bit]);
            let set = self.values.iter().enumerate().filter(|(_, value)| is_high(**value));
            set.for_each(|(sample, _)| bytes[sample * unit + bit / 8] |= 1 << (bit % 8));
        }
        self.stretch(&mut bytes, unit);
        self.member(&format!("logic-1-{}", self.chunk), &bytes)?;
        self.bytes = bytes;
        Ok(())
    }

    fn fill_logic(&mut self, traces: &SweepTraces<'_>, wire: usize) {
        let (waveform, samples) = (&traces.waveforms[wire], self.header.samples());
        if Form::of(&waveform.signal) == Form::Bit {
            return hold(waveform, samples, &mut self.values);
        }
        pulses(waveform, samples, &mut self.told);
        self.values.clear();
        self.values.extend(self.told.iter().map(|told| f64::from(u8::from(told.is_some()))));
    }

    fn write_analog(&mut self, traces: &SweepTraces<'_>, place: usize) -> io::Result<()> {
        let wire = self.analog[place];
        hold(&traces.waveforms[wire], self.header.samples(), &mut self.values);
        let mut bytes = std::mem::take(&mut self.bytes);
        bytes.clear();
        let volts = |value: &f64| volts(&self.header.wires[wire], *value) as f32;
        self.values.iter().for_each(|value| bytes.extend(volts(value).to_le_bytes()));
        self.stretch(&mut bytes, 4);
        self.member(&format!("analog-1-{}-{}", self.channel(place), self.chunk), &bytes)?;
        self.bytes = bytes;
        Ok(())
    }

    /// Goes on with the last sample, of `size` bytes, through the retrace.
    fn stretch(&self, bytes: &mut Vec<u8>, size: usize) {
        let last = bytes.len().saturating_sub(size);
        (0..self.header.timebase.retrace_samples).for_each(|_| bytes.extend_from_within(last..last + size));
    }
}

impl Encoder for SigrokFile {
    fn sweep(&mut self, traces: &SweepTraces<'_>) -> io::Result<()> {
        self.chunk += 1;
        if !self.logic.is_empty() {
            self.write_logic(traces)?;
        }
        (0..self.analog.len()).try_for_each(|place| self.write_analog(traces, place))
    }

    fn finish(self: Box<Self>) -> io::Result<()> {
        self.zip.finish()?.flush()
    }
}
