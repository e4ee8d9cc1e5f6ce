// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <iterator>
#include <optional>
#include <set>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/exchange_keys.h"
#include "core/fnv_hash.h"
#include "core/grain_widths.h"
#include "core/number_text.h"
#include "exchange/dielectric_index.h"
#include "exchange/format_writers.h"
#include "exchange/image_settings.h"
#include "material/texture_place.h"
#include "scene/builtin_mesh.h"

namespace patina {
namespace {

using Json = nlohmann::json;

static_assert(std::endian::native == std::endian::little, "glTF's buffers are so");

constexpr double ballDistance = 2.5;
constexpr int floatType = 5126;
constexpr int indexType = 5125;
constexpr int vertexTarget = 34962;
constexpr int indexTarget = 34963;
constexpr int repeatWrap = 10497;
constexpr int clampWrap = 33071;
constexpr int mirrorWrap = 33648;
constexpr int nearestFilter = 9728;
constexpr int linearFilter = 9729;
constexpr int mipmapFilter = 9987;

Json colorJson(const glm::dvec3& color) {
    return Json::array({color.x, color.y, color.z});
}

/// Gathers a file: materials, images, samplers and a buffer that all share.
class GltfFile {
  public:
    GltfFile(ExportImages& images, bool isBinary) : images_(images), isBinary_(isBinary) {
        document_["asset"] = {{"version", "2.0"}, {"generator", "Patina"}};
    }

    void addExtension(const std::string& name) { extensions_.insert(name); }

    /// Returns {"index": n} of an image, with its place; null where it is dropped, which is told.
    Json texture(ExportedLook& look, const std::string& word) {
        const TextureUse* found = look.image(word);
        if (found == nullptr) {
            return nullptr;
        }
        const TextureUse& use = *found;
        const auto path = images_.add(use.file, {".png", ".jpg", ".jpeg"});
        if (!path || isAdded(use)) {
            look.tell(Kept::Dropped, imageTitle(use),
                      path ? "is added to the value" : path.error().text());
            return nullptr;
        }
        std::string lost = lostSettings(use);
        Json json = placed(use, imageIndex(*path, fileNameOf(*path)), lost);
        look.tell(lost.empty() ? Kept::Exact : Kept::Approximated, imageTitle(use),
                  lost.empty() ? *path : fmt::format("{}, without {}", *path, lost));
        return json;
    }

    /// Returns the same of the image that has the roots of a highlight's widths in green and the
    /// metalness in blue, made of the images on the values of these two words; empty for none.
    Json metallicRoughnessTexture(ExportedLook& look, const std::string& widths,
                                  const std::string& metalness) {
        std::vector<std::string> words;
        std::ranges::copy_if(std::array{widths, metalness}, std::back_inserter(words),
                             [](const std::string& word) { return !word.empty(); });
        const auto numbers = [&look](const std::string& word) {
            return word.empty() ? std::nullopt
                                : std::optional(ExportImages::Numbers{look.images.at(word),
                                                                      look.channels.at(word)});
        };
        const auto path = images_.addMetallicRoughness(numbers(widths), numbers(metalness));
        if (!path) {
            for (const std::string& word : words) {
                look.tell(Kept::Dropped, imageTitle(look.images.at(word)), path.error().text());
            }
            return nullptr;
        }
        std::string lost;
        const std::string name = metalness.empty() ? roughnessAlone : fileNameOf(*path);
        Json json = placed(look.images.at(words.front()), imageIndex(*path, name), lost);
        for (const std::string& word : words) {
            look.tell(lost.empty() ? Kept::Exact : Kept::Approximated,
                      imageTitle(look.images.at(word)),
                      fmt::format("the {} of {}{}", word == widths ? "green" : "blue", *path,
                                  lost.empty() ? "" : ", without " + lost));
        }
        return json;
    }

    /// Returns what the image of a texture in a material is: its URI, or the hash of its content
    /// inside the file; empty for none.
    std::string imageOf(const Json& material, const Json::json_pointer& texture) const {
        if (!material.contains(texture)) {
            return {};
        }
        const std::size_t index = material.at(texture).at("index");
        const std::size_t source = document_.at("textures").at(index).at("source");
        const Json& image = document_.at("images").at(source);
        if (image.contains("uri")) {
            return image.at("uri");
        }
        const std::size_t viewIndex = image.at("bufferView");
        const Json& view = document_.at("bufferViews").at(viewIndex);
        const std::size_t offset = view.at("byteOffset");
        const std::size_t length = view.at("byteLength");
        return contentHash(std::string_view(buffer_).substr(offset, length));
    }

    /// Gives the images of a preset their paths in the export, or hashes where they are inside the
    /// file, and leaves out those that are not files there.
    void nameImages(Json& textures) {
        const std::vector<std::string_view> inside{".png", ".jpg", ".jpeg"};
        Json named = Json::object();
        for (const auto& [key, use] : textures.items()) {
            const auto path = images_.add(use.value("file", std::string()),
                                          isBinary_ ? inside : std::vector<std::string_view>());
            if (path) {
                named[key] = use;
                named[key]["file"] = *path;
                if (isBinary_) {
                    imageIndex(*path, fileNameOf(*path));
                    named[key]["file"] = insidePrefix + contentHash(images_.bytes(*path));
                }
            }
        }
        textures = std::move(named);
    }

    void addMaterial(const Json& material) { document_["materials"].push_back(material); }

    /// Adds a ball for each material, one beside the other.
    Result<void> addBalls() {
        Object object;
        object.mesh = "builtin:sphere";
        const auto ball = builtinMesh(object);
        if (!ball) {
            return tl::unexpected(ball.error());
        }
        const Json attributes = attributesOf(*ball);
        const int indices = addAccessor(
            bytesOf(ball->indices), indexTarget,
            {{"componentType", indexType}, {"count", ball->indices.size()}, {"type", "SCALAR"}});
        for (std::size_t i = 0; i < document_["materials"].size(); ++i) {
            const Json& name = document_["materials"][i]["name"];
            document_["meshes"].push_back(
                {{"name", name},
                 {"primitives",
                  {{{"attributes", attributes}, {"indices", indices}, {"material", i}}}}});
            document_["nodes"].push_back({{"name", name},
                                          {"mesh", i},
                                          {"translation", {ballDistance * double(i), 0.0, 0.0}}});
            document_["scenes"][0]["nodes"].push_back(i);
        }
        document_["scene"] = 0;
        return {};
    }

    /// Returns the text; the buffer lies in a file of this name, or follows where it has none.
    std::string text(const std::string& bufferName) {
        if (!extensions_.empty()) {
            document_["extensionsUsed"] = extensions_;
        }
        Json buffer{{"byteLength", buffer_.size()}};
        if (!bufferName.empty()) {
            buffer["uri"] = bufferName;
        }
        document_["buffers"] = Json::array({buffer});
        return document_.dump(isBinary_ ? -1 : 2) + (isBinary_ ? "" : "\n");
    }

    const std::string& buffer() const { return buffer_; }

  private:
    template <class T>
    static std::string bytesOf(const std::vector<T>& numbers) {
        std::string bytes(numbers.size() * sizeof(T), '\0');
        std::memcpy(bytes.data(), numbers.data(), bytes.size());
        return bytes;
    }

    Json attributesOf(const Mesh& ball) {
        std::vector<glm::vec3> positions;
        std::vector<glm::vec3> normals;
        std::vector<glm::vec2> places;
        for (const Vertex& vertex : ball.vertices) {
            positions.push_back(vertex.position);
            normals.push_back(vertex.normal);
            places.emplace_back(vertex.uv.x, 1.0f - vertex.uv.y); // counted from an image's top
        }
        const glm::vec3 lower = ball.bounds.lower;
        const glm::vec3 upper = ball.bounds.upper;
        const auto accessor = [&](const char* type) {
            return Json{
                {"componentType", floatType}, {"count", ball.vertices.size()}, {"type", type}};
        };
        Json bounded = accessor("VEC3");
        bounded["min"] = {lower.x, lower.y, lower.z};
        bounded["max"] = {upper.x, upper.y, upper.z};
        return {{"POSITION", addAccessor(bytesOf(positions), vertexTarget, bounded)},
                {"NORMAL", addAccessor(bytesOf(normals), vertexTarget, accessor("VEC3"))},
                {"TEXCOORD_0", addAccessor(bytesOf(places), vertexTarget, accessor("VEC2"))}};
    }

    int addAccessor(const std::string& bytes, int target, Json accessor) {
        accessor["bufferView"] = addView(bytes);
        document_["bufferViews"].back()["target"] = target;
        document_["accessors"].push_back(std::move(accessor));
        return static_cast<int>(document_["accessors"].size()) - 1;
    }

    int addView(const std::string& bytes) {
        document_["bufferViews"].push_back(
            {{"buffer", 0}, {"byteOffset", buffer_.size()}, {"byteLength", bytes.size()}});
        buffer_ += bytes;
        buffer_.resize((buffer_.size() + 3) / 4 * 4, '\0');
        return static_cast<int>(document_["bufferViews"].size()) - 1;
    }

    /// Returns the index of an element of a list, which is added unless it is there.
    int indexIn(const char* list, const Json& element) {
        Json& all = document_[list];
        for (std::size_t i = 0; i < all.size(); ++i) {
            if (all[i] == element) {
                return static_cast<int>(i);
            }
        }
        all.push_back(element);
        return static_cast<int>(all.size()) - 1;
    }

    /// Returns what names an image where a material uses it, with its place.
    Json placed(const TextureUse& use, int image, std::string& lost) {
        const Json texture{{"source", image}, {"sampler", samplerIndex(use)}};
        Json json{{"index", indexIn("textures", texture)}};
        if (!isUnplaced(use)) {
            place(json, use, lost);
        }
        return json;
    }

    int imageIndex(const std::string& path, const std::string& name) {
        if (!isBinary_) {
            return indexIn("images", {{"uri", path}, {"name", name}});
        }
        const auto known = inside_.find(path);
        if (known != inside_.end()) {
            return known->second;
        }
        const bool isPng = path.ends_with(".png");
        const Json image{{"bufferView", addView(images_.bytes(path))},
                         {"mimeType", isPng ? "image/png" : "image/jpeg"},
                         {"name", name}};
        return inside_[path] = indexIn("images", image);
    }

    int samplerIndex(const TextureUse& use) {
        const bool isNearest = use.filter == TextureFilter::Nearest;
        const int wrap = use.wrap == TextureWrap::Repeat  ? repeatWrap
                         : use.wrap == TextureWrap::Clamp ? clampWrap
                                                          : mirrorWrap;
        return indexIn("samplers", {{"magFilter", isNearest ? nearestFilter : linearFilter},
                                    {"minFilter", isNearest ? nearestFilter : mipmapFilter},
                                    {"wrapS", wrap},
                                    {"wrapT", wrap}});
    }

    /// Writes the place of an image by KHR_texture_transform, whose coordinates begin at the top:
    /// it scales, then turns, so that a turned image has one scale.
    void place(Json& json, const TextureUse& use, std::string& lost) {
        const bool isSheared = use.rotation != 0.0 && use.scale.x != use.scale.y;
        TextureUse placed = use;
        placed.rotation = isSheared ? 0.0 : use.rotation;
        if (isSheared) {
            lost += (lost.empty() ? "" : ", ") + std::string("its rotation");
        }
        const TexturePlace rows = texturePlace(placed);
        addExtension("KHR_texture_transform");
        json["extensions"]["KHR_texture_transform"] = {
            {"offset", {rows.across.y + rows.across.z, 1.0 - rows.up.y - rows.up.z}},
            {"rotation", std::atan2(rows.up.x, rows.up.y)},
            {"scale", {placed.scale.x, placed.scale.y}}};
    }

    ExportImages& images_;
    bool isBinary_;
    Json document_ = Json::object();
    std::string buffer_;
    std::set<std::string> extensions_;
    std::map<std::string, int> inside_; ///< maps an image in the buffer to its index
};

/// Writes one material of a glTF file.
class GltfMaterial {
  public:
    GltfMaterial(ExportedLook& look, GltfFile& file) : look_(look), file_(file) {}

    Json write() {
        material_["name"] = look_.material.name;
        Json& base = material_["pbrMetallicRoughness"];
        const std::string colorWord = look_.isTransmissive()     ? "transmission"
                                      : look_.material.isMetal() ? "f0"
                                                                 : "diffuse";
        base["metallicFactor"] = look_.material.isMetal() ? 1.0 : 0.0; // unless it is mixed
        const Json colors = file_.texture(look_, colorWord);
        const glm::dvec3 color = factorOf(colorWord, colors);
        const double opacity =
            look_.isTransmissive() ? 1.0 : look_.value("opacity", glm::dvec3(1.0)).x;
        base["baseColorFactor"] = {color.x, color.y, color.z, opacity};
        const bool isDarkened = !look_.isTransmissive() && look_.material.isDielectric() &&
                                look_.value("f0") != glm::dvec3(0.0);
        look_.tellOf(colorWord, isDarkened ? Kept::Approximated : Kept::Exact,
                     isDarkened ? "baseColorFactor, darker where the highlight takes its light"
                                : "baseColorFactor");
        if (!colors.is_null()) {
            base["baseColorTexture"] = colors;
        }
        writeHighlight(base);
        writeTransmission();
        writeGlow();
        writeOpacity(base.contains("baseColorTexture") ? colorWord : std::string());
        writeNormals();
        drop("height", "raises the surface");
        writeForeign();
        writePreset();
        return material_;
    }

  private:
    /// Returns what the image on a value is multiplied with; the value itself where it is not
    /// written.
    glm::dvec3 factorOf(const std::string& word, const Json& texture) const {
        return texture.is_null() ? look_.value(word) : imageFactor(look_, word);
    }

    void writeHighlight(Json& base) {
        if (look_.material.look == "matte") {
            base["roughnessFactor"] = 1.0;
            extension("KHR_materials_specular")["specularFactor"] = 0.0;
            return;
        }
        if (look_.material.hasGrain()) {
            writeGrain(base);
        } else {
            writeRoughness(base);
        }
        if (!look_.material.isMetal()) {
            writeReflectance();
        }
    }

    /// Returns the word where the image on its value is one of numbers that glTF has; empty where
    /// there is none.
    std::string imageOfNumbers(const std::string& word) const {
        const TextureUse* image = look_.image(word);
        return image != nullptr && !isAdded(*image) && image->strength == 1.0 ? word
                                                                              : std::string();
    }

    /// Writes the metalness and the width, whose images lie alike, for they are one.
    void writeRoughness(Json& base) {
        const std::string widths = imageOfNumbers("alpha");
        std::string metalness = imageOfNumbers("metalness");
        if (widths.empty()) {
            drop("alpha", "counts in part, or is added to the width");
        }
        if (metalness.empty()) {
            drop("metalness", "counts in part, or is added to the metalness");
        } else if (!widths.empty() && !liesAs(*look_.image("alpha"), *look_.image("metalness"))) {
            drop("metalness", "lies otherwise than that on the roughness, with which it is one");
            metalness.clear();
        }
        Json texture;
        if (!widths.empty() || !metalness.empty()) {
            texture = file_.metallicRoughnessTexture(look_, widths, metalness);
        }
        const double roughness = std::sqrt(factorOf("alpha", widths.empty() ? Json() : texture).x);
        base["roughnessFactor"] = roughness;
        look_.tellOf("alpha", Kept::Exact,
                     fmt::format("roughnessFactor {}, its root", shortestFloatText(roughness)));
        if (look_.material.hasMetalness()) {
            const double share = factorOf("metalness", metalness.empty() ? Json() : texture).x;
            base["metallicFactor"] = share;
            look_.tellOf("metalness", Kept::Exact,
                         fmt::format("metallicFactor {}", shortestFloatText(share)));
        }
        if (!texture.is_null()) {
            base["metallicRoughnessTexture"] = std::move(texture);
        }
    }

    /// Writes a highlight that is long across a grain: its width there lies between the one along
    /// the grain and 1, at the square of the strength.
    void writeGrain(Json& base) {
        const GrainWidths widths = widthsOf({look_.value("alpha").x, look_.value("anisotropy").x});
        const double along = std::min(widths.along, 1.0);
        const double across = std::min(widths.across, 1.0);
        const double strength = along < 1.0 ? std::sqrt((across - along) / (1.0 - along)) : 0.0;
        base["roughnessFactor"] = std::sqrt(along);
        Json& grain = extension("KHR_materials_anisotropy");
        grain["anisotropyStrength"] = strength;
        grain["anisotropyRotation"] = streakAcross(look_.value("grain").x);
        const bool isCut = across < widths.across;
        look_.tellOf("alpha", isCut ? Kept::Approximated : Kept::Exact,
                     isCut
                         ? "roughnessFactor; glTF has no widths above 1"
                         : fmt::format("roughnessFactor {}, the root of the width along the grain",
                                       shortestFloatText(std::sqrt(along))));
        look_.tellOf("anisotropy", isCut ? Kept::Approximated : Kept::Exact,
                     fmt::format("KHR_materials_anisotropy {}", shortestFloatText(strength)));
        look_.tellOf("grain", Kept::Exact,
                     "KHR_materials_anisotropy, which turns across the grain");
        drop("alpha", "drives a width that a grain has in two directions");
        drop("anisotropy", "drives an anisotropy, which takes another image in glTF");
    }

    void writeReflectance() {
        const glm::dvec3 f0 = look_.value("f0");
        constexpr double usual = 0.04; // of glTF 2.0, appendix B.2.1
        const bool isUsual = glm::vec3(f0) == glm::vec3(float(usual));
        std::string how = "that of every dielectric";
        if (!isUsual) {
            const DielectricIndex index = dielectricIndexOf(f0);
            extension("KHR_materials_ior")["ior"] = index.ior;
            how = fmt::format("KHR_materials_ior {}", shortestFloatText(index.ior));
            if (index.tint != glm::dvec3(1.0)) {
                extension("KHR_materials_specular")["specularColorFactor"] = colorJson(index.tint);
                how += ", KHR_materials_specular";
            }
        }
        look_.tellOf("f0", Kept::Exact, how);
        drop("f0", "drives the reflectance, which has no image of ours");
    }

    /// Writes what refracts. A pane has no volume, and absorbs nothing then.
    void writeTransmission() {
        if (!look_.isTransmissive()) {
            return;
        }
        const double share = 1.0 - look_.value("opacity", glm::dvec3(1.0)).x;
        extension("KHR_materials_transmission")["transmissionFactor"] = share;
        look_.tellOf("opacity", Kept::Exact, "KHR_materials_transmission");
        if (look_.value("diffuse") != glm::dvec3(0.0)) {
            look_.tellOf("diffuse", Kept::Dropped, "the base colour is that of what passes");
        }
        drop("diffuse", "the base colour is that of what passes");
        if (look_.material.values.contains("thickness")) {
            dropPaneValues();
            return;
        }
        Json& volume = extension("KHR_materials_volume");
        volume["thicknessFactor"] = 1.0; // of the ball, half of its diameter
        volume["attenuationColor"] = colorJson(look_.value("attenuation.color"));
        volume["attenuationDistance"] = look_.value("attenuation.distance").x;
        look_.tellOf("attenuation.color", Kept::Exact, "KHR_materials_volume");
        look_.tellOf("attenuation.distance", Kept::Exact, "KHR_materials_volume");
        if (const double dispersion = look_.value("dispersion").x; dispersion > 0.0) {
            extension("KHR_materials_dispersion")["dispersion"] = dispersion;
            look_.tellOf("dispersion", Kept::Exact, "KHR_materials_dispersion");
        }
    }

    void dropPaneValues() {
        look_.tellOf("thickness", Kept::Approximated, "a wall without a thickness");
        if (look_.value("attenuation.color") != glm::dvec3(1.0)) {
            look_.tellOf("attenuation.color", Kept::Dropped,
                         "a wall without a thickness absorbs nothing");
        }
    }

    void writeGlow() {
        const glm::dvec3 glow = imageFactor(look_, "emissive");
        const double brightest = std::max({glow.x, glow.y, glow.z, 1.0});
        if (glow == glm::dvec3(0.0)) {
            drop("emissive", "drives a glow that is black");
            return;
        }
        material_["emissiveFactor"] = colorJson(glow / brightest);
        if (brightest > 1.0) {
            extension("KHR_materials_emissive_strength")["emissiveStrength"] = brightest;
        }
        if (const Json texture = file_.texture(look_, "emissive"); !texture.is_null()) {
            material_["emissiveTexture"] = texture;
        }
        look_.tellOf("emissive", Kept::Exact,
                     brightest > 1.0 ? "emissiveFactor, KHR_materials_emissive_strength"
                                     : "emissiveFactor");
    }

    /// Writes the opacity, and its image if it is the alpha of the colour's.
    void writeOpacity(const std::string& colorWord) {
        if (look_.isTransmissive()) {
            drop("opacity", "is told by a transmission without images");
            return;
        }
        const TextureUse* image = look_.image("opacity");
        const bool isInColor = image != nullptr && !colorWord.empty() &&
                               look_.images.at(colorWord).file == image->file;
        if (look_.material.values.contains("opacity") || isInColor) {
            const bool isCut = isInColor && image->cutOut;
            material_["alphaMode"] = isCut ? "MASK" : "BLEND";
            if (isCut) {
                material_["alphaCutoff"] = image->threshold;
            }
            look_.tellOf("opacity", Kept::Exact, "the alpha of baseColorFactor");
        }
        if (isInColor) {
            look_.tell(Kept::Exact, "Opacity image", "the alpha of the colour's image");
        } else {
            drop("opacity", "is not the alpha of the colour's image");
        }
    }

    void writeNormals() {
        TextureUse* image = look_.image("normal");
        if (image == nullptr) {
            return;
        }
        const double strength = std::exchange(image->strength, 1.0);
        if (Json texture = file_.texture(look_, "normal"); !texture.is_null()) {
            if (strength != 1.0) {
                texture["scale"] = strength;
            }
            material_["normalTexture"] = std::move(texture);
        }
    }

    /// Writes back what came with a glTF file and only other programs know.
    void writeForeign() {
        const Json all = look_.preset.value("extras", Json::object());
        const Json foreign = all.value(foreignKey, Json::object());
        const auto in = [&foreign](const char* key) {
            const Json value = foreign.is_object() ? foreign.value(key, Json()) : Json();
            return value.is_object() ? value : Json::object();
        };
        const Json extensions = in("extensions");
        const Json extras = in("extras");
        for (const auto& [name, value] : extensions.items()) {
            if (!material_.contains("extensions") || !material_["extensions"].contains(name)) {
                static_cast<Json&>(extension(name.c_str())) = value;
            }
        }
        for (const auto& [key, value] : extras.items()) {
            material_["extras"][key] = value;
        }
    }

    /// Writes the preset itself, which comes back as it was while nobody changes the factors.
    void writePreset() {
        Json preset = look_.preset;
        file_.nameImages(preset["textures"]);
        const Json& base = material_["pbrMetallicRoughness"];
        Json written = base["baseColorFactor"];
        for (int i = 0; i < 3; ++i) {
            written.push_back(material_.contains("emissiveFactor") ? material_["emissiveFactor"][i]
                                                                   : Json(0.0));
        }
        written.push_back(base["metallicFactor"]);
        written.push_back(base["roughnessFactor"]);
        Json images = Json::array();
        for (const char* texture : {"/pbrMetallicRoughness/baseColorTexture",
                                    "/pbrMetallicRoughness/metallicRoughnessTexture",
                                    "/normalTexture", "/emissiveTexture"}) {
            images.push_back(file_.imageOf(material_, Json::json_pointer(texture)));
        }
        material_["extras"][ownExtras] = {{presetKey, std::move(preset)},
                                          {writtenKey, std::move(written)},
                                          {imagesKey, std::move(images)}};
    }

    void drop(const std::string& word, const std::string& why) {
        if (const TextureUse* image = look_.image(word)) {
            look_.tell(Kept::Dropped, imageTitle(*image), why);
        }
    }

    Json& extension(const char* name) {
        file_.addExtension(name);
        return material_["extensions"][name];
    }

    ExportedLook& look_;
    GltfFile& file_;
    Json material_ = Json::object();
};

void addAll(GltfFile& file, std::vector<ExportedLook>& materials) {
    for (ExportedLook& look : materials) {
        file.addMaterial(GltfMaterial(look, file).write());
    }
    if (const auto added = file.addBalls(); !added) {
        for (ExportedLook& look : materials) {
            look.tell(Kept::Dropped, "Ball", added.error().text());
        }
    }
}

void addNumber(std::string& bytes, std::uint32_t number) {
    for (int shift = 0; shift < 32; shift += 8) {
        bytes += static_cast<char>(number >> shift & 0xffu);
    }
}

void addChunk(std::string& bytes, std::uint32_t type, std::string content, char filler) {
    content.resize((content.size() + 3) / 4 * 4, filler);
    addNumber(bytes, static_cast<std::uint32_t>(content.size()));
    addNumber(bytes, type);
    bytes += content;
}

} // namespace

std::string writeGltf(std::vector<ExportedLook>& materials, ExportImages& images,
                      const std::string& bufferName, std::string& buffer) {
    GltfFile file(images, false);
    addAll(file, materials);
    buffer = file.buffer();
    return file.text(bufferName);
}

std::string writeGlb(std::vector<ExportedLook>& materials, ExportImages& images) {
    constexpr std::uint32_t magic = 0x46546c67;
    constexpr std::uint32_t jsonChunk = 0x4e4f534a;
    constexpr std::uint32_t binaryChunk = 0x004e4942;
    constexpr std::uint32_t headerBytes = 12;
    GltfFile file(images, true);
    addAll(file, materials);
    std::string chunks;
    addChunk(chunks, jsonChunk, file.text({}), ' ');
    addChunk(chunks, binaryChunk, file.buffer(), '\0');
    std::string bytes;
    addNumber(bytes, magic);
    addNumber(bytes, 2);
    addNumber(bytes, headerBytes + static_cast<std::uint32_t>(chunks.size()));
    return bytes + chunks;
}

} // namespace patina
