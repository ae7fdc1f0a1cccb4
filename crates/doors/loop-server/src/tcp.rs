//! Clients on TCP, one after another, each with the token in its first request.

use std::io::{self, BufReader, BufWriter, Read};
use std::net::{IpAddr, SocketAddr, TcpListener, TcpStream};

use diagnostics::Problem;
use loop_protocol::{Home, Message, Session, WireError, unreadable};

use crate::patient::Patient;
use crate::{PATIENCE, ServerError, Token, serve};

/// Key of a first request that has the token.
const TOKEN: &str = "token";

/// Most bytes of a first request, before its client is admitted (chosen).
const FIRST_REQUEST: u64 = 4096;

/// A server on TCP.
#[derive(Debug)]
pub struct TcpServer {
    listener: TcpListener,
    address: SocketAddr,
    token: Token,
}

impl TcpServer {
    /// A server at `address`; port 0 means any that is free.
    ///
    /// # Errors
    /// If nothing can listen there.
    pub fn bind(address: IpAddr, port: u16, token: Token) -> Result<Self, ServerError> {
        let failed = |source: io::Error| {
            let place = SocketAddr::new(address, port).to_string();
            ServerError::Listen { place, source, help: "name another port, or 0 for any that is free" }
        };
        let listener = TcpListener::bind((address, port)).map_err(failed)?;
        let address = listener.local_addr().map_err(failed)?;
        Ok(Self { listener, address, token })
    }

    /// Address and port at which it listens.
    pub fn address(&self) -> SocketAddr {
        self.address
    }

    /// The word that a client needs.
    pub fn token(&self) -> &Token {
        &self.token
    }

    /// Serves one client after another, each with a session of its own. `hear` is told of each client that was let go.
    pub fn serve<H: Home>(&self, session: impl Fn() -> Session<H>, hear: impl Fn(&str)) {
        for client in self.listener.incoming() {
            let heard = client.map_err(WireError::Io).and_then(|client| self.serve_client(&client, &session));
            if let Err(error) = heard {
                hear(&format!("warning: a client was let go: {error}"));
            }
        }
    }

    fn serve_client<H: Home>(
        &self,
        client: &TcpStream,
        session: impl Fn() -> Session<H>,
    ) -> Result<(), WireError> {
        client.set_nodelay(true).map_err(WireError::Io)?;
        let mut from = BufReader::new(Patient::new(client, PATIENCE));
        let mut to = BufWriter::new(client);
        let admitted = self.admitted(&mut from).inspect_err(|error| {
            // The client may be gone.
            let _ = unreadable(error).write(&mut to);
        });
        let Some(request) = admitted? else { return Ok(()) };
        from.get_mut().has_time();
        let mut session = session();
        session.answer(&request).write(&mut to).map_err(WireError::Io)?;
        serve(&mut session, &mut from, &mut to)
    }

    /// The first request of a client, without its token; `None` if it says nothing.
    fn admitted(&self, from: &mut impl Read) -> Result<Option<Message>, WireError> {
        let mut first = from.take(FIRST_REQUEST);
        let read = Message::read(&mut first);
        if read.is_err() && first.limit() == 0 {
            let problem = Problem::of_file("request", "the first request is too long");
            return Err(problem
                .expected(format!("at most {FIRST_REQUEST} bytes before a client is admitted"))
                .into());
        }
        let Some(mut request) = read? else { return Ok(None) };
        let word = request.header.remove(TOKEN);
        let is_hello = request.header.get("do").is_some_and(|word| word == "hello");
        if is_hello && word.as_ref().and_then(|word| word.as_str()).is_some_and(|word| self.token.is(word)) {
            return Ok(Some(request));
        }
        let problem = match (is_hello, word.is_some()) {
            (false, _) => Problem::of_file("request", "the first request is no `hello`").key("do"),
            (true, false) => Problem::of_file("request", "a client without a token").key(TOKEN),
            (true, true) => Problem::of_file("request", "the token is another one").key(TOKEN),
        };
        let problem = problem.expected("`hello` with the token of the server under `token`");
        Err(problem.help("the server says its token when it begins").into())
    }
}
