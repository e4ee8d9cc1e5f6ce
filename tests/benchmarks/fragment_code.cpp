// SPDX-License-Identifier: GPL-3.0-or-later
#include "fragment_code.h"

#include <array>
#include <cstring>
#include <fstream>
#include <string>

#include <dlfcn.h>
#include <fcntl.h>
#include <link.h>
#include <unistd.h>

#include "support/program.h"

namespace patina::benchmarks {
namespace {

/// Where the library lies that the driver has loaded; empty: it has none.
std::string loadedCompiler() {
    std::string path;
    dl_iterate_phdr(
        [](dl_phdr_info* info, std::size_t, void* found) {
            if (std::strstr(info->dlpi_name, "libLLVM") != nullptr) {
                *static_cast<std::string*>(found) = info->dlpi_name;
            }
            return 0;
        },
        &path);
    return path;
}

/// What the process writes to its standard error stream in the meantime goes to a file.
class CaughtErrors {
  public:
    explicit CaughtErrors(const std::filesystem::path& file) : kept_(dup(STDERR_FILENO)) {
        const int caught = open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
        dup2(caught, STDERR_FILENO);
        close(caught);
    }
    ~CaughtErrors() {
        dup2(kept_, STDERR_FILENO);
        close(kept_);
    }
    CaughtErrors(const CaughtErrors&) = delete;
    CaughtErrors& operator=(const CaughtErrors&) = delete;

  private:
    int kept_;
};

/// A function as the remarks tell it, block by block.
class CountedFunction {
  public:
    void addBlock(const std::string& name, long instructions) {
        isInLoop_ = (isInLoop_ || name == "loop_begin") && name != "loop_exit";
        isFragment_ = isFragment_ || name == "loop_body";
        weighed_ += (isInLoop_ ? 2 : 1) * instructions;
    }

    /// Only fragments go through a loop that keeps this name.
    long ofFragments() const { return isFragment_ ? weighed_ : 0; }

  private:
    bool isInLoop_ = false;
    bool isFragment_ = false;
    long weighed_ = 0;
};

/// "remark: ...: BasicBlock: <name>", ": <instructions>", ..., "... instructions in function".
long countedIn(const std::filesystem::path& remarks) {
    const std::string block = "BasicBlock: ";
    long sum = 0;
    CountedFunction function;
    std::string name;
    std::ifstream file(remarks);
    for (std::string line; std::getline(file, line);) {
        if (const std::size_t place = line.find(block); place != std::string::npos) {
            name = line.substr(place + block.size());
        } else if (line.starts_with(": ")) {
            function.addBlock(name, std::stol(line.substr(2)));
        } else if (line.ends_with("instructions in function")) {
            sum += function.ofFragments();
            function = {};
        }
    }
    return sum;
}

} // namespace

Result<FragmentCode> FragmentCode::create() {
    const std::string path = loadedCompiler();
    if (path.empty()) {
        return failure("the driver compiles shaders without LLVM", "llvmpipe");
    }
    void* library = dlopen(path.c_str(), RTLD_NOW | RTLD_NOLOAD);
    using Parse = void (*)(int, const char* const*, const char*);
    const auto parse = library == nullptr
                           ? nullptr
                           : reinterpret_cast<Parse>(dlsym(library, "LLVMParseCommandLineOptions"));
    if (parse == nullptr) {
        return failure(path + " takes no options", "a shared library of LLVM");
    }
    constexpr std::array options{"patina-benchmarks", "-pass-remarks-analysis=asm-printer"};
    parse(int(options.size()), options.data(), nullptr);
    return FragmentCode();
}

long FragmentCode::instructionsOf(const std::function<void()>& work) const {
    const tests::TemporaryFolder folder;
    const std::filesystem::path remarks = folder.path() / "remarks";
    {
        const CaughtErrors caught(remarks);
        work();
    }
    return countedIn(remarks);
}

} // namespace patina::benchmarks
