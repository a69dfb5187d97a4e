//! `bosquet lsp`: a language server on standard input and output, a thin face on [`bosquet::ide`].
//!
//! One thread reads, one answers in order. What has been cancelled while it waited is not worked on, and diagnostics wait
//! until nothing else does, so that fast typing costs one check and not one for every key.

mod answers;
mod convert;
mod frame;
mod lines;
mod places;
mod texts;
mod uri;

use crate::cli::{Ended, limits::STACK};
use bosquet::element::Catalogue;
use bosquet::ide::{Desk, Finding};
use frame::Frame;
use lines::Lines;
use lsp_server::{ErrorCode, Message, Notification, Request, RequestId, Response, ResponseError};
use lsp_types::{
    DidChangeTextDocumentParams, DidCloseTextDocumentParams, DidOpenTextDocumentParams, InitializeParams,
    PublishDiagnosticsParams, TextDocumentContentChangeEvent, Uri,
};
use places::Places;
use serde_json::{Value, json};
use std::collections::{BTreeMap, BTreeSet, VecDeque};
use std::io::Write;
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::mpsc::{Receiver, channel};
use texts::Texts;

/// Serves until the editor says `exit` or goes away. An end without `shutdown` before it is a failure.
pub fn run() -> Ended {
    let (sender, receiver) = channel();
    std::thread::spawn(move || {
        let mut input = std::io::stdin().lock();
        while let Some(frame) = frame::read(&mut input) {
            if sender.send(frame).is_err() {
                return;
            }
        }
    });
    let serving = std::thread::Builder::new().stack_size(STACK).spawn(move || Server::new(receiver).serve());
    match serving.map(std::thread::JoinHandle::join) {
        Ok(Ok(true)) => Ended::Well,
        Ok(Ok(false)) => Ended::Wrong,
        Ok(Err(panic)) => std::panic::resume_unwind(panic),
        Err(error) => Ended::Usage(format!("the worker thread cannot be started: {error}")),
    }
}

/// How far the session has come.
#[derive(Clone, Copy, PartialEq)]
enum Stage {
    /// Before `initialize`.
    New,
    Running,
    /// After `shutdown`.
    Closed,
}

struct Server {
    receiver: Receiver<Frame>,
    waiting: VecDeque<Frame>,
    stage: Stage,
    texts: Texts,
    places: Places,
    /// Where the manual's pictures lie.
    pictures: Option<String>,
    /// Texts have changed since diagnostics were told.
    is_stale: bool,
    /// The files for which diagnostics are shown.
    shown: BTreeSet<String>,
}

impl Server {
    fn new(receiver: Receiver<Frame>) -> Server {
        Server {
            receiver,
            waiting: VecDeque::new(),
            stage: Stage::New,
            texts: Texts::new(Vec::new()),
            places: Places::default(),
            pictures: None,
            is_stale: false,
            shown: BTreeSet::new(),
        }
    }

    /// Works until the end; whether `shutdown` came before it.
    fn serve(mut self) -> bool {
        while let Some(frame) = self.next() {
            match frame {
                Frame::Broken(answer) => self.send(&answer),
                Frame::Message(Message::Request(request)) => self.request(request),
                Frame::Message(Message::Notification(note)) if note.method == "exit" => break,
                Frame::Message(Message::Notification(note)) => self.note(note),
                Frame::Message(Message::Response(_)) => {}
            }
        }
        self.stage == Stage::Closed
    }

    /// The next frame; before waiting for one, diagnostics are told.
    fn next(&mut self) -> Option<Frame> {
        self.waiting.extend(self.receiver.try_iter());
        if self.waiting.is_empty() {
            if std::mem::take(&mut self.is_stale) {
                self.diagnose();
            }
            self.waiting.push_back(self.receiver.recv().ok()?);
        }
        self.waiting.pop_front()
    }

    fn request(&mut self, request: Request) {
        let id = request.id.clone();
        let result = match (request.method.as_str(), self.stage) {
            _ if self.is_cancelled(&id) => Err(error(ErrorCode::RequestCanceled, "the request was cancelled")),
            ("initialize", Stage::New) => self.initialize(request.params),
            (_, Stage::New) => Err(error(ErrorCode::ServerNotInitialized, "`initialize` comes first")),
            ("initialize", _) => Err(error(ErrorCode::InvalidRequest, "`initialize` comes once")),
            (_, Stage::Closed) => Err(error(ErrorCode::InvalidRequest, "after `shutdown` only `exit` is left")),
            ("shutdown", _) => {
                self.stage = Stage::Closed;
                Ok(Value::Null)
            }
            _ => {
                let catalogue = self.catalogue(&request.params);
                self.answer(request, catalogue.as_deref().unwrap_or_else(|| Catalogue::built_in()))
            }
        };
        let response = match result {
            Ok(value) => Response { id, result: Some(value), error: None },
            Err(error) => Response { id, result: None, error: Some(error) },
        };
        self.message(Message::Response(response));
    }

    /// The catalogue of the file that a request is about, where its place has one.
    fn catalogue(&mut self, params: &Value) -> Option<Arc<Catalogue>> {
        let uri: Uri = serde_json::from_value(params.get("textDocument")?.get("uri")?.clone()).ok()?;
        self.places.catalogue(&mut self.texts, &uri::path(&uri))
    }

    /// Whether a message that waits cancels the request.
    fn is_cancelled(&self, id: &RequestId) -> bool {
        let cancels = |note: &Notification| {
            let given = note.params.get("id").cloned().and_then(|id| serde_json::from_value::<RequestId>(id).ok());
            note.method == "$/cancelRequest" && given.as_ref() == Some(id)
        };
        self.waiting.iter().any(|frame| matches!(frame, Frame::Message(Message::Notification(note)) if cancels(note)))
    }

    fn initialize(&mut self, params: Value) -> Result<Value, ResponseError> {
        let params: InitializeParams = read(params)?;
        #[expect(deprecated, reason = "older editors send the one folder and no list")]
        let root = params.root_uri.clone();
        let folders = params.workspace_folders.clone().unwrap_or_default().into_iter().map(|folder| folder.uri);
        let uris = folders.chain(root).filter(uri::is_file);
        let folders: BTreeSet<PathBuf> = uris.map(|uri| PathBuf::from(uri::path(&uri))).collect();
        self.texts = Texts::new(folders.into_iter().collect());
        self.pictures = pictures(&self.texts, params.initialization_options.as_ref());
        if let Some(folder) = &self.pictures {
            self.texts.open_folder(&PathBuf::from(folder));
        }
        self.stage = Stage::Running;
        let info = json!({ "name": "bosquet", "version": env!("CARGO_PKG_VERSION") });
        Ok(json!({ "capabilities": convert::capabilities(), "serverInfo": info }))
    }

    fn note(&mut self, note: Notification) {
        if self.stage != Stage::Running {
            return;
        }
        match note.method.as_str() {
            "textDocument/didOpen" => self.noted(note.params, |texts, params: DidOpenTextDocumentParams| {
                texts.put(&params.text_document.uri, params.text_document.text);
            }),
            "textDocument/didChange" => self.noted(note.params, |texts, params: DidChangeTextDocumentParams| {
                if let Some(text) = texts.buffer(&params.text_document.uri) {
                    params.content_changes.into_iter().for_each(|change| changed(text, change));
                }
            }),
            "textDocument/didClose" => self.noted(note.params, |texts, params: DidCloseTextDocumentParams| {
                texts.close(&params.text_document.uri);
            }),
            "textDocument/didSave" | "workspace/didChangeWatchedFiles" => {
                self.texts.look_for_files();
                self.places.forget();
                self.is_stale = true;
            }
            _ => {}
        }
    }

    /// Applies a notification to the texts; one that cannot be read has no answer and is passed over.
    fn noted<P: serde::de::DeserializeOwned>(&mut self, params: Value, apply: impl FnOnce(&mut Texts, P)) {
        if let Ok(params) = serde_json::from_value(params) {
            apply(&mut self.texts, params);
            self.is_stale = true;
        }
    }

    /// Tells what is wrong in the open files and in what they import, and takes back what no longer is.
    fn diagnose(&mut self) {
        let mut found: BTreeMap<String, Vec<Finding>> = BTreeMap::new();
        let desk = Desk::new(&self.texts, Catalogue::built_in());
        for path in self.texts.open_paths() {
            found.entry(path.clone()).or_default();
            for finding in desk.diagnose(&path) {
                let of_file = found.entry(finding.place.path.clone()).or_default();
                if !of_file.contains(&finding) {
                    of_file.push(finding);
                }
            }
        }
        let gone = self.shown.iter().filter(|path| !found.contains_key(*path)).cloned();
        let gone: Vec<(String, Vec<Finding>)> = gone.map(|path| (path, Vec::new())).collect();
        let notes: Vec<Notification> = found
            .iter()
            .chain(gone.iter().map(|(path, none)| (path, none)))
            .filter_map(|(path, findings)| publication(&desk, &self.texts, path, findings))
            .collect();
        self.shown = found.into_keys().collect();
        notes.into_iter().for_each(|note| self.message(Message::Notification(note)));
    }

    fn message(&mut self, message: Message) {
        let mut value = serde_json::to_value(message).unwrap_or_default();
        if let Some(fields) = value.as_object_mut() {
            fields.insert("jsonrpc".into(), "2.0".into());
        }
        self.send(&value);
    }

    /// An editor that has gone reads nothing: the input ends then, and with it the session.
    fn send(&mut self, value: &Value) {
        let mut output = std::io::stdout().lock();
        let _ = frame::write(&mut output, value).and_then(|()| output.flush());
    }
}

/// One edit of a text.
fn changed(text: &mut String, change: TextDocumentContentChangeEvent) {
    match change.range {
        Some(range) => {
            let bytes = Lines::of(text).bytes(range);
            text.replace_range(bytes, &change.text);
        }
        None => *text = change.text,
    }
}

fn publication(desk: &Desk, texts: &Texts, path: &str, findings: &[Finding]) -> Option<Notification> {
    let document = desk.document(path);
    let lines = Lines::of(document.as_ref().map_or("", |document| document.text()));
    let diagnostics = findings.iter().map(|finding| convert::diagnostic(finding, &lines)).collect();
    let params = PublishDiagnosticsParams { uri: texts.uri(path)?, diagnostics, version: None };
    Some(Notification::new("textDocument/publishDiagnostics".into(), params))
}

/// The folder of the manual's pictures: said by the editor, in the workspace, or beside the command.
fn pictures(texts: &Texts, options: Option<&Value>) -> Option<String> {
    let said = options.and_then(|options| options.get("pictures")).and_then(Value::as_str).map(PathBuf::from);
    let own = texts.workspace().iter().flat_map(|f| [f.join("docs/manual/images"), f.join("manual/images")]);
    let command = std::env::current_exe().ok();
    let beside = command.as_ref().and_then(|path| Some(path.parent()?.join("../share/bosquet/manual/images")));
    let folder = said.into_iter().chain(own).chain(beside).find(|folder| folder.is_dir())?;
    Some(folder.canonicalize().ok()?.to_string_lossy().replace('\\', "/"))
}

/// Parameters as their type.
fn read<P: serde::de::DeserializeOwned>(params: Value) -> Result<P, ResponseError> {
    serde_json::from_value(params)
        .map_err(|e| error(ErrorCode::InvalidParams, &format!("the parameters are wrong: {e}")))
}

fn error(code: ErrorCode, message: &str) -> ResponseError {
    ResponseError { code: code as i32, message: message.into(), data: None }
}
