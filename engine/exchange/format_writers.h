// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "exchange/export_images.h"
#include "exchange/exported_look.h"

namespace patina {

// Each writes materials, whose names differ, as the content of a file, takes their images, and adds
// to their lines what becomes of each value and image.

/// Writes glTF 2.0 as text, its images and its triangles beside it in `images`.
std::string writeGltf(std::vector<ExportedLook>& materials, ExportImages& images,
                      const std::string& bufferName, std::string& buffer);
/// Writes the same as one binary file with all inside.
std::string writeGlb(std::vector<ExportedLook>& materials, ExportImages& images);
std::string writeMaterialX(std::vector<ExportedLook>& materials, ExportImages& images);
std::string writeMtl(std::vector<ExportedLook>& materials, ExportImages& images);

} // namespace patina
