//! What the desk says, in the protocol's words.

use crate::cli::lsp::lines::Lines;
use bosquet::diag::Severity;
use bosquet::ide::{Completion, CompletionKind, Finding, Fold, Signature, Sort, Swatch, Symbol, TINTS, Tint, Tinted};
use lsp_types::{
    CompletionItemKind, Diagnostic, DiagnosticSeverity, InsertTextFormat, NumberOrString, SemanticTokenModifier,
    SemanticTokenType, SymbolKind,
};
use serde_json::{Value, json};

/// What is shown in a file.
pub trait Shown {
    /// In the protocol's words.
    fn shown(&self, lines: &Lines) -> Value;
}

/// What the server can do.
pub fn capabilities() -> Value {
    let types: Vec<SemanticTokenType> = TINTS.iter().map(|tint| token_type(*tint)).collect();
    let modifiers = [SemanticTokenModifier::DEFINITION, SemanticTokenModifier::DEFAULT_LIBRARY];
    json!({
        "positionEncoding": "utf-16",
        "textDocumentSync": { "openClose": true, "change": 2, "save": true },
        "hoverProvider": true,
        "completionProvider": { "triggerCharacters": [".", "@", "\"", "(", "{", "|"] },
        "signatureHelpProvider": { "triggerCharacters": ["(", ","], "retriggerCharacters": ["="] },
        "definitionProvider": true,
        "referencesProvider": true,
        "renameProvider": { "prepareProvider": true },
        "documentSymbolProvider": true,
        "foldingRangeProvider": true,
        "documentFormattingProvider": true,
        "colorProvider": true,
        "semanticTokensProvider": { "legend": { "tokenTypes": types, "tokenModifiers": modifiers }, "full": true },
    })
}

/// One diagnostic.
pub fn diagnostic(finding: &Finding, lines: &Lines) -> Diagnostic {
    let severity = match finding.severity {
        Severity::Error => DiagnosticSeverity::ERROR,
        Severity::Lint => DiagnosticSeverity::WARNING,
        Severity::Note => DiagnosticSeverity::INFORMATION,
    };
    Diagnostic {
        range: lines.range(&(finding.place.start..finding.place.end)),
        severity: Some(severity),
        code: Some(NumberOrString::String(finding.code.into())),
        source: Some("bosquet".into()),
        message: finding.message.clone(),
        ..Diagnostic::default()
    }
}

/// Signatures, the first one whose parameters reach as far as the cursor being the active one.
pub fn signatures(found: &[Signature]) -> Value {
    let Some(first) = found.first() else { return Value::Null };
    let units = |signature: &Signature, byte: usize| signature.label[..byte].encode_utf16().count();
    let one = |signature: &Signature| {
        let param = |(range, docs): &(std::ops::Range<usize>, String)| json!({ "label": [units(signature, range.start), units(signature, range.end)], "documentation": docs });
        let params: Vec<Value> = signature.params.iter().map(param).collect();
        json!({ "label": signature.label, "documentation": markdown(&signature.docs), "parameters": params })
    };
    let active = found.iter().position(|signature| signature.params.len() > signature.active).unwrap_or(0);
    let signatures: Vec<Value> = found.iter().map(one).collect();
    json!({ "signatures": signatures, "activeSignature": active, "activeParameter": first.active })
}

/// Tinted names as the protocol packs them: steps of lines and columns, lengths, numbers of types, bits of modifiers.
pub fn tokens(tints: &[Tinted], lines: &Lines) -> Vec<u32> {
    let (mut line, mut column, mut data) = (0, 0, Vec::with_capacity(tints.len() * 5));
    for tinted in tints {
        let range = lines.range(&tinted.range);
        let start = range.start;
        let step = if start.line == line { start.character - column } else { start.character };
        let number = TINTS.iter().position(|tint| *tint == tinted.tint).unwrap_or(0) as u32;
        let bits = u32::from(tinted.is_definition) | u32::from(tinted.is_built_in) << 1;
        data.extend([start.line - line, step, range.end.character - start.character, number, bits]);
        (line, column) = (start.line, start.character);
    }
    data
}

impl Shown for Completion {
    fn shown(&self, lines: &Lines) -> Value {
        let order = order(self.kind);
        json!({
            "label": self.label,
            "kind": item_kind(self.kind),
            "detail": self.detail,
            "documentation": markdown(&self.docs),
            "sortText": format!("{order}{}", self.label),
            "filterText": self.label,
            "insertTextFormat": InsertTextFormat::SNIPPET,
            "textEdit": { "range": lines.range(&self.replaces), "newText": self.insert },
        })
    }
}

impl Shown for Symbol {
    fn shown(&self, lines: &Lines) -> Value {
        let kind = match self.sort {
            Sort::Rule => SymbolKind::CLASS,
            Sort::Attribute => SymbolKind::PROPERTY,
            Sort::Constant => SymbolKind::CONSTANT,
            Sort::Function => SymbolKind::FUNCTION,
            Sort::Import => SymbolKind::MODULE,
            Sort::Style => SymbolKind::NAMESPACE,
        };
        let inside: Vec<Value> = self.inside.iter().map(|symbol| symbol.shown(lines)).collect();
        json!({
            "name": self.name, "detail": self.detail, "kind": kind, "range": lines.range(&self.whole),
            "selectionRange": lines.range(&self.at), "children": inside,
        })
    }
}

impl Shown for Fold {
    fn shown(&self, lines: &Lines) -> Value {
        let range = lines.range(&self.range);
        let kind = if self.is_comment { "comment" } else { "region" };
        json!({ "startLine": range.start.line, "endLine": range.end.line, "kind": kind })
    }
}

impl Shown for Swatch {
    fn shown(&self, lines: &Lines) -> Value {
        let [red, green, blue, alpha] = self.color;
        json!({
            "range": lines.range(&self.range),
            "color": { "red": red, "green": green, "blue": blue, "alpha": alpha },
        })
    }
}

fn markdown(text: &str) -> Value {
    if text.is_empty() { Value::Null } else { json!({ "kind": "markdown", "value": text }) }
}

/// What comes first in a list: what the place itself asks for, then the file's own, then the language's.
fn order(kind: CompletionKind) -> u8 {
    match kind {
        CompletionKind::Argument | CompletionKind::Word | CompletionKind::File | CompletionKind::Annotation => 1,
        CompletionKind::Param => 2,
        CompletionKind::Rule => 3,
        CompletionKind::Operation => 4,
        CompletionKind::Attribute | CompletionKind::Function => 5,
        CompletionKind::Element => 6,
        CompletionKind::Keyword => 7,
    }
}

fn item_kind(kind: CompletionKind) -> CompletionItemKind {
    match kind {
        CompletionKind::Operation => CompletionItemKind::METHOD,
        CompletionKind::Function => CompletionItemKind::FUNCTION,
        CompletionKind::Attribute => CompletionItemKind::PROPERTY,
        CompletionKind::Rule => CompletionItemKind::CLASS,
        CompletionKind::Param => CompletionItemKind::VARIABLE,
        CompletionKind::Argument => CompletionItemKind::FIELD,
        CompletionKind::Word => CompletionItemKind::ENUM_MEMBER,
        CompletionKind::Annotation => CompletionItemKind::EVENT,
        CompletionKind::Keyword => CompletionItemKind::KEYWORD,
        CompletionKind::File => CompletionItemKind::FILE,
        CompletionKind::Element => CompletionItemKind::CONSTANT,
    }
}

fn token_type(tint: Tint) -> SemanticTokenType {
    match tint {
        Tint::Operation => SemanticTokenType::METHOD,
        Tint::Rule => SemanticTokenType::CLASS,
        Tint::Function => SemanticTokenType::FUNCTION,
        Tint::Attribute => SemanticTokenType::PROPERTY,
        Tint::Param => SemanticTokenType::PARAMETER,
        Tint::Import => SemanticTokenType::NAMESPACE,
        Tint::Annotation => SemanticTokenType::DECORATOR,
        Tint::Word => SemanticTokenType::ENUM_MEMBER,
        Tint::Style => SemanticTokenType::TYPE,
    }
}
