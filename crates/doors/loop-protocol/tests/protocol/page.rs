//! The page of the protocol: every request has an example, and a session answers all of them in their order.

use loop_protocol::{Message, Plane, REQUESTS};
use serde_json::{Value, json};

use crate::home::{Scene, done};

const PAGE: &str = include_str!("../../../../../docs/loop-protocol.md");

/// Blocks of the page in `language`.
fn blocks(language: &str) -> Vec<&'static str> {
    let begin = format!("```{language}\n");
    PAGE.split(&begin).skip(1).map(|rest| rest.split("```").next().unwrap()).collect()
}

/// Requests of the page.
fn requests() -> Vec<Value> {
    blocks("json").into_iter().map(|block| serde_json::from_str(block).unwrap()).collect()
}

#[test]
fn every_request_has_a_heading_and_an_example() {
    let names = REQUESTS.map(|row| row.name);
    let headings: Vec<&str> =
        PAGE.lines().filter_map(|line| line.strip_prefix("### `")?.strip_suffix('`')).collect();
    assert_eq!(headings, names);
    let requests = requests();
    let examples: Vec<&str> = requests.iter().map(|request| request["do"].as_str().unwrap()).collect();
    assert_eq!(examples, names);
}

#[test]
fn the_bytes_are_those_of_a_request() {
    let hex = blocks("hex");
    let bytes: Vec<u8> =
        hex[0].split_whitespace().map(|byte| u8::from_str_radix(byte, 16).unwrap()).collect();
    assert_eq!(hex.len(), 1);
    assert_eq!(Message::new(requests()[0].clone()).encode(), bytes);
}

#[test]
fn the_examples_are_answered() {
    let mut session = loop_protocol::Session::new(Scene::by("ideal"));
    let mut state: Vec<Plane> = Vec::new();
    for request in requests() {
        let word = request["do"].as_str().unwrap().to_owned();
        let planes = if word == "restore" { std::mem::take(&mut state) } else { Vec::new() };
        let answer = session.answer(&Message::new(request.clone()).with(planes));
        assert_eq!(answer.header["id"], request["id"]);
        let told = done(&answer);
        let names: Vec<&str> = answer.planes.iter().map(Plane::name).collect();
        match &*word {
            "state" => state = answer.planes,
            "restore" => assert_eq!(told["driven"], 1),
            "frame" => assert_eq!(names, ["picture", "light", "range"]),
            "look" | "step" => assert_eq!(names, ["picture"]),
            "record" => assert_eq!(names, ["scenario.toml", "driven.csv", "record.json"]),
            "probe" => assert_eq!(names, ["mu.height", "places"]),
            _ => assert!(names.is_empty(), "{word}: {names:?}"),
        }
    }
}

#[test]
fn the_refusal_is_that_of_a_session() {
    let mut session = Scene::by("ideal").session();
    let request = Message::new(json!({ "id": 7, "do": "frame", "frame": 0, "plane": [] }));
    let shown: Value = serde_json::from_str(blocks("text")[0]).unwrap();
    assert_eq!(Value::Object(session.answer(&request).header), shown);
}
