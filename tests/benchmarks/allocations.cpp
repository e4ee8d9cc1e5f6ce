// SPDX-License-Identifier: GPL-3.0-or-later
#include "allocations.h"

#include <cstdlib>
#include <new>

namespace {
thread_local long count = 0;
}

// Replacing these two also catches the array forms, which call them.
void* operator new(std::size_t size) {
    ++count;
    if (void* memory = std::malloc(size == 0 ? 1 : size)) {
        return memory;
    }
    throw std::bad_alloc();
}

void operator delete(void* memory) noexcept {
    std::free(memory);
}

void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}

namespace patina::benchmarks {

long allocations() {
    return count;
}

} // namespace patina::benchmarks
