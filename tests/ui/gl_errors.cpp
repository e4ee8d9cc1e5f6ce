// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/gl_errors.h"

#include <cstdlib>
#include <fstream>
#include <iterator>

namespace patina::tests {

GlErrors* GlErrors::listening_ = nullptr;

GlErrors::GlErrors() {
    setenv("MESA_DEBUG", "1", 1);
    setenv("MESA_LOG_FILE", file_.c_str(), 1);
    listening_ = this;
}

std::string GlErrors::taken() {
    std::ifstream file(listening_->file_);
    file.seekg(listening_->taken_);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    listening_->taken_ += static_cast<std::streamoff>(text.size());
    return text;
}

void GlErrors::OnTestEnd(const testing::TestInfo&) {
    if (const std::string errors = taken(); !errors.empty()) {
        ADD_FAILURE() << errors;
    }
}

} // namespace patina::tests
