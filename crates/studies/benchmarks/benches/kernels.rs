//! Every kernel whose instructions `instructions` counts, timed: block by block, fidelity by fidelity, and what stands before.

#![allow(missing_docs)]

use benchmarks::KERNELS;
use criterion::{Criterion, Throughput, criterion_group, criterion_main};

fn kernels(c: &mut Criterion) {
    for kernel in KERNELS {
        let mut work = kernel.ready(None);
        let (of, how) = kernel.name.split_once('/').expect("what it is of, then how");
        let mut group = c.benchmark_group(of);
        group.throughput(Throughput::Elements(work.elements)).sample_size(20);
        group.bench_function(how, |b| b.iter(&mut work.run));
    }
}

criterion_group!(benches, kernels);
criterion_main!(benches);
