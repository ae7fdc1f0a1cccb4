//! CSV and JSON, and the record beside the others.

use serde_json::Value;
use signal::{Axis, Kind};
use waveform::Format;

use crate::sample::{FRAME, SAMPLES, header, held, pulse, second, waveforms, write, written};

#[test]
fn csv_has_a_row_a_sample() {
    let (_folder, path) = written(Format::Csv);
    let text = std::fs::read_to_string(&path).unwrap();
    let mut lines = text.lines();
    assert_eq!(
        lines.next(),
        Some(
            "frame,sweep,index,time [s],sweep.range [m],sweep.fold.x [1],sweep.polarity.x [1],tg.red.hold [corner],\
             tg.height [m],dpp.blank [1],pg.present [1],sm.write [1]"
        )
    );
    for sweep in 3..6 {
        let waveforms = waveforms(sweep);
        for sample in 0..SAMPLES {
            let cells: Vec<&str> = lines.next().unwrap().split(',').collect();
            assert_eq!(cells[..3], [FRAME.to_string(), sweep.to_string(), sample.to_string()]);
            let time: f64 = cells[3].parse().unwrap();
            assert!((time - second(sweep, sample)).abs() < 1e-12);
            for (cell, waveform) in cells[4..].iter().zip(&waveforms) {
                let expected = match waveform.signal.kind {
                    Kind::Event => pulse(waveform, sample),
                    _ => Some(held(waveform, sample)),
                };
                assert_eq!(cell.parse::<f64>().ok(), expected, "{} {sample}", waveform.signal.name);
            }
        }
    }
    assert_eq!(lines.next(), None);
}

#[test]
fn json_has_an_object_a_sweep() {
    let (_folder, path) = written(Format::Json);
    let text = std::fs::read_to_string(&path).unwrap();
    let document: Value = serde_json::from_str(&text).unwrap();
    assert_eq!(document["schema"], "lunoid.waveforms/1");
    assert_eq!(document["clock"]["sample_rate"], "73200000/1001 Hz");
    assert_eq!(document["signals"][4]["full_scale"], 500.0);
    assert_eq!(document["signals"][4]["block"], "terrain-generator");
    let traces = document["traces"].as_array().unwrap();
    assert_eq!(traces.len(), 3);
    for (trace, sweep) in traces.iter().zip(3..) {
        assert_eq!(trace["sweep"], sweep);
        for waveform in waveforms(sweep) {
            let member = &trace["signals"][waveform.signal.name];
            // serde_json reads numbers to the last digit but one; as text they are all there.
            assert!(text.contains(&serde_json::to_string(&waveform.values).unwrap()));
            assert_eq!(member["values"].as_array().unwrap().len(), waveform.values.len());
            match waveform.signal.axis {
                Axis::Changes => assert!(text.contains(&serde_json::to_string(&waveform.times).unwrap())),
                _ => assert!(member["times"].is_null()),
            }
        }
    }
}

#[test]
fn a_record_stands_beside_what_has_no_units() {
    for format in [Format::Vcd, Format::Fst, Format::Npz, Format::Raw, Format::Sr] {
        let (folder, path) = written(format);
        let name = format!("w.{}.json", format.name());
        let record: Value =
            serde_json::from_slice(&std::fs::read(folder.path().join(name)).unwrap()).unwrap();
        assert_eq!(record["file"], path.file_name().unwrap().to_str().unwrap());
        assert_eq!(record["format"], format.name());
        assert_eq!(record["signals"].as_array().unwrap().len(), header(3..6).wires.len());
        assert_eq!(record["signals"][4]["datum"], 120.0);
        assert!(record["display"].as_str().unwrap().contains("line"));
    }
}

/// A VCD and an FST of one name have a save file each.
#[test]
fn vcd_and_fst_of_one_name_keep_their_own_save_files() {
    let folder = tempfile::tempdir().unwrap();
    for name in ["w.vcd", "w.fst"] {
        let format = Format::of_path(std::path::Path::new(name)).unwrap();
        let written = write(format, &folder.path().join(name), 3..6);
        assert!(written.contains(&folder.path().join(format!("{name}.gtkw"))), "{written:?}");
    }
    let saved = |name: &str| std::fs::read_to_string(folder.path().join(name)).unwrap();
    assert!(saved("w.vcd.gtkw").contains("\"w.vcd\"") && saved("w.fst.gtkw").contains("\"w.fst\""));
}

/// GTKWave draws what the save file says: reals as steps over four rows, words signed, gates as bits.
#[test]
fn a_save_file_stands_beside_what_gtkwave_opens() {
    for format in [Format::Vcd, Format::Fst] {
        let (folder, _) = written(format);
        let name = format!("w.{}", format.name());
        let text = std::fs::read_to_string(folder.path().join(format!("{name}.gtkw"))).unwrap();
        // Both names without a folder: whoever opens the save file from another one finds the waveforms beside it.
        let names = format!("[dumpfile] \"{name}\"\n[savefile] \"{name}.gtkw\"\n[timestart] ");
        assert!(text.contains(&names), "{text}");
        assert!(
            text.contains("@8420\n[color] 2\n+{sweep range [m]} sweep.range\n@20000\n-\n-\n-\n"),
            "{text}"
        );
        assert!(text.contains("@420\n[color] 1\n+{tg red hold [corner]} tg.red.hold[31:0]\n"), "{text}");
        assert!(
            text.contains("@28\n[color] 4\n+{dpp blank} dpp.blank\n")
                && text.contains("} display.sm.write\n"),
            "{text}"
        );
    }
}
