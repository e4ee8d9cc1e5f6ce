// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/lights/environment_pictures.h"

namespace patina {
namespace {

/// In place of a picture that is on its way. A software driver compiles programs anew where one
/// with coarser versions, or with sides that are powers of two, takes the place of one without.
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
