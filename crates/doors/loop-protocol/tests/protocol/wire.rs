//! Messages as bytes.

use loop_protocol::{Dtype, Message, Plane};
use quantities::unit_interval;
use serde_json::json;

use crate::home::Scene;

fn number(key: u64) -> f64 {
    2e6 * unit_interval(11, &[key]) - 1e6
}

/// One plane of each type, with axes of different lengths.
fn message() -> Message {
    let numbers: Vec<f64> = (0..24).map(number).collect();
    let planes = vec![
        Plane::of("bytes", &[2, 3], &[0_u8, 1, 2, 3, 254, 255]),
        Plane::of("shorts", &[3], &[0_u16, 258, 65_535]),
        Plane::of("words", &[1, 1, 2], &[0x0102_0304_u32, u32::MAX]),
        Plane::of("signed", &[2], &[i32::MIN, -2]),
        Plane::of("singles", &[4], &[f32::INFINITY, -0.0, 1.5, f32::MIN_POSITIVE]),
        Plane::of("doubles", &[2, 3, 4], &numbers),
        Plane::of::<f64>("none", &[0, 7], &[]),
        Plane::of("one", &[], &[6_u8]),
    ];
    Message::new(json!({ "id": 3, "do": "look", "x": 0.1 + 0.2, "é": "\u{1F680}" })).with(planes)
}

#[test]
fn what_is_written_is_read() {
    let message = message();
    let read = Message::decode(&message.encode()).unwrap();
    assert_eq!(read, message);
    let doubles: Vec<f64> = (0..24).map(number).collect();
    assert_eq!(read.plane("doubles").unwrap().values::<f64>().unwrap(), doubles);
    assert_eq!(read.plane("words").unwrap().values::<u32>().unwrap(), [0x0102_0304, u32::MAX]);
    assert_eq!(read.plane("words").unwrap().values::<i32>(), None);
    let singles = read.plane("singles").unwrap().values::<f32>().unwrap();
    assert_eq!(singles.map_bits(), [f32::INFINITY, -0.0, 1.5, f32::MIN_POSITIVE].map(f32::to_bits));
}

trait MapBits {
    fn map_bits(&self) -> Vec<u32>;
}

impl MapBits for Vec<f32> {
    fn map_bits(&self) -> Vec<u32> {
        self.iter().map(|value| value.to_bits()).collect()
    }
}

/// Byte by byte, as `docs/loop-protocol.md` has them: clients in other languages rely on them.
#[test]
fn bytes_of_the_format() {
    let planes = vec![Plane::of("a", &[2, 1], &[1.0_f32, -2.0]), Plane::of("b", &[1], &[258_u16])];
    let message = Message::new(json!({ "id": 1 })).with(planes);
    let header = br#"{"id":1,"planes":[{"dtype":"f32","name":"a","shape":[2,1]},{"dtype":"u16","name":"b","shape":[1]}]}"#;
    let mut bytes = b"lunoid.1".to_vec();
    bytes.extend([header.len() as u8, 0, 0, 0, 0, 0, 0, 0, 10, 0, 0, 0, 0, 0, 0, 0]);
    bytes.extend(header);
    bytes.extend([0, 0, 128, 63, 0, 0, 0, 192, 2, 1]);
    assert_eq!(message.encode(), bytes);
    assert_eq!(Message::decode(&bytes).unwrap(), message);
}

/// A request names planes under the key that lists them.
#[test]
fn names_of_planes_are_kept() {
    for names in [json!(["picture", "range"]), json!([])] {
        let request = Message::new(json!({ "id": 1, "do": "frame", "frame": 0, "planes": names }));
        assert_eq!(Message::decode(&request.encode()).unwrap(), request);
        let answer = Message::decode(&Scene::by("ideal").session().answer_bytes(&request.encode())).unwrap();
        let planes: Vec<&str> = answer.planes.iter().map(Plane::name).collect();
        assert_eq!(json!(planes), names);
    }
    let mut bytes = Message::new(json!({ "id": 1, "planes": ["a"] })).encode();
    bytes[16] = 1;
    bytes.push(7);
    assert!(Message::decode(&bytes).is_err(), "a byte of a plane that is a name alone");
}

#[test]
fn types_have_their_words_and_sizes() {
    let rows = Dtype::ALL.map(|dtype| (dtype.name(), dtype.size()));
    assert_eq!(rows, [("u8", 1), ("u16", 2), ("u32", 4), ("i32", 4), ("f32", 4), ("f64", 8)]);
    assert!(Dtype::ALL.into_iter().all(|dtype| Dtype::of_name(dtype.name()) == Some(dtype)));
    assert_eq!(Dtype::of_name("f16"), None);
}

#[test]
fn messages_follow_one_another() {
    let (first, second) = (message(), Message::new(json!({ "id": 4 })));
    let mut bytes = Vec::new();
    first.write(&mut bytes).unwrap();
    assert_eq!(bytes, first.encode());
    second.write(&mut bytes).unwrap();
    let mut rest = &bytes[..];
    assert_eq!(Message::read(&mut rest).unwrap(), Some(first));
    assert_eq!(Message::read(&mut rest).unwrap(), Some(second));
    assert_eq!(Message::read(&mut rest).unwrap(), None);
}
