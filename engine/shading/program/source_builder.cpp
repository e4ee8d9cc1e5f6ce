// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/program/source_builder.h"

#include <algorithm>

#include <boost/uuid/name_generator_sha1.hpp>
#include <boost/uuid/uuid_io.hpp>
#include <fmt/format.h>

#include "catalog/descriptor.h"
#include "core/text.h"
#include "shading/program/block_text.h"
#include "shading/glsl/shader_file.h"
#include "shading/glsl/tokens.h"
#include "shading/glsl/unused_code.h"

namespace patina {
namespace {

/// Limits the errors of one text: nobody reads more.
constexpr std::size_t maxErrors = 100;

std::string_view nextLine(std::string_view& rest) {
    const std::size_t end = rest.find('\n');
    std::string_view line = rest.substr(0, end);
    rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
    if (line.ends_with('\r')) {
        line.remove_suffix(1);
    }
    return line;
}

bool leavesRoot(const std::string& name) {
    const std::filesystem::path path = std::filesystem::path(name).lexically_normal();
    return path.is_absolute() || path.empty() || *path.begin() == "..";
}

/// Returns the hash of all that a program may take from the block.
std::string hashOf(const Block& block, const std::string& code) {
    const boost::uuids::name_generator_sha1 generate(boost::uuids::ns::oid());
    constexpr auto replace = nlohmann::json::error_handler_t::replace;
    const std::string descriptor = toJson(block).dump(-1, ' ', false, replace);
    return boost::uuids::to_string(generate(descriptor + '\0' + code));
}

StrangerBlock strangerOf(const Block& block, const std::string& code,
                         const std::filesystem::path& shaders) {
    return {block.kind,
            block.id,
            block.shaderFile,
            shaders,
            block.descriptorFile.parent_path().parent_path(),
            hashOf(block, code)};
}

} // namespace

SourceBuilder::SourceBuilder(std::filesystem::path root) : root_(std::move(root)) {}

void SourceBuilder::append(std::string_view line) {
    source_.text.append(line);
    source_.text += '\n';
    ++lines_;
}

void SourceBuilder::add(std::string_view generated) {
    while (!generated.empty()) {
        append(nextLine(generated));
    }
}

void SourceBuilder::addFile(const std::filesystem::path& file) {
    addIncluded(file.string(), {});
}

void SourceBuilder::addBlock(const Block& block) {
    addIncluded(block.shaderFile.string(), {}, &block);
}

void SourceBuilder::addIncluded(const std::string& name, const Place& includer,
                                const Block* block) {
    if (errors_.size() >= maxErrors) {
        return;
    }
    if (!includer.file.empty() && leavesRoot(name)) {
        errors_.push_back({includer.file, includer.line, 1,
                           fmt::format("cannot include \"{}\"", name),
                           "a file of the shader folder, such as \"lib/math.glsl\""});
        return;
    }
    const std::filesystem::path path = (root_ / name).lexically_normal();
    if (!taken_.insert(path).second) {
        return;
    }
    const Result<std::string> text = readShaderFile(path);
    if (!text) {
        const bool isMissing = !includer.file.empty() && text.error().line == 0;
        errors_.push_back(
            isMissing ? Error{includer.file, includer.line, 1,
                              fmt::format("cannot include \"{}\": {}", name, text.error().problem),
                              text.error().expected}
                      : text.error());
        return;
    }
    const std::string code = withoutComments(*text);
    if (block != nullptr) {
        const Errors mistakes = blockTextMistakes(*block, code);
        const std::size_t told = std::min(mistakes.size(), maxErrors - errors_.size());
        errors_.insert(errors_.end(), mistakes.begin(),
                       mistakes.begin() + static_cast<std::ptrdiff_t>(told));
    }
    const std::size_t first = addText(path.string(), code);
    if (block != nullptr && !block->shipped) {
        parts_.push_back({first, source_.text.size(), structName(*block), functionName(*block)});
        source_.strangers.push_back(strangerOf(*block, code, root_));
    }
}

std::size_t SourceBuilder::addText(const std::string& file, std::string_view text) {
    int number = 0;
    std::string_view rest = text;
    while (!rest.empty()) {
        ++number;
        if (const auto include = includedFile(nextLine(rest)); !include.empty()) {
            addIncluded(std::string(include), {file, number});
        }
    }
    const std::size_t first = source_.text.size();
    const std::size_t index = source_.files.size();
    source_.files.push_back(file);
    number = 0;
    bool gap = true; // the next line that is kept needs a #line
    while (!text.empty()) {
        const std::string_view line = nextLine(text);
        ++number;
        if (isBlank(line) || !includedFile(line).empty()) {
            gap = true;
            continue;
        }
        if (gap) {
            append(fmt::format("#line {} {}", number + int(index) * ShaderSource::linesPerFile,
                               index));
        }
        gap = false;
        append(line.substr(0, line.find_last_not_of(" \t") + 1));
    }
    append(fmt::format("#line {} 0", lines_ + 2));
    return first;
}

Checked<ShaderSource> SourceBuilder::finish() const {
    if (!errors_.empty()) {
        return tl::unexpected(errors_);
    }
    return withoutUnused(withPrivateNames(source_, parts_));
}

} // namespace patina
