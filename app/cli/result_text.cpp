// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/result_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "catalog/json_text.h"

namespace patina {
namespace {

using Json = nlohmann::json;

constexpr const char* resultFormat = "patina.results";
constexpr int resultVersion = 1;

std::string lineOf(const Json& json) {
    return json.dump(-1, ' ', false, Json::error_handler_t::replace) + '\n';
}

/// Returns a member that is a whole number of at least `min`, or 0.
std::size_t countIn(const Json& json, const char* member, std::size_t min) {
    const auto found = json.find(member);
    const bool isCount = found != json.end() && found->is_number_unsigned();
    const std::size_t count = isCount ? found->get<std::size_t>() : 0;
    return count >= min ? count : 0;
}

std::string textIn(const Json& json, const char* member) {
    const auto found = json.find(member);
    return found != json.end() && found->is_string() ? found->get<std::string>() : std::string();
}

Result<ResultHead> headFrom(const Json& json, const std::string& file) {
    const auto wrong = [&](const char* problem) {
        return tl::unexpected(Error{file, 1, 1, problem, "a file that --results has written"});
    };
    if (!json.is_object() || textIn(json, "format") != resultFormat) {
        return wrong("this is no file of results");
    }
    if (countIn(json, "version", 1) != resultVersion) {
        return wrong("another version of Patina has written these results");
    }
    ResultHead head{textIn(json, "command"), countIn(json, "presets", 1), countIn(json, "shard", 1),
                    countIn(json, "shards", 1), json};
    for (const char* member : {"format", "version", "command", "presets", "shard", "shards"}) {
        head.about.erase(member);
    }
    if (head.command.empty() || head.presets == 0 || head.shard == 0 || head.shard > head.shards) {
        return wrong("the head does not say of what these results are");
    }
    return head;
}

Result<ResultLine> lineFrom(const Json& json, const ResultHead& head, const std::string& file,
                            int place) {
    const auto wrong = [&](const std::string& problem) {
        return tl::unexpected(Error{file, place, 1, problem, {}});
    };
    if (!json.is_object()) {
        return wrong("this is no result");
    }
    ResultLine line{countIn(json, "number", 1), textIn(json, "preset"), textIn(json, "content"),
                    json.value("result", Json()), textIn(json, "failure")};
    if (line.number == 0 || line.preset.empty() || (line.hasFailed() && line.failure.empty())) {
        return wrong("this is no result");
    }
    if (line.number > head.presets || !head.has(line.number)) {
        return wrong(
            fmt::format("preset {} is none of shard {}/{}", line.number, head.shard, head.shards));
    }
    return line;
}

} // namespace

std::string ResultHead::text() const {
    Json json = about;
    json["format"] = resultFormat;
    json["version"] = resultVersion;
    json["command"] = command;
    json["presets"] = presets;
    json["shard"] = shard;
    json["shards"] = shards;
    return lineOf(json);
}

std::string differenceOf(const ResultHead& a, const ResultHead& b) {
    std::vector<std::string> differing;
    if (a.command != b.command) {
        differing.emplace_back("command");
    }
    if (a.presets != b.presets) {
        differing.emplace_back("number of presets");
    }
    if (a.shards != b.shards) {
        differing.emplace_back("number of shards");
    }
    Json members = a.about;
    members.update(b.about);
    for (const auto& member : members.items()) {
        if (a.about.value(member.key(), Json()) != b.about.value(member.key(), Json())) {
            differing.push_back(member.key());
        }
    }
    return fmt::format("{}", fmt::join(differing, ", "));
}

std::string ResultLine::text() const {
    Json json{{"number", number}, {"preset", preset}, {"content", content}};
    if (hasFailed()) {
        json["failure"] = failure;
    } else {
        json["result"] = result;
    }
    return lineOf(json);
}

Result<ResultText> readResults(std::string_view text, const std::string& file) {
    ResultText read;
    int place = 0;
    for (std::size_t end; (end = text.find('\n', read.wholeBytes)) != std::string_view::npos;) {
        ++place;
        auto parsed = parseJson(text.substr(read.wholeBytes, end - read.wholeBytes), file);
        read.wholeBytes = end + 1;
        if (!parsed) {
            Error error = parsed.error();
            error.line = place; // the parser knows of one line only
            return tl::unexpected(std::move(error));
        }
        if (place == 1) {
            auto head = headFrom(parsed->value, file);
            if (!head) {
                return tl::unexpected(head.error());
            }
            read.head = std::move(*head);
            continue;
        }
        auto line = lineFrom(parsed->value, read.head, file, place);
        if (!line) {
            return tl::unexpected(line.error());
        }
        read.lines.push_back({std::move(*line), place});
    }
    if (place == 0) {
        return tl::unexpected(
            Error{file, 1, 1, "this is no file of results", "a file that --results has written"});
    }
    read.isCut = read.wholeBytes < text.size();
    return read;
}

} // namespace patina
