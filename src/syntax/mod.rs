//! Rule text → syntax tree: [`parse`] never fails; what is broken is reported and left out.

pub mod ast;
