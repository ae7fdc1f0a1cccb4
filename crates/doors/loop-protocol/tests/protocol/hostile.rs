//! Bytes from anybody: one error each, and no memory that nobody sent.

use std::io::{self, Read};

use loop_protocol::{Home, Message, Opening, PREFIX, Plane, Session, WireError};
use quantities::hash_words;
use serde_json::json;

use drive::{Drive, DriveError, Wishes};

/// A home that opens nothing.
struct Nobody;

impl Home for Nobody {
    fn open(&mut self, asked: &Opening) -> Result<Drive, DriveError> {
        Drive::open("no/such.toml".as_ref(), &asked.over(&Wishes::default()), 1)
    }
}

fn bytes(header: &str, planes: &[u8]) -> Vec<u8> {
    let mut bytes = b"lunoid.1".to_vec();
    bytes.extend((header.len() as u64).to_le_bytes());
    bytes.extend((planes.len() as u64).to_le_bytes());
    bytes.extend(header.as_bytes());
    bytes.extend(planes);
    bytes
}

fn refused(bytes: &[u8]) -> Vec<String> {
    match Message::decode(bytes) {
        Err(WireError::Problems(list) | WireError::Faulty { problems: list, .. }) => list
            .records()
            .iter()
            .map(|fault| format!("{} {:?} {:?}", fault.title, fault.found, fault.expected))
            .collect(),
        other => panic!("{other:?}"),
    }
}

#[test]
fn rubbish_has_one_error_each() {
    let plane = r#""name":"a","dtype":"u8""#;
    let listed = |list: &str| format!(r#"{{"planes":[{list}]}}"#);
    let cases: [(Vec<u8>, &str); 21] = [
        (b"GET / HTTP/1.1\r\n\r\nHost: me".to_vec(), "no message of lunoid.loop/1"),
        (b"lunoid.2aaaaaaaaaaaaaaaa".to_vec(), "no message"),
        (Vec::new(), "ends within its prefix"),
        (b"lun".to_vec(), "ends within its prefix"),
        (bytes("{}", b"")[..23].to_vec(), "ends within its prefix"),
        (bytes(r#"{"id":1}"#, b"")[..27].to_vec(), "ends within its header"),
        (bytes("{\"id\":", b""), "no JSON"),
        (bytes("\"text\"", b""), "no object"),
        (bytes("", b""), "no JSON"),
        (bytes("{\"id\":1,\"id\":2,\"do\":\"state\"}", b""), "two values of the key `id`"),
        (bytes(r#"{"planes":3}"#, b""), "no list"),
        (bytes("{}", b"abc"), "do not add up"),
        (bytes(&listed(&format!(r#"{{{plane},"shape":[4]}}"#)), b"abc"), "do not add up"),
        (
            bytes(&listed(&format!(r#"{{{plane},"shape":[2,2]}}"#)), b"abcd")[..]
                .split_last()
                .unwrap()
                .1
                .to_vec(),
            "ends within its plane `a`",
        ),
        (bytes(&listed(&format!(r#"{{{plane},"shape":[-1]}}"#)), b""), "no shape"),
        (bytes(&listed(&format!(r#"{{{plane},"shape":[1,1,1,1,1,1,1,1,1]}}"#)), b"a"), "no shape"),
        (bytes(&listed(&format!(r#"{{{plane},"shape":[4294967296,4294967296,2]}}"#)), b""), "no shape"),
        (bytes(&listed(r#"{"name":"a","dtype":"f16","shape":[1]}"#), b"ab"), "no type of numbers"),
        (bytes(&listed(r#"{"dtype":"u8","shape":[1]}"#), b"a"), "without a name"),
        (bytes(&listed(&format!(r#"{{{plane},"shape":[1]}},{{{plane},"shape":[1]}}"#)), b"ab"), "one name"),
        ([bytes("{}", b""), b"more".to_vec()].concat(), "something follows"),
    ];
    for (bytes, word) in cases {
        let faults = refused(&bytes);
        assert!(faults.len() == 1 && faults[0].contains(word), "{word}: {faults:?}");
    }
}

/// Faults within a whole message leave the next message readable; a broken frame does not.
#[test]
fn what_follows_a_faulty_message_is_read() {
    let hello = Message::new(json!({ "id": 2, "do": "hello" })).encode();
    let listed = r#"{"id":9,"do":"open","planes":[{"name":"a","dtype":"f16","shape":[1]}]}"#;
    for (header, planes, id) in
        [("{\"id\":", &b""[..], json!(null)), ("[1]", b"abc", json!(null)), (listed, b"ab", json!(9))]
    {
        let both = [bytes(header, planes), hello.clone()].concat();
        let mut rest = &both[..];
        let Err(WireError::Faulty { id: found, problems }) = Message::read(&mut rest) else {
            panic!("{header}")
        };
        assert_eq!((found, problems.len()), (id, 1), "{header}");
        assert_eq!(Message::read(&mut rest).unwrap().unwrap().header["do"], "hello", "{header}");
    }
    let cut = bytes(listed, b"ab");
    let cut = Message::read(&mut &cut[..cut.len() - 1]);
    assert!(matches!(cut, Err(WireError::Problems(_))), "planes that are not all there: {cut:?}");
}

/// Lengths of 2^63 are refused before any byte is waited for; deep JSON does not end the program.
#[test]
fn claims_take_no_memory() {
    struct Claim(Vec<u8>, usize);
    impl Read for Claim {
        fn read(&mut self, to: &mut [u8]) -> io::Result<usize> {
            assert!(self.1 + to.len() <= 1 << 20, "no more is asked for than comes");
            let count = self.0[self.1..].len().min(to.len());
            to[..count].copy_from_slice(&self.0[self.1..self.1 + count]);
            self.1 += count;
            Ok(count)
        }
    }
    let prefix =
        |header: u64, planes: u64| [&b"lunoid.1"[..], &header.to_le_bytes(), &planes.to_le_bytes()].concat();
    for (header, planes, count) in [(1 << 63, 0, 1), (u64::MAX, u64::MAX, 2), (16 << 20, (256 << 20) + 1, 1)]
    {
        let Err(WireError::Problems(list)) = Message::read(&mut Claim(prefix(header, planes), 0)) else {
            panic!()
        };
        assert_eq!(list.records().len(), count);
        assert!(list.records()[0].help.as_deref().unwrap().starts_with("--raise"));
    }
    let allowed = Message::read(&mut Claim(prefix(16 << 20, 256 << 20), 0));
    assert!(
        matches!(allowed, Err(WireError::Problems(list)) if list.to_string().contains("within its header"))
    );
    let deep = "[".repeat(100_000);
    assert!(refused(&bytes(&deep, b""))[0].contains("no JSON"));
}

/// Whole messages, damaged: read or refused, and a session answers what is read.
#[test]
fn damaged_messages_are_answered() {
    let pose = json!({ "x_m": 1, "y_m": 2, "z_m": 3, "heading_deg": 4, "pitch_deg": 5, "roll_deg": 6 });
    let seeds = [
        Message::new(json!({ "id": 1, "do": "look", "pose": pose, "planes": ["picture", "range"] })),
        Message::new(json!({ "id": 2, "do": "open", "set": { "a.b": [1, "x"] }, "overlays": ["tear"] }))
            .with(vec![Plane::of("a", &[2, 2], &[1_u16, 2, 3, 4]), Plane::of_file("b", vec![1; 9])]),
        Message::new(json!({ "id": 3, "do": "restore" }))
            .with(vec![Plane::of_file("state", b"{\"schema\":1}".to_vec())]),
        Message::new(json!({ "id": 4, "do": "probe", "signals": ["tg.*"], "sweeps": [1, 2], "frame": 0 })),
    ];
    let (mut session, mut read) = (Session::new(Nobody), 0);
    for number in 0..4000_u64 {
        let mut bytes = seeds[number as usize % seeds.len()].encode();
        for damage in 0..=hash_words(5, &[number]) % 3 {
            let at = hash_words(6, &[number, damage]) as usize % bytes.len();
            match hash_words(7, &[number, damage]) % 3 {
                0 => bytes[at] = hash_words(8, &[number, damage]) as u8,
                1 => bytes.truncate(at.max(1)),
                _ => drop(bytes.splice(at..at, *b"9}")),
            }
        }
        read += usize::from(Message::decode(&bytes).is_ok());
        let answer = Message::decode(&session.answer_bytes(&bytes)).unwrap();
        assert!(answer.header.contains_key("ok") != answer.header.contains_key("error"));
    }
    assert!((20..3800).contains(&read), "{read}");
    assert_eq!(PREFIX, 24);
}
