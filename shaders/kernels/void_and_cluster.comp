#version 450
#extension GL_GOOGLE_include_directive : require
// Void-and-cluster by one workgroup. Each pass brings the pixel that was toggled last into
// the energies of those that it reaches, and finds the next. A pixel's word is its energy,
// and bit 31 where it is set: so the least word is the largest void, and the least
// complement the tightest cluster. A column belongs to one invocation, so none reads a
// word that another wrote; they meet in minima in shared memory, whose order does not show.
#include "interface.glsl"

// The least word of each row of all frames, and the least complement of one.
shared uint row_keys[2048];
shared uint best_key;
shared uint best_row;
shared uint best_pixel;

// A pixel that was toggled: its place, and whether it was taken away.
struct Change {
    uint x;
    uint y;
    uint frame;
    bool removed;
};

// How far apart two places on a circle are.
uint circular(uint a, uint b, uint circumference) {
    uint d = a > b ? a - b : b - a;
    return min(d, circumference - d);
}

// Row `i` of those that a change reaches: around it in its frame, and its own in others.
uint reached(Change change, uint i) {
    if (i < push.span) {
        uint y = change.y + push.height - (push.span >> 1) + i;
        return change.frame * push.height + y % push.height;
    }
    uint frame = change.frame + 1u + i - push.span;
    return frame % push.frames * push.height + change.y;
}

// Takes this invocation's words of a row into the row's keys.
void gather(uint row) {
    for (uint x = gl_LocalInvocationID.x; x < push.width; x += gl_WorkGroupSize.x) {
        uint word = words[row * push.width + x];
        atomicMin(row_keys[2u * row], word);
        atomicMin(row_keys[2u * row + 1u], ~word);
    }
}

// Brings a change into this invocation's words of a row.
void bring(Change change, uint row) {
    uint distance = circular(row / push.height, change.frame, push.frames);
    uint down = circular(row % push.height, change.y, push.height);
    for (uint x = gl_LocalInvocationID.x; x < push.width; x += gl_WorkGroupSize.x) {
        uint across = circular(x, change.x, push.width);
        // In the same frame, or at the same place; else past the end of the table.
        uint squared = distance == 0u ? across * across + down * down
            : across == 0u ? distance * distance : push.terms;
        if (squared < push.terms) {
            uint at = row * push.width + x;
            uint word = words[at];
            word += change.removed ? 0u - energies[squared] : energies[squared];
            words[at] = word ^ (squared == 0u ? 0x80000000u : 0u);
        }
    }
}

void main() {
    uint lane = kernel_invocation();
    uint rows = push.height * push.frames;
    for (uint i = lane; i < 2u * rows; i += gl_WorkGroupSize.x) {
        row_keys[i] = 0xffffffffu;
    }
    barrier();
    for (uint row = 0u; row < rows; row++) {
        gather(row);
    }
    uint last = state[0];
    Change change = Change(0u, 0u, 0u, state[1] != 0u);
    uint rank = push.rank;
    uint converged = 0u;
    for (uint pass = 0u; pass < push.passes && converged == 0u; pass++) {
        uint count = 0u;
        if (last != 0xffffffffu) {
            uint row = last / push.width;
            change = Change(last % push.width, row % push.height, row / push.height, change.removed);
            count = push.span + push.frames - 1u;
        }
        barrier();
        if (lane == 0u) {
            best_key = 0xffffffffu;
            best_row = 0xffffffffu;
            best_pixel = 0xffffffffu;
        }
        if (lane < count) {
            uint row = reached(change, lane);
            row_keys[2u * row] = 0xffffffffu;
            row_keys[2u * row + 1u] = 0xffffffffu;
        }
        barrier();
        for (uint i = 0u; i < count; i++) {
            uint row = reached(change, i);
            bring(change, row);
            gather(row);
        }
        barrier();
        uint removes = (push.removes >> (pass & 1u)) & 1u;
        uvec2 best = uvec2(0xffffffffu);
        for (uint row = lane; row < rows; row += gl_WorkGroupSize.x) {
            uint key = row_keys[2u * row + removes];
            if (key < best.x) {
                best = uvec2(key, row);
            }
        }
        atomicMin(best_key, best.x);
        barrier();
        if (best.x == best_key) {
            atomicMin(best_row, best.y);
        }
        barrier();
        uint inverted = 0u - removes;
        for (uint x = lane; x < push.width; x += gl_WorkGroupSize.x) {
            uint at = best_row * push.width + x;
            if ((words[at] ^ inverted) == best_key) {
                atomicMin(best_pixel, at);
            }
        }
        barrier();
        uint next = best_pixel;
        if (push.rank_step == 0u && removes == 0u && next == last) {
            converged = 1u;
        }
        if (lane == 0u && push.rank_step != 0u) {
            ranks[next] = rank;
        }
        rank += push.rank_step;
        last = next;
        change.removed = removes != 0u;
    }
    if (lane == 0u) {
        state[0] = last;
        state[1] = change.removed ? 1u : 0u;
        state[2] = converged;
    }
}
