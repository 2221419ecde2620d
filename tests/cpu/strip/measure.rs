//! What is counted of a module, against a count by hand and against the stock kernels' rows.

use corput::interface::KERNELS;
use corput::spirv::{Module, prune};
use corput::strip::{Measure, measure};

const HEAD: &str = "#version 450\nlayout(local_size_x = 1) in;\n\
                    layout(set = 1, binding = 2) buffer Words { uint words[]; };\n";

fn of(body: &str) -> Measure {
    let text = format!("{HEAD}{body}");
    let words = corput::compile::to_spirv(&text, &[], &mut |_| None).expect("a shader");
    measure(&words).expect("a module")
}

#[test]
fn tables_count_once() {
    let plain = of("void main() { words[0] = 1u; }\n");
    assert_eq!((plain.functions, plain.table_bytes), (1, 0));
    assert_eq!((plain.resources, plain.specialization), (vec![(1, 2)], 0));
    let tabled = of(
        "const uvec2 A[3] = uvec2[3](uvec2(1u), uvec2(2u, 5u), uvec2(3u));\n\
         const float B[2][2] = float[2][2](float[2](1.0, 2.0), float[2](1.5, 2.0));\n\
         layout(constant_id = 7) const uint C = 5u;\n\
         uint f(uint i) { return A[i].y + uint(B[i][1]) + A[i + 1u].x; }\n\
         void main() { words[0] = f(words[1]) + C; }\n",
    );
    assert_eq!((tabled.functions, tabled.table_bytes), (2, 24 + 16));
    assert_eq!(tabled.specialization, 1);
    let one_more = of(
        "const uvec2 A[4] = uvec2[4](uvec2(1u), uvec2(2u), uvec2(3u), uvec2(4u));\n\
                       void main() { words[0] = A[words[1]].x; }\n",
    );
    assert_eq!(one_more.table_bytes, 32);
}

#[test]
fn stock_kernels_have_what_their_rows_say() {
    for kernel in KERNELS {
        let words = corput::kernels::spirv(kernel.name).expect("a module");
        let measured = measure(&words).expect("a module");
        let bindings: Vec<(u32, u32)> = kernel.bindings.iter().map(|b| (0, b.binding)).collect();
        let mut sorted = bindings.clone();
        sorted.sort_unstable();
        assert_eq!(measured.resources, sorted, "{}", kernel.name);
        assert_eq!(measured.bytes, 4 * words.len());
        assert_eq!(
            measured.specialization,
            kernel.specialization().len(),
            "{}",
            kernel.name
        );
        let module = Module::parse(&words).expect("a module");
        assert_eq!(measured.functions, module.functions().len());
        assert_eq!(measured.instructions, module.instructions().len());
        let constants = module.instructions().iter().filter(|row| {
            let op = row.op().expect("a known opcode");
            format!("{op:?}").starts_with("Constant")
        });
        assert_eq!(measured.constants, constants.count(), "{}", kernel.name);
        let pruned = measure(&prune(&words, &[]).expect("a module")).expect("a module");
        assert!(pruned.functions <= measured.functions && pruned.bytes <= measured.bytes);
    }
    assert!(measure(&[]).is_err());
}
