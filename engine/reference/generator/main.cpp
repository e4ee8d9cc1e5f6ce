// SPDX-License-Identifier: GPL-3.0-or-later
// This program writes the C++ files that compile the shading code of one or more shader folders in
// double precision: one per block, two for the library, one with the table of blocks.
#include <algorithm>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <vector>

#include <fmt/format.h>

#include "block_unit.h"
#include "catalog/catalog.h"
#include "library_unit.h"

namespace patina {
namespace {

constexpr const char* elementary = "lib/elementary.glsl";

/// Writes a file unless it has this text already, so that an edit compiles one unit only.
Result<void> write(const std::filesystem::path& file, const std::string& text) {
    std::ostringstream old;
    if (std::ifstream stream(file, std::ios::binary); stream) {
        old << stream.rdbuf();
    }
    if (old.str() == text) {
        return {};
    }
    std::ofstream stream(file, std::ios::binary);
    stream << text;
    stream.close();
    return stream ? Result<void>() : failure(file.string() + " cannot be written");
}

Result<GlslLines> libraryLines(const std::filesystem::path& root) {
    std::vector<std::filesystem::path> files;
    for (const auto& item : std::filesystem::directory_iterator(root / "lib")) {
        if (item.path().extension() == ".glsl") {
            files.push_back(item.path());
        }
    }
    std::sort(files.begin(), files.end());
    GlslLines all;
    std::set<std::string> taken{elementary};
    for (const auto& file : files) {
        if (!taken.insert("lib/" + file.filename().string()).second) {
            continue;
        }
        GlslReader reader(root, taken);
        Result<GlslLines> lines = reader.read(file);
        if (!lines) {
            return lines;
        }
        taken = reader.taken();
        all.insert(all.end(), lines->begin(), lines->end());
    }
    return all;
}

Result<void> writeLibrary(const std::filesystem::path& root, const std::filesystem::path& target) {
    const Result<GlslLines> lines = libraryLines(root);
    const Result<GlslLines> polynomials = GlslReader(root, {}).read(root / elementary);
    if (!lines || !polynomials) {
        return tl::unexpected((lines ? polynomials : lines).error());
    }
    const Declarations elementaryOnes = declarationsOf(plainText(*polynomials));
    Declarations all = declarationsOf(plainText(*lines));
    all.functions.insert(all.functions.end(), elementaryOnes.functions.begin(),
                         elementaryOnes.functions.end());
    const std::string geometry =
        "Geometry geometry(const vec3& n, const vec3& t, const vec3& l, const vec3& v) {\n"
        "    Geometry g;\n"
        "    g.n = library::safeNormalize(n, g.n);\n"
        "    g.t = library::tangentAlong(g.n, t);\n"
        "    g.b = cross(g.n, g.t);\n"
        "    g.l = library::safeNormalize(l, g.n);\n"
        "    g.v = library::safeNormalize(v, g.n);\n"
        "    return g;\n}\n\n";
    const auto done = write(target / "library.cpp",
                            librarySource({"functions", "library", asCpp(*lines), geometry, all}));
    return done ? write(target / "polynomials.cpp",
                        librarySource({"elementaryPolynomials", "polynomials", asCpp(*polynomials),
                                       "", elementaryOnes}))
                : done;
}

bool hasReference(const Block& block) {
    const BlockKind* kind = findKind(block.kind);
    return kind != nullptr && kind->hasReference;
}

Result<void> writeBlocks(Catalog catalog, const std::filesystem::path& target) {
    const std::filesystem::path root = catalog.roots.front().folder;
    const auto firstWithout =
        std::stable_partition(catalog.blocks.begin(), catalog.blocks.end(), hasReference);
    for (auto block = firstWithout; block != catalog.blocks.end(); ++block) {
        if (auto done = write(target / unitFile(*block), emptyUnit(*block)); !done) {
            return done;
        }
    }
    catalog.blocks.erase(firstWithout, catalog.blocks.end());
    for (const Block& block : catalog.blocks) {
        const Result<GlslLines> lines = GlslReader(root, {elementary}).read(block.shaderFile);
        if (!lines) {
            return tl::unexpected(lines.error());
        }
        if (auto done = write(target / unitFile(block), blockSource(block, *lines)); !done) {
            return done;
        }
    }
    return write(target / "registry.cpp", registrySource(catalog.blocks));
}

int run(const std::vector<std::string>& arguments) {
    if (arguments.size() < 2) {
        fmt::print(stderr, "usage: patina-reference-generator TARGET-FOLDER SHADER-FOLDER...\n");
        return 2;
    }
    std::vector<BlockRoot> roots;
    for (std::size_t i = 1; i < arguments.size(); ++i) {
        roots.push_back({arguments[i], true});
    }
    const Catalog catalog = loadCatalog(roots);
    if (!catalog.errors.empty()) {
        fmt::print(stderr, "{}\n", text(catalog.errors));
        return 1;
    }
    const std::filesystem::path target = arguments[0];
    std::filesystem::create_directories(target);
    auto done = writeLibrary(roots.front().folder, target);
    if (done) {
        done = writeBlocks(catalog, target);
    }
    if (!done) {
        fmt::print(stderr, "{}\n", done.error().text());
    }
    return done ? 0 : 1;
}

} // namespace
} // namespace patina

int main(int argc, char** argv) {
    return patina::run({argv + 1, argv + argc});
}
