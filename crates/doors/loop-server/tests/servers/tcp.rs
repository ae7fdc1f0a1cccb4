//! TCP: nobody without the token, and one after another.

use std::net::{IpAddr, Ipv4Addr, Shutdown, SocketAddr, TcpStream};
use std::thread;

use loop_server::{ServerError, TcpServer, Token};
use serde_json::{Value, json};

use crate::home::{fault, hello, request, said, session};

const HERE: IpAddr = IpAddr::V4(Ipv4Addr::LOCALHOST);

/// A server that lives as long as the tests.
fn server(token: Token) -> SocketAddr {
    let server = TcpServer::bind(HERE, 0, token).unwrap();
    let address = server.address();
    thread::spawn(move || server.serve(session, |_| ()));
    address
}

fn spoken(address: SocketAddr, bytes: &[u8]) -> Vec<Value> {
    let stream = TcpStream::connect(address).unwrap();
    let other = stream.try_clone().unwrap();
    said(stream, || other.shutdown(Shutdown::Write).unwrap(), bytes)
}

#[test]
fn a_client_with_the_token_is_answered_and_no_other() {
    let token = Token::random().unwrap();
    let address = server(token.clone());
    let with = |word: &str| request(json!({ "id": 1, "do": "hello", "token": word }));
    let replies = spoken(address, &[with(token.word()), hello()].concat());
    assert_eq!(replies.len(), 2, "{replies:?}");
    assert_eq!(replies[0]["ok"], replies[1]["ok"], "after the first request no token is asked for");
    assert_eq!(replies[0]["ok"]["protocol"], "lunoid.loop/1");
    let bad = [
        (hello(), "a client without a token"),
        (with("0123456789abcdef0123456789abcdef"), "the token is another one"),
        (with(""), "the token is another one"),
        (request(json!({ "id": 1, "do": "hello", "token": 7 })), "the token is another one"),
        (
            request(json!({ "id": 1, "do": "frame", "frame": 0, "token": token.word() })),
            "the first request is no `hello`",
        ),
        (b"GET / HTTP/1.1\r\nHost: here\r\n\r\n".to_vec(), "the bytes are no message of lunoid.loop/1"),
        (
            request(json!({ "id": 1, "do": "hello", "token": "x".repeat(5000) })),
            "the first request is too long",
        ),
    ];
    for (bytes, title) in bad {
        let replies = spoken(address, &[bytes, hello()].concat());
        assert_eq!((replies.len(), fault(&replies[0])), (1, title), "{replies:?}");
    }
    drop(TcpStream::connect(address).unwrap());
    assert_eq!(spoken(address, &with(token.word())).len(), 1, "the next client is served");
}

#[test]
fn a_port_that_is_taken_is_an_error_that_says_what_to_do() {
    let address = server(Token::random().unwrap());
    let taken = TcpServer::bind(HERE, address.port(), Token::random().unwrap()).unwrap_err();
    assert!(matches!(taken, ServerError::Listen { .. }));
    let text = taken.to_string();
    assert!(text.starts_with(&address.to_string()) && text.ends_with("0 for any that is free"), "{text}");
}
