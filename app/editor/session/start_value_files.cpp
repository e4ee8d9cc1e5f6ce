// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/start_value_files.h"

#include <algorithm>
#include <vector>

#include "core/atomic_file.h"
#include "material/file_header.h"
#include "session/session.h"

namespace patina {
namespace {

namespace fs = std::filesystem;

constexpr FileFormat startFormat{"patina.start-values", 1, "file of start values"};
constexpr const char* suffix = ".json";

std::vector<fs::path> filesIn(const fs::path& folder) {
    std::vector<fs::path> files;
    std::error_code missing;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, missing)) {
        if (entry.path().extension() == suffix) {
            files.push_back(entry.path());
        }
    }
    std::ranges::sort(files);
    return files;
}

} // namespace

fs::path startValueFolder() {
    return configFolder() / "start-values";
}

StartValueReading readStartValues(const fs::path& folder) {
    StartValueReading reading;
    for (const fs::path& file : filesIn(folder)) {
        const Result<LocatedJson> json = readJson(file);
        if (!json) {
            reading.errors.push_back(json.error());
            continue;
        }
        Errors errors;
        JsonReader reader(*json, "", errors);
        readHeader(reader, startFormat, errors);
        std::string model;
        nlohmann::json parameters = nlohmann::json::object();
        reader.read("model", model);
        reader.readObject("parameters", parameters);
        if (errors.empty() && !model.empty()) {
            reading.values.insert_or_assign(model, std::move(parameters));
        }
        addNew(reading.errors, errors);
    }
    return reading;
}

Result<void> writeStartValues(const fs::path& folder, const std::string& model,
                              const nlohmann::json& parameters) {
    const fs::path file = folder / (model + suffix);
    std::error_code error;
    if (parameters.is_null()) {
        fs::remove(file, error);
        return error ? tl::unexpected(Error{file.string(), 0, 0, "cannot be removed", {}})
                     : Result<void>();
    }
    fs::create_directories(folder, error);
    return writeFileAtomically(file, writeJson({{"format", startFormat.name},
                                                {"version", startFormat.version},
                                                {"model", model},
                                                {"parameters", parameters}}));
}

} // namespace patina
