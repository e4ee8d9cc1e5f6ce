// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/lights/environment_pictures.h"

namespace patina {
namespace {

/// Returns the black picture for use while the real one is missing. It has one level and sides that
/// are powers of two, like real pictures, because a software driver compiles programs again for
/// another kind of texture.
const EnvironmentTexels& blackTexels() {
    static const EnvironmentTexels black{glm::ivec2(4), std::vector<std::uint16_t>(64)};
    return black;
}

} // namespace

bool EnvironmentPicture::fillSome() {
    return whole.fillSome(image ? image->whole : blackTexels());
}

std::pair<std::shared_ptr<EnvironmentPicture>, bool>
EnvironmentPictures::of(const std::shared_ptr<const EnvironmentImage>& image) {
    std::erase_if(pictures_, [](const auto& picture) { return picture.expired(); });
    for (const auto& held : pictures_) {
        if (auto picture = held.lock(); picture->image == image) {
            return {std::move(picture), false};
        }
    }
    auto made = std::make_shared<EnvironmentPicture>();
    made->image = image;
    made->small.fill(image ? image->small : blackTexels());
    made->whole.begin(image ? image->whole.size : blackTexels().size);
    pictures_.push_back(made);
    return {std::move(made), true};
}

} // namespace patina
