// SPDX-License-Identifier: GPL-3.0-or-later
// Replays what the fuzzer starts from, and random damage to it, without a fuzzer.
#include <random>

#include <gtest/gtest.h>

#include "fuzz/read_files.h"
#include "support/program.h"

namespace patina::tests::corpus_test {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> filesBelow(const char* folder, const char* ending = "") {
    std::vector<std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        if (entry.is_regular_file() && entry.path().string().ends_with(ending)) {
            files.push_back(readFile(entry.path()));
        }
    }
    return files;
}

TEST(JsonCorpus, EveryFile_IsReadOrRefused) {
    const std::vector<std::string> files = filesBelow(PATINA_SOURCE_DIR "/tests/fuzz/corpus");
    ASSERT_GE(files.size(), 10u);
    for (const std::string& file : files) {
        readAsFiles(file);
    }
}

/// Changes, drops or doubles a few bytes.
std::string damaged(std::string text, std::mt19937& random) {
    const auto upTo = [&random](std::size_t end) {
        return random() % std::max<std::size_t>(end, 1);
    };
    for (std::size_t changes = 1 + upTo(4); changes > 0 && !text.empty(); --changes) {
        const std::size_t at = upTo(text.size());
        switch (upTo(3)) {
        case 0:
            text[at] = static_cast<char>(random());
            break;
        case 1:
            text.erase(at, 1 + upTo(8));
            break;
        default:
            text.insert(at, text.substr(upTo(text.size()), 1 + upTo(16)));
        }
    }
    return text;
}

TEST(JsonCorpus, DamagedPresets_AreReadOrRefused) {
    std::mt19937 random(7);
    for (const std::string& file : filesBelow(PATINA_SOURCE_DIR "/presets", ".json")) {
        for (int i = 0; i < 50; ++i) {
            readAsFiles(damaged(file, random));
        }
    }
}

TEST(JsonCorpus, DamagedDescriptors_AreReadOrRefused) {
    std::mt19937 random(8);
    for (const std::string& file : filesBelow(PATINA_SOURCE_DIR "/shaders/models")) {
        for (int i = 0; i < 50; ++i) {
            readAsFiles(damaged(file, random));
        }
    }
}

} // namespace
} // namespace patina::tests::corpus_test
