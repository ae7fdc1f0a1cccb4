//! A state that is written down, and its bytes changed.

use std::sync::Arc;

use run_record::Program;
use state::{Block, BlockKind, Gone, Hashes, Head, Identity, Place, State};

fn block(kind: BlockKind, frame: u64, rows: u64, row: u64, first: f32) -> Block {
    let values = (0..rows * row).map(|at| first + at as f32).collect();
    Block { kind, frame, rows, row, values: Arc::new(values) }
}

pub fn state(frame: u64, sweep: u32, gone: Gone, stores: u64, words: Vec<String>) -> State {
    let [program, machine, scenario] = ["lunoid", "pra-nominal", "A \"drive\""].map(str::to_owned);
    let program =
        Program { name: program, version: "1".into(), commit: "2".into(), result_family: "3".into() };
    let hashes = Hashes {
        settings: "a".into(),
        view: "b".into(),
        ground: "c".into(),
        scenery: "d".into(),
        mission: "e".into(),
    };
    let rows = block(BlockKind::Rows, frame, sweep.into(), 3, 0.25);
    let earlier = |kind| (frame.saturating_sub(stores)..frame).map(move |at| block(kind, at, 4, 3, -1.5));
    let blocks = [rows].into_iter().chain(earlier(BlockKind::Store)).chain(earlier(BlockKind::Picture));
    State {
        head: Head {
            identity: Identity { program, machine, scenario, hashes },
            words,
            place: Place { frame, sweep, gone },
            tick: 77 + frame,
            time_s: frame as f64 / 30.0,
        },
        digital: "{\n  \"levels\": []\n}\n".into(),
        blocks: blocks.collect(),
    }
}

pub fn example() -> State {
    state(5, 2, Gone::Ticks(9), 2, vec!["a.toml".into(), "--sweeps".into(), "4".into()])
}

/// The checksum of changed bytes made good.
pub fn sealed(mut bytes: Vec<u8>) -> Vec<u8> {
    let mut hasher = blake3::Hasher::new();
    hasher.update(&bytes[..32]).update(&bytes[64..]);
    bytes[32..64].copy_from_slice(hasher.finalize().as_bytes());
    bytes
}

/// The file with `old` in its texts replaced by `new`, lengths and checksum made good.
pub fn reworded(old: &str, new: &str) -> Vec<u8> {
    let bytes = example().bytes();
    let header = u32::from_le_bytes(bytes[12..16].try_into().unwrap()) as usize;
    let digital = example().digital.len();
    let text = String::from_utf8(bytes[64..64 + header].to_vec()).unwrap();
    assert!(text.contains(old), "{old}: {text}");
    let text = text.replacen(old, new, 1);
    let mut out = bytes[..64].to_vec();
    out.extend_from_slice(text.as_bytes());
    out.extend_from_slice(&bytes[64 + header..64 + header + digital]);
    out.resize(out.len().next_multiple_of(64), 0);
    out.extend_from_slice(&bytes[(64 + header + digital).next_multiple_of(64)..]);
    out[12..16].copy_from_slice(&(text.len() as u32).to_le_bytes());
    let length = out.len() as u64;
    out[16..24].copy_from_slice(&length.to_le_bytes());
    sealed(out)
}
