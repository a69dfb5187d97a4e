//! What helps to follow a derivation: `print` within expressions, and where in the tree a shape stands.

use crate::functions::args::any;
use crate::functions::{Function, Gives};
use crate::value::Value;

pub(super) static LIST: &[Function] = &[
    Function::new(
        "print",
        "(value)",
        (1, 1),
        "The value itself, which is also shown after the run.",
        |args, around| {
            let value = any(args, 0)?.clone();
            around.told.borrow_mut().push(value.clone());
            Ok(value)
        },
    )
    .gives(Gives::Same),
    Function::new(
        "getTreeKey",
        "()",
        (0, 0),
        "The path to the shape in the tree, as a list: `0;2;1;` is the second child of the third child of the lot. The \
         same for a whole rule. Cost: linear in the shapes so far.",
        |_, around| Ok(Value::text((around.tree_key)())),
    )
    .text(),
];
