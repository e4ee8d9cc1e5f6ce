// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameters/copied_values.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "catalog/json_reader.h"
#include "catalog/value_json.h"
#include "material/file_header.h"
#include "material/texture_file.h"

namespace patina {
namespace {

using Json = nlohmann::json;

constexpr FileFormat valuesFormat{"patina.values", 1, "copy of values"};

/// Reads copied values and pastes them onto one value or several. A reader is used once: it hands
/// its result over.
class ValuesReader {
  public:
    ValuesReader(const CopiedJson& copied, const ParameterSource& source)
        : copied_(copied), source_(source), reader_(copied.json, "", result_.problems) {
        readHeader(reader_, valuesFormat, result_.problems);
        if (!result_.problems.empty()) {
            return;
        }
        reader_.read("kind", kind_);
        parameters_.emplace(reader_.child("parameters"));
        ids_ = parameters_->unknown();
        ReadingRights rights;
        rights.everything = copied.isTrusted;
        References references({}, rights);
        textures_ = readTextures(reader_, references, notes_).uses;
    }

    PastedValues ontoOne(const Parameter& target) {
        if (!result_.problems.empty()) {
            return finished();
        }
        if (ids_.size() != 1) {
            reader_.addError("parameters", fmt::format("{} values were copied", ids_.size()),
                             "one value, or to be pasted onto a group");
            return finished();
        }
        take(ids_.begin().key(), target);
        return finished();
    }

    PastedValues ontoAll(const NamedBlock& block, std::span<const Parameter* const> targets) {
        if (result_.problems.empty() && kind_ != block.kind) {
            reader_.addError("kind", fmt::format("these are values of \"{}\"", kind_),
                             fmt::format("values of \"{}\"", block.kind));
        }
        if (!result_.problems.empty()) {
            return finished();
        }
        std::vector<std::string> missing;
        for (const auto& [id, json] : ids_.items()) {
            const auto found = std::ranges::find(targets, id, &Parameter::id);
            if (found != targets.end()) {
                take(id, **found);
            } else {
                missing.push_back(id);
            }
        }
        if (!missing.empty()) {
            parameters_->addError(missing.front(),
                                  fmt::format("{} does not take {} here, which stays on the "
                                              "clipboard",
                                              block.label, fmt::join(missing, ", ")));
        }
        return finished();
    }

  private:
    void take(const std::string& id, const Parameter& target) {
        const Json* json = parameters_->find(id);
        const ValueReading value = valueFromJson(target, *json);
        if (!value) {
            parameters_->addError(id, value.error());
            return;
        }
        if (infoOf(target.type).isFile && !copied_.isTrusted) {
            parameters_->addError(id, "a text from elsewhere names a file", "to choose it by hand");
            return;
        }
        result_.edits.values[target.id] = conformed(target, *value);
        if (source_.takesTextures() && !target.textureChannels.empty()) {
            const auto image = textures_.find(id);
            result_.edits.textures[target.id] =
                image == textures_.end() ? std::nullopt : std::optional(image->second);
        }
    }

    PastedValues finished() {
        addNew(result_.problems, notes_);
        result_.problems = inClipboard(std::move(result_.problems));
        return std::move(result_);
    }

    const CopiedJson& copied_;
    const ParameterSource& source_;
    PastedValues result_;
    JsonReader reader_;
    Errors notes_;
    std::optional<JsonReader> parameters_;
    Json ids_ = Json::object();
    std::string kind_;
    std::map<std::string, TextureUse, std::less<>> textures_;
};

} // namespace

nlohmann::json copiedValues(const NamedBlock& block, std::span<const Parameter* const> parameters,
                            const ParameterSource& source) {
    Json json{{"format", valuesFormat.name},
              {"version", valuesFormat.version},
              {"kind", block.kind},
              {"block", block.id},
              {"parameters", Json::object()}};
    for (const Parameter* parameter : parameters) {
        json["parameters"][parameter->id] = toJson(source.value(*parameter));
        if (const auto use = source.texture(parameter->id)) {
            json["textures"][parameter->id] = toJson(*use, parameter->id, {});
        }
    }
    return json;
}

bool mayReadAll(std::span<const Parameter* const> parameters, const ParameterSource& source) {
    return std::ranges::all_of(parameters, [&](const Parameter* parameter) {
        const auto use = source.texture(parameter->id);
        return !use || source.mayRead(*use);
    });
}

bool areCopiedValues(const CopiedJson& copied) {
    return copied.format() == valuesFormat.name;
}

PastedValues pastedOnto(const Parameter& target, const CopiedJson& copied,
                        const ParameterSource& source) {
    return ValuesReader(copied, source).ontoOne(target);
}

PastedValues pastedOnto(const NamedBlock& block, std::span<const Parameter* const> targets,
                        const CopiedJson& copied, const ParameterSource& source) {
    return ValuesReader(copied, source).ontoAll(block, targets);
}

} // namespace patina
