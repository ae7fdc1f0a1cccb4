//! NPY and NPZ: bytes as numpy writes them, and damaged files.

use std::io::Read;

use files::{
    Npy, NpyData, NpyError, NpyFileError, NpyLayout, npy_layout, parse_npz, read_npy, write_npy, write_npz,
};
use proptest::prelude::{any, prop_assert_eq, proptest};

fn bytes_of(array: &Npy) -> Vec<u8> {
    let mut bytes = Vec::new();
    array.write(&mut bytes).expect("memory takes it");
    bytes
}

/// A file with this dictionary and these values, as version `major`.
fn file(major: u8, dictionary: &str, values: &[u8]) -> Vec<u8> {
    let length = dictionary.len() as u32;
    let mut bytes = [b"\x93NUMPY".as_slice(), &[major, 0]].concat();
    let field = length.to_le_bytes();
    bytes.extend_from_slice(if major == 1 { &field[..2] } else { &field });
    [&bytes, dictionary.as_bytes(), values].concat()
}

fn dictionary(descr: &str, fortran: &str, shape: &str) -> String {
    format!("{{'descr': '{descr}', 'fortran_order': {fortran}, 'shape': {shape}, }}")
}

/// What `np.save` writes for `np.array([[1.5, -2.0]], dtype="<f4")` (numpy 2.4), header padding and all.
#[test]
fn bytes_are_those_of_numpy() {
    let mut expected =
        b"\x93NUMPY\x01\x00v\x00{'descr': '<f4', 'fortran_order': False, 'shape': (1, 2), }".to_vec();
    expected.resize(127, b' ');
    expected.push(b'\n');
    expected.extend_from_slice(&[0, 0, 0xc0, 0x3f, 0, 0, 0, 0xc0]);
    let array = Npy::new(vec![1, 2], vec![1.5_f32, -2.0]).expect("the shape fits");
    assert_eq!(bytes_of(&array), expected);
}

#[test]
fn headers_end_at_a_multiple_of_64() {
    for dimensions in 0..20 {
        let bytes = bytes_of(&Npy::new(vec![1; dimensions], vec![0_u8]).expect("the shape fits"));
        assert_eq!((bytes.len() - 1) % 64, 0);
        assert_eq!(Npy::parse(&bytes).expect("ours").shape().len(), dimensions);
    }
}

#[test]
fn versions_byte_orders_and_notations_are_read() {
    let values = [0x01, 0x02];
    for (major, text, expected) in [
        (1, dictionary("<i2", "False", "(1,)"), 0x0201),
        (2, dictionary(">i2", "False", "(1,)"), 0x0102),
        (3, "{\"shape\": ( 1 , ), \"descr\":'<i2','fortran_order' :False}\n".to_owned(), 0x0201),
        (1, dictionary("<i2", "True", "(1L, 1)"), 0x0201),
        (1, dictionary("<i2", "False", "()"), 0x0201),
    ] {
        let array = Npy::parse(&file(major, &text, &values)).expect("a good file");
        assert_eq!(array.data(), &NpyData::I16(vec![expected]), "{text}");
    }
}

#[test]
fn fortran_order_becomes_c_order() {
    // a[i][j][k] = 100 i + 10 j + k, the first index fastest.
    let values: Vec<u8> =
        (0..4).flat_map(|k| (0..3).flat_map(move |j| (0..2).map(move |i| 100 * i + 10 * j + k))).collect();
    let array = Npy::parse(&file(1, &dictionary("|u1", "True", "(2, 3, 4)"), &values)).expect("a good file");
    let expected: Vec<u8> =
        (0..2).flat_map(|i| (0..3).flat_map(move |j| (0..4).map(move |k| 100 * i + 10 * j + k))).collect();
    assert_eq!(array.into_parts(), (vec![2, 3, 4], NpyData::U8(expected)));
}

#[test]
fn empty_arrays_are_arrays() {
    let array = Npy::parse(&file(1, &dictionary("<f8", "True", "(3, 0)"), &[])).expect("a good file");
    assert!(array.data().is_empty());
    assert_eq!(array.shape(), [3, 0]);
}

#[test]
fn damaged_files_are_refused() {
    let parse = |descr: &str, shape: &str, values: &[u8]| {
        Npy::parse(&file(1, &dictionary(descr, "False", shape), values)).expect_err("damaged")
    };
    assert_eq!(Npy::parse(b""), Err(NpyError::NotNpy));
    assert_eq!(Npy::parse(b"\x93NUMPY\x04\x00"), Err(NpyError::Version { major: 4, minor: 0 }));
    assert_eq!(Npy::parse(b"\x93NUMPY\x01"), Err(NpyError::Truncated { expected: 10, found: 7 }));
    let cut = Npy::parse(b"\x93NUMPY\x02\x00\xff\xff\xff\xff{");
    assert_eq!(cut, Err(NpyError::Truncated { expected: 12 + 0xffff_ffff, found: 13 }));
    assert_eq!(parse("<c8", "(1,)", &[0; 8]), NpyError::Type { found: "<c8".into() });
    assert_eq!(parse("é", "(1,)", &[0; 8]), NpyError::Type { found: "é".into() });
    assert_eq!(parse("|f8", "(1,)", &[0; 8]), NpyError::Type { found: "|f8".into() });
    assert!(matches!(parse("<f8", "(3,)", &[0; 16]), NpyError::Size { expected: 24, found: 16, .. }));
    assert!(matches!(parse("<f8", "(1,)", &[0; 16]), NpyError::Size { expected: 8, found: 16, .. }));
    let huge = "(9223372036854775807, 9223372036854775807)";
    assert!(matches!(parse("<f8", huge, &[0; 16]), NpyError::Overflow { .. }));
    assert!(matches!(parse("<f8", "(-1,)", &[0; 16]), NpyError::Header { .. }));
    let table = "{'descr': [('x', '<f8')], 'fortran_order': False, 'shape': (1,)}";
    let error = Npy::parse(&file(1, table, &[0; 8])).expect_err("a table of columns");
    assert_eq!(
        error.to_string(),
        "NPY header at byte 20: expected a text in quotes (tables of named columns are not read)"
    );
}

#[test]
fn a_shape_that_does_not_fit_is_refused() {
    let error = Npy::new(vec![2, 2], vec![1.0_f64]).expect_err("1 is not 4");
    assert_eq!(error, NpyError::Shape { shape: vec![2, 2], values: 1 });
}

#[test]
fn files_name_themselves_in_errors() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("a.npy");
    let array = Npy::new(vec![3], vec![1_u16, 2, 3]).expect("the shape fits");
    write_npy(&path, &array).expect("written");
    assert_eq!(read_npy(&path, 1000).expect("ours"), array);
    assert_eq!(array.data().to_f64(), [1.0, 2.0, 3.0]);
    std::fs::write(&path, "no").expect("written");
    assert!(read_npy(&path, 1000).expect_err("no").to_string().contains("a.npy: not an NPY file"));
    assert!(matches!(read_npy(folder.path(), 1000), Err(NpyFileError::File(_))));
}

/// The front of a file is read first, and more of it where the header is longer.
#[test]
fn long_headers_are_read_to_their_end() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("a.npy");
    let dictionary = dictionary("<f8", "False", "(2,)") + &" ".repeat(5000);
    let bytes = file(1, &dictionary, &[1.5_f64.to_le_bytes(), (-2.0_f64).to_le_bytes()].concat());
    let array = Npy::new(vec![2], vec![1.5, -2.0]).expect("the shape fits");
    for (bytes, expected) in [
        (bytes.as_slice(), Ok(array)),
        (&bytes[..5000], Err(NpyError::Truncated { expected: bytes.len() as u64 - 16, found: 5000 })),
    ] {
        std::fs::write(&path, bytes).expect("written");
        let read = read_npy(&path, 1 << 20).map_err(|error| match error {
            NpyFileError::Format { source, .. } => source,
            NpyFileError::File(error) => panic!("{error}"),
        });
        assert_eq!(Npy::parse(bytes), expected);
        assert_eq!(read, expected);
    }
}

#[test]
fn npz_is_a_zip_of_npy_and_always_the_same() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("a.npz");
    let (x, y) =
        (Npy::new(vec![2], vec![1.0, 2.0]).expect("fits"), Npy::new(vec![1, 1], vec![7_u8]).expect("fits"));
    let mut written = Vec::new();
    for _ in 0..2 {
        write_npz(&path, [("tg.height", &x), ("gate", &y)]).expect("written");
        written.push(std::fs::read(&path).expect("read"));
    }
    assert_eq!(written[0], written[1]);
    let mut zip = zip::ZipArchive::new(std::io::Cursor::new(&written[0])).expect("a zip");
    let names: Vec<_> = zip.file_names().map(|name| name.expect("a plain name").into_owned()).collect();
    assert_eq!(names, ["tg.height.npy", "gate.npy"]);
    let mut bytes = Vec::new();
    let mut entry = zip.by_name("gate.npy").expect("it is there");
    assert_eq!(entry.compression(), zip::CompressionMethod::Stored);
    entry.read_to_end(&mut bytes).expect("readable");
    assert_eq!(Npy::parse(&bytes).expect("ours"), y);
    let read = parse_npz(&written[0]).expect("ours");
    assert_eq!(read, [("tg.height".to_owned(), x.clone()), ("gate".to_owned(), y)]);
    for cut in [0, 30, written[0].len() / 2, written[0].len() - 1] {
        let said = parse_npz(&written[0][..cut]).expect_err("cut short").to_string();
        assert!(said.contains("not an NPZ file"), "{cut}: {said}");
    }
    assert!(write_npz(&path, [("x", &x), ("x", &x)]).is_err());
    assert_eq!(std::fs::read(&path).expect("read"), written[0]);
}

proptest! {
    #[test]
    fn what_is_written_is_read(values in proptest::collection::vec(any::<f64>(), 0..40)) {
        let array = Npy::new(vec![values.len()], values).expect("the shape fits");
        let read = Npy::parse(&bytes_of(&array)).expect("ours");
        prop_assert_eq!(bytes_of(&read), bytes_of(&array));
    }

    /// One byte changed anywhere: an array or an error, never a panic, never another number of values.
    #[test]
    fn a_flipped_byte_is_survived(at in 0_usize..152, to in any::<u8>()) {
        let mut bytes = bytes_of(&Npy::new(vec![3], vec![1.0, 2.0, 3.0]).expect("the shape fits"));
        bytes[at] = to;
        if let Ok(array) = Npy::parse(&bytes) {
            prop_assert_eq!(array.data().len(), array.shape().iter().product::<usize>());
        }
    }

    #[test]
    fn any_dictionary_is_survived(text in "[{}()':,a-z0-9L<>|TF \n]{0,80}") {
        let _ = Npy::parse(&file(1, &text, &[0; 8]));
    }
}

#[test]
fn a_layout_tells_where_the_values_stand() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("a.npy");
    let of = |text: &str, values: usize| {
        std::fs::write(&path, file(1, text, &vec![0; values])).expect("written");
        npy_layout(&path)
    };
    let text = dictionary(">f4", "True", "(3, 5)");
    let expected = NpyLayout {
        shape: vec![3, 5],
        fortran_order: true,
        offset: 10 + text.len() as u64,
        value_bytes: 4,
        is_real: true,
        is_signed: true,
        is_little: false,
    };
    assert_eq!(of(&text, 60).expect("a good file"), expected);
    let bytes = of(&dictionary("|u1", "False", "(7,)"), 7).expect("a good file");
    assert_eq!((bytes.value_bytes, bytes.is_real, bytes.is_signed, bytes.is_little), (1, false, false, true));
    assert!(
        of(&text, 59)
            .expect_err("a short file")
            .to_string()
            .contains("a.npy: NPY shape [3, 5] needs 60 bytes")
    );
    assert!(of(&dictionary("<c8", "False", "(7,)"), 56).expect_err("complex").to_string().contains("'<c8'"));
}
