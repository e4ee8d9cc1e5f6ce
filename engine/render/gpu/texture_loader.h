// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <tuple>
#include <utility>

#include "assets/asset_client.h"
#include "render/gpu/texture_source.h"

namespace patina {

/// Loads images where no window waits, as for the command line. Each image is read when it is first
/// asked for, in the call itself; a failure is remembered with its reason.
class TextureLoader {
  public:
    /// Keeps a reference to the client, which must outlive it.
    explicit TextureLoader(AssetClient& client) : client_(client) {}

    TextureLookup find(const TextureUse& use, TextureDecoding decoding);
    TextureSource source();

    /// Returns why images are missing, each reason once.
    Errors takeProblems() { return std::exchange(problems_, {}); }

  private:
    AssetClient& client_;
    std::map<std::tuple<std::string, TextureDecoding>, TextureLookup> found_;
    Errors problems_;
};

} // namespace patina
