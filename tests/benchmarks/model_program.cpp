// SPDX-License-Identifier: GPL-3.0-or-later
#include "model_program.h"

#include <string>

#include <epoxy/gl.h>
#include <fmt/format.h>

#include "catalog/table_source.h"
#include "cpu_clock.h"
#include "gl/vertex_array.h"
#include "measure/eval/eval_case.h"
#include "measure/eval/eval_source.h"
#include "shading/glsl/compile_log.h"
#include "shading/program/source_builder.h"
#include "shading/program/block_source.h"
#include "shading/program/block_use.h"

namespace patina::benchmarks {
namespace {

const std::filesystem::path folder =
    std::filesystem::path(PATINA_SOURCE_DIR) / "tests" / "benchmarks";

/// The model with its values, and what fills its slots at the start.
struct Subject {
    EvalBlock model;
    std::vector<EvalBlock> slots; ///< one per slot; null block when it starts empty
};

Subject subjectOf(const Catalog& catalog, const ModelChoice& choice) {
    const Block& model = *choice.model;
    Subject subject{{&model, defaultValues(model), choice.levels}, {}};
    for (const auto& [id, value] : choice.values) {
        subject.model.values[id] = value;
    }
    for (const Slot& slot : model.slots) {
        const bool isReplaced = choice.filler != nullptr && subject.slots.empty();
        const Block* filler =
            isReplaced ? choice.filler : catalog.find(slot.kind, slot.defaultBlock);
        subject.slots.push_back(
            {filler, filler == nullptr ? Values{} : defaultValues(*filler), choice.levels});
    }
    return subject;
}

void addParameters(SourceBuilder& builder, const EvalBlock& block, const std::string& function,
                   std::span<const SlotFill> slots) {
    // Views do the same, which also look at values that may be equal.
    const std::vector<CompiledValue> compiled =
        BlockUse(*block.block, block.values, block.accuracy).compiled();
    builder.add(constantsSource(*block.block));
    builder.add(structSource(*block.block));
    builder.add(unpackSource(*block.block, {function, compiled, slots}));
}

std::vector<SlotFill> addSlots(SourceBuilder& builder, const Subject& subject) {
    std::vector<SlotFill> filled;
    for (std::size_t i = 0; i < subject.slots.size(); ++i) {
        const EvalBlock& filler = subject.slots[i];
        const std::string& kind = subject.model.block->slots[i].kind;
        if (filler.block == nullptr) {
            builder.add(emptySlotSource(kind));
            continue;
        }
        addParameters(builder, filler, "unpack" + slotStructName(kind), {});
        builder.add(tableDeclarations(*filler.block));
        builder.addFile(filler.block->shaderFile);
        builder.add(computedTables(*filler.block));
        builder.add(slotNamesSource(*filler.block));
        filled.push_back({filler.block->kind, vec4Count(*filler.block)});
    }
    return filled;
}

std::vector<float> valuesOf(const Subject& subject) {
    std::vector<float> values;
    const auto append = [&](const EvalBlock& block) {
        for (const double x : block.packedValues()) {
            values.push_back(static_cast<float>(x));
        }
    };
    append(subject.model);
    for (const EvalBlock& slot : subject.slots) {
        if (slot.block != nullptr) {
            append(slot);
        }
    }
    return values;
}

SourceBuilder begunSource(const Catalog& catalog, std::size_t floats) {
    SourceBuilder builder(catalog.roots.front().folder);
    builder.add(fmt::format("#version 410 core\n#define OUT(T) out T\n"
                            "#define TARGET_SIZE {}.0\n"
                            "uniform vec4 parameters[{}];\n"
                            "#define PARAMETER_DATA(i) parameters[base + (i)]\n",
                            ModelProgram::targetSize, std::max<std::size_t>(floats / 4, 1)));
    builder.addFile("lib/directions.glsl");
    builder.addFile(folder / "model_cost.frag");
    return builder;
}

tl::expected<gl::Shader, Errors> compiled(unsigned stage, const Checked<ShaderSource>& source) {
    if (!source) {
        return tl::unexpected(source.error());
    }
    auto shader = gl::Shader::compile(stage, source->text);
    if (!shader) {
        return tl::unexpected(compileErrors(shader.error(), *source));
    }
    return std::move(*shader);
}

Checked<gl::Program> linked(const Catalog& catalog, const SourceBuilder& fragmentText) {
    SourceBuilder triangle(catalog.roots.front().folder);
    triangle.add("#version 410 core\n");
    triangle.addFile("passes/evaluate_triangle.glsl");
    const auto vertex = compiled(GL_VERTEX_SHADER, triangle.finish());
    const auto fragment = compiled(GL_FRAGMENT_SHADER, fragmentText.finish());
    if (!vertex || !fragment) {
        return tl::unexpected((vertex ? fragment : vertex).error());
    }
    auto program = gl::Program::link(*vertex, *fragment);
    if (!program) {
        return tl::unexpected(Errors{Error{{}, 0, 0, program.error(), {}}});
    }
    return std::move(*program);
}

} // namespace

Checked<ModelProgram> ModelProgram::link(const Catalog& catalog, const ModelChoice& choice,
                                         const std::filesystem::path& textbook) {
    const Block& model = *choice.model;
    const Subject subject = subjectOf(catalog, choice);
    const std::vector<float> values = valuesOf(subject);
    SourceBuilder builder = begunSource(catalog, values.size());
    const std::vector<SlotFill> filled = addSlots(builder, subject);
    addParameters(builder, subject.model, "unpackModel", filled);
    builder.add(tableDeclarations(model));
    builder.addFile(textbook.empty() ? model.shaderFile : textbook);
    builder.add(computedTables(model));
    builder.add(fmt::format("vec3 shaded(Directions d) {{ return {}(d, unpackModel(0)); }}\n",
                            functionName(model)));
    Checked<gl::Program> program = linked(catalog, builder);
    if (!program) {
        return tl::unexpected(program.error());
    }
    program->use();
    glUniform4fv(program->uniform("parameters"), static_cast<int>(values.size() / 4),
                 values.data());
    return ModelProgram(std::move(*program));
}

Checked<ModelProgram> ModelProgram::linkEmpty(const Catalog& catalog) {
    SourceBuilder builder = begunSource(catalog, 0);
    builder.add("vec3 shaded(Directions d) { return N + T + B + L + V; }\n");
    Checked<gl::Program> program = linked(catalog, builder);
    if (!program) {
        return tl::unexpected(program.error());
    }
    return ModelProgram(std::move(*program));
}

double ModelProgram::secondsPerPixel(int frames) const {
    program_.use();
    glFinish();
    const double began = workSeconds();
    for (int i = 0; i < frames; ++i) {
        glDrawArrays(GL_TRIANGLES, 0, 3);
    }
    glFinish();
    return (workSeconds() - began) / (double(frames) * targetSize * targetSize);
}

} // namespace patina::benchmarks
