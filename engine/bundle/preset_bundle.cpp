// SPDX-License-Identifier: GPL-3.0-or-later
#include "bundle/preset_bundle.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <map>
#include <memory>
#include <set>

#include <fmt/format.h>

#include <sys/stat.h>
#include <unzip.h>
#include <zip.h>

#include "catalog/json_text.h"
#include "core/atomic_file.h"
#include "core/ordinary_file.h"
#include "material/file_suffixes.h"
#include "material/preset_file.h"
#include "material/texture_path.h"
#include "material/variant.h"
#include "measured/measured_reflectance.h"

namespace patina {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view pictureFolder = "pictures/";
constexpr std::array imageSuffixes{".png",  ".jpg", ".jpeg", ".exr", ".hdr", ".tif",
                                   ".tiff", ".dds", ".tga",  ".bmp", ".webp"};
constexpr std::uintmax_t maxBundleBytes = std::uintmax_t(2) << 30;
constexpr int unixHost = 3; ///< is the system in "version made by" for which the attributes have a
                            ///< file mode

struct CloseUnzip {
    void operator()(void* file) const { unzClose(file); }
};
struct CloseZip {
    void operator()(void* file) const { zipClose(file, nullptr); }
};
using Unzip = std::unique_ptr<void, CloseUnzip>;
using Zip = std::unique_ptr<void, CloseZip>;

bool isPreset(std::string_view name) {
    return name.ends_with(presetSuffix);
}

bool isImage(const fs::path& name) {
    std::string suffix = name.extension().string();
    std::ranges::transform(suffix, suffix.begin(),
                           [](unsigned char letter) { return std::tolower(letter); });
    return std::ranges::find(imageSuffixes, suffix) != imageSuffixes.end();
}

/// Is the date of every entry, the earliest that a zip file can have: the same presets make the
/// same bytes.
constexpr tm_zip firstDate{0, 0, 0, 1, 0, 1980};

bool add(void* zip, const std::string& name, std::string_view bytes) {
    constexpr uLong utf8Names = 1u << 11;
    zip_fileinfo info{};
    info.tmz_date = firstDate;
    const int opened =
        zipOpenNewFileInZip4_64(zip, name.c_str(), &info, nullptr, 0, nullptr, 0, nullptr,
                                Z_DEFLATED, Z_DEFAULT_COMPRESSION, 0, -MAX_WBITS, DEF_MEM_LEVEL,
                                Z_DEFAULT_STRATEGY, nullptr, 0, 0, utf8Names, 1);
    return opened == ZIP_OK &&
           zipWriteInFileInZip(zip, bytes.data(), static_cast<unsigned>(bytes.size())) == ZIP_OK &&
           zipCloseFileInZip(zip) == ZIP_OK;
}

/// Writes presets into an open zip; a file that several of them name is written once.
class BundleWriter {
  public:
    explicit BundleWriter(void* zip) : zip_(zip) {}

    BundleOutcome add(const BundledPreset& preset) {
        Material material = preset.material;
        setParent(material, {});
        if (const Result<void> added = addFiles(material); !added) {
            return {preset.name, added.error().problem};
        }
        const std::string stem = unused(preset.name, presets_);
        write(stem + std::string(presetSuffix), writeJson(toJson(material)));
        if (!preset.picture.empty()) {
            write(fmt::format("{}{}.png", pictureFolder, stem), preset.picture);
        }
        return {preset.name, ""};
    }

    /// Returns whether something could not be written: the file is then damaged.
    bool hasFailed() const { return hasFailed_; }

  private:
    /// Writes the files that a material names, and names them by their paths in the bundle.
    Result<void> addFiles(Material& material) {
        for (auto& [key, use] : material.textures) {
            if (isVertexColors(use.file)) {
                continue;
            }
            const Result<std::string> name =
                use.outside ? failure(fmt::format("\"{}\" lies outside its folder and is not read",
                                                  use.file))
                : isImage(use.file) ? addFile(use.file, "images")
                                    : failure(fmt::format("\"{}\" is no image", use.file));
            if (!name) {
                return tl::unexpected(name.error());
            }
            use.file = *name;
        }
        for (auto& [id, value] : material.model.parameters) {
            auto* file = std::get_if<std::string>(&value);
            if (file == nullptr || !isMeasuredFile(*file)) {
                continue;
            }
            const Result<std::string> name = addFile(*file, "measured");
            if (!name) {
                return tl::unexpected(name.error());
            }
            *file = *name;
        }
        return {};
    }

    /// Writes a file unless it is there already, and returns its path in the bundle.
    Result<std::string> addFile(const std::string& file, std::string_view folder) {
        const auto [known, isNew] = files_.try_emplace(file);
        if (isNew) {
            const fs::path path(file);
            const Result<std::string> bytes = readFile(path, BundleLimits{}.fileBytes);
            if (!bytes) {
                files_.erase(known);
                return tl::unexpected(bytes.error());
            }
            known->second = fmt::format("{}/{}{}", folder, unused(path.stem().string(), stems_),
                                        path.extension().string());
            write(known->second, *bytes);
        }
        return known->second;
    }

    void write(const std::string& name, std::string_view bytes) {
        hasFailed_ = hasFailed_ || !patina::add(zip_, name, bytes);
    }

    /// Returns `stem`, with a number where `others` has it already, and adds the result to
    /// `others`.
    static std::string unused(std::string stem, std::set<std::string>& others) {
        std::ranges::replace(stem, '/', '-');
        std::string name = stem;
        for (int number = 2; !others.insert(name).second; ++number) {
            name = fmt::format("{}-{}", stem, number);
        }
        return name;
    }

    void* zip_;
    std::map<std::string, std::string> files_; ///< maps a file to its path in the bundle
    std::set<std::string> stems_;
    std::set<std::string> presets_;
    bool hasFailed_ = false;
};

/// Unpacks the entries of a zip into a folder and keeps an outcome for each.
class BundleReader {
  public:
    BundleReader(void* zip, fs::path folder, const BundleLimits& limits)
        : zip_(zip), folder_(std::move(folder)), limits_(limits) {}

    Result<std::vector<BundleOutcome>> run() {
        unz_global_info64 all{};
        if (unzGetGlobalInfo64(zip_, &all) != UNZ_OK) {
            return failure("it is no zip file");
        }
        if (all.number_entry > limits_.files) {
            return failure(
                fmt::format("it holds {} files, more than {}", all.number_entry, limits_.files));
        }
        int found = all.number_entry > 0 ? unzGoToFirstFile(zip_) : UNZ_END_OF_LIST_OF_FILE;
        for (; found == UNZ_OK; found = unzGoToNextFile(zip_)) {
            if (auto taken = takeEntry(); !taken) {
                return tl::unexpected(taken.error());
            }
        }
        return found == UNZ_END_OF_LIST_OF_FILE ? Result<std::vector<BundleOutcome>>(outcomes_)
                                                : failure("its list of files is damaged");
    }

  private:
    Result<void> takeEntry() {
        std::array<char, 4096> name{};
        unz_file_info64 info{};
        if (unzGetCurrentFileInfo64(zip_, &info, name.data(), name.size() - 1, nullptr, 0, nullptr,
                                    0) != UNZ_OK) {
            return failure("its list of files is damaged");
        }
        const std::string entry = name.data();
        if (entry.ends_with('/') || entry.starts_with(pictureFolder)) {
            return {};
        }
        const std::string why = whyNot(entry, info);
        if (!why.empty()) {
            outcomes_.push_back({entry, why});
            return {};
        }
        return unpack(entry);
    }

    std::string whyNot(const std::string& entry, const unz_file_info64& info) const {
        if (info.size_filename >= 4096 || info.size_filename != entry.size()) {
            return "its name cannot be read";
        }
        if (!staysInFolder(entry)) {
            return "its path leads out of the bundle";
        }
        const bool hasMode = (info.version >> 8) == unixHost;
        const auto mode = static_cast<mode_t>(info.external_fa >> 16);
        if (hasMode && (mode & S_IFMT) != 0 && !S_ISREG(mode)) {
            return "it is no ordinary file";
        }
        if (!isPreset(entry) && !isImage(entry) && !isMeasuredFile(entry)) {
            return "it is neither a preset nor an image nor a measured file";
        }
        std::error_code unreadable;
        return fs::exists(folder_ / entry, unreadable) ? "the bundle has two files of this name"
                                                       : "";
    }

    Result<void> unpack(const std::string& entry) {
        const fs::path file = folder_ / entry;
        std::error_code failed;
        fs::create_directories(file.parent_path(), failed);
        std::ofstream out(file, std::ios::binary);
        if (failed || !out) {
            outcomes_.push_back({entry, "it could not be written"});
            return {};
        }
        if (unzOpenCurrentFile(zip_) != UNZ_OK) {
            fs::remove(file, failed);
            outcomes_.push_back({entry, "it cannot be unpacked"});
            return {};
        }
        const Result<bool> whole = copyCurrent(entry, out);
        const bool isIntact = unzCloseCurrentFile(zip_) == UNZ_OK; // also its checksum
        out.close();
        if (!whole) {
            return tl::unexpected(whole.error());
        }
        if (!*whole || !isIntact || !out) {
            fs::remove(file, failed);
            outcomes_.push_back({entry, out ? "it is damaged" : "it could not be written"});
        } else {
            outcomes_.push_back({entry, ""});
        }
        return {};
    }

    /// Unpacks the current entry and returns false when it is damaged. Fails when the bytes that
    /// come out exceed a limit, whatever size the zip declares.
    Result<bool> copyCurrent(const std::string& entry, std::ofstream& out) {
        std::array<char, 65536> bytes{};
        std::uint64_t size = 0;
        for (;;) {
            const int read = unzReadCurrentFile(zip_, bytes.data(), bytes.size());
            if (read <= 0) {
                return read == 0;
            }
            size += static_cast<std::uint64_t>(read);
            all_ += static_cast<std::uint64_t>(read);
            if (size > limits_.fileBytes || all_ > limits_.bytes) {
                return failure(fmt::format("\"{}\" makes it larger than it may be", entry));
            }
            out.write(bytes.data(), read);
        }
    }

    void* zip_;
    fs::path folder_;
    BundleLimits limits_;
    std::uint64_t all_ = 0;
    std::vector<BundleOutcome> outcomes_;
};

/// Returns the path of a folder that does not exist yet, named after the bundle.
fs::path newFolder(const fs::path& bundle, const fs::path& folder) {
    const std::string stem = bundle.stem().empty() ? "presets" : bundle.stem().string();
    fs::path place = folder / stem;
    std::error_code unreadable;
    for (int number = 2; fs::exists(place, unreadable); ++number) {
        place = folder / fmt::format("{}-{}", stem, number);
    }
    return place;
}

Error cannotBeWritten(const fs::path& file) {
    return {file.string(), 0, 0, "it cannot be written", {}};
}

Error at(const fs::path& file, Error error) {
    error.file = file.string();
    return error;
}

} // namespace

Result<std::vector<BundleOutcome>> exportBundle(const fs::path& file,
                                                const std::vector<BundledPreset>& presets) {
    auto draft = AtomicFile::create(file);
    if (!draft) {
        return tl::unexpected(draft.error());
    }
    const std::string open = fmt::format("/proc/self/fd/{}", draft->descriptor());
    Zip zip(zipOpen64(open.c_str(), APPEND_STATUS_CREATE));
    if (!zip) {
        return tl::unexpected(cannotBeWritten(file));
    }
    BundleWriter writer(zip.get());
    std::vector<BundleOutcome> outcomes;
    for (const BundledPreset& preset : presets) {
        outcomes.push_back(writer.add(preset));
    }
    const bool areAllLost =
        !presets.empty() && std::ranges::none_of(outcomes, [](const BundleOutcome& outcome) {
            return outcome.problem.empty();
        });
    if (areAllLost) {
        return outcomes;
    }
    // The list of files is written last: without it nothing can be read.
    if (zipClose(zip.release(), nullptr) != ZIP_OK || writer.hasFailed()) {
        return tl::unexpected(cannotBeWritten(file));
    }
    if (auto saved = draft->commit(); !saved) {
        return tl::unexpected(saved.error());
    }
    return outcomes;
}

Result<BundleImport> importBundle(const fs::path& file, const fs::path& folder,
                                  const BundleLimits& limits) {
    const Result<OrdinaryFile> opened = OrdinaryFile::open(file, maxBundleBytes);
    if (!opened) {
        return tl::unexpected(opened.error());
    }
    const std::string open = fmt::format("/proc/self/fd/{}", opened->descriptor());
    const Unzip zip(unzOpen64(open.c_str()));
    if (!zip) {
        return tl::unexpected(Error{file.string(), 0, 0, "it is no zip file", {}});
    }
    BundleImport import{newFolder(file, folder), {}};
    std::error_code failed;
    fs::create_directories(import.folder, failed);
    if (failed) {
        return tl::unexpected(
            Error{import.folder.string(), 0, 0, "the folder cannot be made", failed.message()});
    }
    Result<std::vector<BundleOutcome>> outcomes =
        BundleReader(zip.get(), import.folder, limits).run();
    const bool isEmpty = outcomes && std::ranges::none_of(*outcomes, [](const auto& outcome) {
                             return outcome.problem.empty();
                         });
    if (!outcomes || isEmpty) {
        fs::remove_all(import.folder, failed);
    }
    if (!outcomes) {
        return tl::unexpected(at(file, outcomes.error()));
    }
    import.outcomes = std::move(*outcomes);
    return import;
}

} // namespace patina
