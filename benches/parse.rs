//! Rule text to syntax tree: megabytes per second on a file that the bench writes.
//!
//! ```text
//! cargo bench --bench parse
//! ```

#[path = "common/gardens.rs"]
mod gardens;

use bosquet::syntax::parse;
use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use std::hint::black_box;

fn parsing(criterion: &mut Criterion) {
    let source = gardens::source();
    let (tree, found) = parse(0, &source);
    assert!(found.is_empty(), "{:?}", found.first());
    assert!(tree.items.len() > 1000);
    let mut group = criterion.benchmark_group("parse");
    group.throughput(Throughput::Bytes(gardens::BYTES as u64)).sample_size(20);
    group.bench_function("gardens", |bencher| bencher.iter_with_large_drop(|| parse(0, black_box(&source))));
    group.finish();
}

criterion_group!(benches, parsing);
criterion_main!(benches);
