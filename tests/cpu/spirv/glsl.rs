//! GLSL for the linter's tests, and its compiler.

use glslang::{
    Compiler, CompilerOptions, ShaderInput, ShaderSource, ShaderStage, SpirvVersion, Target,
    VulkanVersion,
};

/// SPIR-V as the crate's kernels get it: Vulkan 1.1, SPIR-V 1.3.
pub fn compile(source: &str) -> Vec<u32> {
    let compiler = Compiler::acquire().expect("glslang");
    let target = Target::Vulkan {
        version: VulkanVersion::Vulkan1_1,
        spirv_version: SpirvVersion::SPIRV1_3,
    };
    let options = CompilerOptions {
        target,
        ..CompilerOptions::default()
    };
    let source_text = ShaderSource::from(source);
    let input = ShaderInput::new(
        &source_text,
        ShaderStage::Compute,
        &options,
        None::<&[(&str, Option<&str>)]>,
        None,
    );
    let shader = compiler
        .create_shader(input.expect("input"))
        .unwrap_or_else(|error| panic!("{error}\n{source}"));
    shader
        .compile()
        .unwrap_or_else(|error| panic!("{error}\n{source}"))
}

/// A kernel whose function `corput_bad` computes the float `code` from
/// `uint u` and `float f`.
pub fn expression(code: &str) -> String {
    format!(
        "#version 450
//DECLARATIONS
layout(local_size_x = 64) in;
layout(std430, set = 0, binding = 0) buffer Data {{ uint data[]; }};
uint corput_bad(uint u) {{ float f = uintBitsToFloat(u); return floatBitsToUint({code}); }}
void main() {{ data[0] = corput_bad(data[1]); }}
"
    )
}

/// An expression, and the opcode for which the linter must name its function.
pub const FORBIDDEN_IN_FUNCTION: &[(&str, &str)] = &[
    ("f < 1.0 ? f : 0.0", "FOrdLessThan"),
    ("sin(f)", "GLSL.std.450 Sin"),
    ("cos(f)", "GLSL.std.450 Cos"),
    ("atan(f, f)", "GLSL.std.450 Atan2"),
    ("exp2(f)", "GLSL.std.450 Exp2"),
    ("log(f)", "GLSL.std.450 Log"),
    ("pow(f, f)", "GLSL.std.450 Pow"),
    ("sqrt(f)", "GLSL.std.450 Sqrt"),
    ("inversesqrt(f)", "GLSL.std.450 InverseSqrt"),
    ("fma(f, f, f)", "GLSL.std.450 Fma"),
    ("mix(f, f, f)", "GLSL.std.450 FMix"),
    ("normalize(vec3(f, f, f)).x", "GLSL.std.450 Normalize"),
    ("length(vec2(f, f))", "GLSL.std.450 Length"),
    ("floor(f)", "GLSL.std.450 Floor"),
    ("abs(f)", "GLSL.std.450 FAbs"),
    ("min(f, f)", "GLSL.std.450 FMin"),
    ("ldexp(f, 3)", "GLSL.std.450 Ldexp"),
    ("unpackHalf2x16(u).x", "GLSL.std.450 UnpackHalf2x16"),
    ("f / f", "FDiv"),
    ("mod(f, f)", "FMod"),
    ("dot(vec3(f, f, f), vec3(f, f, f))", "Dot"),
    ("(vec3(f, f, f) * f).x", "VectorTimesScalar"),
    ("(mat2(f) * vec2(f, f)).x", "MatrixTimesVector"),
    ("transpose(mat2(f))[0].x", "Transpose"),
    ("f + f", "FAdd"),
    ("f - f", "FSub"),
    ("f * f", "FMul"),
    ("-f", "FNegate"),
    ("f++", "FAdd"),
    ("float(u)", "ConvertUToF"),
    ("float(int(u))", "ConvertSToF"),
    ("uintBitsToFloat(uint(f))", "ConvertFToU"),
    ("uintBitsToFloat(0x2f800000u) * float(u)", "FMul"),
    ("uintBitsToFloat(0x2f800000u) * float(u)", "ConvertUToF"),
    ("uintBitsToFloat(uint(int(u) / 3))", "SDiv"),
    ("uintBitsToFloat(uint(int(u) % 3))", "SMod"),
    ("isnan(f) ? f : f", "IsNan"),
    (
        "uintBitsToFloat(atomicExchange(data[2], u))",
        "AtomicExchange",
    ),
];

/// Declarations, an expression that uses them, and the opcode for which the
/// linter must name the module.
pub const FORBIDDEN_IN_MODULE: &[(&str, &str, &str)] = &[
    ("", "float(double(f))", "TypeFloat"),
    ("", "float(double(f))", "Capability"),
    (
        "#extension GL_EXT_shader_explicit_arithmetic_types_int64 : require",
        "uintBitsToFloat(uint(uint64_t(u) * u >> 32))",
        "TypeInt",
    ),
    (
        "#extension GL_EXT_shader_explicit_arithmetic_types_int16 : require",
        "uintBitsToFloat(uint(uint16_t(u)))",
        "TypeInt",
    ),
    (
        "#extension GL_EXT_shader_explicit_arithmetic_types_int8 : require",
        "uintBitsToFloat(uint(uint8_t(u)))",
        "TypeInt",
    ),
    (
        "#extension GL_EXT_shader_explicit_arithmetic_types_float16 : require",
        "float(float16_t(f))",
        "TypeFloat",
    ),
    (
        "#extension GL_KHR_shader_subgroup_arithmetic : require",
        "uintBitsToFloat(subgroupAdd(u))",
        "Capability",
    ),
    (RTE, "f", "ExecutionMode"),
    (RTE, "f", "Extension"),
    (RTE, "f", "Capability"),
    (
        "mediump float corput_low(mediump float f) { return f; }",
        "corput_low(f)",
        "Decorate",
    ),
    (
        "layout(constant_id = 0) const int K = 7;",
        "uintBitsToFloat(uint(K / 3))",
        "SpecConstantOp",
    ),
    (
        "layout(constant_id = 0) const bool K = true; const float S = K ? 0.5 : 0.25;",
        "S",
        "SpecConstantOp",
    ),
];

/// Declares round-to-nearest-even, which not every device has.
const RTE: &str = "#extension GL_EXT_spirv_intrinsics : require
spirv_execution_mode(extensions = [\"SPV_KHR_float_controls\"], capabilities = [4467], 4462, 32);";

/// A kernel of the exact profile, with much of what is allowed; `defines`
/// stand first.
pub fn exact_kernel(defines: &str) -> String {
    EXACT.replace("//DEFINES", defines)
}

const EXACT: &str = r"#version 450
//DEFINES
layout(local_size_x_id = 7) in;
layout(constant_id = 3) const uint COUNT = 5u;
layout(push_constant) uniform Push { uint first; uint count; };
layout(std430, set = 0, binding = 0) buffer Data { uint data[]; };
layout(std430, set = 0, binding = 2) readonly buffer Wide { uvec4 wide[]; };
layout(std430, set = 1, binding = 1) buffer Floats { float floats[]; };
shared uint total;
const uint TABLE[4] = uint[](2u, 3u, 5u, 7u);
struct Corput_Pair { uint bits; float value; };

float corput_unit_floor(uint u) { return float(u >> 8) * uintBitsToFloat(0x33800000u); }
float corput_unit_ceil(uint u) {
    return float(min((u >> 8) + uint((u & 255u) != 0u), 0xffffffu)) * uintBitsToFloat(0x33800000u);
}
vec2 corput_unit_floor(uvec2 u) { return vec2(corput_unit_floor(u.x), corput_unit_floor(u.y)); }
uint corput_seed_sqrt(uint m) { return uint(sqrt(float(m)) * uintBitsToFloat(0x45800000u)); }
uint corput_seed_quotient(uint a, uint b) {
    return uint(float(a) / float(b) * uintBitsToFloat(0x4b800000u));
}
int corput_seed_step(int r, uint q) {
    return int(floor(float(r) / float(2u * q)));
}
uint corput_sqrt(uint m) {
    uint q = corput_seed_sqrt(m);
    for (uint i = 0u; i < 18u && q * q > m; ++i) { q -= 1u; }
    return q + uint(corput_seed_step(int(m - q * q), q)) + corput_seed_quotient(m, q);
}
uint corput_bits(uint n) {
    uint high, low, carry, borrow;
    umulExtended(n, 0x9e3779b9u, high, low);
    uint sum = uaddCarry(high, low, carry);
    sum += usubBorrow(sum, carry, borrow) + bitfieldReverse(n) + uint(bitCount(n)) + uint(findMSB(n));
    int ihigh, ilow;
    imulExtended(int(n), -3, ihigh, ilow);
    sum ^= uint(abs(ihigh) + sign(ilow)) + bitfieldExtract(n, 3, 5) + bitfieldInsert(n, sum, 2, 3);
    switch (n & 3u) {
        case 0u: return sum / TABLE[n >> 30];
        case 1u: return sum % 3u;
        default: return n == 7u ? sum : ~sum;
    }
}
#ifdef WITH_FRAME
void corput_frame(vec3 n, out vec3 t, out vec3 b) {
    t = vec3(n.x * n.x - n.y, n.y + n.z * n.x, n.z);
    b = vec3(n.y * t.z - n.z * t.y, n.z * t.x - n.x * t.z, n.x * t.y - n.y * t.x);
}
vec3 corput_frame_combine(vec3 n, vec3 d) {
    precise vec3 t, b;
    corput_frame(n, t, b);
    return vec3(t.x * d.x + b.x * d.y, t.y * d.x + b.y * d.y, n.z + d.z);
}
#endif
void main() {
    uint index = gl_GlobalInvocationID.x + first;
    if (index >= count) { return; }
    Corput_Pair pair = Corput_Pair(corput_bits(index) + corput_sqrt(index), corput_unit_ceil(index));
    vec2 unit = corput_unit_floor(wide[index].xy);
    if (floatBitsToUint(unit.x) < floatBitsToUint(unit.y)) { unit = unit.yx; }
    floats[index] = unit.x;
    data[index] = floatBitsToUint(pair.value) + pair.bits * COUNT;
    atomicAdd(total, pair.bits);
    barrier();
#ifdef WITH_FRAME
    vec3 world = corput_frame_combine(vec3(unit, pair.value), vec3(pair.value, unit));
    floats[index] = world.z;
#endif
    data[index + uint(data.length()) / 2u] = total;
}
";
