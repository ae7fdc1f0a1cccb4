//! Tests of files read by ngspice and sigrok-cli.

use std::collections::BTreeMap;

use signal::{Kind, Waveform};
use waveform::Format;

use crate::sample::{RETRACE, SAMPLES, header, held, pulse, said, second, tool, waveforms, written};

/// What is on the wire, in volts where it has any.
fn volts(place: usize, waveform: &Waveform, sample: usize) -> f64 {
    let wire = header(3..6).wires[place];
    match waveform.signal.kind {
        Kind::Event => f64::from(u8::from(pulse(waveform, sample).is_some())),
        Kind::Bus => held(waveform, sample),
        Kind::Gate | Kind::Analog => (held(waveform, sample) - wire.datum) / wire.full_scale * wire.volts,
    }
}

#[test]
fn ngspice_loads_raw() {
    let (folder, path) = written(Format::Raw);
    let names: Vec<&str> = header(3..6).wires.iter().map(|wire| wire.signal.name).collect();
    let out = folder.path().join("out.txt");
    let script = format!(
        "* waveforms\n.control\nset numdgt=16\nset wr_singlescale\nload {}\nsetplot tran1\nwrdata {} {}\ndisplay\nquit\n.endc\n.end\n",
        path.display(),
        out.display(),
        names.join(" ")
    );
    let deck = folder.path().join("deck.cir");
    std::fs::write(&deck, script).unwrap();
    let Some(output) = tool("ngspice", &["-b", deck.to_str().unwrap()]) else { return };
    let display = String::from_utf8_lossy(&output.stdout).into_owned();
    assert!(display.contains("tg.height") && display.contains("voltage, real, 150 long"), "{display}");
    assert!(display.contains("notype, real, 150 long"), "{display}");
    let text = std::fs::read_to_string(&out).unwrap_or_else(|_| panic!("{display}"));
    let mut rows = text.lines();
    for sweep in 3..6 {
        let waveforms = waveforms(sweep);
        for sample in 0..SAMPLES {
            let numbers: Vec<f64> =
                rows.next().unwrap().split_whitespace().map(|word| word.parse().unwrap()).collect();
            assert_eq!(numbers.len(), names.len() + 1);
            assert!((numbers[0] - second(sweep, sample)).abs() < 1e-15);
            for (place, waveform) in waveforms.iter().enumerate() {
                let (found, expected) = (numbers[place + 1], volts(place, waveform, sample));
                let close = (found - expected).abs() <= 1e-14 * expected.abs().max(1.0);
                assert!(close, "{} {sweep} {sample}: {found} {expected}", waveform.signal.name);
            }
        }
    }
    assert_eq!(rows.next(), None);
}

/// Prints the first and the last value of each vector of a raw file, and how many there are.
const READ_RAW: &str = "
import sys
from spicelib import RawRead
raw = RawRead(sys.argv[1])
for name in raw.get_trace_names():
    wave = raw.get_trace(name).get_wave(0)
    print(name, len(wave), repr(float(wave[0])), repr(float(wave[-1])))
";

/// spicelib's reader (Python) finds the layout of the file by itself.
#[test]
fn spicelib_reads_raw() {
    let (_folder, path) = written(Format::Raw);
    let Some(known) = tool("python3", &["-c", "import spicelib"]) else { return };
    if !known.status.success() {
        return eprintln!("SKIPPED: python3 has no spicelib; its reader of raw files is not tested");
    }
    let text = said(tool("python3", &["-c", READ_RAW, path.to_str().unwrap()]).unwrap());
    let mut lines = text.lines();
    assert!(lines.next().unwrap().starts_with(&format!("time {} ", 3 * SAMPLES)), "{text}");
    let ends = [(3, 0), (5, SAMPLES - 1)].map(|(sweep, sample)| (waveforms(sweep), sample));
    for (place, wire) in header(3..6).wires.iter().enumerate() {
        let words: Vec<&str> = lines.next().unwrap().split(' ').collect();
        assert_eq!(words[..2], [wire.signal.name.to_lowercase(), (3 * SAMPLES).to_string()]);
        for ((waveforms, sample), word) in ends.iter().zip(&words[2..]) {
            assert_eq!(word.parse::<f64>().unwrap(), volts(place, &waveforms[place], *sample), "{text}");
        }
    }
}

/// Prints the members of a zip that hold logic or numbers: name, then bytes or the bits of f32.
const UNPACK: &str = "
import sys, zipfile, struct
archive = zipfile.ZipFile(sys.argv[1])
for name in archive.namelist():
    data = archive.read(name)
    if name.startswith('logic-1'):
        print(name, *data)
    if name.startswith('analog-1'):
        print(name, *struct.unpack('<%dI' % (len(data) // 4), data))
";

/// sigrok reads the session, and writes down what it has read: the same logic, and the same numbers to the bit.
#[test]
fn sigrok_opens_sr() {
    let (folder, path) = written(Format::Sr);
    let input = path.to_str().unwrap();
    let Some(output) = tool("sigrok-cli", &["-i", input, "--show"]) else { return };
    let show = said(output);
    assert!(show.contains("Samplerate: 73127"), "{show}");
    let count = 3 * (SAMPLES + RETRACE);
    assert!(show.contains(&format!("Logic sample count: {count}")), "{show}");
    assert!(show.contains(&format!("Analog sample count: {count}")), "{show}");
    let again = folder.path().join("again.sr");
    said(tool("sigrok-cli", &["-i", input, "-O", "srzip", "-o", again.to_str().unwrap()]).unwrap());
    let Some(output) = tool("python3", &["-c", UNPACK, again.to_str().unwrap()]) else { return };
    let mut read: BTreeMap<String, Vec<u32>> = BTreeMap::new();
    for line in said(output).lines() {
        let mut words = line.split(' ');
        let channel = words.next().unwrap().rsplit_once('-').unwrap().0.to_owned();
        read.entry(channel).or_default().extend(words.map(|word| word.parse::<u32>().unwrap()));
    }
    let is_logic = ["sweep.fold.x", "sweep.polarity.x", "dpp.blank"];
    assert!(is_logic.iter().all(|name| show.contains(&format!("- {name}: logic"))), "{show}");
    let analog = |name: &&str| !is_logic.contains(name);
    let names: Vec<&str> = header(3..6).wires.iter().map(|wire| wire.signal.name).collect();
    let order: Vec<&str> = is_logic.into_iter().chain(names.iter().copied().filter(analog)).collect();
    for row in 0..count {
        let sample = (row % (SAMPLES + RETRACE)).min(SAMPLES - 1);
        for (place, waveform) in waveforms(3 + (row / (SAMPLES + RETRACE)) as u32).iter().enumerate() {
            let name = waveform.signal.name;
            let channel = order.iter().position(|known| *known == name).unwrap();
            let expected = volts(place, waveform, sample);
            if channel < is_logic.len() {
                let found = read["logic-1"][row] >> channel & 1;
                assert_eq!(found, u32::from(expected > 0.0), "{name} {row}");
            } else {
                let found = f32::from_bits(read[&format!("analog-1-{}", channel + 1)][row]);
                assert_eq!(found, expected as f32, "{name} {row}");
            }
        }
    }
}
