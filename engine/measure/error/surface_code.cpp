// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/error/surface_code.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "shading/effects/effect_set.h"
#include "shading/effects/surface_buffer_layout.h"
#include "shading/program/compiled_block.h"

namespace patina {
namespace {

constexpr std::size_t sharesPerValue = 4;

/// Is the largest half float, at which programs clamp light.
constexpr double maxLight = 65504.0;

std::vector<double> widened(std::span<const glm::vec4> data, std::size_t first,
                            std::size_t floats) {
    std::vector<double> values(floats);
    for (std::size_t i = 0; i < floats; ++i) {
        values[i] = double(data[first + i / 4][static_cast<int>(i % 4)]);
    }
    return values;
}

Result<SurfaceCode::BlockCode> codeAt(const BlockPlace& place, std::span<const glm::vec4> data,
                                      std::size_t first) {
    return compiledBlock(*place.block).map([&](const reference::Block* code) {
        return SurfaceCode::BlockCode{code, widened(data, first, place.layout.floats)};
    });
}

const ParameterField* fieldOf(const BlockPlace& place, std::string_view name) {
    const auto found = std::ranges::find_if(
        place.layout.fields, [name](const ParameterField& field) { return field.name == name; });
    return found == place.layout.fields.end() ? nullptr : &*found;
}

/// Sets accuracy choices to the levels that the program has, which may differ from the material's.
void takeLevels(std::vector<double>& values, const BlockPlace& place, const BlockUse& use) {
    for (const ParameterField& field : place.layout.fields) {
        const bool hasLevel = field.choice != nullptr && !field.choice->values.empty();
        if (hasLevel && field.offset < values.size()) {
            const EnumValue* level = &use.level(*field.choice);
            values[field.offset] = static_cast<double>(level - field.choice->values.data());
        }
    }
}

/// Collects an object's code, block by block.
class Collector {
  public:
    Collector(std::size_t index, const SurfaceBuffer& buffer, const BufferedScene* around)
        : index_(index), object_(buffer.objects[index]), buffer_(buffer), around_(around),
          layout_(object_.pipeline->object), effects_(object_.pipeline->effects) {}

    Result<SurfaceCode> collect() {
        if (auto whole = checkWhole(); !whole) {
            return tl::unexpected(whole.error());
        }
        code_.eye = glm::dvec3(buffer_.eye);
        code_.firstShare = object_.firstShare;
        if (isLitByEnvironment(effects_)) {
            code_.firstSample = object_.firstSample;
            code_.isSampled = !takesKeyAlone(effects_);
        }
        code_.isSampled = code_.isSampled || (code_.facets && code_.facets->isSampled());
        code_.openness = opennessValue(effects_);
        code_.slots = layout_.slots.size();
        code_.blends = effects_.blend.has_value();
        addBlock(*layout_.model, *effects_.model);
        for (std::size_t i = 0; i < layout_.slots.size(); ++i) {
            addBlock(layout_.slots[i], effects_.slots[i]);
        }
        addPolarised();
        if (effects_.blend) {
            addBlock(*layout_.part(kinds::fresnel), *effects_.blend);
        }
        addImages();
        addPlaces();
        addEmission();
        addDiffuse();
        if (const auto highlight = highlightAmbientData(layout_)) {
            code_.highlightAmbient = glm::dvec3(object_.data[static_cast<std::size_t>(*highlight)]);
        }
        addLights();
        addSurroundings();
        return problem_ ? Result<SurfaceCode>(tl::unexpected(*problem_)) : std::move(code_);
    }

  private:
    /// Follows the rays through a body of facets.
    Result<void> takeRefraction() {
        if (around_ == nullptr) {
            return failure("the object refracts what is seen through it");
        }
        Result<FacetedRays> rays = FacetedRays::of(object_, index_, *around_);
        if (!rays) {
            return tl::unexpected(rays.error());
        }
        code_.facets = std::move(*rays);
        return {};
    }

    Result<void> checkWhole() {
        if (!layout_.model) {
            return failure("an object has a plain fallback for its model");
        }
        if (effects_.refraction) {
            if (auto taken = takeRefraction(); !taken) {
                return taken;
            }
        } else if (isVisiblyTransparent(effects_)) {
            return failure("the object is transparent");
        }
        if (readsCurvature(effects_)) {
            return failure("the object's model is told how the surface bends, which has no code in "
                           "double precision");
        }
        if (const std::string effect = unknownToReference(effects_); !effect.empty()) {
            return failure(
                fmt::format("the object has {}, which has no code in double precision", effect));
        }
        return {};
    }

    SurfaceCode::BlockCode codeOf(const BlockPlace& place, std::span<const glm::vec4> data,
                                  std::size_t first) {
        Result<SurfaceCode::BlockCode> code = codeAt(place, data, first);
        if (!code && !problem_) {
            problem_ = code.error();
        }
        return code ? std::move(*code) : SurfaceCode::BlockCode();
    }

    void addBlock(const BlockPlace& place, const BlockUse& use) {
        code_.blocks.push_back(codeOf(place, object_.data, static_cast<std::size_t>(place.first)));
        takeLevels(code_.blocks.back().values, place, use);
        places_.push_back(&place);
    }

    /// Notes the Fresnel term that answers to polarised light, where there is such.
    void addPolarised() {
        for (std::size_t i = 0; answersPolarisedLight(effects_) && i < code_.slots; ++i) {
            const reference::Block* code = code_.blocks[i + 1].code;
            if (layout_.slots[i].block->kind == kinds::fresnel && code != nullptr) {
                code_.polarised.emplace(
                    SurfaceCode::Polarised{PolarisedTerm(layout_.slots[i], *code), i});
            }
        }
    }

    void addImages() {
        for (std::size_t i = 0; i < object_.inputs.size(); ++i) {
            const BoundTexture& image = effects_.textures[object_.inputs[i]];
            for (std::size_t b = 0; b < places_.size(); ++b) {
                const ParameterField* field = fieldOf(*places_[b], fieldName(image.parameter->id));
                if (places_[b]->block->kind == image.kind && field != nullptr) {
                    code_.textured.push_back({b, field->offset, field->components, i});
                }
            }
        }
    }

    /// Adds what the model is told of each pixel as images that change its fields.
    void addPlaces() {
        std::size_t value = bufferPlace<DrawnPlaceEffect>(effects_);
        for (const Parameter* parameter : placedParameters(effects_)) {
            const ParameterField* field = fieldOf(*layout_.model, fieldName(parameter->id));
            code_.textured.push_back({0, field->offset, field->components, value++});
        }
    }

    void addEmission() {
        for (const Parameter* color : effects_.emission) {
            const ParameterField* field = fieldOf(*layout_.model, fieldName(color->id));
            if (field != nullptr) {
                code_.emission.push_back({0, field->offset, field->components, 0});
            }
        }
    }

    void addDiffuse() {
        for (const Parameter& parameter : layout_.model->block->parameters) {
            const ParameterField* field = fieldOf(*layout_.model, fieldName(parameter.id));
            if (parameter.role == roles::diffuse && field != nullptr) {
                code_.diffuse.push_back({0, field->offset, field->components, 0});
            }
        }
    }

    /// Reads the lights as packScene() laid them out: a header, then light after light. A drawing
    /// takes the key light alone.
    void addLights() {
        const bool takesOne = takesKeyAlone(effects_);
        std::size_t share = 0;
        for (std::size_t g = 0; g < effects_.lights.size(); ++g) {
            if (!isTaken(effects_, effects_.lights[g])) {
                continue;
            }
            const LightPlace& group = object_.pipeline->scene.groups[g];
            const glm::vec4 header = buffer_.sceneData[static_cast<std::size_t>(group.light.first)];
            const auto first = static_cast<std::size_t>(takesOne ? header.z : header.y);
            const std::size_t one = first > 0 ? 1 : 0;
            const std::size_t count = takesOne ? one : static_cast<std::size_t>(header.x);
            for (std::size_t i = 0; i < count; ++i) {
                const std::size_t at = first + i * static_cast<std::size_t>(group.vec4s());
                SurfaceCode::LightCode light{codeOf(group.light, buffer_.sceneData, at), {}};
                if (group.colors > 0) {
                    const std::size_t colors = at + static_cast<std::size_t>(group.colors);
                    light.colors = LightColors{glm::dvec3(buffer_.sceneData[colors]),
                                               glm::dvec3(buffer_.sceneData[colors + 1]),
                                               takesOne
                                                   ? glm::dvec3(0.0)
                                                   : glm::dvec3(buffer_.sceneData[colors + 2])};
                }
                if (effects_.lights[g].isPolarised && code_.polarised) {
                    light.field = glm::dvec4(
                        buffer_.sceneData[at + static_cast<std::size_t>(group.colors) + 3]);
                }
                if (group.shadow && hasShadows(effects_)) {
                    light.share = share++;
                }
                code_.lights.push_back(std::move(light));
            }
        }
    }

    void addSurroundings() {
        const SceneLayout& scene = object_.pipeline->scene;
        const auto data = [this](int index) {
            return glm::dvec3(buffer_.sceneData[static_cast<std::size_t>(index)]);
        };
        const bool isAmbient = takesAmbient(effects_);
        if (isAmbient && effects_.ambient) {
            code_.ambient = data(SceneLayout::ambient);
        }
        if (const std::optional<int> sky = hemisphereData(scene); isAmbient && sky) {
            code_.hemisphere = SurfaceCode::Hemisphere{data(*sky), data(*sky + 1), data(*sky + 2)};
        }
        if (const BlockPlace* fog = scene.part(kinds::fog)) {
            code_.fog = codeOf(*fog, buffer_.sceneData, static_cast<std::size_t>(fog->first));
        }
    }

    std::size_t index_;
    const BufferedObject& object_;
    const SurfaceBuffer& buffer_;
    const BufferedScene* around_;
    const ObjectLayout& layout_;
    const EffectSet& effects_;
    SurfaceCode code_;
    std::vector<const BlockPlace*> places_;
    std::optional<Error> problem_;
};

glm::dvec3 at(std::span<const double> values, std::size_t offset) {
    return {values[offset], values[offset + 1], values[offset + 2]};
}

bool sends(const glm::dvec3& radiance) {
    return std::max({radiance.r, radiance.g, radiance.b}) > 0.0;
}

} // namespace

Result<SurfaceCode> SurfaceCode::of(std::size_t object, const SurfaceBuffer& buffer,
                                    const BufferedScene* around) {
    return Collector(object, buffer, around).collect();
}

SurfaceShader::SurfaceShader(const SurfaceCode& code)
    : code_(code), incidence_(reference::findFunction("incidenceBetween")) {
    for (const SurfaceCode::BlockCode& block : code.blocks) {
        values_.push_back(block.values);
    }
    for (std::size_t i = 0; i < code.slots; ++i) {
        fillers_.push_back({code.blocks[i + 1].code, values_[i + 1]});
    }
    polarised_ = fillers_;
    if (code.polarised) {
        polarised_[code.polarised->slot].block = &code.polarised->term.block();
    }
}

void SurfaceShader::lookAt(const SurfaceBuffer& buffer, std::size_t pixel) {
    buffer_ = &buffer;
    pixel_ = pixel;
    const glm::dvec3 x(buffer.positions[pixel]);
    point_ = {x, glm::dvec3(buffer.normals[pixel]), glm::dvec3(buffer.tangents[pixel]),
              code_.eye - x, buffer.place(pixel)};
    takeImages();
}

glm::dvec3 SurfaceShader::still() const {
    return lit() + ambient();
}

glm::dvec3 SurfaceShader::finished(glm::dvec3 sum) const {
    if (code_.blends) {
        sum = blended(sum);
    }
    sum += emitted();
    if (code_.fog) {
        sum = fogged(sum);
    }
    return glm::clamp(sum, 0.0, maxLight);
}

glm::dvec3 SurfaceShader::passed(std::uint32_t round) const {
    return code_.facets ? code_.facets->seen(*buffer_, pixel_, round) : glm::dvec3(0.0);
}

/// Computes as passes/refraction_facets_rays.glsl.
glm::dvec3 SurfaceShader::over(const glm::dvec3& passed, const glm::dvec3& finished) const {
    const double opacity = double(buffer_->normals[pixel_].w);
    return code_.facets ? glm::mix(glm::clamp(passed, 0.0, maxLight), finished, opacity) : finished;
}

/// Returns one of the values that the buffer holds for the pixel.
glm::dvec4 SurfaceShader::noted(std::size_t value) const {
    return glm::dvec4(buffer_->values[value][pixel_]);
}

void SurfaceShader::takeImages() {
    for (const SurfaceCode::FieldPlace& field : code_.textured) {
        const glm::dvec4 value = noted(field.value);
        for (int i = 0; i < field.components; ++i) {
            values_[field.block][field.offset + static_cast<std::size_t>(i)] = value[i];
        }
    }
}

/// Computes as passes/environment_light.glsl, with the directions of
/// passes/environment_samples.glsl.
glm::dvec3 SurfaceShader::sampled() const {
    glm::dvec3 sum(0.0);
    for (int i = 0; code_.firstSample && i < SurfaceBufferLayout::samples; ++i) {
        const std::size_t first =
            *code_.firstSample + std::size_t(i * SurfaceBufferLayout::sampleValues);
        const glm::dvec3 arriving(noted(first + 1));
        if (sends(arriving)) {
            sum += arriving * value(glm::dvec3(noted(first)), point_.toEye, fillers_);
        }
    }
    return sum / double(SurfaceBufferLayout::samples);
}

/// Returns the model's value, with what is below 0 raised to 0.
glm::dvec3 SurfaceShader::value(const glm::dvec3& l, const glm::dvec3& v,
                                reference::Fillers fillers) const {
    reference::Geometry geometry = reference::geometry(point_.n, point_.t, l, v);
    geometry.pixel = point_.place;
    return reference::shade(*code_.blocks.front().code, geometry, values_.front(), fillers);
}

/// Returns the model's value without its diffuse term; 0 where the model does not tell it apart.
glm::dvec3 SurfaceShader::highlightAlone(const glm::dvec3& l, reference::Fillers fillers) const {
    if (code_.diffuse.empty()) {
        return glm::dvec3(0.0);
    }
    std::vector<double> values = values_.front();
    for (const SurfaceCode::FieldPlace& field : code_.diffuse) {
        std::fill_n(values.begin() + static_cast<std::ptrdiff_t>(field.offset), field.components,
                    0.0);
    }
    reference::Geometry geometry = reference::geometry(point_.n, point_.t, l, point_.toEye);
    geometry.pixel = point_.place;
    return reference::shade(*code_.blocks.front().code, geometry, values, fillers);
}

/// Returns the ambient light that lights add.
glm::dvec3 SurfaceShader::fromLights() const {
    glm::dvec3 sum(0.0);
    for (const SurfaceCode::LightCode& light : code_.lights) {
        if (light.colors) {
            sum += light.colors->ambient *
                   light.block.code->light(point_.x, light.block.values).radiance;
        }
    }
    return sum;
}

glm::dvec3 SurfaceShader::lit() const {
    glm::dvec3 sum(0.0);
    for (const SurfaceCode::LightCode& light : code_.lights) {
        reference::Illumination arriving = light.block.code->light(point_.x, light.block.values);
        if (light.share) {
            const std::size_t value = code_.firstShare + *light.share / sharesPerValue;
            const auto part = static_cast<int>(*light.share % sharesPerValue);
            arriving.radiance *= noted(value)[part];
        }
        if (sends(arriving.radiance)) {
            std::optional<FieldAcross> swings;
            if (light.field) {
                swings.emplace(code_.polarised->term,
                               acrossOf(arriving.l, glm::normalize(point_.toEye), *light.field));
            }
            const std::vector<reference::Filler>& fillers = light.field ? polarised_ : fillers_;
            glm::dvec3 shaded = value(arriving.l, point_.toEye, fillers);
            if (light.colors) {
                const glm::dvec3 highlight = highlightAlone(arriving.l, fillers);
                shaded = light.colors->diffuse * glm::max(shaded - highlight, glm::dvec3(0.0)) +
                         light.colors->highlight * highlight;
            }
            sum += arriving.radiance * shaded;
        }
    }
    return sum;
}

/// Computes as passes/ambient.glsl, passes/hemisphere.glsl and passes/openness.glsl.
glm::dvec3 SurfaceShader::ambient() const {
    const glm::dvec3 fromLamps = fromLights();
    if (!code_.ambient && !code_.hemisphere && !sends(fromLamps)) {
        return glm::dvec3(0.0);
    }
    const reference::Geometry g = reference::geometry(point_.n, point_.t, point_.n, point_.toEye);
    const glm::dvec4 open =
        code_.openness ? noted(*code_.openness) : glm::dvec4(0.0, 0.0, 0.0, 1.0);
    const glm::dvec3 facing = g.n + glm::dvec3(open);
    const double length = glm::length(facing);
    glm::dvec3 light = code_.ambient.value_or(glm::dvec3(0.0)) + fromLamps;
    if (code_.hemisphere) {
        const glm::dvec3 n = length > 1e-30 ? facing / length : g.n;
        const double up = glm::clamp(0.5 + 0.5 * glm::dot(n, code_.hemisphere->up), 0.0, 1.0);
        light += glm::mix(code_.hemisphere->ground, code_.hemisphere->sky, up);
    }
    return open.w * light *
           (value(g.n, 0.5 * g.n + std::sqrt(0.75) * g.t, fillers_) + code_.highlightAmbient);
}

glm::dvec3 SurfaceShader::emitted() const {
    glm::dvec3 sum(0.0);
    for (const SurfaceCode::FieldPlace& field : code_.emission) {
        sum += at(values_.front(), field.offset);
    }
    return sum;
}

glm::dvec3 SurfaceShader::blended(const glm::dvec3& shaded) const {
    const reference::Geometry g = reference::geometry(point_.n, point_.t, point_.n, point_.toEye);
    const std::array<double, 6> directions{g.n.x, g.n.y, g.n.z, g.v.x, g.v.y, g.v.z};
    std::array<double, 2> incidence{};
    incidence_->call(directions.data(), incidence.data());
    const reference::Block& block = *code_.blocks.back().code;
    const glm::dvec3 share = block.fresnel(incidence[0], incidence[1], values_.back());
    return glm::mix(shaded, block.tint(values_.back()), share);
}

glm::dvec3 SurfaceShader::fogged(const glm::dvec3& shaded) const {
    const double range = glm::length(point_.toEye);
    const reference::FogRay ray{code_.eye, -point_.toEye / std::max(range, 1e-300), range};
    const reference::Block& block = *code_.fog->code;
    return glm::mix(block.fogColor(code_.fog->values), shaded, block.fog(ray, code_.fog->values));
}

} // namespace patina
