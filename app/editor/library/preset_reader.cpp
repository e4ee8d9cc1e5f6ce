// SPDX-License-Identifier: GPL-3.0-or-later
#include "library/preset_reader.h"

#include <algorithm>
#include <chrono>
#include <unordered_map>

#include <QCollator>

#include "material/file_suffixes.h"
#include "material/preset_file.h"

#include <sys/stat.h>

namespace patina {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

/// Is the age below which a stamp may not show a further change: file systems' clocks are coarse.
constexpr std::int64_t freshNanoseconds = 2'000'000'000;
constexpr auto firstShare = std::chrono::milliseconds(100);
constexpr auto tellAfter = std::chrono::milliseconds(400);
constexpr int maxFolderDepth = 12;

std::int64_t nowNanoseconds() {
    const auto now = std::chrono::system_clock::now().time_since_epoch();
    return std::chrono::duration_cast<std::chrono::nanoseconds>(now).count();
}

QString text(const std::string& bytes) {
    return QString::fromStdString(bytes);
}

QString nameOf(const PresetEntry& entry) {
    return entry.material.name.empty() ? text(entry.file.filename().string()).section('.', 0, 0)
                                       : text(entry.material.name);
}

QString searchedOf(const PresetEntry& entry) {
    QString all = entry.name + ' ' + text(entry.material.description) + ' ' +
                  text(entry.material.author) + ' ' + entry.modelLabel;
    for (const std::string& tag : entry.material.tags) {
        all += ' ' + text(tag);
    }
    return all.toCaseFolded();
}

/// Collects the preset files in and below a folder, and all folders. Links to folders are not
/// followed, since one may lead to all of the disk, or in a circle.
void walk(const fs::path& folder, int depth, std::vector<fs::path>& files,
          std::vector<fs::path>& folders) {
    std::error_code unreadable;
    fs::directory_iterator entries(folder, fs::directory_options::skip_permission_denied,
                                   unreadable);
    if (unreadable) {
        return;
    }
    folders.push_back(folder);
    std::vector<fs::path> below;
    for (const fs::directory_entry& entry : entries) {
        std::error_code gone;
        if (entry.is_directory(gone) && !entry.is_symlink(gone)) {
            below.push_back(entry.path());
        } else if (entry.path().filename().string().ends_with(presetSuffix)) {
            files.push_back(entry.path());
        }
    }
    for (const fs::path& each : below) {
        if (depth < maxFolderDepth) {
            walk(each, depth + 1, files, folders);
        }
    }
}

/// Reads presets, and reuses those that were read before and have not changed.
class Reader {
  public:
    Reader(const Catalog& catalog, const std::vector<PresetPtr>& known) : catalog_(catalog) {
        for (const PresetPtr& entry : known) {
            known_[entry->file.string()] = entry;
        }
    }

    PresetPtr read(const fs::path& file, const PresetFolder& folder, Errors& errors) {
        const auto found = known_.find(file.string());
        if (found != known_.end() && isAsRead(*found->second, folder)) {
            return found->second;
        }
        auto entry = std::make_shared<PresetEntry>();
        entry->file = file;
        entry->path = text(file.string());
        entry->folder = folder.path;
        entry->shipped = folder.shipped;
        entry->sources = {stampOf(file)};
        Checked<PresetReading> reading = readPreset(file, catalog_);
        if (!reading) {
            errors.insert(errors.end(), reading.error().begin(), reading.error().end());
            return nullptr;
        }
        entry->material = std::move(reading->material);
        for (const fs::path& parent : reading->parents) {
            entry->sources.push_back(stampOf(parent));
        }
        complete(*entry);
        return entry;
    }

  private:
    void complete(PresetEntry& entry) const {
        const Block* model = catalog_.find(kinds::models, entry.material.model.id);
        entry.modelLabel = text(model ? model->label : entry.material.model.id);
        entry.name = nameOf(entry);
        entry.searched = searchedOf(entry);
        const std::int64_t now = nowNanoseconds();
        entry.isFresh = std::ranges::any_of(entry.sources, [now](const FileStamp& stamp) {
            return now - stamp.written < freshNanoseconds;
        });
    }

    static bool isAsRead(const PresetEntry& entry, const PresetFolder& folder) {
        return !entry.isFresh && entry.folder == folder.path && entry.shipped == folder.shipped &&
               std::ranges::all_of(entry.sources, [](const FileStamp& stamp) {
                   return stampOf(stamp.file) == stamp;
               });
    }

    const Catalog& catalog_;
    std::unordered_map<std::string, PresetPtr> known_;
};

void sortByName(std::vector<PresetPtr>& entries) {
    QCollator collator;
    collator.setNumericMode(true);
    collator.setCaseSensitivity(Qt::CaseInsensitive);
    std::vector<std::pair<QCollatorSortKey, PresetPtr>> keyed;
    keyed.reserve(entries.size());
    for (const PresetPtr& entry : entries) {
        keyed.emplace_back(collator.sortKey(entry->name), entry);
    }
    std::ranges::sort(keyed, [](const auto& a, const auto& b) {
        const int order = a.first.compare(b.first);
        return order != 0 ? order < 0 : a.second->file < b.second->file;
    });
    std::ranges::transform(keyed, entries.begin(), [](const auto& each) { return each.second; });
}

} // namespace

FileStamp stampOf(const fs::path& file) {
    struct stat state {};
    if (stat(file.c_str(), &state) != 0) {
        return {file};
    }
    return {file, state.st_size, state.st_mtim.tv_sec * 1'000'000'000 + state.st_mtim.tv_nsec};
}

PresetsRead readPresets(const std::vector<PresetFolder>& folders, const Catalog& catalog,
                        const std::vector<PresetPtr>& known,
                        const std::function<bool(const PresetsRead& read)>& soFar) {
    Reader reader(catalog, known);
    PresetsRead read;
    auto tellAt = Clock::now() + firstShare;
    for (const PresetFolder& folder : folders) {
        std::vector<fs::path> files;
        walk(folder.path, 0, files, read.folders);
        for (const fs::path& file : files) {
            if (const PresetPtr entry = reader.read(file, folder, read.errors)) {
                read.entries.push_back(entry);
            }
            if (Clock::now() >= tellAt) {
                sortByName(read.entries);
                if (!soFar(read)) {
                    return read;
                }
                tellAt = Clock::now() + tellAfter;
            }
        }
    }
    sortByName(read.entries);
    return read;
}

} // namespace patina
