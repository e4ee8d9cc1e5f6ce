// SPDX-License-Identifier: GPL-3.0-or-later
#include "material/texture_use.h"

#include <algorithm>
#include <functional>
#include <map>

#include "catalog/descriptor_words.h"

namespace patina {
namespace {

constexpr Words<TextureColorSpace, 4> colorSpaces{{{"auto", TextureColorSpace::Auto},
                                                   {"srgb", TextureColorSpace::Srgb},
                                                   {"linear", TextureColorSpace::Linear},
                                                   {"roots", TextureColorSpace::Roots}}};
constexpr Words<TextureChannel, 6> channelWords{{{"auto", TextureChannel::Auto},
                                                 {"rgb", TextureChannel::Color},
                                                 {"r", TextureChannel::Red},
                                                 {"g", TextureChannel::Green},
                                                 {"b", TextureChannel::Blue},
                                                 {"a", TextureChannel::Alpha}}};
constexpr Words<TextureMode, 3> modes{{{"replace", TextureMode::Replace},
                                       {"multiply", TextureMode::Multiply},
                                       {"add", TextureMode::Add}}};
constexpr Words<TextureWrap, 3> wraps{{{"repeat", TextureWrap::Repeat},
                                       {"clamp", TextureWrap::Clamp},
                                       {"mirror", TextureWrap::Mirror}}};
constexpr Words<TextureFilter, 2> filters{
    {{"smooth", TextureFilter::Smooth}, {"nearest", TextureFilter::Nearest}}};

/// Reads and writes a setting as a parameter's value.
struct Access {
    std::function<Value(const TextureUse&)> read;
    std::function<void(TextureUse&, const Value&)> write;
};

template <class Member>
Access member(Member TextureUse::*field) {
    return {[field](const TextureUse& use) { return Value(use.*field); },
            [field](TextureUse& use, const Value& value) {
                if (const Member* held = std::get_if<Member>(&value)) {
                    use.*field = *held;
                }
            }};
}

template <class Choice, std::size_t N>
Access choice(Choice TextureUse::*field, const Words<Choice, N>& words) {
    return {[field, &words](const TextureUse& use) {
                return Value(std::string(wordFor(words, use.*field)));
            },
            [field, &words](TextureUse& use, const Value& value) {
                const auto* word = std::get_if<std::string>(&value);
                if (const auto meaning = meaningOf(words, word ? *word : "")) {
                    use.*field = *meaning;
                }
            }};
}

const std::map<std::string, Access, std::less<>>& accessTable() {
    static const std::map<std::string, Access, std::less<>> table{
        {"channel", choice(&TextureUse::channel, channelWords)},
        {"colorSpace", choice(&TextureUse::colorSpace, colorSpaces)},
        {"mode", choice(&TextureUse::mode, modes)},
        {"wrap", choice(&TextureUse::wrap, wraps)},
        {"filter", choice(&TextureUse::filter, filters)},
        {"scale", member(&TextureUse::scale)},
        {"offset", member(&TextureUse::offset)},
        {"rotation", member(&TextureUse::rotation)},
        {"strength", member(&TextureUse::strength)},
        {"cutOut", member(&TextureUse::cutOut)},
        {"threshold", member(&TextureUse::threshold)}};
    return table;
}

Parameter described(ParameterType type, std::string id, std::string label, std::string doc,
                    Value usual) {
    Parameter parameter;
    parameter.type = type;
    parameter.id = std::move(id);
    parameter.label = std::move(label);
    parameter.doc = std::move(doc);
    parameter.defaultValue = std::move(usual);
    return parameter;
}

Parameter ranged(Parameter parameter, glm::dvec2 hard, glm::dvec2 soft, double step) {
    parameter.min = hard.x;
    parameter.max = hard.y;
    parameter.softMin = soft.x;
    parameter.softMax = soft.y;
    parameter.step = step;
    return parameter;
}

Parameter chosen(std::string id, std::string label, std::string doc,
                 std::vector<EnumValue> values) {
    Parameter parameter = described(ParameterType::Enum, std::move(id), std::move(label),
                                    std::move(doc), values.front().id);
    parameter.values = std::move(values);
    return parameter;
}

Parameter channelSetting(const std::vector<std::string>& channels) {
    const std::vector<EnumValue> all{{"auto", "Automatic",
                                      "The usual channel for this; where that is alpha, the grey "
                                      "of an image without one."},
                                     {"rgb", "Colour", "Red, green and blue."},
                                     {"r", "Red", "The red channel alone."},
                                     {"g", "Green", "The green channel alone."},
                                     {"b", "Blue", "The blue channel alone."},
                                     {"a", "Alpha", "The alpha channel alone."}};
    std::vector<EnumValue> taken{all.front()};
    for (const EnumValue& value : all) {
        const bool listed = std::find(channels.begin(), channels.end(), value.id) != channels.end();
        if (listed || (channels.empty() && value.id.size() == 1)) {
            taken.push_back(value);
        }
    }
    return chosen("channel", "Channel", "Which channel of the image counts.", std::move(taken));
}

Parameter colorSpaceSetting() {
    return chosen("colorSpace", "Colour space", "How the numbers in the file are meant.",
                  {{"auto", "Automatic", "sRGB for colours, linear for everything else."},
                   {"srgb", "sRGB", "Encoded as for a screen."},
                   {"linear", "Linear", "The numbers themselves."},
                   {"roots", "Square roots",
                    "The square roots of what is meant, as those of roughness in glTF and in game "
                    "engines are."}});
}

Parameter modeSetting() {
    return chosen("mode", "Mode", "What the image does to the value in the form.",
                  {{"replace", "Replace", "The image stands in place of the value."},
                   {"multiply", "Multiply", "The image darkens the value."},
                   {"add", "Add", "The image is added to the value."}});
}

Parameter strengthSetting(TextureRole role) {
    constexpr double maxSlope = 20.0;
    constexpr double maxMetres = 10.0;
    if (role == TextureRole::Normal) {
        return ranged(described(ParameterType::Float, "strength", "Strength",
                                "How steep the relief is; negative turns it inside out.", 1.0),
                      {-maxSlope, maxSlope}, {0.0, 2.0}, 0.01);
    }
    if (role == TextureRole::Height) {
        Parameter height = ranged(described(ParameterType::Float, "strength", "Height",
                                            "From black to white; negative turns it inside out.",
                                            static_cast<double>(0.02f)),
                                  {-maxMetres, maxMetres}, {0.0, 0.1}, 0.001);
        height.unit = "m";
        return height;
    }
    return ranged(described(ParameterType::Float, "strength", "Strength",
                            "How much of the image is seen.", 1.0),
                  {0.0, 1.0}, {0.0, 1.0}, 0.01);
}

void addPlacement(Block& block) {
    constexpr double maxNumber = 10000.0;
    block.parameters.push_back(chosen("wrap", "Wrap", "What lies beside the image.",
                                      {{"repeat", "Repeat", "The image again."},
                                       {"clamp", "Clamp", "Its edge, drawn out."},
                                       {"mirror", "Mirror", "The image, mirrored."}}));
    block.parameters.push_back(chosen("filter", "Filter", "What is between its pixels.",
                                      {{"smooth", "Smooth", "Blended, also from afar."},
                                       {"nearest", "Nearest", "Hard pixels."}}));
    block.parameters.push_back(
        ranged(described(ParameterType::Vec2, "scale", "Scale",
                         "How often the image fits, across and up.", glm::dvec2(1.0)),
               {-maxNumber, maxNumber}, {0.0, 8.0}, 0.01));
    block.parameters.push_back(ranged(described(ParameterType::Vec2, "offset", "Offset",
                                                "How far it is moved, in images.", glm::dvec2(0.0)),
                                      {-maxNumber, maxNumber}, {-1.0, 1.0}, 0.01));
    Parameter rotation =
        ranged(described(ParameterType::Float, "rotation", "Rotation", "Counter-clockwise.", 0.0),
               {-360000.0, 360000.0}, {-180.0, 180.0}, 1.0);
    rotation.unit = "deg";
    block.parameters.push_back(std::move(rotation));
}

void addCutOut(Block& block) {
    block.parameters.push_back(described(ParameterType::Bool, "cutOut", "Cut out",
                                         "Each point is either there or not.", false));
    Parameter threshold = described(ParameterType::Float, "threshold", "Threshold",
                                    "What is below is cut away.", 0.5);
    threshold.enabledWhen = "cutOut == true";
    block.parameters.push_back(std::move(threshold));
}

} // namespace

TextureRole textureRole(std::string_view key) {
    if (key == "normal") {
        return TextureRole::Normal;
    }
    if (key == "height") {
        return TextureRole::Height;
    }
    return key == "opacity" ? TextureRole::Opacity : TextureRole::Input;
}

TextureUse textureUse(std::string_view key, std::string file) {
    TextureUse use;
    use.file = std::move(file);
    use.strength = std::get<double>(strengthSetting(textureRole(key)).defaultValue);
    return use;
}

Block textureSettings(TextureRole role, const std::vector<std::string>& channels) {
    Block block;
    block.id = "texture";
    block.label = "Image";
    if (role != TextureRole::Normal) {
        block.parameters.push_back(channelSetting(channels));
    }
    if (role == TextureRole::Input || role == TextureRole::Opacity) {
        block.parameters.push_back(colorSpaceSetting());
        block.parameters.push_back(modeSetting());
    }
    block.parameters.push_back(strengthSetting(role));
    addPlacement(block);
    if (role == TextureRole::Opacity) {
        addCutOut(block);
    }
    return block;
}

Block vertexColorSettings(const std::vector<std::string>& channels) {
    Block block;
    block.id = "texture";
    block.label = "Vertex colours";
    block.parameters = {channelSetting(channels), modeSetting(),
                        strengthSetting(TextureRole::Input)};
    return block;
}

Value textureSetting(const TextureUse& use, std::string_view id) {
    return accessTable().find(id)->second.read(use);
}

void storeTextureSetting(TextureUse& use, std::string_view id, const Value& value) {
    if (const auto found = accessTable().find(id); found != accessTable().end()) {
        found->second.write(use, roundedToFloat(value));
    }
}

} // namespace patina
