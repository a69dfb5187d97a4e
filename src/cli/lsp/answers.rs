//! Requests and their answers: each asks the desk and says in the protocol's words what it was told.

use crate::cli::lsp::convert::{self, Shown};
use crate::cli::lsp::lines::Lines;
use crate::cli::lsp::{Server, error, read, uri};
use bosquet::element::Catalogue;
use bosquet::ide::{Desk, Pictures, Place};
use lsp_server::{ErrorCode, Request, ResponseError};
use lsp_types::{
    ColorPresentationParams, DocumentColorParams, DocumentSymbolParams, FoldingRangeParams, Location, Position,
    ReferenceParams, RenameParams, SemanticTokensParams, TextDocumentPositionParams, TextEdit, Uri,
};
use serde::Serialize;
use serde_json::{Value, json};
use std::collections::BTreeMap;

type Answer = Result<Value, ResponseError>;

impl Server {
    /// The answer to a request; `null` where there is nothing to say.
    pub(super) fn answer(&self, request: Request, catalogue: &Catalogue) -> Answer {
        let files = self.texts.files();
        let address = self.pictures.as_deref().map(uri::address);
        let pictures = self.pictures.as_deref().zip(address.as_deref());
        let pictures = pictures.map(|(folder, address)| Pictures { folder, address });
        let desk = Desk::new(&self.texts, catalogue).with_files(&files).with_pictures(pictures);
        let at = Asked { server: self, desk: &desk };
        let params = request.params;
        match request.method.as_str() {
            "textDocument/hover" => at.hover(&read(params)?),
            "textDocument/completion" => at.completion(&read(params)?),
            "textDocument/signatureHelp" => at.signature(&read(params)?),
            "textDocument/definition" => at.definition(&read(params)?),
            "textDocument/references" => at.references(&read(params)?),
            "textDocument/prepareRename" => at.renamable(&read(params)?),
            "textDocument/rename" => at.rename(&read(params)?),
            "textDocument/documentSymbol" => at.symbols(&read(params)?),
            "textDocument/foldingRange" => at.folds(&read(params)?),
            "textDocument/formatting" => at.formatting(&read(params)?),
            "textDocument/documentColor" => at.colors(&read(params)?),
            "textDocument/colorPresentation" => at.presentation(&read(params)?),
            "textDocument/semanticTokens/full" => at.tokens(&read(params)?),
            other => Err(error(ErrorCode::MethodNotFound, &format!("there is no method `{other}`"))),
        }
    }
}

/// A request under way.
struct Asked<'a> {
    server: &'a Server,
    desk: &'a Desk<'a>,
}

impl Asked<'_> {
    /// The path of a URI, and the byte of a position in it.
    fn place(&self, uri: &Uri, position: Position) -> (String, usize) {
        let path = uri::path(uri);
        let offset = self.with_lines(&path, |lines| lines.offset(position)).unwrap_or(0);
        (path, offset)
    }

    fn at(&self, params: &TextDocumentPositionParams) -> (String, usize) {
        self.place(&params.text_document.uri, params.position)
    }

    fn with_lines<T>(&self, path: &str, then: impl FnOnce(&Lines) -> T) -> Option<T> {
        let document = self.desk.document(path)?;
        Some(then(&Lines::of(document.text())))
    }

    /// What is told about a file, with its lines.
    fn shown<T: Shown>(&self, path: &str, found: &[T]) -> Answer {
        let shown = self.with_lines(path, |lines| found.iter().map(|one| one.shown(lines)).collect::<Vec<Value>>());
        Ok(json!(shown.unwrap_or_default()))
    }

    fn location(&self, place: &Place) -> Option<Location> {
        let range = self.with_lines(&place.path, |lines| lines.range(&(place.start..place.end)))?;
        Some(Location { uri: self.server.texts.uri(&place.path)?, range })
    }

    fn locations(&self, places: &[Place]) -> Answer {
        written(places.iter().filter_map(|place| self.location(place)).collect::<Vec<_>>())
    }

    fn hover(&self, params: &TextDocumentPositionParams) -> Answer {
        let (path, offset) = self.at(params);
        let Some(hover) = self.desk.hover(&path, offset) else { return Ok(Value::Null) };
        let range = self.with_lines(&path, |lines| lines.range(&(hover.place.start..hover.place.end)));
        Ok(json!({ "contents": { "kind": "markdown", "value": hover.text }, "range": range }))
    }

    fn completion(&self, params: &TextDocumentPositionParams) -> Answer {
        let (path, offset) = self.at(params);
        self.shown(&path, &self.desk.completions(&path, offset))
    }

    fn signature(&self, params: &TextDocumentPositionParams) -> Answer {
        let (path, offset) = self.at(params);
        Ok(convert::signatures(&self.desk.signatures(&path, offset)))
    }

    fn definition(&self, params: &TextDocumentPositionParams) -> Answer {
        let (path, offset) = self.at(params);
        self.locations(&self.desk.definition(&path, offset))
    }

    fn references(&self, params: &ReferenceParams) -> Answer {
        let (path, offset) = self.at(&params.text_document_position);
        let mut found = self.desk.references(&path, offset);
        if !params.context.include_declaration {
            let declared = self.desk.definition(&path, offset);
            found.retain(|place| !declared.contains(place));
        }
        self.locations(&found)
    }

    fn renamable(&self, params: &TextDocumentPositionParams) -> Answer {
        let (path, offset) = self.at(params);
        let found = self.desk.renamable(&path, offset).map_err(|refusal| refused(&refusal))?;
        let range = self.with_lines(&path, |lines| lines.range(&(found.place.start..found.place.end)));
        Ok(json!({ "range": range, "placeholder": found.name }))
    }

    fn rename(&self, params: &RenameParams) -> Answer {
        let (path, offset) = self.at(&params.text_document_position);
        let places = self.desk.rename(&path, offset, &params.new_name).map_err(|refusal| refused(&refusal))?;
        let mut changes: BTreeMap<String, Vec<TextEdit>> = BTreeMap::new();
        for Location { uri, range } in places.iter().filter_map(|place| self.location(place)) {
            let edits = changes.entry(uri.as_str().to_string()).or_default();
            edits.push(TextEdit { range, new_text: params.new_name.clone() });
        }
        Ok(json!({ "changes": changes }))
    }

    fn symbols(&self, params: &DocumentSymbolParams) -> Answer {
        let path = uri::path(&params.text_document.uri);
        self.shown(&path, &self.desk.symbols(&path))
    }

    fn folds(&self, params: &FoldingRangeParams) -> Answer {
        let path = uri::path(&params.text_document.uri);
        self.shown(&path, &self.desk.folds(&path))
    }

    /// One edit of everything; `null` for a broken file, whose mistakes are told already.
    fn formatting(&self, params: &DocumentSymbolParams) -> Answer {
        let path = uri::path(&params.text_document.uri);
        let Some(document) = self.desk.document(&path) else { return Ok(Value::Null) };
        let Some(new) = self.desk.laid_out(&path) else { return Ok(Value::Null) };
        let (old, lines) = (document.text(), Lines::of(document.text()));
        let edit = json!({ "range": lines.range(&(0..old.len())), "newText": new });
        Ok(if new == old { json!([]) } else { json!([edit]) })
    }

    fn colors(&self, params: &DocumentColorParams) -> Answer {
        let path = uri::path(&params.text_document.uri);
        self.shown(&path, &self.desk.swatches(&path))
    }

    fn presentation(&self, params: &ColorPresentationParams) -> Answer {
        let path = uri::path(&params.text_document.uri);
        let bytes = self.with_lines(&path, |lines| lines.bytes(params.range)).unwrap_or_default();
        let color = [params.color.red, params.color.green, params.color.blue, params.color.alpha];
        let text = self.desk.color_written(&path, bytes, color);
        Ok(json!(text.into_iter().map(|text| json!({ "label": text })).collect::<Vec<_>>()))
    }

    fn tokens(&self, params: &SemanticTokensParams) -> Answer {
        let path = uri::path(&params.text_document.uri);
        let tints = self.desk.tints(&path);
        let data = self.with_lines(&path, |lines| convert::tokens(&tints, lines)).unwrap_or_default();
        Ok(json!({ "data": data }))
    }
}

fn refused(refusal: &bosquet::ide::Refusal) -> ResponseError {
    error(ErrorCode::RequestFailed, &refusal.to_string())
}

fn written(value: impl Serialize) -> Answer {
    serde_json::to_value(value).map_err(|e| error(ErrorCode::InternalError, &e.to_string()))
}
