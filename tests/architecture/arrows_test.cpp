// SPDX-License-Identifier: GPL-3.0-or-later
// The arrows that ARCHITECTURE.md draws are the ones that the includes and the linker follow.
#include <map>
#include <regex>
#include <set>

#include <gtest/gtest.h>

#include "source_tree.h"

namespace patina::tests::arrows_test {
namespace {

using Arrows = std::map<std::string, std::set<std::string>>; // folder -> what it may use

/// The first fenced block behind `words`: chains such as "core <- catalog <- material".
Arrows arrowsDrawn(std::string_view words = "## The arrows") {
    const std::string text = readText(projectRoot() / "ARCHITECTURE.md");
    const auto heading = text.find(words);
    const auto begin = text.find("```", heading) + 3;
    const std::string block = text.substr(begin, text.find("```", begin) - begin);

    Arrows arrows;
    std::string previous;
    bool linked = false;
    static const std::regex token(R"(<-|[a-z]+(/[a-z]+)?)");
    for (std::sregex_iterator it(block.begin(), block.end(), token), end; it != end; ++it) {
        if (it->str() == "<-") {
            linked = true;
            continue;
        }
        arrows[it->str()];
        if (linked) {
            arrows[it->str()].insert(previous);
        }
        previous = it->str();
        linked = false;
    }
    return arrows;
}

Arrows transitive(Arrows arrows) {
    for (std::size_t round = 0; round < arrows.size(); ++round) {
        for (auto& [folder, uses] : arrows) {
            const std::set<std::string> direct = uses;
            for (const auto& used : direct) {
                uses.insert(arrows[used].begin(), arrows[used].end());
            }
        }
    }
    return arrows;
}

/// The folder within which "shading/glsl/tokens.h" lies: the last one for which there are arrows.
std::string engineRoomOf(const std::filesystem::path& path, const Arrows& arrows) {
    std::string room = path.begin()->string();
    for (const std::filesystem::path& part : path.parent_path()) {
        room = arrows.contains(part.string()) ? part.string() : room;
    }
    return room;
}

/// "engine/core/value.h" is in the room "core", "app/files/main.cpp" in "app/files".
std::string roomOf(const SourceFile& file, const Arrows& arrows) {
    const std::filesystem::path path(file.path);
    auto part = path.begin();
    const std::string top = (part++)->string();
    const std::string folder = part->string();
    if (top == "engine") {
        return engineRoomOf(path.lexically_relative(top), arrows);
    }
    return arrows.contains(top + "/" + folder) ? top + "/" + folder : top;
}

std::vector<SourceFile> programSources() {
    return filesUnder({"engine", "app"}, {".h", ".cpp", ".in"});
}

TEST(Arrows, EveryEngineFolder_IsDrawn) {
    const Arrows arrows = arrowsDrawn();
    for (const auto& entry : std::filesystem::directory_iterator(projectRoot() / "engine")) {
        if (entry.is_directory()) {
            EXPECT_TRUE(arrows.contains(entry.path().filename().string())) << entry.path();
        }
    }
}

TEST(Arrows, Includes_FollowThem) {
    const Arrows arrows = transitive(arrowsDrawn());
    static const std::regex include("#include \"([a-z]+/[a-z_/.]+)\"");
    for (const SourceFile& file : programSources()) {
        const std::string room = roomOf(file, arrows);
        ASSERT_TRUE(arrows.contains(room)) << file.path;
        std::sregex_iterator it(file.text.begin(), file.text.end(), include);
        for (const std::sregex_iterator end; it != end; ++it) {
            const std::string used = engineRoomOf((*it)[1].str(), arrows);
            if (arrows.contains(used) && used != room) {
                EXPECT_TRUE(arrows.at(room).contains(used))
                    << file.place(std::size_t(it->position())) << ": " << room << " may not use "
                    << used;
            }
        }
    }
}

/// The arrows between the rooms of a folder, those of rooms in between included.
Arrows roomArrows(const std::string& folder) {
    return transitive(arrowsDrawn("Rooms of `" + folder + "`"));
}

/// The room of "engine/render" that "engine/render/pass/pass.h" is in; empty: in none of them.
std::string roomWithin(const std::string& folder, const SourceFile& file) {
    const auto inside = std::filesystem::path(file.path).lexically_relative(folder);
    return inside.has_parent_path() ? inside.begin()->string() : std::string();
}

/// Includes of a folder's rooms begin with `prefix`. Files above the rooms are for users of the
/// folder, but for `shared`, which all rooms may include.
void expectRoomsToFollow(const std::string& folder, const std::string& prefix,
                         const std::string& shared = {}) {
    const Arrows arrows = roomArrows(folder);
    const std::regex include("#include \"" + prefix + "([a-z_.]+)(/|\")");
    for (const SourceFile& file : filesUnder({folder}, {".h", ".cpp"})) {
        const std::string room = roomWithin(folder, file);
        std::sregex_iterator it(file.text.begin(), file.text.end(), include);
        for (const std::sregex_iterator end; it != end && !room.empty(); ++it) {
            const std::string used = (*it)[1];
            const bool isElsewhere =
                !std::filesystem::exists(projectRoot() / folder / used); // a folder of the engine
            ASSERT_TRUE(arrows.contains(room)) << file.path;
            EXPECT_TRUE(isElsewhere || used == room || used == shared ||
                        arrows.at(room).contains(used))
                << file.place(std::size_t(it->position())) << ": " << room << " may not use "
                << used;
        }
    }
}

void expectEngineRoomsToFollow(const std::string& folder, const std::string& shared = {}) {
    expectRoomsToFollow("engine/" + folder, folder + "/", shared);
}

TEST(Arrows, RoomsOfTheShadingCode_FollowTheirs) {
    expectEngineRoomsToFollow("shading");
}

TEST(Arrows, RoomsOfTheMeasuringCode_FollowTheirs) {
    expectEngineRoomsToFollow("measure");
}

TEST(Arrows, RoomsOfTheRenderer_FollowTheirs) {
    expectEngineRoomsToFollow("render", "view.h");
}

TEST(Arrows, RoomsOfTheEditor_FollowTheirs) {
    expectRoomsToFollow("app/editor", "");
}

TEST(Arrows, RoomsOfTheEditor_AreNoFoldersOfTheEngine) {
    for (const auto& [room, uses] : roomArrows("app/editor")) {
        EXPECT_FALSE(std::filesystem::exists(projectRoot() / "engine" / room))
            << room << ": whose file an include names would be unclear";
    }
}

TEST(Arrows, NoRoom_IsAboveItself) {
    for (const char* folder : {"engine/shading", "engine/measure", "engine/render", "app/editor"}) {
        for (const auto& [room, uses] : roomArrows(folder)) {
            EXPECT_FALSE(uses.contains(room)) << folder << '/' << room;
        }
    }
}

TEST(Arrows, Libraries_LinkOnlyAlongThem) {
    const Arrows arrows = transitive(arrowsDrawn());
    static const std::regex library(
        R"(patina_engine_library\(([a-z]+)(?:\s+COLD)?\s+USES([a-z\s]+))");
    for (const SourceFile& file : filesUnder({"engine"}, {"CMakeLists.txt"})) {
        std::smatch match;
        if (!std::regex_search(file.text, match, library)) {
            continue;
        }
        std::istringstream used(match[2]);
        for (std::string name; used >> name;) {
            EXPECT_TRUE(arrows.at(match[1]).contains(name)) << file.path << " uses " << name;
        }
    }
}

TEST(Arrows, ForeignFormats_AreLinkedByTheFilesProgramOnly) {
    for (const SourceFile& file : filesUnder({"engine", "app"}, {"CMakeLists.txt"})) {
        const bool mayLink = file.path == "app/files/CMakeLists.txt";
        EXPECT_TRUE(mayLink || file.text.find("patina::io") == std::string::npos) << file.path;
    }
}

TEST(Arrows, Engine_HasNoQt) {
    static const std::regex qt("#include <Q|Qt[0-9]?::");
    for (const SourceFile& file : filesUnder({"engine"})) {
        EXPECT_FALSE(std::regex_search(file.text, qt)) << file.path;
    }
}

TEST(Arrows, CommandLineAndFilesProgram_HaveNoQt) {
    static const std::regex qt("#include <Q|Qt[0-9]?::");
    for (const SourceFile& file : filesUnder({"app/cli", "app/files"})) {
        EXPECT_FALSE(std::regex_search(file.text, qt)) << file.path;
    }
}

TEST(Arrows, TheirMap_IsReadInFiveMinutes) {
    const std::string map = readText(projectRoot() / "ARCHITECTURE.md");
    EXPECT_LE(std::ranges::count(map, '\n'), 150) << "what goes beyond the map is in docs/design";
}

} // namespace
} // namespace patina::tests::arrows_test
