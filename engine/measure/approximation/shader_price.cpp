// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/approximation/shader_price.h"

#include <algorithm>

#include <fmt/format.h>

#include "catalog/table_source.h"
#include "measure/error/parallel.h"
#include "measure/eval/eval_source.h"
#include "measure/time/instruction_count.h"
#include "predict/family_compiler.h"
#include "shading/glsl/shader_file.h"
#include "shading/program/table_writer.h"

namespace patina {
namespace {

constexpr double weightOfTranscendental = 4.0;

/// Returns what takes the place of the function that reads a case: arguments differ from pixel to
/// pixel, and values are uniform, as in the programs that draw.
std::string pricedCaseData(std::size_t places, std::size_t values) {
    std::string code = fmt::format("uniform vec4 caseValues[{}];\n", values);
    std::string choice;
    for (std::size_t i = 0; i < places; ++i) {
        code += fmt::format("in vec4 casePlace{};\n", i);
        choice += fmt::format("i == {} ? casePlace{} : ", i, i);
    }
    return code + fmt::format("vec4 caseData(int i) {{\n    return {}caseValues[i - {}];\n}}\n",
                              choice, places);
}

std::string vertexStage(std::size_t places) {
    std::string outputs;
    std::string body;
    for (std::size_t i = 0; i < places; ++i) {
        outputs += fmt::format("out vec4 casePlace{};\n", i);
        body += fmt::format("    casePlace{} = casePlaces[{}] * corner.xyxy;\n", i, i);
    }
    return fmt::format("#version 410 core\nuniform vec4 casePlaces[{}];\n{}void main() {{\n"
                       "    vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? "
                       "3.0 : -1.0);\n{}    gl_Position = vec4(corner, 0.0, 1.0);\n}}\n",
                       places, outputs, body);
}

/// Replaces the whole definition of a function, where the text has one.
void replaceFunction(std::vector<ShaderEdit>& edits, const ShaderSyntax& syntax,
                     std::string_view name, std::string code) {
    if (const int index = syntax.functionNamed(name); index >= 0) {
        const ParsedFunction& function = syntax.functions[static_cast<std::size_t>(index)];
        edits.push_back({function.first, function.last, std::move(code), {}, -1});
    }
}

/// Returns the text that tables of a block are read by: that of the shader passes. It is empty
/// where it cannot be read, and then nothing that reads a table compiles.
std::string tableReaders(const ShaderSource& source) {
    for (const std::filesystem::path file : source.files) {
        if (file.filename() == "evaluate.glsl") {
            return readShaderFile(file.parent_path() / "block_tables.glsl").value_or(std::string());
        }
    }
    return {};
}

/// Lets the tables of a block be read in place of being computed.
void readTables(std::vector<ShaderEdit>& edits, const ShaderSyntax& syntax, const Block* block) {
    if (block != nullptr) {
        for (const BlockTable& table : block->tables) {
            replaceFunction(edits, syntax, tableFunction(*block, table),
                            readingCode(*block, table));
        }
    }
}

double weighed(const InstructionCount& count) {
    return count.arithmetic + count.branch + count.memory +
           weightOfTranscendental * (count.transcendental + count.texture);
}

} // namespace

std::string readingCode(const Block& block, const BlockTable& table) {
    TableLayout layout;
    layout.places.push_back({&block, &table, TableReader::Model, 0, 0});
    return textBehindBlock(block, layout, SurfaceOutput::Picture);
}

ShaderPrice::ShaderPrice(const EvalCase& subject, const ShaderSource& source,
                         const ShaderSyntax& syntax, const GpuFamily& family)
    : source_(source), syntax_(syntax), family_(family),
      places_(std::max<std::size_t>((placeTexels(subject).size() + 3) / 4, 1)),
      values_(std::max<std::size_t>((valueTexels(subject).size() + 3) / 4, 1)) {
    replaceFunction(frame_, syntax, "caseData",
                    tableReaders(source) + pricedCaseData(places_, values_));
    readTables(frame_, syntax, subject.block.block);
    readTables(frame_, syntax, subject.slot.block);
    replaceFunction(frame_, syntax, "givenUnit",
                    "vec3 givenUnit(vec3 v, vec3 fallback) {\n    return v;\n}\n");
    replaceFunction(frame_, syntax, "tangentAlong",
                    "vec3 tangentAlong(vec3 n, vec3 t) {\n    return t;\n}\n");
}

ProgramText ShaderPrice::programOf(const std::vector<ShaderEdit>& edits) const {
    std::vector<ShaderEdit> all = edits;
    for (ShaderEdit& edit : all) {
        if (!edit.tableRead.empty()) {
            edit.helper.clear();
            edit.tableComputed = edit.tableRead;
        }
    }
    all.insert(all.end(), frame_.begin(), frame_.end());
    sortEdits(all);
    return {vertexStage(places_), editedSource(source_, syntax_, all).text};
}

std::vector<std::optional<double>> ShaderPrice::of(const std::vector<std::vector<ShaderEdit>>& ways,
                                                   const std::function<bool()>& isStopped) {
    std::vector<ProgramText> programs;
    for (const std::vector<ShaderEdit>& edits : ways) {
        programs.push_back(programOf(edits));
    }
    std::vector<std::optional<double>> prices(ways.size());
    if (!counts_) {
        const GpuFamily* const families[] = {&family_};
        FamilyCompilerOptions options;
        options.isStopped = isStopped;
        options.processes = parallelParts();
        const auto compiled = compileForFamilies(families, programs, options);
        for (std::size_t i = 0; compiled && i < prices.size(); ++i) {
            if (compiled->programs[i] && compiled->programs[i]->contains(family_.id)) {
                prices[i] = compiled->programs[i]->at(family_.id).fragment.cycles;
            }
        }
        if (compiled || isStopped()) {
            return prices;
        }
        counts_ = true;
        note_ = compiled.error().text();
    }
    for (std::size_t i = 0; i < prices.size() && !isStopped(); ++i) {
        if (const auto count = countInstructions(programs[i].fragment)) {
            prices[i] = weighed(*count);
        }
    }
    return prices;
}

std::string ShaderPrice::unit() const {
    return counts_ ? "instructions" : fmt::format("cycles of {} for 64 pixels", family_.label);
}

} // namespace patina
