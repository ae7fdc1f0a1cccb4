//! Stored numbers that are voids: special values of labels, masks, alpha bands, blocks that a file leaves out.

use survey::ReadOptions;

use crate::made::{
    Directory, Field, LABEL, Made, SIDE, against, bytes, floats, heights, labelled, quarters, tiff, words,
};

/// Samples `from` and those behind it, one for each mark, replaced by the marks.
fn marked(mut numbers: Vec<f64>, marks: &[f64]) -> Vec<f64> {
    numbers[30..30 + marks.len()].copy_from_slice(marks);
    numbers
}

/// Voids of a label's image, when all its heights are right.
fn voids(made: &Made) -> usize {
    let (voids, worst) = against(&made.plain().unwrap(), 1.0, 0.0);
    assert!(worst < 1e-4, "{worst}");
    voids
}

const SATURATIONS: &str = "UNIT = METER
  CORE_NULL = -32768
  CORE_LOW_REPR_SATURATION = -32767
  CORE_LOW_INSTR_SATURATION = -32766
  CORE_HIGH_INSTR_SATURATION = -32765
  CORE_HIGH_REPR_SATURATION = -32764";

#[test]
fn all_special_values_of_integers_are_voids() {
    let marks = [-32768.0, -32767.0, -32766.0, -32765.0, -32764.0];
    let image = words(&marked(quarters(), &marks));
    assert_eq!(voids(&labelled(&[("UNIT = METER", SATURATIONS)], &image)), 5);
    // Bits, other keywords, at the top of the label.
    let bits = "UNIT = METER\n  NULL = 16#8000#\n  LOW_REPR_SAT = 16#8001#\n  INVALID = -32766";
    let top = ("RECORD_TYPE = FIXED", "NOT_APPLICABLE_CONSTANT = (-32765, -32764)\nRECORD_TYPE = FIXED");
    assert_eq!(voids(&labelled(&[("UNIT = METER", bits), top], &image)), 5);
    // Unsigned samples of 32 bits, the highest byte first.
    let marks = [0.0, 4_294_967_295.0, 4_294_967_294.0];
    let big: Vec<u8> =
        marked(quarters(), &marks).iter().flat_map(|number| (*number as u32).to_be_bytes()).collect();
    let unsigned = [
        ("LSB_INTEGER", "MSB_UNSIGNED_INTEGER"),
        ("BITS = 16", "BITS = 32"),
        ("UNIT = METER", "UNIT = METER\n CORE_NULL = 0\n SATURATION_CONSTANT = {4294967294, 16#FFFFFFFF#}"),
    ];
    assert_eq!(voids(&labelled(&unsigned, &big)), 3);
}

#[test]
fn all_special_values_of_reals_are_voids() {
    let special = |bits: u32| f64::from(f32::from_bits(bits));
    let image = floats(&marked(heights(), &[special(0xff7f_fffb), special(0xff7f_fffc)]));
    let real = |marks: &'static str| {
        [
            ("LSB_INTEGER", "PC_REAL"),
            ("BITS = 16", "BITS = 32"),
            ("FACTOR = 0.25", "FACTOR = 1"),
            ("UNIT = METER", marks),
        ]
    };
    let both = "UNIT = METER\n CORE_NULL = 16#FF7FFFFB#\n CORE_LOW_REPR_SATURATION = 16#FF7FFFFC#";
    assert_eq!(voids(&labelled(&real(both), &image)), 2);
    let least = "UNIT = METER\n VALID_MINIMUM = -9000";
    let made = labelled(&real(least), &image);
    assert_eq!(voids(&made), 2);
    assert!(made.plain().unwrap().notes[0].starts_with("2 samples lie beyond -9000 to inf"), "told");
    let text = "UNIT = METER\n MISSING_CONSTANT = (-3.4028226550889045e+38, 16#FF7FFFFC#)";
    assert_eq!(voids(&labelled(&real(text), &image)), 2);
    // Nothing declares them: the advice of each refusal leads to the next, and out.
    let undeclared = labelled(&real("UNIT = METER"), &image);
    assert_eq!(crate::advice::no_data(&undeclared), 2);
}

#[test]
fn lists_and_ranges_are_voids() {
    let image = words(&marked(quarters(), &[-32768.0, -32767.0, -32700.0, -32752.0]));
    let with = |marks: &str| {
        let unit = format!("UNIT = METER\n  {marks}");
        voids(&labelled(&[("UNIT = METER", &unit)], &image))
    };
    assert_eq!(with("INVALID_CONSTANT = (-32768, -32767, -32700, -32752)"), 4);
    assert_eq!(with("INVALID_CONSTANT = {-32768..-32752, -32700}"), 4);
    assert_eq!(with("INVALID_CONSTANT = -32768..-32700"), 4);
    assert_eq!(with("VALID_MINIMUM = -32000"), 4);
    assert_eq!(with("CORE_VALID_MINIMUM = -32000\n  MISSING_CONSTANT = \"N/A\""), 4);
    for wrong in ["MISSING_CONSTANT = (-32768, many)", "CORE_NULL = 5..2", "CORE_NULL = -32768 <M>"] {
        let unit = format!("UNIT = METER\n  {wrong}");
        let refusal = labelled(&[("UNIT = METER", &unit)], &image).refusal();
        assert!(
            refusal.contains("label line 11, ") && refusal.contains("a range, or a list")
                || refusal.contains("without a unit"),
            "{refusal}"
        );
    }
    // A mark that no sample can hold may mean another one.
    let made = labelled(&[("UNIT = METER", "UNIT = METER\n  CORE_NULL = 65535")], &words(&quarters()));
    assert!(made.plain().unwrap().notes[0].contains("no sample can hold 65535"), "told");
}

/// A mask of bits that hides the 4 x 4 samples from line 8, column 12 on.
fn mask_of_bits() -> Vec<u8> {
    let hidden = |line: usize| (8..12).contains(&line);
    (0..SIDE).flat_map(|line| [0xff, if hidden(line) { 0x0f } else { 0xff }, 0xff]).collect()
}

/// The made ground, 0 where the mask hides it.
fn holed() -> Directory {
    let mut samples = heights();
    for line in 8..12 {
        samples[line * SIDE + 8..line * SIDE + 12].fill(0.0);
    }
    Directory::of(floats(&samples), 32, 3)
}

fn mask(kind: u16, bits: u16, block: Vec<u8>) -> Directory {
    let side = SIDE as u16;
    let tags =
        [(254, kind), (256, side), (257, side), (258, bits), (259, 1), (262, 4), (277, 1), (278, side)];
    Directory::new(&tags, vec![block])
}

#[test]
fn masks_in_the_file_are_voids() {
    assert_eq!(voids(&tiff(&[holed(), mask(4, 1, mask_of_bits())])), 16);
    // Behind a copy of less detail and its mask; as bytes; in tiles; by its colours alone.
    let copy = mask(1, 8, vec![9; SIDE * SIDE]).with(262, Field::Shorts(vec![1]));
    let of_copy = mask(5, 8, vec![0; SIDE * SIDE]);
    assert_eq!(voids(&tiff(&[holed(), copy.clone(), of_copy, mask(4, 1, mask_of_bits())])), 16);
    let wide: Vec<u8> =
        mask_of_bits().iter().flat_map(|byte| (0..8).map(move |k| (byte >> (7 - k) & 1) * 255)).collect();
    assert_eq!(voids(&tiff(&[holed(), mask(4, 8, wide.clone())])), 16);
    assert_eq!(voids(&tiff(&[holed(), mask(0, 1, mask_of_bits())])), 16);
    let mut tiles = mask(4, 8, vec![]);
    tiles.tags.remove(&278);
    tiles.place = [324, 325];
    tiles.put(322, Field::Shorts(vec![16]));
    tiles.put(323, Field::Shorts(vec![16]));
    let at = |line: usize, column: usize| {
        wide.get(line * SIDE + column).copied().filter(|_| column < SIDE).unwrap_or(7)
    };
    let tile = |line: usize, column: usize| {
        (0..256).map(|index| at(line + index / 16, column + index % 16)).collect::<Vec<_>>()
    };
    tiles.blocks = vec![tile(0, 0), tile(0, 16), tile(16, 0), tile(16, 16)];
    assert_eq!(voids(&tiff(&[holed(), tiles])), 16);
    // A mask of another size masks something else, and another picture is no mask.
    let mut small = mask(4, 8, vec![0; 144]);
    [256, 257, 278].iter().for_each(|tag| small.put(*tag, Field::Shorts(vec![12])));
    let refusal = tiff(&[holed(), small]).refusal();
    assert!(
        refusal.contains("directory 2: found a mask of 12 x 12") && refusal.contains("24 x 24"),
        "{refusal}"
    );
    let page = copy.with(254, Field::Shorts(vec![2]));
    let two = tiff(&[Directory::ground(), page]).plain().unwrap();
    assert!(two.notes.iter().any(|note| note.contains("directory 2 of the file is another picture")));
}

#[test]
fn a_mask_beside_the_file_is_read_and_other_metadata_are_told() {
    let beside = bytes(&[mask(0, 1, mask_of_bits()).with(262, Field::Shorts(vec![1]))]);
    let ground = bytes(&[holed()]);
    let made = Made::new(&[
        ("made.tif", &ground),
        ("made.tif.msk", &beside),
        ("made.tif.aux.xml", b"<PAMDataset/>"),
    ]);
    assert_eq!(voids(&made), 16);
    let notes = made.plain().unwrap().notes.join("\n");
    assert!(
        notes.contains("made.tif.msk masks samples") && notes.contains("made.tif.aux.xml is not read"),
        "{notes}"
    );
    let broken = Made::new(&[("made.tif", &ground), ("made.tif.msk", b"II*\0")]);
    assert!(broken.refusal().contains("made.tif.msk"));
}

/// Heights and a second band, sample by sample.
fn with_alpha(kind: u16, alpha: impl Fn(usize) -> f64) -> Directory {
    let samples: Vec<f64> = heights().iter().enumerate().flat_map(|(k, h)| [*h, alpha(k)]).collect();
    Directory::of(floats(&samples), 32, 3)
        .with(277, Field::Shorts(vec![2]))
        .with(338, Field::Shorts(vec![kind]))
}

#[test]
fn alpha_bands_are_masks() {
    let hole = |k: usize| if (100..116).contains(&k) { 0.0 } else { 255.0 };
    assert_eq!(voids(&with_alpha(2, hole).made()), 16);
    assert_eq!(voids(&with_alpha(1, hole).made()), 16);
    let faint = |k: usize| if k < 50 { 9.0 } else { hole(k) };
    assert_eq!(voids(&with_alpha(2, faint).made()), 16);
    let refusal = with_alpha(1, faint).made().refusal();
    assert!(
        refusal.contains("ExtraSamples") && refusal.contains("multiplied by an alpha of 9 of 255"),
        "{refusal}"
    );
    // Named by an item alone.
    let named = "<GDALMetadata><Item name=\"COLORINTERP\" sample=\"1\" role=\"colorinterp\">Alpha</Item></GDALMetadata>";
    assert_eq!(voids(&with_alpha(0, hole).with(42112, Field::Text(named.into())).made()), 16);
    // Chosen by the user, it is what is read; of no kind, it is one band of two.
    let second = ReadOptions { band: Some(2), ..ReadOptions::default() };
    assert_eq!(with_alpha(2, hole).made().read(&second).unwrap().range(), Some([0.0, 255.0]));
    assert!(with_alpha(0, hole).made().refusal().contains("2 bands, none chosen"));
}

/// A no-data value that no sample can hold makes no void. A note tells of it.
#[test]
fn marks_that_no_sample_holds_are_told() {
    let words: Vec<u8> = heights().iter().flat_map(|height| (*height as i16).to_le_bytes()).collect();
    let is_told = |format: u16, mark: &str| {
        let made = Directory::of(words.clone(), 16, format).with(42113, Field::Text(mark.into()));
        let note = format!("the no-data value is {mark}, which no sample can hold");
        made.made().plain().unwrap().notes.contains(&note)
    };
    assert_eq!(["-9999", "65535", "65536", "0.5"].map(|mark| is_told(1, mark)), [true, false, true, true]);
    assert_eq!(["-9999", "65535", "-32769"].map(|mark| is_told(2, mark)), [false, true, true]);
}

#[test]
fn blocks_that_a_file_leaves_out_are_voids() {
    let mut strips = Directory::ground();
    strips.blocks[2] = vec![];
    strips.blocks[5] = vec![];
    let made = strips.clone().made();
    assert_eq!(voids(&made), 2 * 4 * SIDE);
    let notes = made.plain().unwrap().notes.join("\n");
    assert!(notes.contains("leaves 2 strips or tiles out"), "{notes}");
    // With a no-data value they are the same; all left out is no ground.
    assert_eq!(voids(&strips.clone().with(42113, Field::Text("-9999".into())).made()), 2 * 4 * SIDE);
    let mut none = strips.clone();
    none.blocks.iter_mut().for_each(Vec::clear);
    assert!(none.made().refusal().contains("all 576 samples are void"));
    let mut tiles = Directory::ground();
    tiles.tags.remove(&278);
    tiles.place = [324, 325];
    tiles.put(322, Field::Shorts(vec![16]));
    tiles.put(323, Field::Shorts(vec![32]));
    let at = |line: usize, column: usize| heights().get(line * SIDE + column).copied().unwrap_or(0.0);
    tiles.blocks = vec![floats(&(0..512).map(|k| at(k / 16, k % 16)).collect::<Vec<_>>()), vec![]];
    assert_eq!(voids(&tiles.made()), SIDE * 8);
    // A sparse file of a size that no memory holds is refused before any is taken.
    let mut vast = strips;
    [256, 257, 278].iter().for_each(|tag| vast.put(*tag, Field::Longs(vec![100_000_000])));
    vast.blocks = vec![vec![]];
    assert!(vast.made().refusal().contains("100000000 x 100000000"));
}

#[test]
fn numbers_beyond_those_that_a_file_states_are_told() {
    let ground = || Directory::of(words(&marked(quarters(), &[-32767.0; 3])), 16, 2);
    let ends = ground().with(280, Field::Shorts(vec![200])).with(281, Field::Shorts(vec![300]));
    let notes = ends.made().plain().unwrap().notes.join("\n");
    assert!(notes.contains("3 samples lie beyond 200 to 300") && notes.contains("give --no-data"), "{notes}");
    let label =
        labelled(&[("UNIT = METER", "UNIT = METER\n  MINIMUM = 200")], &words(&marked(quarters(), &[-5.0])));
    assert!(label.plain().unwrap().notes[0].starts_with("1 samples lie beyond 200 to inf"));
    assert!(LABEL.contains("UNIT = METER"));
}
