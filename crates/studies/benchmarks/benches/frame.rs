//! Whole frames: the machine in both scalar types on one and two threads, and `exact`.

#![allow(missing_docs)]

use machine::Prepare;
use std::hint::black_box;

use benchmarks::{Choice, TimedScene};
use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use exact::Exact;
use generator::Generator;
use scenario::Scalar;
use signal::Probe;

/// One whole frame of the README's scene, 1000 sweeps x 1000 samples, to finished planes.
fn whole_frame(c: &mut Criterion) {
    let mut group = c.benchmark_group("whole frame");
    group.sample_size(20);
    for (name, scalar) in [("f32", Scalar::F32), ("f64", Scalar::F64)] {
        for threads in [1, 2] {
            let scene =
                TimedScene::shipped("first-light", &Choice { scalar: Some(scalar), ..Choice::default() });
            let (mut planes, pose) = (scene.planes(), scene.pose);
            group.throughput(Throughput::Elements(scene.samples()));
            let session = scene.stage.prepare();
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
            group.bench_function(BenchmarkId::new(name, format!("{threads} threads")), |b| {
                pool.install(|| {
                    b.iter(|| black_box(session.frame(0, &pose, &mut planes, &mut Probe::off())));
                });
            });
        }
    }
    group.finish();
}

/// The same frame by closed form and root finding.
fn exact_frame(c: &mut Criterion) {
    let scene =
        TimedScene::shipped("first-light", &Choice { scalar: Some(Scalar::F64), ..Choice::default() });
    let (mut planes, pose) = (scene.planes(), scene.pose);
    let session = Exact.prepare(scene.stage.stage()).expect("exact draws terrain");
    let mut group = c.benchmark_group("exact frame");
    group.sample_size(10);
    group.bench_function("all threads", |b| {
        b.iter(|| black_box(session.frame(0, &pose, &mut planes, &mut Probe::off())));
    });
    group.finish();
}

criterion_group!(benches, whole_frame, exact_frame);
criterion_main!(benches);
