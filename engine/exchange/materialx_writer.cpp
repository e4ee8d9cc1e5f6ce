// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "core/grain_widths.h"
#include "core/number_text.h"
#include "core/text.h"
#include "exchange/dielectric_index.h"
#include "exchange/format_writers.h"
#include "exchange/image_settings.h"
#include "material/texture_place.h"

namespace patina {
namespace {

std::string colorText(const glm::dvec3& color) {
    return fmt::format("{}, {}, {}", shortestFloatText(color.x), shortestFloatText(color.y),
                       shortestFloatText(color.z));
}

std::string inputText(std::string_view name, std::string_view type, std::string_view value) {
    return fmt::format("    <input name=\"{}\" type=\"{}\" value=\"{}\"/>\n", name, type, value);
}

std::string linkText(std::string_view name, std::string_view type, std::string_view node) {
    return fmt::format("    <input name=\"{}\" type=\"{}\" nodename=\"{}\"/>\n", name, type, node);
}

/// Writes one material as an OpenPBR surface and the nodes that its images need.
class MaterialXMaterial {
  public:
    MaterialXMaterial(ExportedLook& look, ExportImages& images) : look_(look), images_(images) {}

    std::string write() {
        if (look_.material.isMetal()) {
            writeMetal();
        } else {
            color("base_color", "diffuse", Kept::Exact, {});
            if (look_.material.isDielectric() || look_.material.hasMetalness()) {
                writeMetalness();
                writeDielectric();
                writeTransmission();
            } else {
                inputs_ += inputText("specular_weight", "float", "0");
                writeDiffuseRoughness();
            }
        }
        writeGlow();
        writeOpacity();
        writeNormals();
        dropHeight();
        const std::string& name = look_.material.name;
        return nodes_ +
               fmt::format("  <open_pbr_surface name=\"{0}_surface\" type=\"surfaceshader\">\n{1}"
                           "  </open_pbr_surface>\n"
                           "  <surfacematerial name=\"{0}\" type=\"material\">\n{2}"
                           "  </surfacematerial>\n",
                           name, inputs_,
                           linkText("surfaceshader", "surfaceshader", name + "_surface"));
    }

  private:
    void writeMetal() {
        color("base_color", "f0", Kept::Exact, {});
        inputs_ += inputText("base_metalness", "float", "1");
        writeRoughness();
    }

    void writeMetalness() {
        if (!look_.material.hasMetalness()) {
            return;
        }
        const char* input = "base_metalness";
        look_.tellOf("metalness", Kept::Exact, input);
        const std::string node =
            look_.images.contains("metalness") ? imageNode("metalness", "float") : std::string();
        if (node.empty()) {
            inputs_ += inputText(input, "float", shortestFloatText(look_.value("metalness").x));
        } else {
            product(input, "metalness", node, imageFactor(look_, "metalness").x);
        }
    }

    /// Writes a number as a node of an image times a factor.
    void product(const char* input, const std::string& word, const std::string& node,
                 double factor) {
        if (factor == 1.0) {
            inputs_ += linkText(input, "float", node);
            return;
        }
        const std::string product = name(word + "_product");
        nodes_ += fmt::format("  <multiply name=\"{}\" type=\"float\">\n{}{}  </multiply>\n",
                              product, linkText("in1", "float", node),
                              inputText("in2", "float", shortestFloatText(factor)));
        inputs_ += linkText(input, "float", product);
    }

    /// OpenPBR's matte base is EON, whose roughness ends at 1.
    void writeDiffuseRoughness() {
        if (look_.material.look != "rough-matte") {
            return;
        }
        const char* input = "base_diffuse_roughness";
        look_.tellOf("roughness", Kept::Exact, input);
        const TextureUse* image = look_.image("roughness");
        if (image != nullptr && image->mode == TextureMode::Replace) {
            if (const std::string node = imageNode("roughness", "float"); !node.empty()) {
                inputs_ += linkText(input, "float", node);
                return;
            }
        } else {
            drop("roughness");
        }
        const double roughness = std::min(look_.value("roughness").x, 1.0);
        inputs_ += inputText(input, "float", shortestFloatText(roughness));
    }

    void writeDielectric() {
        const DielectricIndex index = dielectricIndexOf(look_.value("f0"));
        inputs_ += inputText("specular_ior", "float", shortestFloatText(index.ior));
        inputs_ += inputText("specular_color", "color3", colorText(index.tint));
        look_.tellOf("f0", Kept::Approximated,
                     fmt::format("specular_ior {} and specular_color: exact facing you, by "
                                 "Fresnel's formula at other angles",
                                 shortestFloatText(index.ior)));
        drop("f0");
        writeRoughness();
    }

    /// Writes what refracts: with a depth its colour is what is left there, without one a tint.
    void writeTransmission() {
        if (!look_.isTransmissive()) {
            return;
        }
        const double share = 1.0 - look_.value("opacity", glm::dvec3(1.0)).x;
        inputs_ += inputText("transmission_weight", "float", shortestFloatText(share));
        look_.tellOf("opacity", Kept::Exact, "transmission_weight");
        const bool isPane = look_.material.values.contains("thickness");
        const char* word = isPane ? "transmission" : "attenuation.color";
        inputs_ += inputText("transmission_color", "color3", colorText(look_.value(word)));
        look_.tellOf(word, Kept::Exact, "transmission_color");
        if (isPane) {
            inputs_ += inputText("geometry_thin_walled", "boolean", "true");
            look_.tellOf("thickness", Kept::Approximated, "a wall without a thickness");
            return;
        }
        inputs_ += inputText("transmission_depth", "float",
                             shortestFloatText(look_.value("attenuation.distance").x));
        look_.tellOf("attenuation.distance", Kept::Exact, "transmission_depth");
        if (look_.value("transmission") != glm::dvec3(1.0)) {
            look_.tellOf("transmission", Kept::Dropped, "the colour is that of the depth");
        }
        writeDispersion();
    }

    void writeDispersion() {
        constexpr double abbeOfOne = 20.0; // is the Abbe number of a dispersion of 1
        const double dispersion = look_.value("dispersion").x;
        if (dispersion > 0.0) {
            inputs_ += inputText("transmission_dispersion_scale", "float", "1");
            inputs_ += inputText("transmission_dispersion_abbe_number", "float",
                                 shortestFloatText(abbeOfOne / dispersion));
            look_.tellOf("dispersion", Kept::Exact, "transmission_dispersion_abbe_number");
        }
    }

    /// Writes a highlight that is long across a grain: OpenPBR's anisotropy is 1 less the ratio of
    /// the widths, the mean of whose squares is that of the squared roughness, and it is long along
    /// the tangent.
    void writeGrain() {
        const GrainWidths widths = widthsOf({look_.value("alpha").x, look_.value("anisotropy").x});
        const double square =
            std::sqrt(0.5 * (widths.across * widths.across + widths.along * widths.along));
        const double anisotropy = 1.0 - widths.along / widths.across;
        const double roughness = std::sqrt(std::min(square, 1.0));
        const Kept kept = square > 1.0 ? Kept::Approximated : Kept::Exact;
        inputs_ += inputText("specular_roughness", "float", shortestFloatText(roughness));
        inputs_ +=
            inputText("specular_roughness_anisotropy", "float", shortestFloatText(anisotropy));
        look_.tellOf("alpha", kept,
                     fmt::format("specular_roughness {}{}", shortestFloatText(roughness),
                                 square > 1.0 ? ", its limit" : ""));
        look_.tellOf(
            "anisotropy", Kept::Exact,
            fmt::format("specular_roughness_anisotropy {}", shortestFloatText(anisotropy)));
        drop("alpha");
        drop("anisotropy");
        writeTangent(streakAcross(look_.value("grain").x));
    }

    /// Writes a tangent that is turned towards the bitangent, as the sum of parts of both, which
    /// leaves open no question of signs.
    void writeTangent(double angle) {
        look_.tellOf("grain", Kept::Exact, "geometry_tangent, across the grain");
        const std::string turned = name("streak");
        for (const auto& [node, share] :
             {std::pair("tangent", std::cos(angle)), std::pair("bitangent", std::sin(angle))}) {
            nodes_ += fmt::format(
                "  <{0} name=\"{1}_{0}\" type=\"vector3\">\n{2}  </{0}>\n"
                "  <multiply name=\"{1}_{0}_part\" type=\"vector3\">\n{3}{4}  </multiply>\n",
                node, turned, inputText("space", "string", "world"),
                linkText("in1", "vector3", fmt::format("{}_{}", turned, node)),
                inputText("in2", "float", shortestFloatText(share + 0.0))); // no -0
        }
        nodes_ += fmt::format("  <add name=\"{0}\" type=\"vector3\">\n{1}{2}  </add>\n", turned,
                              linkText("in1", "vector3", turned + "_tangent_part"),
                              linkText("in2", "vector3", turned + "_bitangent_part"));
        inputs_ += linkText("geometry_tangent", "vector3", turned);
    }

    /// OpenPBR squares its roughness; an image of widths goes through a root.
    void writeRoughness() {
        if (look_.material.hasGrain()) {
            writeGrain();
            return;
        }
        const TextureUse* image = look_.image("alpha");
        std::string node = image == nullptr ? std::string() : imageNode("alpha", "float");
        if (!node.empty()) {
            const bool isOfRoots = image->colorSpace == TextureColorSpace::Roots;
            if (!isOfRoots) {
                const std::string root = name("alpha_root");
                nodes_ += fmt::format("  <sqrt name=\"{}\" type=\"float\">\n{}  </sqrt>\n", root,
                                      linkText("in", "float", node));
                node = root;
            }
            product("specular_roughness", "alpha", node, std::sqrt(imageFactor(look_, "alpha").x));
            look_.tellOf("alpha", Kept::Exact,
                         isOfRoots ? "specular_roughness, its image as it is"
                                   : "specular_roughness, the root of its image");
            return;
        }
        const double roughness = std::sqrt(look_.value("alpha").x);
        inputs_ += inputText("specular_roughness", "float", shortestFloatText(roughness));
        look_.tellOf("alpha", Kept::Exact,
                     fmt::format("specular_roughness {}, its root", shortestFloatText(roughness)));
    }

    void writeGlow() {
        const glm::dvec3 glow = imageFactor(look_, "emissive");
        const double brightest = std::max({glow.x, glow.y, glow.z});
        if (brightest <= 0.0) {
            drop("emissive");
            return;
        }
        inputs_ += inputText("emission_luminance", "float", shortestFloatText(brightest));
        look_.material.values["emissive"] = glow / brightest;
        if (TextureUse* image = look_.image("emissive")) {
            image->mode = TextureMode::Multiply;
        }
        color("emission_color", "emissive", Kept::Approximated,
              ", its brightness taken for candelas per square metre");
    }

    void writeOpacity() {
        if (look_.isTransmissive()) {
            drop("opacity");
            return;
        }
        if (look_.material.values.contains("opacity")) {
            inputs_ +=
                inputText("geometry_opacity", "float", shortestFloatText(look_.value("opacity").x));
            look_.tellOf("opacity", Kept::Exact, "geometry_opacity");
        }
        const TextureUse* image = look_.image("opacity");
        if (image == nullptr) {
            return;
        }
        const bool isAlpha =
            image->channel == TextureChannel::Auto || image->channel == TextureChannel::Alpha;
        if (isAlpha || look_.material.values.contains("opacity")) {
            drop("opacity");
            return;
        }
        if (const std::string node = imageNode("opacity", "float"); !node.empty()) {
            inputs_ += linkText("geometry_opacity", "float", node);
        }
    }

    void writeNormals() {
        TextureUse* image = look_.image("normal");
        if (image == nullptr) {
            return;
        }
        const double strength = std::exchange(image->strength, 1.0);
        const std::string node = imageNode("normal", "vector3");
        if (!node.empty()) {
            const std::string map = name("normalmap");
            nodes_ +=
                fmt::format("  <normalmap name=\"{}\" type=\"vector3\">\n{}{}  </normalmap>\n", map,
                            linkText("in", "vector3", node),
                            inputText("scale", "float", shortestFloatText(strength)));
            inputs_ += linkText("geometry_normal", "vector3", map);
        }
    }

    void dropHeight() {
        if (const TextureUse* image = look_.image("height")) {
            look_.tell(Kept::Dropped, imageTitle(*image), "raises the surface");
        }
    }

    void drop(const std::string& word) {
        if (const TextureUse* image = look_.image(word)) {
            look_.tell(Kept::Dropped, imageTitle(*image),
                       fmt::format("drives {}, which takes no image here",
                                   look_.labels.contains(word) ? look_.labels[word] : word));
        }
    }

    /// Writes a colour, or its image times the colour.
    void color(const char* input, const std::string& word, Kept kept, const std::string& note) {
        const glm::dvec3 factor = imageFactor(look_, word);
        look_.tellOf(word, kept, input + note);
        const std::string node =
            look_.images.contains(word) ? imageNode(word, "color3") : std::string();
        if (node.empty()) {
            inputs_ += inputText(input, "color3", colorText(look_.value(word)));
        } else if (factor == glm::dvec3(1.0)) {
            inputs_ += linkText(input, "color3", node);
        } else {
            const std::string product = name(word + "_product");
            nodes_ += fmt::format("  <multiply name=\"{}\" type=\"color3\">\n{}{}  </multiply>\n",
                                  product, linkText("in1", "color3", node),
                                  inputText("in2", "color3", colorText(factor)));
            inputs_ += linkText(input, "color3", product);
        }
    }

    /// Writes the node of an image and what places it, and returns the node's name; empty where the
    /// image is dropped.
    std::string imageNode(const std::string& word, const char* type) {
        const TextureUse& use = look_.images.at(word);
        const auto path = images_.add(use.file, {});
        if (!path || isAdded(use)) {
            look_.tell(Kept::Dropped, imageTitle(use),
                       path ? "is added to the value" : path.error().text());
            return {};
        }
        const bool isColor = std::string_view(type) == "color3";
        const int part = std::string_view(type) == "float" ? partOf(use.channel) : -1;
        const std::string place = isUnplaced(use) ? std::string() : placeNode(word, use);
        std::string image = name(word + "_image");
        nodes_ += fmt::format(
            "  <image name=\"{}\" type=\"{}\">\n"
            "    <input name=\"file\" type=\"filename\" value=\"{}\" colorspace=\"{}\"/>\n{}"
            "  </image>\n",
            image, part < 0 ? type : "color3", escapedForXml(*path),
            isColor ? "srgb_texture" : "lin_rec709",
            place.empty() ? std::string() : linkText("texcoord", "vector2", place));
        TextureUse whole = use;
        whole.strength = 1.0; // which mixNode() writes
        if (!isColor) {
            whole.colorSpace = TextureColorSpace::Auto; // its numbers are taken as they are
        }
        if (part >= 0) {
            image = partNode(word, image, part);
            whole.channel = TextureChannel::Auto;
        }
        const std::string lost = lostSettings(whole);
        look_.tell(lost.empty() ? Kept::Exact : Kept::Approximated, imageTitle(use),
                   lost.empty() ? *path : fmt::format("{}, without {}", *path, lost));
        return use.strength == 1.0 ? image : mixNode(word, type, image, use);
    }

    /// Returns the index of a channel of red, green and blue; -1 for others, which are an image of
    /// one channel or are lost.
    static int partOf(TextureChannel channel) {
        return channel == TextureChannel::Red     ? 0
               : channel == TextureChannel::Green ? 1
               : channel == TextureChannel::Blue  ? 2
                                                  : -1;
    }

    std::string partNode(const std::string& word, const std::string& image, int part) {
        const std::string extracted = name(word + "_channel");
        nodes_ += fmt::format("  <extract name=\"{}\" type=\"float\">\n{}{}  </extract>\n",
                              extracted, linkText("in", "color3", image),
                              inputText("index", "integer", std::to_string(part)));
        return extracted;
    }

    /// Writes how much of an image shows, of the value or of white behind it.
    std::string mixNode(const std::string& word, std::string_view type, const std::string& image,
                        const TextureUse& use) {
        const bool isReplaced = use.mode == TextureMode::Replace;
        const glm::dvec3 behind = isReplaced ? look_.value(word) : glm::dvec3(1.0);
        const std::string mixed = name(word + "_mix");
        nodes_ += fmt::format(
            "  <mix name=\"{}\" type=\"{}\">\n{}{}{}  </mix>\n", mixed, type,
            linkText("fg", type, image),
            inputText("bg", type,
                      type == "color3" ? colorText(behind) : shortestFloatText(behind.x)),
            inputText("mix", "float", shortestFloatText(use.strength)));
        return mixed;
    }

    /// Writes where an image is as two products with the mesh's coordinates, which leave open no
    /// question of signs and orders.
    std::string placeNode(const std::string& word, const TextureUse& use) {
        const std::string uv = name(word + "_uv");
        nodes_ += fmt::format("  <texcoord name=\"{}\" type=\"vector2\"/>\n", uv);
        const TexturePlace place = texturePlace(use);
        for (const auto& [part, row] : {std::pair("u", place.across), std::pair("v", place.up)}) {
            const std::string dot = name(fmt::format("{}_{}_dot", word, part));
            const std::string sum = name(fmt::format("{}_{}", word, part));
            nodes_ +=
                fmt::format("  <dotproduct name=\"{}\" type=\"float\">\n{}{}  </dotproduct>\n"
                            "  <add name=\"{}\" type=\"float\">\n{}{}  </add>\n",
                            dot, linkText("in1", "vector2", uv),
                            inputText("in2", "vector2",
                                      fmt::format("{}, {}", shortestFloatText(row.x + 0.0), // no -0
                                                  shortestFloatText(row.y + 0.0))),
                            sum, linkText("in1", "float", dot),
                            inputText("in2", "float", shortestFloatText(row.z)));
        }
        const std::string both = name(word + "_place");
        nodes_ += fmt::format("  <combine2 name=\"{}\" type=\"vector2\">\n{}{}  </combine2>\n",
                              both, linkText("in1", "float", name(word + "_u")),
                              linkText("in2", "float", name(word + "_v")));
        return both;
    }

    std::string name(const std::string& part) const { return look_.material.name + '_' + part; }

    ExportedLook& look_;
    ExportImages& images_;
    std::string nodes_;
    std::string inputs_;
};

} // namespace

std::string writeMaterialX(std::vector<ExportedLook>& materials, ExportImages& images) {
    std::string text = "<?xml version=\"1.0\"?>\n"
                       "<materialx version=\"1.39\" colorspace=\"lin_rec709\">\n";
    for (ExportedLook& look : materials) {
        text += MaterialXMaterial(look, images).write();
    }
    return text + "</materialx>\n";
}

} // namespace patina
