//! Who is served: the browser that brought the token, from the page itself.

use std::sync::atomic::{AtomicBool, Ordering};

use tungstenite::http::{HeaderName, Method, Request, header};

use super::SOCKET;
use super::reply::Reply;
use crate::Token;

/// What is done with a request.
pub enum Verdict {
    /// A socket is opened.
    Socket,
    /// The page is told whether a socket can be opened: a browser hides from it why one was refused.
    IsThereRoom,
    /// A file is served.
    File,
    /// This reply is all.
    Reply(Reply),
}

/// The token, which admits one browser once, and the cookie that this browser has from then on.
#[derive(Debug)]
pub struct Admission {
    port: u16,
    /// The page that is opened first.
    first: &'static str,
    token: Token,
    is_spent: AtomicBool,
    cookie: Token,
}

impl Admission {
    pub fn new(port: u16, first: &'static str, token: Token, cookie: Token) -> Self {
        Self { port, first, token, is_spent: AtomicBool::new(false), cookie }
    }

    pub fn token(&self) -> &Token {
        &self.token
    }

    /// What is done with a request. A name of this computer that others may have given to it is refused, and so is a socket of another page.
    pub fn of(&self, head: &Request<()>) -> Verdict {
        let refused = |status, why| Verdict::Reply(Reply::refusal(status, why));
        let hosts = ["127.0.0.1", "localhost"].map(|name| format!("{name}:{}", self.port));
        let host = line(head, header::HOST);
        if !hosts.iter().any(|own| Some(own.as_str()) == host) {
            return refused(
                421,
                "the address has another host name; open the one that the command has printed",
            );
        }
        if head.method() != Method::GET {
            return refused(405, "only GET is answered");
        }
        if head.uri().path() == "/" {
            return Verdict::Reply(self.first(head));
        }
        if !self.has_cookie(head) {
            return refused(
                403,
                "this browser is not admitted; open the address that the command has printed",
            );
        }
        if head.uri().path() != SOCKET {
            return Verdict::File;
        }
        if !head.headers().contains_key(header::UPGRADE) {
            return Verdict::IsThereRoom;
        }
        let origin = line(head, header::ORIGIN).and_then(|origin| origin.strip_prefix("http://"));
        if origin == host { Verdict::Socket } else { refused(403, "another page is not answered") }
    }

    /// The reply to whoever opens the address: the token is spent by the first who brings it.
    fn first(&self, head: &Request<()>) -> Reply {
        let word = head.uri().query().and_then(|query| query.strip_prefix("token="));
        let is_token = word.is_some_and(|word| self.token.is(word));
        if self.has_cookie(head) || is_token && !self.is_spent.swap(true, Ordering::Relaxed) {
            let cookie = format!("{}={}", self.name(), self.cookie.word());
            return Reply::onward(self.first, format!("{cookie}; Path=/; HttpOnly; SameSite=Strict"));
        }
        if is_token {
            return Reply::refusal(403, "the address was used by another browser; start the command again");
        }
        Reply::refusal(403, "a token is missing; open the address that the command has printed")
    }

    /// Name of the cookie. Servers at other ports of this computer have the same cookies.
    fn name(&self) -> String {
        format!("lunoid-{}", self.port)
    }

    fn has_cookie(&self, head: &Request<()>) -> bool {
        let name = self.name();
        let cookies = line(head, header::COOKIE).unwrap_or("");
        let own = cookies.split("; ").filter_map(|cookie| cookie.split_once('='));
        own.filter(|(other, _)| *other == name).any(|(_, word)| self.cookie.is(word))
    }
}

/// A line that stands once in a head.
fn line(head: &Request<()>, name: HeaderName) -> Option<&str> {
    let mut lines = head.headers().get_all(name).iter();
    let line = lines.next()?.to_str().ok()?;
    lines.next().is_none().then_some(line)
}
