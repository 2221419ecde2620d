#version 450
#extension GL_GOOGLE_include_directive : require
// Points of any number of columns, four words an invocation, columns from a table.
#include "interface.glsl"
#include "column.glsl"

const uint COLUMN_WORDS = 11u;

Column column_load(uint index) {
    uint at = index * COLUMN_WORDS;
    return Column(columns[at],
        CorputOdometerBase(
            CorputBase(columns[at + 1u], columns[at + 2u], columns[at + 3u], columns[at + 4u],
                columns[at + 5u], columns[at + 6u], columns[at + 7u]),
            columns[at + 8u], columns[at + 9u], columns[at + 10u]));
}

uint word(uint at) {
    uint point = at / DIMENSIONS;
    Column c = column_load(at - point * DIMENSIONS);
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
