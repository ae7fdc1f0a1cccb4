//! The save file of GTKWave: which signals are shown, and how, so that it draws curves at once.

use std::path::Path;

use signal::Wire;
use text::visible_line;

use crate::Header;
use crate::clock::Clock;
use crate::header::Form;
use crate::tree::path as tree_path;
use crate::vcd_file::TOLD;

/// Flags of a row, as GTKWave writes them in hexadecimal.
const BITS: &str = "@28";
const SIGNED_DECIMAL: &str = "@420";
const ANALOG_STEP: &str = "@8420";
const REAL: &str = "@420";
const ANALOG_HEIGHT: &str = "@20000";
const REMARK: &str = "@200";
/// Rows that a curve takes beside its own.
const ROWS: usize = 3;
/// Colours of GTKWave but red, which stands for what is unknown: orange to violet.
const COLOURS: [u32; 6] = [2, 3, 4, 5, 6, 7];
/// Widths of the window that GTKWave calls a frame (200 pixels), in the window that opens.
const FRAMES: u64 = 4;

/// The text of the save file for the waveforms at `path`. Given its own name and that of the waveforms, GTKWave looks for these beside
/// the save file, whatever folder it is started in.
pub fn text(path: &Path, header: &Header) -> String {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    let (start, zoom) = window(header);
    let mut text = format!(
        "[*]\n[*] lunoid: {}\n[*]\n[dumpfile] \"{name}\"\n[savefile] \"{name}.gtkw\"\n[timestart] {start}\n[size] 1600 900\n[pos] -1 -1\n\
         *-{zoom}.000000 {start} -1 -1 -1 -1 -1 -1 -1 -1 -1 -1 -1 -1 -1 -1 -1 -1 -1 -1 -1 -1 -1 -1 -1 -1\n\
         [sst_width] 220\n[signals_width] 300\n[sst_expanded] 1\n",
        visible_line(&header.title.lines().collect::<Vec<_>>().join(" "))
    );
    let mut block = "";
    let mut colour = COLOURS.len() - 1;
    for wire in &header.wires {
        if wire.signal.block() != block {
            block = wire.signal.block();
            colour = (colour + 1) % COLOURS.len();
            text += &format!("{REMARK}\n-{block}\n");
        }
        let (scopes, own) = tree_path(wire);
        let name = [&scopes[..], &[own]].concat().join(".");
        text += &rows(wire, &name, of_register(wire.signal.name).unwrap_or(COLOURS[colour]));
    }
    text + "[pattern_trace] 1\n[pattern_trace] 0\n"
}

/// The colour of a coloured register and of its wires; black has the window's own.
fn of_register(name: &str) -> Option<u32> {
    const REGISTERS: [(&str, u32); 4] = [("black", 0), ("red", 1), ("yellow", 3), ("green", 4)];
    let part = |colour: &str| name.split('.').any(|part| part == colour);
    REGISTERS.into_iter().find(|(colour, _)| part(colour)).map(|(_, number)| number)
}

/// Where the first sweep begins, and the zoom (the power of two of a frame's picoseconds) that shows it whole.
fn window(header: &Header) -> (u64, u32) {
    let at = |sweep| Clock::new(header).map_or(0, |clock| clock.at(sweep, 0.0));
    let (start, end) = (at(header.sweeps.start), at(header.sweeps.start + 1));
    (start, ((end - start) / FRAMES).next_power_of_two().ilog2())
}

/// The rows of a wire, under its whole name with its unit; of names with dots GTKWave shows the end alone.
fn rows(wire: &Wire, name: &str, colour: u32) -> String {
    let (own, unit) = (wire.signal.name.replace('.', " "), wire.signal.unit);
    let row =
        |flags: &str, alias: &str, name: &str| format!("{flags}\n[color] {colour}\n+{{{alias}}} {name}\n");
    let with_unit = format!("{own} [{unit}]");
    match Form::of(&wire.signal) {
        Form::Real => row(ANALOG_STEP, &with_unit, name) + ANALOG_HEIGHT + "\n" + &"-\n".repeat(ROWS),
        Form::Bit => row(BITS, &own, name),
        Form::Word => row(SIGNED_DECIMAL, &with_unit, &format!("{name}[31:0]")),
        Form::Pulse => row(BITS, &own, name) + &row(REAL, &format!("{own} told"), &format!("{name}{TOLD}")),
    }
}
