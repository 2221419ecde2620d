#version 450
// What:   start-up probe: does one operation per row, on operands from a buffer
//         so that no compiler can fold it.
// Rows:   four words each: operation, a, b, c. One result word per row.
// Judge:  src/vulkan/probe.rs. The operations' numbers are in probe_rows.rs.

layout(local_size_x = 64) in;

layout(std430, set = 0, binding = 0) readonly buffer Buffer0 { uint arguments[]; };
layout(std430, set = 0, binding = 1) buffer Buffer1 { uint results[]; };

void main() {
    uint group = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
    uint row = group * 64u + gl_LocalInvocationID.x;
    if (row >= uint(results.length())) {
        return;
    }
    uint a = arguments[row * 4u + 1u];
    uint b = arguments[row * 4u + 2u];
    uint c = arguments[row * 4u + 3u];
    float x = uintBitsToFloat(a);
    float y = uintBitsToFloat(b);
    float z = uintBitsToFloat(c);
    uint result = 0u;
    switch (arguments[row * 4u]) {
    case 0u: { // add
        precise float sum = x + y;
        result = floatBitsToUint(sum);
        break;
    }
    case 1u: { // subtract
        precise float difference = x - y;
        result = floatBitsToUint(difference);
        break;
    }
    case 2u: { // multiply
        precise float product = x * y;
        result = floatBitsToUint(product);
        break;
    }
    case 3u: { // multiply, then add
        precise float product = x * y;
        precise float sum = product + z;
        result = floatBitsToUint(sum);
        break;
    }
    case 4u: { // multiply, then subtract
        precise float product = x * y;
        precise float difference = product - z;
        result = floatBitsToUint(difference);
        break;
    }
    case 5u: { // multiply, then subtract from
        precise float product = x * y;
        precise float difference = z - product;
        result = floatBitsToUint(difference);
        break;
    }
    case 6u: { // the rounding error of a sum
        precise float sum = x + y;
        precise float back = sum - x;
        precise float rest = y - back;
        result = floatBitsToUint(rest);
        break;
    }
    case 7u: // negate
        result = floatBitsToUint(-x);
        break;
    case 8u: { // choose a float at run time
        float chosen = c != 0u ? x : y;
        result = floatBitsToUint(chosen);
        break;
    }
    case 9u: // unsigned to float
        result = floatBitsToUint(float(a));
        break;
    case 10u: // signed to float
        result = floatBitsToUint(float(int(a)));
        break;
    case 11u: // fraction to float
        result = floatBitsToUint(float(a >> 8));
        break;
    case 12u: // float to unsigned
        result = uint(x);
        break;
    case 13u: // float to signed
        result = uint(int(x));
        break;
    case 14u: // shift left
        result = a << b;
        break;
    case 15u: // shift right, zeros in
        result = a >> b;
        break;
    case 16u: // shift right, sign in
        result = uint(int(a) >> int(b));
        break;
    case 17u: // less
        result = x < y ? 1u : 0u;
        break;
    case 18u: // floor
        result = floatBitsToUint(floor(x));
        break;
    }
    results[row] = result;
}
