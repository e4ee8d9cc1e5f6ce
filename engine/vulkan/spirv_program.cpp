// SPDX-License-Identifier: GPL-3.0-or-later
#include "vulkan/spirv_program.h"

#include <algorithm>

#include <glslang/MachineIndependent/iomapper.h>
#include <glslang/MachineIndependent/localintermediate.h>
#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>

namespace patina {
namespace {

constexpr auto messages = static_cast<EShMessages>(EShMsgSpvRules | EShMsgVulkanRules);
constexpr int usualVersion = 410;

/// Initialises glslang for as long as the program runs.
struct GlslangLifetime {
    GlslangLifetime() { glslang::InitializeProcess(); }
    ~GlslangLifetime() { glslang::FinalizeProcess(); }
    GlslangLifetime(const GlslangLifetime&) = delete;
    GlslangLifetime& operator=(const GlslangLifetime&) = delete;
};

/// Is one stage whose text glslang has read; its text must outlive it.
class Stage {
  public:
    Stage(EShLanguage stage, const std::string& text) : shader_(stage), text_(text.c_str()) {
        shader_.setStrings(&text_, 1);
        shader_.setEnvInput(glslang::EShSourceGlsl, stage, glslang::EShClientVulkan, 100);
        shader_.setEnvInputVulkanRulesRelaxed();
        shader_.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_1);
        shader_.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_3);
        shader_.setAutoMapLocations(true);
        shader_.setAutoMapBindings(true);
    }

    bool parse() { return shader_.parse(GetDefaultResources(), usualVersion, false, messages); }
    glslang::TShader& shader() { return shader_; }

  private:
    glslang::TShader shader_;
    const char* text_;
};

tl::unexpected<Error> notCompiled(const std::string& log) {
    return failure("the shader does not compile for Vulkan: " + log);
}

bool isTexelBuffer(const glslang::TType& type) {
    return type.getSampler().isBuffer();
}

std::vector<SpirvProgram::Binding> bindingsOf(const glslang::TProgram& program) {
    using Resource = SpirvProgram::Resource;
    std::vector<SpirvProgram::Binding> bindings;
    const auto add = [&](int number, Resource resource) {
        const auto found =
            std::ranges::find(bindings, std::uint32_t(number), &SpirvProgram::Binding::number);
        if (number >= 0 && found == bindings.end()) {
            bindings.push_back({std::uint32_t(number), resource});
        }
    };
    for (int i = 0; i < program.getNumUniformBlocks(); ++i) {
        add(program.getUniformBlock(i).getBinding(), Resource::UniformBlock);
    }
    for (int i = 0; i < program.getNumUniformVariables(); ++i) {
        const glslang::TObjectReflection& uniform = program.getUniform(i);
        if (const glslang::TType* type = uniform.getType();
            type != nullptr && type->getBasicType() == glslang::EbtSampler) {
            add(uniform.getBinding(),
                isTexelBuffer(*type) ? Resource::TexelBuffer : Resource::Sampler);
        }
    }
    return bindings;
}

SpirvProgram::Attribute::Type attributeType(const glslang::TType& type) {
    using Type = SpirvProgram::Attribute::Type;
    return type.getBasicType() == glslang::EbtInt    ? Type::Int
           : type.getBasicType() == glslang::EbtUint ? Type::Uint
                                                     : Type::Float;
}

std::vector<SpirvProgram::Attribute> attributesOf(const glslang::TProgram& program) {
    std::vector<SpirvProgram::Attribute> attributes;
    for (int i = 0; i < program.getNumPipeInputs(); ++i) {
        const glslang::TType* type = program.getPipeInput(i).getType();
        if (type == nullptr || type->isBuiltIn() || !type->getQualifier().hasLocation()) {
            continue;
        }
        const int locations = type->isMatrix() ? type->getMatrixCols() : 1;
        for (int column = 0; column < locations; ++column) {
            attributes.push_back({type->getQualifier().layoutLocation + std::uint32_t(column),
                                  attributeType(*type)});
        }
    }
    return attributes;
}

std::uint32_t outputsOf(const glslang::TProgram& program) {
    std::uint32_t count = 0;
    for (int i = 0; i < program.getNumPipeOutputs(); ++i) {
        const glslang::TType* type = program.getPipeOutput(i).getType();
        if (type != nullptr && !type->isBuiltIn() && type->getQualifier().hasLocation()) {
            count = std::max(count, std::uint32_t(type->getQualifier().layoutLocation) + 1);
        }
    }
    return count;
}

/// Gives the resources and the interface numbers that agree between the stages.
bool giveNumbers(glslang::TProgram& program) {
    glslang::TDefaultGlslIoResolver resolver(*program.getIntermediate(EShLangVertex));
    glslang::TGlslIoMapper mapper;
    return program.mapIO(&resolver, &mapper);
}

} // namespace

Result<SpirvProgram> spirvProgram(const std::string& vertex, const std::string& fragment) {
    static const GlslangLifetime lifetime;
    Stage first(EShLangVertex, vertex);
    Stage second(EShLangFragment, fragment);
    for (Stage* stage : {&first, &second}) {
        if (!stage->parse()) {
            return notCompiled(stage->shader().getInfoLog());
        }
    }
    glslang::TProgram program;
    program.addShader(&first.shader());
    program.addShader(&second.shader());
    if (!program.link(messages) || !giveNumbers(program) ||
        !program.buildReflection(EShReflectionSeparateBuffers | EShReflectionAllBlockVariables)) {
        return notCompiled(program.getInfoLog());
    }
    SpirvProgram result;
    glslang::GlslangToSpv(*program.getIntermediate(EShLangVertex), result.vertex);
    glslang::GlslangToSpv(*program.getIntermediate(EShLangFragment), result.fragment);
    result.bindings = bindingsOf(program);
    result.attributes = attributesOf(program);
    result.outputs = outputsOf(program);
    return result;
}

} // namespace patina
