// SPDX-License-Identifier: GPL-3.0-or-later
// Built with clang and -DPATINA_FUZZ=ON; run as: patina-fuzz tests/fuzz/corpus presets shaders
#include <cstddef>
#include <cstdint>

#include "fuzz/read_files.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    patina::tests::readAsFiles({reinterpret_cast<const char*>(data), size});
    return 0;
}
