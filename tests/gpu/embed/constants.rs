//! Stock modules that an engine strips by specialization constants alone: with what their
//! `constants.json` says and nothing else they make the reference's words.

use crate::support::{on_each_device, words};
use corput::bulk::Reference;
use corput::catalog::{Engine, Options, Request, Sampler};
use corput::modules::{File, Target, all, of_points};
use corput::report::hexadecimal;
use corput::vulkan::{Access, Buffer, Device, Pipeline, PipelineDescription};
use serde_json::Value;
use sha2::{Digest, Sha256};
use std::collections::BTreeSet;
use std::sync::Arc;

fn request(sampler: &str, dimensions: u64, count: u64) -> (Sampler, Request) {
    request_from(0, sampler, dimensions, count)
}

fn request_from(first: u64, sampler: &str, dimensions: u64, count: u64) -> (Sampler, Request) {
    let sampler = Sampler::parse(sampler).unwrap();
    let request = Request::new(&Options {
        first,
        dimensions: Some(dimensions),
        scramble: sampler.scramble(),
        seed: sampler.is_random().then_some(7),
        ..Options::new(sampler.sequence(), count)
    });
    (sampler, request.unwrap())
}

fn bytes<'a>(files: &'a [File], name: &str) -> &'a [u8] {
    let found = files.iter().find(|file| file.name == name);
    &found.unwrap_or_else(|| panic!("no {name}")).bytes
}

fn number(value: &Value) -> u64 {
    value.as_u64().unwrap_or_else(|| panic!("{value}"))
}

fn list(value: &Value) -> &Vec<Value> {
    value.as_array().unwrap_or_else(|| panic!("{value}"))
}

/// What an engine does: a pipeline and a dispatch for each entry of the document. `change` gets
/// each constant first.
fn made(device: &Arc<Device>, files: &[File], change: &dyn Fn(&Value) -> (u32, u32)) -> Vec<u32> {
    let document: Value = serde_json::from_slice(bytes(files, "constants.json")).unwrap();
    let module = &document["module"];
    let spirv = words(bytes(files, module["file"].as_str().unwrap()));
    let size = number(&document["result_bytes"]);
    let mut results = Buffer::new(device, size, Access::Readback).unwrap();
    let table = document["table"]["file"].as_str().map(|name| {
        let bytes = bytes(files, name);
        let mut table = Buffer::new(device, bytes.len() as u64, Access::Upload).unwrap();
        table.write(0, bytes).unwrap();
        table
    });
    let numbers = list(&module["bindings"]).iter();
    let bindings: Vec<u32> = numbers.map(|one| number(&one["binding"]) as u32).collect();
    let mut buffers = vec![(0, &results)];
    buffers.extend(table.iter().map(|table| (1, table)));
    for dispatch in list(&document["dispatches"]) {
        let constants: Vec<(u32, u32)> = list(&dispatch["constants"]).iter().map(change).collect();
        let description = PipelineDescription {
            name: "stock",
            spirv: &spirv,
            bindings: &bindings,
            push_constant_bytes: 4 * list(&module["push_constants"]).len() as u32,
            specialization: &constants,
        };
        let pipeline = Pipeline::new(device, &description).unwrap();
        let push: Vec<u8> = list(&module["push_constants"])
            .iter()
            .flat_map(|member| {
                match member["name"].as_str().unwrap() {
                    "first" => number(&document["points"]["first"]) as u32,
                    "invocations" => number(&dispatch["invocations"]) as u32,
                    "stride" => 1,
                    other => panic!("{other}"),
                }
                .to_ne_bytes()
            })
            .collect();
        let groups = number(&dispatch["groups"]);
        device.run(&pipeline, &buffers, &push, groups).unwrap();
    }
    let points = &document["points"];
    let kept = 4 * number(&points["count"]) * number(&points["dimensions"]);
    results.read(0, kept, words).unwrap()
}

fn as_they_are(constant: &Value) -> (u32, u32) {
    (
        number(&constant["id"]) as u32,
        number(&constant["value"]) as u32,
    )
}

fn reference(request: &Request) -> Vec<u32> {
    let mut words = vec![0; request.count as usize * request.columns.len()];
    Reference::new(request).fill(0, &mut words).unwrap();
    words
}

#[test]
fn more_words_than_a_module_counts_are_refused() {
    let (sampler, request) = request("halton", 5, 1 << 32);
    let refused = of_points(sampler, &request, Target::default());
    assert_eq!(refused.map_err(|error| error.exit_code()).err(), Some(2));
}

#[test]
fn stock_modules_make_points_by_constants_alone() {
    let (few, many) = ((1 << 8) + 3, (1 << 16) + 3);
    let cases = [
        ("sobol", 2, many),
        ("sobol:owen-hash", 3, many),
        ("halton", 2, many),
        ("halton:permute", 2, many),
        ("halton", 5, few),
        ("sobol:owen", 7, few),
        ("vdc", 1, many),
        ("random", 4, many),
        ("r2", 2, many),
        ("pmj02", 2, few),
        ("latin-hypercube", 2, few),
    ];
    on_each_device(|device| {
        let mut kernels = BTreeSet::new();
        let int64 = device.has_int64();
        for (name, dimensions, count) in cases {
            let (sampler, request) = request(name, dimensions, count);
            let want = reference(&request);
            for cpu in [false, true] {
                let files = of_points(sampler, &request, Target { cpu, int64 }).unwrap();
                let got = made(device, &files, &as_they_are);
                assert!(got == want, "{name}, {dimensions} dimensions, cpu: {cpu}");
                kernels.insert(files[0].name.clone());
            }
        }
        println!("{kernels:?}");
        assert!(kernels.len() > 4);
    });
}

/// As many points as take 64-bit integers, on the device that makes them in a moment.
#[test]
fn modules_of_wide_integers_do_too() {
    on_each_device(|device| {
        if !device.has_int64() || !device.info().name.contains("llvmpipe") {
            println!("not tried: {} is slow, or has none", device.info().name);
            return;
        }
        for first in [0, 1 << 31] {
            let (sampler, request) = request_from(first, "sobol", 2, 1 << 23);
            let target = Target {
                cpu: true,
                int64: true,
            };
            let files = of_points(sampler, &request, target).unwrap();
            let document: Value = serde_json::from_slice(bytes(&files, "constants.json")).unwrap();
            let capabilities = list(&document["module"]["capabilities"]);
            assert!(capabilities.iter().any(|one| one == "Int64"), "{document}");
            assert!(
                request
                    .first
                    .is_multiple_of(number(&document["first_multiple"]))
            );
            assert!(
                made(device, &files, &as_they_are) == reference(&request),
                "from {first} on"
            );
        }
    });
}

/// A constant that is another shows. (Without any, invocations make more points than the buffer has
/// room for.)
#[test]
fn other_constants_make_other_points() {
    on_each_device(|device| {
        let (sampler, request) = request("halton", 2, (1 << 16) + 3);
        let files = of_points(sampler, &request, Target::default()).unwrap();
        let want = reference(&request);
        for name in ["OUTPUT", "COLUMN1_BASE", "COLUMN1_GROUP_POWER"] {
            let found = std::cell::Cell::new(false);
            let other = made(device, &files, &|constant| {
                let (id, value) = as_they_are(constant);
                let is_it = constant["name"].as_str() == Some(name);
                found.set(found.get() || is_it);
                (id, if is_it { value ^ 1 } else { value })
            });
            assert!(found.get(), "{name}");
            assert!(other != want, "another {name}");
        }
    });
}

/// Every stock module has its file, its hash and the names of all that it takes.
#[test]
fn every_stock_module_is_described() {
    let files = all().unwrap();
    let document: Value = serde_json::from_slice(bytes(&files, "modules.json")).unwrap();
    let modules = list(&document["modules"]);
    assert_eq!(modules.len() + 1, files.len());
    assert_eq!(modules.len(), corput::interface::KERNELS.len());
    for module in modules {
        let spirv = bytes(&files, module["file"].as_str().unwrap());
        assert_eq!(spirv.len() as u64, number(&module["bytes"]));
        assert_eq!(module["sha256"], hexadecimal(&Sha256::digest(spirv)));
        let facts = corput::spirv::describe(&words(spirv)).unwrap();
        let ids = |value: &Value| number(&value["id"]) as u32;
        let named: BTreeSet<u32> = list(&module["constants"]).iter().map(ids).collect();
        // What a module does not use the compiler may have left out.
        assert!(
            facts.spec_ids.iter().all(|id| named.contains(id)),
            "{module}"
        );
    }
}
