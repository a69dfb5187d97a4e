//! Chance: from the shape's own stream, so the same shape draws the same numbers.

use crate::functions::Function;
use crate::functions::args::number;
use crate::value::Value;

pub(super) static LIST: &[Function] = &[
    Function::new(
        "rand",
        "() | (max) | (min, max)",
        (0, 2),
        "A number in [0, 1), [0, max) or [min, max).",
        |args, around| {
            let (from, to) = match args {
                [] => (0.0, 1.0),
                [_] => (0.0, number(args, 0)?),
                _ => (number(args, 0)?, number(args, 1)?),
            };
            Ok(Value::Float(around.random.uniform(from, to)))
        },
    ),
    Function::new("p", "(probability)", (1, 1), "True with the given probability, 0 to 1.", |args, around| {
        Ok(Value::Bool(around.random.unit() < number(args, 0)?))
    })
    .truth(),
];
