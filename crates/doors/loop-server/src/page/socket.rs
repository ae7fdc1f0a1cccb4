//! A session on a WebSocket: one binary message a request, one a reply.

use std::net::TcpStream;

use limits::Limit;
use loop_protocol::{Home, PREFIX, Session};
use tungstenite::handshake::server::{create_response, write_response};
use tungstenite::protocol::{Role, WebSocketConfig};
use tungstenite::{Error, Message, WebSocket};

use super::head::Asked;
use super::reply::Reply;

/// Answers the page until it goes.
///
/// # Errors
/// What went wrong, in words.
pub fn serve<H: Home>(mut stream: TcpStream, asked: Asked, mut session: Session<H>) -> Result<(), String> {
    let said = |error: Error| error.to_string();
    let response = match create_response(&asked.head) {
        Ok(response) => response,
        Err(error) => {
            let reply = Reply::refusal(400, &format!("no socket is opened: {error}"));
            return reply.write(&mut stream).map_err(|error| error.to_string());
        }
    };
    write_response(&mut stream, &response).map_err(said)?;
    stream.set_read_timeout(None).map_err(|error| error.to_string())?;
    let mut socket = WebSocket::from_partially_read(stream, asked.rest, Role::Server, Some(bounds()));
    loop {
        match socket.read() {
            Ok(Message::Binary(request)) => {
                let reply = session.answer_bytes(&request);
                socket.send(Message::binary(reply)).map_err(said)?;
            }
            // The protocol has no text: its bytes are no message, and the answer says so.
            Ok(Message::Text(text)) => {
                let reply = session.answer_bytes(text.as_bytes());
                socket.send(Message::binary(reply)).map_err(said)?;
            }
            Ok(_) => {}
            Err(Error::ConnectionClosed | Error::AlreadyClosed) => return Ok(()),
            // A page that is closed says no word.
            Err(Error::Protocol(_) | Error::Io(_)) if !socket.can_read() => return Ok(()),
            Err(error) => return Err(error.to_string()),
        }
    }
}

/// Bounds of a message: those of the protocol.
fn bounds() -> WebSocketConfig {
    let most = [Limit::HeaderBytes, Limit::PlaneBytes].map(Limit::value).into_iter().sum::<u64>();
    let most = usize::try_from(most).unwrap_or(usize::MAX).saturating_add(PREFIX);
    WebSocketConfig::default().max_message_size(Some(most)).max_frame_size(Some(most))
}
