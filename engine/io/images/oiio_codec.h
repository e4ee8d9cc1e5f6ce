// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/srgb_table.h"
#include "io/image_codec.h"

namespace patina {

/// Reads and writes pictures through OpenImageIO.
class OiioCodec final : public ImageCodec {
  public:
    OiioCodec();
    Result<Image> read(const std::filesystem::path& file) const override;
    Result<Image> readNumbers(const std::filesystem::path& file, int& bits) const override;
    Result<std::string> encode(const std::string& extension, const Image& image) const override;

  private:
    SrgbTable srgb_;
};

} // namespace patina
