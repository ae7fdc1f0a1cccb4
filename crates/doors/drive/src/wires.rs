//! The machine as it stands: its signals, its blocks, and the faults that ship for it.

use generator::Omission;
use hardware_model::{BLOCK_TABLES, FAULTS, PartCounts, prediction, proof};
use machine::{LINKS, Link};
use serde_json::Value;
use signal::{Signal, Wire};
use toml::Table;

use crate::Drive;

/// A signal, and its wire if this machine has one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SignalRow {
    /// Signal of the table.
    pub signal: Signal,
    /// The wire with its full scale; `None` where its block is left out.
    pub wire: Option<Wire>,
}

/// A block of the machine.
#[derive(Debug, Clone, PartialEq)]
pub struct BlockRow {
    /// Name of the block.
    pub name: &'static str,
    /// Whether none of its signals has a wire in this machine.
    pub left_out: bool,
    /// Names of its signals, in the order of the signal table.
    pub signals: Vec<&'static str>,
    /// What was left out in it, and why.
    pub omissions: Vec<Omission>,
    /// Ways from it to other blocks; none of other generators than the hybrid machine.
    pub links: Vec<&'static Link>,
    /// Its parts with their numbers, in words; empty where nothing is counted.
    pub parts: Vec<String>,
    /// Tables of the hardware model that describe it.
    pub tables: &'static [&'static str],
}

/// An overlay of one fault that ships with the program.
#[derive(Debug, Clone, PartialEq)]
pub struct FaultRow {
    /// Name, as `--overlay` takes it.
    pub name: &'static str,
    /// What the overlay proves.
    pub proves: &'static str,
    /// What it predicts of the picture, in words.
    pub predicts: String,
    /// Dotted keys that it sets, with their values.
    pub keys: Vec<(String, Value)>,
}

impl Drive {
    /// All signals of the generator, in the order of its table.
    pub fn signals(&self) -> Vec<SignalRow> {
        let wires = self.bench.session.wires();
        let wire = |signal: &Signal| wires.iter().find(|wire| wire.signal.name == signal.name).copied();
        let table = self.opened.generator.signals().iter();
        table.map(|signal| SignalRow { signal: *signal, wire: wire(signal) }).collect()
    }

    /// Blocks that drive signals, in the order of the signal table; then those that only take some.
    pub fn blocks(&self) -> Vec<BlockRow> {
        let (mut blocks, omissions) = (Vec::<BlockRow>::new(), self.omissions());
        for row in self.signals() {
            let name = row.signal.block();
            let at = blocks.iter().position(|block| block.name == name).unwrap_or(blocks.len());
            if at == blocks.len() {
                let omissions = omissions.iter().filter(|omission| omission.block == name).cloned().collect();
                blocks.push(BlockRow { omissions, ..self.block(name) });
            }
            blocks[at].left_out &= row.wire.is_none();
            blocks[at].signals.push(row.signal.name);
        }
        // The tube has its signals along the lines of the display, in a table of its own.
        let ends = LINKS.iter().map(|link| link.to).filter(|_| self.opened.is_machine());
        for name in ends {
            if blocks.iter().all(|block| block.name != name) {
                blocks.push(BlockRow { left_out: false, ..self.block(name) });
            }
        }
        blocks
    }

    /// A block without its signals and omissions.
    fn block(&self, name: &'static str) -> BlockRow {
        let is_machine = self.opened.is_machine();
        let links = LINKS.iter().filter(|link| is_machine && link.from == name).collect();
        let parts = if is_machine { PartCounts::of(&self.opened.model).of_block(name) } else { Vec::new() };
        let tables = BLOCK_TABLES.iter().find(|(block, _)| is_machine && *block == name);
        let tables = tables.map_or(&[][..], |(_, tables)| tables);
        BlockRow { name, left_out: true, signals: Vec::new(), omissions: Vec::new(), links, parts, tables }
    }

    /// Overlays of one fault that ship for what draws.
    pub fn faults(&self) -> Vec<FaultRow> {
        match self.opened.row {
            None => FAULTS.iter().map(fault).collect(),
            Some(row) => row.gear.iter().flat_map(|gear| gear.faults).map(fault).collect(),
        }
    }
}

fn fault((name, text): &(&'static str, &'static str)) -> FaultRow {
    let mut keys = Vec::new();
    // A test reads every overlay that ships.
    let table = text.parse::<Table>().unwrap_or_default();
    table.into_iter().filter(|(key, _)| key != "format").for_each(|(key, value)| put(key, value, &mut keys));
    FaultRow { name, proves: proof(text), predicts: prediction(text), keys }
}

/// Adds the values below `key`, tables by their own keys.
fn put(key: String, value: toml::Value, keys: &mut Vec<(String, Value)>) {
    match value {
        toml::Value::Table(table) => {
            table.into_iter().for_each(|(below, value)| put(format!("{key}.{below}"), value, keys));
        }
        other => keys.push((key, serde_json::to_value(other).unwrap_or_default())),
    }
}
