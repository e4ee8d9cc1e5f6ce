// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numbered_texts.h"

#include <cstddef>
#include <functional>
#include <map>
#include <mutex>
#include <vector>

namespace patina {
namespace {

struct NumberedTexts {
    std::mutex guard;
    std::vector<std::string> texts{std::string()};
    std::map<std::string, int, std::less<>> numbers{{std::string(), 0}};
};

NumberedTexts& numberedTexts() {
    static NumberedTexts all;
    return all;
}

} // namespace

int numberOfText(std::string_view text) {
    NumberedTexts& all = numberedTexts();
    const std::lock_guard lock(all.guard);
    if (const auto found = all.numbers.find(text); found != all.numbers.end()) {
        return found->second;
    }
    const int number = static_cast<int>(all.texts.size());
    all.texts.emplace_back(text);
    all.numbers.emplace(text, number);
    return number;
}

std::string numberedText(int number) {
    NumberedTexts& all = numberedTexts();
    const std::lock_guard lock(all.guard);
    const bool isKnown = number > 0 && static_cast<std::size_t>(number) < all.texts.size();
    return isKnown ? all.texts[static_cast<std::size_t>(number)] : std::string();
}

} // namespace patina
