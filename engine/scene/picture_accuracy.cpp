// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/picture_accuracy.h"

#include <algorithm>

#include "scene/picture_choice_text.h"

namespace patina {
namespace {

using Level = PictureChoiceText::Level;

constexpr std::array samplesLevels{
    Level{"8", "8 samples", "Edges in eight steps, where the graphics card offers as many."},
    Level{"4", "4 samples", "Edges in four steps."}, Level{"2", "2 samples", "Edges in two steps."},
    Level{"1", "1 sample", "Edges are jagged."}};

constexpr std::array lightingLevels{
    Level{"pixel", "Per pixel", "The model is asked at every pixel."},
    Level{"vertex", "Per vertex",
          "The model is asked at the corners of the triangles and the light in between is blended: "
          "highlights between corners are lost. Materials with images or marks, and scenes with "
          "shadows or an environment, stay per pixel."}};

constexpr std::array normalsLevels{
    Level{"unit", "Of length 1", "The normal between corners is brought to length 1."},
    Level{"interpolated", "As blended",
          "The normal stays as short as blending makes it: coarse meshes get darker between their "
          "corners."}};

constexpr std::array highlightsLevels{
    Level{"sharp", "As they are", "A highlight is as narrow as its material says."},
    Level{"widened", "Widened",
          "Where the surface turns more within a pixel than a highlight is wide, the highlight is "
          "widened by that: it is larger and dimmer and does not sparkle when something moves."}};

constexpr std::array fogLevels{
    Level{"pixel", "Per pixel", "What fog leaves is worked out at every pixel."},
    Level{"vertex", "Per vertex",
          "What fog leaves is worked out at the corners of the triangles and blended in between. "
          "The ground and lines stay per pixel."}};

constexpr std::array scaleLevels{
    Level{"full", "Full size", "Every pixel is drawn."},
    Level{"three-quarters", "Three quarters",
          "9 of 16 pixels are drawn; the picture is stretched."},
    Level{"half", "Half", "1 of 4 pixels is drawn; the picture is stretched."}};

constexpr std::array numbersLevels{
    Level{"full", "32 bits", "Seven digits per channel."},
    Level{"half", "16 bits", "Three digits per channel, half the memory: nobody sees it."}};

constexpr std::array environmentLevels{
    Level{"sampled", "Sampled",
          "A mean over directions of the light from all around, which settles."},
    Level{"fitted", "Fitted",
          "What the material reflects is taken apart into a matte part and two lobes, which see "
          "the environment out of focus: there at once, without grain."}};

constexpr std::array texts{
    PictureChoiceText{PictureChoice::Samples, "samples", "Samples per pixel",
                      "How many places of a pixel are looked at for edges.", samplesLevels},
    PictureChoiceText{PictureChoice::Lighting, "lighting", "Lighting",
                      "Where the lighting model is asked.", lightingLevels},
    PictureChoiceText{PictureChoice::Normals, "normals", "Normals",
                      "Whether normals are brought to length 1 at every pixel.", normalsLevels},
    PictureChoiceText{PictureChoice::Highlights, "highlights", "Highlights",
                      "What becomes of highlights that are smaller than a pixel.",
                      highlightsLevels},
    PictureChoiceText{PictureChoice::Fog, "fog", "Fog", "Where fog is worked out.", fogLevels},
    PictureChoiceText{PictureChoice::Scale, "scale", "Render scale",
                      "How much of the picture's width and height is drawn.", scaleLevels},
    PictureChoiceText{PictureChoice::Numbers, "numbers", "Linear picture",
                      "How fine the numbers are in which light is summed up.", numbersLevels},
    PictureChoiceText{PictureChoice::Environment, "environment", "Environment",
                      "How the light from all around is summed up.", environmentLevels}};

static_assert(texts.size() == pictureChoices);

} // namespace

std::span<const PictureChoiceText> pictureChoiceTexts() {
    return texts;
}

const PictureChoiceText* pictureChoiceText(std::string_view id) {
    const auto found = std::ranges::find_if(
        texts, [id](const PictureChoiceText& text) { return text.id == id; });
    return found == texts.end() ? nullptr : &*found;
}

std::optional<std::size_t> PictureChoiceText::level(std::string_view levelId) const {
    const auto found = std::ranges::find_if(
        levels, [levelId](const Level& each) { return each.id == levelId; });
    return found == levels.end()
               ? std::nullopt
               : std::optional(static_cast<std::size_t>(found - levels.begin()));
}

void PictureAccuracy::choose(PictureChoice choice, std::size_t level) {
    const auto index = static_cast<std::size_t>(choice);
    levels_[index] = static_cast<std::uint8_t>(std::min(level, texts[index].levels.size() - 1));
}

} // namespace patina
