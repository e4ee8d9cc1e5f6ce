// SPDX-License-Identifier: GPL-3.0-or-later
#include "machine_text.h"

#include <ctime>
#include <fstream>
#include <thread>

#include <fmt/format.h>

#include "gl/driver.h"
#include "statistics.h"

namespace patina::benchmarks {
namespace {

std::string processor() {
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);) {
        if (line.starts_with("model name")) {
            return line.substr(line.find(':') + 2);
        }
    }
    return "a processor without a name";
}

} // namespace

std::string today() {
    const std::time_t now = std::time(nullptr);
    std::string text(sizeof "2026-11-22", '\0');
    text.resize(std::strftime(text.data(), text.size(), "%Y-%m-%d", std::gmtime(&now)));
    return text;
}

std::string machineText() {
    return fmt::format("{}, {} cores,\n{}", processor(), std::thread::hardware_concurrency(),
                       gl::driverText());
}

double load() {
    double minute = 0.0;
    return getloadavg(&minute, 1) == 1 ? minute : 0.0;
}

bool writeDocument(const std::string& name, const std::string& text) {
    std::ofstream written(PATINA_SOURCE_DIR "/docs/" + name, std::ios::binary);
    written << text;
    const bool isWritten = bool(written.flush());
    report("docs/" + name, isWritten ? "written" : "could not be written", isWritten, "");
    return isWritten;
}

} // namespace patina::benchmarks
