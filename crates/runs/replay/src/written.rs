//! Whether a run has written a file: each of its files says so in its first bytes. A name alone is no proof.

use std::io::Read;
use std::path::Path;

use picture::{SOFTWARE, png_texts};
use remote_shadow::has_tiles;

use crate::truth::TruthItem;

/// Bytes at the start of a file in which its mark is looked for.
const HEAD_BYTES: u64 = 1 << 16;

/// First columns of every table of poses.
const POSES: &str = "frame,t_s,x_m,y_m,z_m,heading_deg,pitch_deg,roll_deg,";

/// First bytes of an OpenEXR file.
const EXR_MAGIC: [u8; 4] = [0x76, 0x2f, 0x31, 0x01];

/// Where a zip archive has the name of its first file (bytes).
const FIRST_NAME: usize = 30;

/// Whether a run wrote the file `name` of the run folder `folder`, as far as the file tells.
pub(crate) fn is_written(folder: &Path, name: &str) -> bool {
    let head = head_of(&folder.join(name)).unwrap_or_default();
    let text = String::from_utf8_lossy(&head);
    let end = Path::new(name).extension().and_then(|end| end.to_str());
    match end.unwrap_or_default() {
        "png" => has_software(&head),
        "json" | "journal" => {
            ["\"schema\": \"lunoid.", "\"schema\":\"lunoid."].iter().any(|mark| text.contains(mark))
        }
        "html" => text.contains("<meta name=\"generator\" content=\"lunoid\">"),
        "svg" => text.contains("<metadata>lunoid</metadata>"),
        "csv" => text.starts_with(POSES),
        "npz" => has_truth(&head),
        "shadow" => has_tiles(&head),
        "exr" => head.starts_with(&EXR_MAGIC) && text.contains("\"schema\":\"lunoid."),
        _ => false,
    }
}

fn head_of(path: &Path) -> Option<Vec<u8>> {
    let mut head = Vec::new();
    files::open(path).ok()?.take(HEAD_BYTES).read_to_end(&mut head).ok()?;
    Some(head)
}

fn has_software(head: &[u8]) -> bool {
    let (keyword, program) = SOFTWARE;
    png_texts(head).iter().any(|(found, text)| found == keyword && text.starts_with(program))
}

/// Whether the first file of a zip archive is an array of the ground truth.
fn has_truth(head: &[u8]) -> bool {
    let name = head.get(FIRST_NAME..).filter(|_| head.starts_with(b"PK\x03\x04")).unwrap_or_default();
    TruthItem::ALL.iter().any(|item| name.starts_with(format!("{}.npy", item.name()).as_bytes()))
}
