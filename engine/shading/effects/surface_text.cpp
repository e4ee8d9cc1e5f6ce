// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/effects/surface_text.h"

#include <algorithm>

#include <fmt/format.h>

#include "shading/program/table_writer.h"

namespace patina {

bool SurfaceText::isPicture() const {
    return output == SurfaceOutput::Picture && set.ground == GroundMode::Off;
}

void SurfaceText::readFrom(std::string_view array) {
    out.add(unpackedFrom(array));
}

void SurfaceText::addBlock(const Block& block, std::span<const CompiledValue> compiled) {
    if (std::ranges::find(written_, &block) != written_.end()) {
        return;
    }
    out.add(constantsSource(block) + structSource(block, compiled));
    if (looksUp(block, object.tables, output)) {
        out.addFile("passes/block_tables.glsl");
    }
    out.add(textBeforeBlock(block, object.tables, output));
    out.addBlock(block);
    out.add(textBehindBlock(block, object.tables, output));
    written_.push_back(&block);
}

void SurfaceText::addOnce(const std::string& code) {
    if (std::ranges::find(code_, code) == code_.end()) {
        code_.push_back(code);
        out.add(code);
    }
}

void SurfaceText::addUnpack(const BlockUse& use, const std::string& function) {
    out.add(unpackSource(use.block(), {function, use.compiled()}));
}

void SurfaceText::addOpenDirections() {
    if (!around.directionsFile.empty()) {
        out.addFile(around.directionsFile);
        return;
    }
    out.add("#define OPEN_TOWARDS(d, width) 1.0\n#define OPEN_SHARE 1.0\n"
            "#define OPEN_MEAN(n) (n)\n");
}

void SurfaceText::noteTerm(const std::string& term, const std::string& value,
                           const std::string& detail) {
    if (isInspected()) {
        main += fmt::format("    noteTerm(TERM_{}, {}, {});\n", term, value, detail);
    }
}

} // namespace patina
