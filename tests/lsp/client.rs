//! An editor for tests: starts the built server on a folder of its own and talks to it as editors do.

use serde_json::{Value, json};
use std::collections::VecDeque;
use std::io::{BufRead, BufReader, Read, Write};
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};
use std::sync::mpsc::{self, Receiver};
use std::time::Duration;
use tempfile::TempDir;

/// A session with the server.
pub struct Client {
    server: Child,
    input: Option<ChildStdin>,
    messages: Receiver<Value>,
    folder: TempDir,
    number: i32,
    /// Notifications that came while an answer was waited for.
    notes: VecDeque<Value>,
}

/// How long the server may think; tests are not timed, but they have to end.
const PATIENCE: Duration = Duration::from_secs(120);

/// The next message of a server; none where it has gone.
fn next(output: &mut BufReader<ChildStdout>) -> Option<Value> {
    let mut length = 0;
    loop {
        let mut line = String::new();
        if output.read_line(&mut line).ok()? == 0 {
            return None;
        }
        match line.trim().split_once(": ") {
            Some(("Content-Length", value)) => length = value.parse().ok()?,
            Some(_) => {}
            None => break,
        }
    }
    let mut body = vec![0; length];
    output.read_exact(&mut body).ok()?;
    serde_json::from_slice(&body).ok()
}

impl Client {
    /// A session before `initialize`, in a folder with these files.
    pub fn start(files: &[(&str, &str)]) -> Client {
        let folder = tempfile::tempdir().expect("a folder");
        for (name, text) in files {
            let path = folder.path().join(name);
            std::fs::create_dir_all(path.parent().expect("a folder")).expect("a folder");
            std::fs::write(path, text).expect("a file");
        }
        let mut server = Command::new(env!("CARGO_BIN_EXE_bosquet"))
            .args(["lsp", "--stdio"])
            .env("XDG_CACHE_HOME", folder.path().join("cache"))
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .expect("the server starts");
        let (input, output) = (server.stdin.take(), server.stdout.take().expect("a pipe"));
        let (sender, messages) = mpsc::channel();
        let mut output = BufReader::new(output);
        std::thread::spawn(move || {
            let told = std::iter::from_fn(|| next(&mut output));
            // Nobody listens any more when the test has ended.
            told.map(|message| sender.send(message)).take_while(Result::is_ok).for_each(drop);
        });
        Client { server, input, messages, folder, number: 0, notes: VecDeque::new() }
    }

    /// A session after `initialize`.
    pub fn new(files: &[(&str, &str)]) -> Client {
        let mut client = Client::start(files);
        let root = client.uri("");
        let root = root.trim_end_matches('/');
        let folders = json!([{ "uri": root, "name": "place" }]);
        let params = json!({ "processId": null, "capabilities": {}, "workspaceFolders": folders });
        client.ask("initialize", params);
        client.tell("initialized", json!({}));
        client
    }

    /// The URI of a file of the folder.
    pub fn uri(&self, name: &str) -> String {
        let folder = self.folder.path().canonicalize().expect("the folder is there");
        format!("file://{}/{name}", folder.display())
    }

    /// Opens a file with a text and waits for its diagnostics.
    pub fn open(&mut self, name: &str, text: &str) -> Vec<Value> {
        let document = json!({ "uri": self.uri(name), "languageId": "cga", "version": 1, "text": text });
        self.tell("textDocument/didOpen", json!({ "textDocument": document }));
        self.diagnostics(name)
    }

    /// Applies edits to an open file.
    pub fn change(&mut self, name: &str, changes: Value) {
        let document = json!({ "uri": self.uri(name), "version": 2 });
        self.tell("textDocument/didChange", json!({ "textDocument": document, "contentChanges": changes }));
    }

    /// The next diagnostics of a file.
    pub fn diagnostics(&mut self, name: &str) -> Vec<Value> {
        let uri = self.uri(name);
        let mut told = self.note("textDocument/publishDiagnostics", &uri);
        assert!(told["diagnostics"].is_array(), "{told}");
        serde_json::from_value(told["diagnostics"].take()).expect("a list")
    }

    /// The result of a request about a place in a file.
    pub fn at(&mut self, method: &str, name: &str, line: u32, character: u32) -> Value {
        let document = json!({ "uri": self.uri(name) });
        let position = json!({ "line": line, "character": character });
        self.ask(&format!("textDocument/{method}"), json!({ "textDocument": document, "position": position }))
    }

    /// The result of a request about a file.
    pub fn about(&mut self, method: &str, name: &str) -> Value {
        let document = json!({ "uri": self.uri(name) });
        self.ask(&format!("textDocument/{method}"), json!({ "textDocument": document }))
    }

    /// The result of a request.
    pub fn ask(&mut self, method: &str, params: Value) -> Value {
        let answer = self.answer(method, params);
        assert!(answer.get("error").is_none(), "{method}: {answer}");
        answer["result"].clone()
    }

    /// The error of a request that is refused.
    pub fn refused(&mut self, method: &str, params: Value) -> Value {
        let answer = self.answer(method, params);
        assert!(answer.get("error").is_some(), "{method}: {answer}");
        answer["error"].clone()
    }

    fn answer(&mut self, method: &str, params: Value) -> Value {
        self.number += 1;
        let id = self.number;
        self.send(&json!({ "jsonrpc": "2.0", "id": id, "method": method, "params": params }));
        loop {
            let message = self.receive();
            if message["id"] == id {
                return message;
            }
            self.notes.push_back(message);
        }
    }

    /// Sends a notification.
    pub fn tell(&mut self, method: &str, params: Value) {
        self.send(&json!({ "jsonrpc": "2.0", "method": method, "params": params }));
    }

    /// Sends a message.
    pub fn send(&mut self, message: &Value) {
        let text = message.to_string();
        self.raw(format!("Content-Length: {}\r\n\r\n{text}", text.len()).as_bytes());
    }

    /// Sends any bytes.
    pub fn raw(&mut self, bytes: &[u8]) {
        let input = self.input.as_mut().expect("the session is open");
        input.write_all(bytes).and_then(|()| input.flush()).expect("the server reads");
    }

    /// The parameters of the next notification of a method about a file; others wait.
    fn note(&mut self, method: &str, uri: &str) -> Value {
        let wanted = |note: &Value| note["method"] == method && note["params"]["uri"] == uri;
        if let Some(index) = self.notes.iter().position(wanted) {
            return self.notes.remove(index).expect("it is there")["params"].take();
        }
        loop {
            let mut message = self.receive();
            if wanted(&message) {
                return message["params"].take();
            }
            self.notes.push_back(message);
        }
    }

    /// The next message; a server that is silent for long has failed.
    pub fn receive(&mut self) -> Value {
        self.messages.recv_timeout(PATIENCE).expect("the server says something")
    }

    /// Ends the session: the exit code.
    pub fn ends(mut self, words: &[&str]) -> i32 {
        for word in words {
            match *word {
                "shutdown" => assert!(self.ask("shutdown", Value::Null).is_null()),
                other => self.tell(other, Value::Null),
            }
        }
        self.input = None;
        self.server.wait().expect("an end").code().expect("no signal")
    }
}

impl Drop for Client {
    fn drop(&mut self) {
        self.input = None;
        let _ = self.server.wait();
    }
}
