//! The frames of the protocol: headers, a blank line, so many bytes of JSON. What is broken is told and skipped, so that
//! one bad message does not end the session.

use lsp_server::Message;
use serde_json::{Value, json};
use std::io::{BufRead, Read, Write};

/// Longer messages are skipped, bytes: rule files are smaller.
const MOST_BYTES: u64 = 256 << 20;
/// Longer header lines are cut, bytes.
const MOST_HEADER: u64 = 8 << 10;

/// What came in.
pub enum Frame {
    /// A message.
    Message(Message),
    /// What is none: the answer that says so.
    Broken(Value),
}

/// The next frame; `None` at the end of the input.
pub fn read(input: &mut impl BufRead) -> Option<Frame> {
    let Some(size) = size(input)? else {
        return Some(broken(-32700, &Value::Null, "the header has no `Content-Length` that is a number"));
    };
    if size > MOST_BYTES {
        std::io::copy(&mut input.take(size), &mut std::io::sink()).ok()?;
        return Some(broken(-32600, &Value::Null, &format!("the message has {size} bytes, more than {MOST_BYTES}")));
    }
    let mut body = vec![0; size as usize];
    input.read_exact(&mut body).ok()?;
    Some(message(&body))
}

/// Writes a message and flushes it; whether that went well.
pub fn write(output: &mut impl Write, message: &Value) -> std::io::Result<()> {
    let text = message.to_string();
    write!(output, "Content-Length: {}\r\n\r\n{text}", text.len())?;
    output.flush()
}

/// The bytes that the header announces, `Some(None)` where it does not say.
fn size(input: &mut impl BufRead) -> Option<Option<u64>> {
    let mut size = None;
    loop {
        let mut line = Vec::new();
        if input.take(MOST_HEADER).read_until(b'\n', &mut line).ok()? == 0 {
            return None;
        }
        let line = String::from_utf8_lossy(&line);
        let line = line.trim();
        if line.is_empty() {
            return Some(size);
        }
        if let Some((_, value)) = line.split_once(':').filter(|(name, _)| name.eq_ignore_ascii_case("Content-Length")) {
            size = value.trim().parse().ok();
        }
    }
}

fn message(body: &[u8]) -> Frame {
    let value: Value = match serde_json::from_slice(body) {
        Ok(value) => value,
        Err(error) => return broken(-32700, &Value::Null, &format!("the message is no JSON: {error}")),
    };
    let id = value.get("id").cloned().unwrap_or(Value::Null);
    match serde_json::from_value(value) {
        Ok(message) => Frame::Message(message),
        Err(_) => broken(-32600, &id, "the message is no request, answer or notification"),
    }
}

fn broken(code: i32, id: &Value, message: &str) -> Frame {
    Frame::Broken(json!({ "jsonrpc": "2.0", "id": id, "error": { "code": code, "message": message } }))
}
