// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <tuple>
#include <utility>

#include "assets/asset_client.h"
#include "render/gpu/texture_source.h"

namespace patina {

/// Represents images for pictures that nobody waits for in front of a window: each is read when it
/// is first asked for, and what cannot be read is remembered with its reason.
class TextureLoader {
  public:
    /// The client outlives it.
    explicit TextureLoader(AssetClient& client) : client_(client) {}

    TextureLookup find(const TextureUse& use, TextureDecoding decoding);
    TextureSource source();

    /// Why images are missing, each once.
    Errors takeProblems() { return std::exchange(problems_, {}); }

  private:
    AssetClient& client_;
    std::map<std::tuple<std::string, TextureDecoding>, TextureLookup> found_;
    Errors problems_;
};

} // namespace patina
