// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/time/instruction_count.h"

#include <algorithm>
#include <cstddef>
#include <unordered_map>
#include <vector>

#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>
#include <spirv-tools/optimizer.hpp>
#include <spirv/unified1/GLSL.std.450.h>
#define SPV_ENABLE_UTILITY_CODE // HasResultAndType
#include <spirv/unified1/spirv.hpp>

#include "shading/glsl/compile_log.h"

namespace patina {
namespace {

constexpr std::size_t headerWords = 5;

/// Initialises glslang for as long as the program runs.
struct GlslangProcess {
    GlslangProcess() { glslang::InitializeProcess(); }
    ~GlslangProcess() { glslang::FinalizeProcess(); }
    GlslangProcess(const GlslangProcess&) = delete;
    GlslangProcess& operator=(const GlslangProcess&) = delete;
};

Result<std::vector<std::uint32_t>> compiled(const std::string& source,
                                            EShLanguage stage = EShLangFragment) {
    static const GlslangProcess process;
    constexpr auto messages = static_cast<EShMessages>(EShMsgSpvRules);
    const char* text = source.c_str();
    glslang::TShader shader(stage);
    shader.setStrings(&text, 1);
    shader.setEnvInput(glslang::EShSourceGlsl, stage, glslang::EShClientOpenGL, 100);
    shader.setEnvClient(glslang::EShClientOpenGL, glslang::EShTargetOpenGL_450);
    shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_0);
    shader.setAutoMapLocations(true);
    shader.setAutoMapBindings(true);
    if (!shader.parse(GetDefaultResources(), 410, false, messages)) {
        return failure(std::string("the shader cannot be counted: ") + shader.getInfoLog());
    }
    glslang::TProgram program;
    program.addShader(&shader);
    if (!program.link(messages) || !program.mapIO()) {
        return failure(std::string("the shader cannot be counted: ") + program.getInfoLog());
    }
    std::vector<std::uint32_t> module;
    glslang::GlslangToSpv(*program.getIntermediate(stage), module);
    return module;
}

enum class Kind { None, Arithmetic, Transcendental, Texture, Branch, Memory };

Kind kindOfFunction(std::uint32_t function) {
    if (function >= GLSLstd450Sin && function <= GLSLstd450InverseSqrt) {
        return Kind::Transcendental;
    }
    switch (function) {
    case GLSLstd450Length:
    case GLSLstd450Distance:
    case GLSLstd450Normalize:
        return Kind::Transcendental;
    default:
        return Kind::Arithmetic;
    }
}

Kind kindOf(spv::Op op) {
    switch (op) {
    case spv::OpFDiv:
    case spv::OpFRem:
    case spv::OpFMod:
    case spv::OpSDiv:
    case spv::OpUDiv:
        return Kind::Transcendental;
    case spv::OpLoad:
    case spv::OpStore:
        return Kind::Memory;
    case spv::OpBranchConditional:
    case spv::OpSwitch:
    case spv::OpKill:
        return Kind::Branch;
    default:
        break;
    }
    const bool isImage = op >= spv::OpImageSampleImplicitLod && op <= spv::OpImageQuerySamples;
    const bool isConversion = op >= spv::OpConvertFToU && op <= spv::OpBitcast;
    const bool isSum = op >= spv::OpSNegate && op <= spv::OpFwidthCoarse;
    return isImage ? Kind::Texture : isConversion || isSum ? Kind::Arithmetic : Kind::None;
}

/// Goes through a module and keeps how many numbers each value has.
class Counter {
  public:
    explicit Counter(std::span<const std::uint32_t> module) : module_(module) {}

    InstructionCount count() {
        for (std::size_t at = headerWords; at < module_.size();) {
            const std::size_t words = module_[at] >> 16;
            if (words == 0 || at + words > module_.size()) {
                break;
            }
            take(static_cast<spv::Op>(module_[at] & 0xffffu), module_.subspan(at, words));
            at += words;
        }
        return count_;
    }

  private:
    using Words = std::span<const std::uint32_t>;

    void take(spv::Op op, Words words) {
        if (op == spv::OpTypeVector) {
            sizes_[words[1]] = static_cast<int>(words[3]);
        }
        bool hasResult = false;
        bool hasType = false;
        spv::HasResultAndType(op, &hasResult, &hasType);
        if (hasResult && hasType) {
            typeOf_[words[2]] = words[1];
        }
        const Kind kind = op == spv::OpExtInst ? kindOfFunction(words[4]) : kindOf(op);
        add(kind, isPerNumber(kind) && hasType ? numbers(op, words) : 1);
    }

    static bool isPerNumber(Kind kind) {
        return kind == Kind::Arithmetic || kind == Kind::Transcendental;
    }

    /// Returns how many numbers a dot product multiplies, and how many anything else results in.
    int numbers(spv::Op op, Words words) const {
        return op == spv::OpDot ? sizeOf(typeOf_.at(words[3])) : sizeOf(words[1]);
    }

    int sizeOf(std::uint32_t type) const {
        const auto found = sizes_.find(type);
        return found == sizes_.end() ? 1 : found->second;
    }

    void add(Kind kind, int count) {
        switch (kind) {
        case Kind::Arithmetic:
            count_.arithmetic += count;
            break;
        case Kind::Transcendental:
            count_.transcendental += count;
            break;
        case Kind::Texture:
            count_.texture += count;
            break;
        case Kind::Branch:
            count_.branch += count;
            break;
        case Kind::Memory:
            count_.memory += count;
            break;
        case Kind::None:
            break;
        }
    }

    Words module_;
    InstructionCount count_;
    std::unordered_map<std::uint32_t, int> sizes_; ///< are counts of components by vector type
    std::unordered_map<std::uint32_t, std::uint32_t> typeOf_; ///< maps a value to its type
};

Errors stageMistakes(const ShaderSource& source, EShLanguage stage) {
    const Result<std::vector<std::uint32_t>> module = compiled(source.text, stage);
    if (module) {
        return {};
    }
    const std::string& log = module.error().problem;
    return compileErrors(log.substr(std::min(log.find("ERROR:"), log.size())), source);
}

} // namespace

InstructionCount countInstructions(std::span<const std::uint32_t> module) {
    return Counter(module).count();
}

Result<InstructionCount> countInstructions(const std::string& fragment) {
    const Result<std::vector<std::uint32_t>> module = compiled(fragment);
    if (!module) {
        return tl::unexpected(module.error());
    }
    spvtools::Optimizer optimizer(SPV_ENV_OPENGL_4_5);
    optimizer.RegisterPerformancePasses();
    std::vector<std::uint32_t> optimised;
    if (!optimizer.Run(module->data(), module->size(), &optimised)) {
        return failure("the shader cannot be counted: its code cannot be optimised");
    }
    return countInstructions(std::span<const std::uint32_t>(optimised));
}

Errors compilerMistakes(const ShaderSource& fragment) {
    return stageMistakes(fragment, EShLangFragment);
}

Errors compilerMistakes(const ProgramSource& program) {
    Errors all = stageMistakes(program.vertex, EShLangVertex);
    if (program.geometry) {
        addNew(all, stageMistakes(*program.geometry, EShLangGeometry));
    }
    addNew(all, stageMistakes(program.fragment, EShLangFragment));
    return all;
}

} // namespace patina
