// SPDX-License-Identifier: GPL-3.0-or-later
#include "cost/mali_core.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "predict/malioc.h"

namespace patina {
namespace {

constexpr std::size_t memoryBytes = std::size_t(2) << 30;
constexpr double secondsEach = 30.0;

/// Is a new folder that only this user may enter, and which is removed with it; its path is empty
/// where the system refuses.
class TemporaryFolder {
  public:
    explicit TemporaryFolder(const std::filesystem::path& parent) {
        std::string name = (parent / "patina-mali-XXXXXX").string();
        if (::mkdtemp(name.data()) != nullptr) {
            path_ = name;
        }
    }

    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    ~TemporaryFolder() {
        if (!path_.empty()) {
            std::error_code ignored; // a temporary folder may stay
            std::filesystem::remove_all(path_, ignored);
        }
    }

    const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
};

bool isWritten(const std::filesystem::path& file, const std::vector<std::uint32_t>& words) {
    std::ofstream stream(file, std::ios::binary | std::ios::trunc);
    stream.write(reinterpret_cast<const char*>(words.data()),
                 std::streamsize(words.size() * sizeof(std::uint32_t)));
    stream.close();
    return !stream.fail();
}

bool isListed(const nlohmann::json& report, const std::string& core) {
    const nlohmann::json cores = report.value("cores", nlohmann::json::array());
    return std::ranges::any_of(
        cores, [&core](const nlohmann::json& each) { return each.value("core", "") == core; });
}

} // namespace

Result<MaliCore> MaliCore::create(const std::string& core) {
    const auto list = maliocReport({{"--list"}, memoryBytes, secondsEach});
    if (!list) {
        return tl::unexpected(list.error());
    }
    if (!isListed(*list, core)) {
        return failure(fmt::format("{} does not know {}", maliocName(*list), core));
    }
    std::error_code failed;
    std::filesystem::path temporary = std::filesystem::temp_directory_path(failed);
    if (failed) {
        return failure("there is no place for temporary files", "a folder in TMPDIR");
    }
    return MaliCore(core, maliocName(*list), std::move(temporary));
}

MaliCore::MaliCore(std::string core, std::string compiler, std::filesystem::path temporary)
    : core_(std::move(core)), compiler_(std::move(compiler)), temporary_(std::move(temporary)) {}

Result<PipelineStatistics> MaliCore::compile(const SpirvProgram& program) const {
    const TemporaryFolder folder(temporary_);
    const std::filesystem::path file = folder.path() / "shader.frag.spv";
    if (folder.path().empty() || !isWritten(file, program.fragment)) {
        return failure("nothing can be written in " + temporary_.string());
    }
    ::setenv("TMPDIR", folder.path().c_str(), 1);
    return maliocReport({{"--vulkan", "--core", core_, file.string()}, memoryBytes, secondsEach})
        .and_then(maliocStage)
        .map([](const StageStatistics& fragment) {
            return PipelineStatistics{{}, fragment};
        });
}

} // namespace patina
