#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require
// Points of any number of columns, four words an invocation, columns from a table.
#include "interface.glsl"
#include "column.glsl"

uint word(uint at) {
    uint point = at / DIMENSIONS;
    Column c = column_load((at - point * DIMENSIONS) * COLUMN_ROWS);
    return column_output(cursor_value(cursor_start(push.first + point, c), c), c, OUTPUT);
}

void main() {
    uint i = kernel_invocation();
    if (i >= push.invocations) {
        return;
    }
    uvec4 words;
    for (uint k = 0u; k < 4u; k++) {
        words[k] = word(i * 4u + k);
    }
    results[i] = words;
}
