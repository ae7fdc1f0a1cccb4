//! TIFFs as programs write them: units of heights, bodies, sample types.

use survey::{Frame, Method, ReadOptions};

use crate::made::{Directory, Field, SIDE, against, floats, heights, tiff};

/// Largest difference of a file's heights from `scale` times the made ones.
fn off(directory: Directory, scale: f64) -> f64 {
    let (voids, worst) = against(&directory.made().plain().unwrap(), scale, 0.0);
    assert_eq!(voids, 0);
    worst
}

fn refusal(directory: Directory) -> String {
    directory.made().refusal()
}

fn notes(directory: Directory) -> String {
    directory.made().plain().unwrap().notes.join("\n")
}

const SURVEY_FOOT: f64 = 1200.0 / 3937.0;

#[test]
fn units_of_heights() {
    let named = |name: &str| Directory::ground().with_items(&[("UNITTYPE", name)]);
    for (name, metres) in [
        ("US survey foot", SURVEY_FOOT),
        ("ft", 0.3048),
        ("km", 1000.0),
        ("metre", 1.0),
        ("Centimeter", 0.01),
        ("", 1.0),
    ] {
        assert!(off(named(name), metres) < 1e-9, "{name}");
    }
    let keyed = |keys: &[(u16, f64)]| {
        let usual = [(1024, 1.0), (2057, 1_737_400.0), (3075, 17.0), (3076, 9001.0)];
        Directory::ground().with_keys(&[&usual, keys].concat())
    };
    for (keys, metres) in [
        (&[(4099, 9002.0)][..], 0.3048),
        (&[(4099, 9003.0)], SURVEY_FOOT),
        (&[(4099, 9036.0)], 1000.0),
        (&[(4096, 6360.0)], SURVEY_FOOT),
        (&[(4096, 5703.0), (4099, 9001.0)], 1.0),
        (&[(4096, 32767.0), (4099, 9002.0)], 0.3048),
    ] {
        assert!(off(keyed(keys), metres) < 1e-9, "{keys:?}");
    }
    // Scale and offset count in the unit.
    let all = named("ft").with_items(&[("UNITTYPE", "ft"), ("SCALE", "2"), ("OFFSET", "10")]);
    let (_, worst) = against(&all.made().plain().unwrap(), 0.6096, 3.048);
    assert!(worst < 1e-9);
    // Two units, an unknown one, a depth.
    let two = keyed(&[(4099, 9002.0)]).with_items(&[("UNITTYPE", "m")]);
    assert!(refusal(two).contains("--scale METRES"));
    assert!(refusal(named("furlong")).contains("item UNITTYPE: found furlong"));
    assert!(refusal(keyed(&[(4099, 9999.0)])).contains("VerticalUnitsGeoKey): found 9999"));
    assert!(refusal(keyed(&[(4096, 5715.0), (4099, 9001.0)])).contains("VerticalGeoKey): found 5715"));
    assert!(notes(Directory::ground()).contains("does not name the unit of its heights"));
    assert!(!notes(named("m")).contains("unit"));
}

/// Degrees at 45 N, 6 E, an arc second apart.
fn degrees_of(keys: &[(u16, f64)]) -> Directory {
    let step = 1.0 / 3600.0;
    Directory::ground()
        .with(33550, Field::Doubles(vec![step, step, 0.0]))
        .with(33922, Field::Doubles(vec![0.0, 0.0, 0.0, 6.0, 45.0, 0.0]))
        .with_keys(&[&[(1024, 2.0), (1025, 1.0)], keys].concat())
}

fn sphere(directory: Directory) -> f64 {
    directory.made().plain().unwrap().frame.sphere().unwrap()
}

#[test]
fn bodies_by_code_and_by_axes() {
    for code in [(2048, 4326.0), (2048, 4269.0), (2050, 6326.0), (2056, 7030.0)] {
        assert_eq!(sphere(degrees_of(&[code])), 6_378_137.0, "{code:?}");
        assert!(notes(degrees_of(&[code])).contains("a code of the Earth, not of the Moon"));
    }
    assert_eq!(sphere(degrees_of(&[(2048, 32767.0), (2057, 1_737_400.0)])), 1_737_400.0);
    assert_eq!(sphere(degrees_of(&[(2048, 4326.0), (2057, 6_378_137.0)])), 6_378_137.0);
    let axis_in_km = [(2052, 9036.0), (2057, 1737.4)];
    assert!((sphere(degrees_of(&axis_in_km)) - 1_737_400.0).abs() < 1e-6);
    // No radius, one that contradicts the code, a flattened body.
    assert!(notes(degrees_of(&[])).contains("does not name the radius of its body: 1737400 m is assumed"));
    let both = notes(degrees_of(&[(2048, 4326.0), (2057, 1_737_400.0)]));
    assert!(both.contains("GeodeticCRSGeoKey) is 4326, a code of the Earth"), "{both}");
    let flat = notes(degrees_of(&[(2057, 3_396_190.0), (2058, 3_376_200.0)]));
    assert!(flat.contains("flattened by 0.589 %"), "{flat}");
    assert!(notes(degrees_of(&[(2057, 3_396_190.0), (2059, 169.894)])).contains("flattened by 0.589 %"));
    assert!(refusal(degrees_of(&[(2057, 0.0)])).contains("EllipsoidSemiMajorAxisGeoKey"));
    // A map of the Earth: unit and note by its code.
    let zone = |keys: &[(u16, f64)]| Directory::ground().with_keys(&[&[(1024, 1.0)], keys].concat());
    assert!(notes(zone(&[(3072, 32633.0)])).contains("ProjectedCRSGeoKey) is 32633, a code of the Earth"));
    let said = refusal(zone(&[(3072, 2226.0)]));
    assert!(said.contains("2226") && said.contains("ProjLinearUnitsGeoKey"), "{said}");
    assert!(notes(zone(&[(3072, 2226.0), (3076, 9003.0)])).contains("2226"));
}

#[test]
fn units_of_angles_and_meridians() {
    let first =
        |keys: &[(u16, f64)]| degrees_of(keys).made().plain().unwrap().affine.first.map(quantities::degrees);
    let usual = first(&[]);
    assert!((usual[1] - 6.0 - 0.5 / 3600.0).abs() < 1e-9);
    let near = |found: [f64; 2], scale: f64, east: f64| {
        (found[0] - usual[0] * scale).abs() < 1e-9 && (found[1] - usual[1] * scale - east).abs() < 1e-9
    };
    assert!(near(first(&[(2054, 9105.0)]), 0.9, 0.0), "grads");
    assert!(near(first(&[(2054, 9103.0)]), 1.0 / 60.0, 0.0), "minutes");
    assert!(near(first(&[(2054, 32767.0), (2055, 0.0174532925199433 / 2.0)]), 0.5, 0.0), "a unit of its own");
    assert!(near(first(&[(2061, 2.5)]), 1.0, 2.5), "a meridian by its longitude");
    assert!(near(first(&[(2051, 8903.0), (2061, 2.337_229)]), 1.0, 2.337_229), "Paris");
    assert!(near(first(&[(2051, 8901.0)]), 1.0, 0.0), "Greenwich");
    assert!(refusal(degrees_of(&[(2051, 8903.0)])).contains("PrimeMeridianGeoKey"));
    assert!(refusal(degrees_of(&[(2054, 9110.0)])).contains("GeogAngularUnitsGeoKey"));
    assert!(refusal(degrees_of(&[(1024, 3.0)])).contains("geo key 1024 (GTModelTypeGeoKey): found 2 and 3"));
    let globe = Directory::ground().with_keys(&[(1024, 3.0)]);
    assert!(refusal(globe).contains("GTModelTypeGeoKey): found 3"));
    // Metres that are said to be degrees are on no globe.
    let metres = Directory::ground().with_keys(&[(1024, 2.0)]);
    assert!(refusal(metres).contains("latitudes from -90 to 90"));
}

#[test]
fn units_of_the_map() {
    let keyed = |keys: &[(u16, f64)]| {
        let usual = [(1024, 1.0), (2057, 1_737_400.0), (3075, 17.0)];
        Directory::ground().with_keys(&[&usual, keys].concat()).made().plain().unwrap()
    };
    for (keys, metres) in [
        (&[(3076, 9001.0)][..], 1.0),
        (&[(3076, 9036.0)], 1000.0),
        (&[(3076, 9003.0)], SURVEY_FOOT),
        (&[(3076, 32767.0), (3077, 0.25)], 0.25),
    ] {
        let read = keyed(keys);
        assert!((read.affine.step[1] - 10.0 * metres).abs() < 1e-9, "{keys:?}");
        assert!((read.affine.first[1] - 10_005.0 * metres).abs() < 1e-6, "{keys:?}");
    }
    assert!(keyed(&[]).notes[0].contains("does not name the unit of its map"));
    // An origin counts in the unit of the map too.
    let read = keyed(&[(3076, 9036.0), (3082, 7.0), (3087, 3.0)]);
    let Frame::Plane(Some(projection)) = read.frame else { panic!("{:?}", read.frame) };
    assert_eq!(projection.offset, [3000.0, 7000.0]);
}

#[test]
fn figures_of_projections() {
    let with = |keys: &[(u16, f64)]| {
        let usual = [(1024, 1.0), (2057, 1_737_400.0), (3076, 9001.0)];
        Directory::ground().with_keys(&[&usual, keys].concat())
    };
    assert!(refusal(with(&[(3075, 17.0), (3092, 0.5)])).contains("ProjScaleAtNatOriginGeoKey"));
    assert!(refusal(with(&[(3075, 21.0), (3093, 0.5)])).contains("ProjScaleAtCenterGeoKey"));
    assert!(refusal(with(&[(3075, 17.0), (3079, 20.0)])).contains("ProjStdParallel2GeoKey"));
    assert!(refusal(with(&[(3075, 9.0), (3096, 12.0)])).contains("ProjRectifiedGridAngleGeoKey"));
    let polar = with(&[(3075, 15.0), (3081, 90.0), (3078, 60.0)]).made().plain().unwrap();
    let Frame::Plane(Some(projection)) = polar.frame else { panic!("{:?}", polar.frame) };
    let Method::PolarStereographic { scale } = projection.method else { panic!("{projection:?}") };
    assert!((scale - 0.5 * (1.0 + 0.75_f64.sqrt())).abs() < 1e-12, "{scale}");
    let unknown = notes(with(&[(3075, 24.0)]));
    assert!(unknown.contains("ProjMethodGeoKey) is 24, a projection that is not known here"), "{unknown}");
}

/// Numbers of few bits, packed from the highest on, each line from a byte on.
fn packed(numbers: &[u8], columns: usize, bits: usize) -> Vec<u8> {
    let pack = |row: &[u8]| {
        let mut bytes = vec![0; (columns * bits).div_ceil(8)];
        for (k, number) in row.iter().enumerate() {
            bytes[k * bits / 8] |= number << (8 - bits - k * bits % 8);
        }
        bytes
    };
    numbers.chunks(columns).flat_map(pack).collect()
}

#[test]
fn samples_below_a_byte_are_unpacked() {
    // An odd number of columns leaves bits over at the end of each line.
    for (bits, columns) in [(1, 23), (2, 21), (4, 19), (4, 24)] {
        let numbers: Vec<u8> = (0..24 * columns).map(|k| (k * 7 / 3 % (1 << bits)) as u8).collect();
        let made = Directory::of(packed(&numbers, columns, bits), bits as u16, 1)
            .with(256, Field::Shorts(vec![columns as u16]));
        let read = made.made().plain().unwrap();
        for (k, number) in numbers.iter().enumerate() {
            assert_eq!(
                read.height(k / columns, k % columns),
                Some(f64::from(*number)),
                "{bits} bits, sample {k}"
            );
        }
    }
    // Two bands, pixel by pixel.
    let numbers: Vec<u8> = (0..24 * 48).map(|k| (k % 13) as u8).collect();
    let two = Directory::of(packed(&numbers, 48, 4), 4, 1).with(277, Field::Shorts(vec![2]));
    let second = ReadOptions { band: Some(2), ..ReadOptions::default() };
    let read = two.made().read(&second).unwrap();
    assert_eq!(read.height(5, 3), Some(f64::from(numbers[2 * (5 * 24 + 3) + 1])));
    for (bits, format) in [(12, 1), (10, 1), (24, 1), (4, 2), (8, 3), (24, 3)] {
        let said = refusal(Directory::of(vec![0; 24 * 24 * 8], bits, format));
        assert!(said.contains(&format!("tag 258 (BitsPerSample): found {bits}")), "{said}");
    }
    for format in [4, 5, 6] {
        let said = refusal(Directory::of(vec![0; 24 * 24 * 8], 32, format));
        assert!(said.contains(&format!("tag 339 (SampleFormat): found {format}")), "{said}");
    }
}

#[test]
fn numbers_of_64_bits_and_halves() {
    let whole: Vec<f64> = heights().iter().map(|height| 4.0 * height).collect();
    let signed = whole.iter().flat_map(|height| (*height as i64).to_le_bytes()).collect();
    assert_eq!(off(Directory::of(signed, 64, 2), 4.0), 0.0);
    let unsigned = whole.iter().flat_map(|height| (*height as u64).to_le_bytes()).collect();
    assert_eq!(off(Directory::of(unsigned, 64, 1), 4.0), 0.0);
    // 1.0 is 0x3c00, -2.0 is 0xc000, 0.5 is 0x3800 (IEEE 754 binary16).
    let halves =
        [0x3c00_u16, 0xc000, 0x3800].iter().cycle().take(576).flat_map(|half| half.to_le_bytes()).collect();
    let read = Directory::of(halves, 16, 3).made().plain().unwrap();
    assert_eq!([0, 1, 2].map(|column| read.height(0, column).unwrap()), [1.0, -2.0, 0.5]);
}

#[test]
fn samples_that_are_radii() {
    let radii = |sphere: f64| heights().iter().map(|height| sphere + height).collect::<Vec<f64>>();
    let doubles =
        |numbers: &[f64]| numbers.iter().flat_map(|number| number.to_le_bytes()).collect::<Vec<u8>>();
    let of = |numbers: &[f64]| Directory::of(doubles(numbers), 64, 3);
    assert!(off(of(&radii(1_737_400.0)), 1.0) < 1e-9);
    assert!(notes(of(&radii(1_737_400.0))).contains("the samples are radii"));
    // In 32 bits a radius has steps of an eighth of a metre, and the made heights are multiples of a quarter.
    assert_eq!(off(Directory::of(floats(&radii(1_737_400.0)), 32, 3), 1.0), 0.0);
    let kilometres: Vec<f64> = radii(1_737_400.0).iter().map(|radius| 1e-3 * radius).collect();
    assert!(off(of(&kilometres).with_items(&[("UNITTYPE", "km")]), 1.0) < 1e-6);
    let mars = [(1024, 1.0), (2057, 3_396_190.0), (3075, 17.0), (3076, 9001.0)];
    assert!(off(of(&radii(3_396_190.0)).with_keys(&mars), 1.0) < 1e-9);
    let offset = Directory::ground().with_items(&[("OFFSET", "1737400")]);
    assert_eq!(off(offset, 1.0), 0.0);
    // Radii of the Earth in a file of the Moon are no heights.
    assert!(refusal(of(&radii(6_378_137.0))).contains("line 0, column 0"));
}

#[test]
fn places_of_other_kinds_are_refused() {
    let with = |tag: u16, field: Field| refusal(Directory::ground().with(tag, field));
    for turn in [2, 3, 6, 8] {
        assert!(with(274, Field::Shorts(vec![turn])).contains("Orientation"));
    }
    assert!(with(50844, Field::Doubles(vec![0.0; 92])).contains("RPCCoefficient"));
    assert!(with(33920, Field::Doubles(vec![0.0; 17])).contains("IntergraphMatrixTag"));
    assert!(with(266, Field::Shorts(vec![2])).contains("FillOrder"));
    assert!(with(320, Field::Shorts(vec![0; 768])).contains("ColorMap"));
    assert!(with(262, Field::Shorts(vec![0])).contains("PhotometricInterpretation"));
    assert!(with(259, Field::Shorts(vec![34887])).contains("Compression"));
    let rpc = "<GDALMetadata><Item name=\"LINE_OFF\" domain=\"RPC\">1</Item></GDALMetadata>";
    assert!(with(42112, Field::Text(rpc.into())).contains("RPC"));
    let tie = |numbers: Vec<f64>| refusal(Directory::ground().with(33922, Field::Doubles(numbers)));
    let two = [[0.0, 0.0, 0.0, 10_000.0, 20_000.0, 0.0], [24.0, 0.0, 0.0, 10_250.0, 20_000.0, 0.0]].concat();
    assert!(tie(two).contains("tie points that place the first sample"));
    let matrix = |a: f64, b: f64| {
        vec![a, b, 0.0, 10_000.0, b, -10.0, 0.0, 20_000.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0]
    };
    let turned = Directory::ground().with(34264, Field::Doubles(matrix(10.0, 1.0)));
    assert!(refusal(turned).contains("a rotated grid"));
    let other = Directory::ground().with(34264, Field::Doubles(matrix(11.0, 0.0)));
    assert!(refusal(other).contains("as the pixel scale says"));
    // Two ways to say one place, and tie points on one grid, are read.
    let same = Directory::ground().with(34264, Field::Doubles(matrix(10.0, 0.0)));
    assert_eq!(off(same, 1.0), 0.0);
    let two = [[0.0, 0.0, 0.0, 10_000.0, 20_000.0, 0.0], [24.0, 24.0, 0.0, 10_240.0, 19_760.0, 0.0]].concat();
    assert_eq!(off(Directory::ground().with(33922, Field::Doubles(two)), 1.0), 0.0);
}

#[test]
fn directories_without_end_are_refused() {
    let mut circle = crate::made::bytes(&[Directory::ground(), Directory::ground()]);
    // The second directory points at the first.
    let first: [u8; 4] = circle[4..8].try_into().unwrap();
    let end = circle.len();
    circle[end - 4..].copy_from_slice(&first);
    let made = crate::made::Made::new(&[("made.tif", &circle)]);
    assert!(made.refusal().contains("a cycle in the list"), "{}", made.refusal());
    assert_eq!(tiff(&[Directory::ground()]).plain().unwrap().columns, SIDE);
}
