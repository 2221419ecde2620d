//! What is allocated while points are made in bulk: lists of a dispatch, and nothing that grows with
//! a chunk.

mod support;

use corput::bulk::Reference;
use corput::catalog::{Engine, Options, Request, Sequence};
use corput::kernels::Generator;
use std::alloc::{GlobalAlloc, Layout, System};
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Counts what Rust allocates.
struct Counting;

static BYTES: AtomicUsize = AtomicUsize::new(0);
static LARGEST: AtomicUsize = AtomicUsize::new(0);

// SAFETY: the system's allocator does the work, with the same arguments.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        BYTES.fetch_add(layout.size(), Ordering::Relaxed);
        LARGEST.fetch_max(layout.size(), Ordering::Relaxed);
        // SAFETY: the caller's promises are passed on.
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        // SAFETY: the same.
        unsafe { System.dealloc(pointer, layout) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

/// One test counts at a time.
static TURN: Mutex<()> = Mutex::new(());

/// Bytes that work allocates in all, and in one piece at most.
fn counted(work: impl FnOnce()) -> [usize; 2] {
    BYTES.store(0, Ordering::SeqCst);
    LARGEST.store(0, Ordering::SeqCst);
    work();
    [&BYTES, &LARGEST].map(|count| count.load(Ordering::SeqCst))
}

/// Words of a chunk.
const WORDS: usize = 1 << 21;

/// Bytes that a chunk may take: a two-thousandth of its own.
const MOST: usize = 4 * WORDS / 2048;

fn request() -> Request {
    Request::new(&Options {
        dimensions: Some(2),
        ..Options::new(Sequence::Halton, 4 * WORDS as u64)
    })
    .expect("a request")
}

/// Chunk after chunk into one slice, after a first that makes what is kept.
fn chunks(engine: &mut dyn Engine, words: &mut [u32], count: u64) -> [usize; 2] {
    let points = words.len() as u64 / 2;
    engine.fill(0, words).expect("points");
    counted(|| {
        for chunk in 1..=count {
            engine.fill(chunk * points, words).expect("points");
        }
    })
}

#[test]
fn chunks_of_a_device_allocate_lists_alone() {
    let _turn = TURN.lock().expect("no panic");
    support::on_each_device(|device| {
        let mut words = vec![0; WORDS];
        let mut generator = Generator::new(device, &request()).expect("a generator");
        let [bytes, largest] = chunks(&mut generator, &mut words, 6);
        println!(
            "{}: {bytes} bytes in 6 chunks, {largest} at most",
            device.info().name
        );
        assert!(bytes < 6 * MOST && largest < MOST, "{bytes}, {largest}");
    });
}

#[test]
fn chunks_of_the_cpu_allocate_lists_alone() {
    let _turn = TURN.lock().expect("no panic");
    let mut words = vec![0; WORDS];
    let mut reference = Reference::new(&request());
    let [bytes, largest] = chunks(&mut reference, &mut words, 6);
    println!("{bytes} bytes in 6 chunks, {largest} at most");
    assert!(bytes < 6 * MOST && largest < MOST, "{bytes}, {largest}");
}

/// The count sees memory of a chunk's size.
#[test]
fn memory_of_a_chunk_is_seen() {
    let _turn = TURN.lock().expect("no panic");
    let [bytes, largest] = counted(|| drop(std::hint::black_box(vec![1u32; WORDS])));
    assert!(bytes >= 4 * WORDS && largest >= 4 * WORDS);
}
