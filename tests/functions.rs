//! What rules rely on in the functions: lists, arrays, texts, colours, patterns and tables lose nothing on the way.

use bosquet::files::Table;
use bosquet::functions::{all, find, folded};
use bosquet::pattern::{Regex, glob};
use bosquet::value::{Array, Cells, Value};
use proptest::prelude::*;
use std::sync::Arc;

fn call(name: &str, args: &[Value]) -> Value {
    folded(find(name).expect("a function"), args).unwrap_or_else(|| panic!("{name} of {args:?} has no value"))
}

fn texts(values: &[String]) -> Value {
    Value::Array(Array::row(Cells::Texts(values.iter().map(|text| text.as_str().into()).collect())).into())
}

fn numbers(columns: usize, values: &[f64]) -> Value {
    Value::Array(Array::new(columns, Cells::Numbers(values.to_vec())).expect("whole rows").into())
}

fn number(value: &Value) -> f64 {
    value.as_float().expect("a number")
}

fn indices(value: &Value) -> Vec<usize> {
    match value.as_array().map(|array| array.cells()) {
        Some(Cells::Numbers(numbers)) => numbers.iter().map(|n| *n as usize).collect(),
        _ => panic!("{value} is no row of indices"),
    }
}

fn anything() -> impl Strategy<Value = Value> {
    let number = prop_oneof![any::<f64>(), -3.0..9.0, Just(f64::NAN), Just(f64::INFINITY), Just(-1e300)];
    let text = prop_oneof!["[a-c;*?$(){}.#é]{0,8}", "#[0-9a-f]{6,8}", Just("\u{e000}".to_string())];
    let row = proptest::collection::vec(number.clone(), 0..7);
    prop_oneof![
        number.prop_map(Value::Float),
        any::<bool>().prop_map(Value::Bool),
        text.clone().prop_map(Value::text),
        row.prop_map(|row| numbers(row.len(), &row)),
        proptest::collection::vec(any::<bool>(), 0..7)
            .prop_map(|row| Value::Array(Array::row(Cells::Truths(row)).into())),
        proptest::collection::vec(text, 0..7).prop_map(|row| texts(&row)),
    ]
}

proptest! {
    #[test]
    fn lists_and_arrays_are_the_same(items in proptest::collection::vec("[^;]{0,5}", 0..9)) {
        let list = call("listFromArray", &[texts(&items)]);
        prop_assert_eq!(call("listToArray", std::slice::from_ref(&list)), texts(&items));
        prop_assert_eq!(number(&call("listSize", &[list])), items.len() as f64);
    }

    #[test]
    fn parts_of_a_list_make_the_list(items in proptest::collection::vec("[a-c]{0,2}", 0..9), at in 0usize..9, word in "\\*?[a-c]{0,2}\\*?") {
        let list = call("listFromArray", &[texts(&items)]);
        let range = |from: usize, to: usize| {
            call("listRange", &[list.clone(), Value::Float(from as f64), Value::Float(to as f64)]).to_string()
        };
        prop_assert_eq!(range(0, at) + &range(at, 9), list.to_string());
        let size = |list: Value| number(&call("listSize", &[list]));
        let word = Value::text(word);
        let kept = size(call("listRetainAll", &[list.clone(), word.clone()]));
        let left = size(call("listRemoveAll", &[list.clone(), word.clone()]));
        prop_assert_eq!(kept + left, items.len() as f64);
        prop_assert_eq!(number(&call("listCount", &[list.clone(), word.clone()])), kept);
        prop_assert_eq!(number(&call("listIndex", &[list, word])) >= 0.0, kept > 0.0);
    }

    #[test]
    fn texts_split_and_join(text in "[ab,é]{0,20}", delimiter in "[,a]{1,2}") {
        let parts = call("splitString", &[Value::text(text.as_str()), Value::text(delimiter.as_str())]);
        let Some(Cells::Texts(parts)) = parts.as_array().map(|array| array.cells()) else { panic!("texts") };
        prop_assert_eq!(parts.join(&delimiter), text.clone());
        let by_expression = Regex::new(&delimiter).unwrap();
        let parts: Vec<&str> = parts.iter().map(Arc::as_ref).collect();
        prop_assert_eq!(by_expression.split(&text), parts);
    }

    #[test]
    fn wildcards_are_small_regular_expressions(pattern in "[ab*?é]{0,8}", text in "[abé]{0,12}") {
        let expression = pattern.replace('*', ".*").replace('?', ".");
        prop_assert_eq!(glob(&pattern, &text), Regex::new(&expression).unwrap().fits(&text));
    }

    #[test]
    fn sorted_indices_are_all_and_in_order(values in proptest::collection::vec(prop_oneof![-3.0..3.0, Just(1.0), Just(f64::NAN)], 0..20)) {
        let order = indices(&call("sortIndices", &[numbers(values.len(), &values)]));
        let mut all = order.clone();
        all.sort_unstable();
        prop_assert_eq!(all, (0..values.len()).collect::<Vec<_>>());
        for pair in order.windows(2) {
            let (a, b) = (values[pair[0]], values[pair[1]]);
            prop_assert!(a < b || b.is_nan() || (a == b && pair[0] < pair[1]), "{a} before {b}");
        }
    }

    #[test]
    fn turning_twice_changes_nothing(columns in 1usize..5, rows in 0usize..5) {
        let cells: Vec<f64> = (0..columns * rows).map(|n| n as f64).collect();
        let array = numbers(columns, &cells);
        let turned = call("transpose", std::slice::from_ref(&array));
        if rows > 0 {
            prop_assert_eq!(number(&call("nRows", std::slice::from_ref(&turned))), columns as f64);
            prop_assert_eq!(call("transpose", &[turned]), array);
        }
    }

    #[test]
    fn colours_come_back_as_they_went(r: u8, g: u8, b: u8, o: u8) {
        let colour = Value::text(format!("#{r:02X}{g:02X}{b:02X}{o:02X}"));
        let part = |name: &str| call(&format!("colorHexTo{name}"), std::slice::from_ref(&colour));
        prop_assert_eq!(call("colorRGBOToHex", &["R", "G", "B", "O"].map(part)), colour.clone());
        prop_assert_eq!(call("colorHSVOToHex", &["H", "S", "V", "O"].map(part)), colour.clone());
    }

    #[test]
    fn tables_come_back_as_they_were_written(
        rows in proptest::collection::vec(proptest::collection::vec("[ab \",;\n1]{0,6}", 3), 1..6),
        delimiter in prop_oneof![Just(';'), Just(','), Just('\t')],
    ) {
        let quoted = |cell: &String| format!("\"{}\"", cell.replace('"', "\"\""));
        let line = |row: &Vec<String>| row.iter().map(quoted).collect::<Vec<_>>().join(&delimiter.to_string());
        let text = rows.iter().map(line).collect::<Vec<_>>().join("\r\n");
        let table = Table::read(&text).unwrap();
        prop_assert_eq!((table.strings.rows(), table.strings.columns()), (rows.len(), 3));
        let cells = rows.concat();
        prop_assert_eq!(Value::Array(table.strings), Value::Array(Arc::new(Array::new(3, Cells::Texts(
            cells.iter().map(|cell| cell.as_str().into()).collect())).unwrap())));
    }

    #[test]
    fn no_arguments_panic(args in proptest::collection::vec(anything(), 0..5)) {
        for function in all() {
            folded(function, &args);
        }
    }
}
