// SPDX-License-Identifier: GPL-3.0-or-later
// The part of SurfaceWriter that writes what a surface adds to a sum of layers.
#include <fmt/format.h>

#include "shading/effects/surface_writer.h"

namespace patina {

/// The inspection looks at each surface by itself.
void SurfaceWriter::writeLayer() {
    if (!object_.transparency || isInspected()) {
        return;
    }
    const Block& block = *object_.transparency->block;
    readFrom("objectData");
    writeBlock(block);
    writeUnpack(block, *set_.scene.transparency, "unpackTransparency");
    out_.add(fmt::format("#define Transparency {}\n#define layerWeight {}\n"
                         "#define LAYER_RANGE objectData[{}]\n",
                         structName(block), functionName(block), object_.layers()));
    out_.addFile("passes/transparency_layer.glsl");
    store_ = fmt::format("storeLayer({{}}, {{}}, unpackTransparency({}))",
                         object_.transparency->first);
    if (!object_.isPeeled()) {
        out_.addFile("passes/transparency_share.glsl");
        last_ += fmt::format("    storedShare = {};\n", alpha_);
    }
}

} // namespace patina
