// SPDX-License-Identifier: GPL-3.0-or-later
#include "predict/gpu_family.h"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <set>

#include "predict/malioc.h"

namespace patina {
namespace {

constexpr double lanesOfWave = 64.0;

std::vector<GpuFamily> familiesOfAmd() {
    const std::string amd = "amd.com, product specifications";
    return {
        GpuFamily{"gcn", "GCN 4", {"polaris10"}, 4, {{"Radeon RX 580", 36, 1340.0, amd}}},
        GpuFamily{"vega", "GCN 5", {"vega10"}, 4, {{"Radeon RX Vega 64", 64, 1546.0, amd}}},
        GpuFamily{"rdna1", "RDNA 1", {"navi10"}, 2, {{"Radeon RX 5700 XT", 40, 1755.0, amd}}},
        GpuFamily{"rdna2",
                  "RDNA 2",
                  {"navi21"},
                  2,
                  {{"Steam Deck", 8, 1600.0, "steamdeck.com, tech specs"},
                   {"Radeon RX 6600", 28, 2044.0, amd},
                   {"Radeon RX 6800 XT", 72, 2015.0, amd}}},
        GpuFamily{"rdna3",
                  "RDNA 3",
                  {"navi31", "gfx1100"},
                  2,
                  {{"Radeon RX 7600", 32, 2250.0, amd}, {"Radeon RX 7900 XTX", 96, 2300.0, amd}}}};
}

std::vector<GpuFamily> familiesOfArm() {
    const std::string source = "nanoreview.net, comparison of SoCs";
    return {
        GpuFamily{
            "mali-g78", "Mali-G78", {"Mali-G78"}, 1, {{"Google Pixel 6", 20, 848.0, source}}, true},
        GpuFamily{"mali-g710",
                  "Mali-G710",
                  {"Mali-G710"},
                  1,
                  {{"MediaTek Dimensity 9000", 10, 850.0, source}},
                  true}};
}

std::vector<GpuFamily> makeFamilies() {
    std::vector<GpuFamily> families = familiesOfAmd();
    const std::set<std::string> cores = maliocCores();
    std::ranges::copy_if(
        familiesOfArm(), std::back_inserter(families),
        [&cores](const GpuFamily& family) { return cores.contains(family.chips.front()); });
    return families;
}

bool isAlike(char a, char b) {
    return std::tolower(static_cast<unsigned char>(a)) ==
           std::tolower(static_cast<unsigned char>(b));
}

std::string knownNames() {
    std::string names;
    for (const GpuFamily& family : gpuFamilies()) {
        names += (names.empty() ? "" : ", ") + family.id;
    }
    return names;
}

} // namespace

std::span<const GpuFamily> gpuFamilies() {
    static const std::vector<GpuFamily> families = makeFamilies();
    return families;
}

Result<std::vector<const GpuFamily*>> gpuFamiliesIn(std::string_view list) {
    std::vector<const GpuFamily*> chosen;
    while (true) {
        const std::string_view name = list.substr(0, list.find(','));
        const auto found = std::ranges::find(gpuFamilies(), name, &GpuFamily::id);
        if (found == gpuFamilies().end()) {
            return failure(
                "there is no family of graphics cards \"" + std::string(name) + "\"",
                "one or more of " + knownNames() +
                    (name.starts_with("mali") ? "; those of Mali need malioc in the path" : ""));
        }
        if (std::ranges::find(chosen, &*found) == chosen.end()) {
            chosen.push_back(&*found);
        }
        if (name.size() == list.size()) {
            return chosen;
        }
        list.remove_prefix(name.size() + 1);
    }
}

std::string CardOfFamily::text() const {
    return card->name + " (" + family->label + ')';
}

std::vector<CardOfFamily> graphicsCards() {
    std::vector<CardOfFamily> cards;
    for (const GpuFamily& family : gpuFamilies()) {
        for (const GraphicsCard& card : family.cards) {
            cards.push_back({&family, &card});
        }
    }
    return cards;
}

Result<CardOfFamily> graphicsCardIn(std::string_view name) {
    for (const GpuFamily& family : gpuFamilies()) {
        if (std::ranges::equal(name, family.id, isAlike) ||
            std::ranges::equal(name, family.label, isAlike)) {
            return CardOfFamily{&family, &family.middleCard(), true};
        }
    }
    std::vector<CardOfFamily> found;
    std::string names;
    for (const CardOfFamily& each : graphicsCards()) {
        const std::string& card = each.card->name;
        const auto part = std::search(card.begin(), card.end(), name.begin(), name.end(), isAlike);
        if (!name.empty() && part != card.end()) {
            found.push_back(each);
        }
        names += (names.empty() ? "" : ", ") + card;
    }
    if (found.size() != 1) {
        return failure((found.empty() ? "there is no graphics card \""
                                      : "there is more than one graphics card \"") +
                           std::string(name) + '"',
                       "one of " + names + ", or a family: " + knownNames());
    }
    return found.front();
}

double predictedMilliseconds(double cyclesPerWave64, double pixels, const GpuFamily& family,
                             const GraphicsCard& card) {
    const double units = double(card.computeUnits) * double(family.simdsPerUnit);
    return pixels / lanesOfWave * cyclesPerWave64 / (units * card.megahertz * 1e3);
}

} // namespace patina
