//! A session that has nothing to open, and what its clients say.

use std::io::{Read, Write};

use diagnostics::Problem;
use drive::{Drive, DriveError};
use loop_protocol::{Home, Message, Opening, Session};
use serde_json::{Value, json};

/// A home that opens nothing.
pub struct Empty;

impl Home for Empty {
    fn open(&mut self, _asked: &Opening) -> Result<Drive, DriveError> {
        Err(Problem::of_file("request", "nothing is opened here").into())
    }
}

pub fn session() -> Session<Empty> {
    Session::new(Empty)
}

/// The bytes of a request.
pub fn request(header: Value) -> Vec<u8> {
    Message::new(header).encode()
}

pub fn hello() -> Vec<u8> {
    request(json!({ "id": 1, "do": "hello" }))
}

/// A message with request number 9 whose plane has a type that is none.
pub fn faulty() -> Vec<u8> {
    let header = r#"{"id":9,"do":"hello","planes":[{"name":"a","dtype":"f16","shape":[1]}]}"#;
    let lengths = [header.len() as u64, 2].map(u64::to_le_bytes).concat();
    [b"lunoid.1", &lengths[..], header.as_bytes(), b"ab"].concat()
}

/// Sends `bytes` and no more; the headers of all replies.
pub fn said(mut stream: impl Read + Write, close: impl FnOnce(), bytes: &[u8]) -> Vec<Value> {
    // A server that has refused has closed.
    let _ = stream.write_all(bytes);
    close();
    let mut replies = Vec::new();
    while let Ok(Some(reply)) = Message::read(&mut stream) {
        replies.push(Value::Object(reply.header));
    }
    replies
}

/// Title of the first fault of a reply.
pub fn fault(reply: &Value) -> &str {
    reply["error"]["problems"][0]["title"].as_str().unwrap_or("")
}
