// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/eval/eval_source.h"

#include <algorithm>
#include <cctype>

#include <fmt/format.h>

#include "catalog/table_source.h"
#include "material/measured_preset.h"
#include "measure/eval/eval_reference.h"
#include "shading/program/block_source.h"
#include "shading/program/source_builder.h"

namespace patina {
namespace {

using Subject = EvalCase::Subject;

int texelsOf(std::size_t numbers) {
    return static_cast<int>((numbers + 3) / 4);
}

const Value& valueOf(const EvalBlock& block, const Parameter& parameter) {
    const auto found = block.values.find(parameter.id);
    return found == block.values.end() ? parameter.defaultValue : found->second;
}

std::string_view compiledText(const Parameter& parameter, const Value& value) {
    if (parameter.compiled == Compiled::WhenZero) {
        return value == Value(0.0) ? "zero" : "nonzero";
    }
    const ParameterTypeInfo& info = infoOf(parameter.type);
    return info.stateWord(parameter, info.state(parameter, conformed(parameter, value)));
}

std::string programKey(const EvalBlock& block) {
    if (block.block == nullptr) {
        return {};
    }
    std::string key = block.block->kind + '/' + block.block->id;
    for (const CompiledValue& value : compiledValues(block)) {
        key += fmt::format(" {}={}", value.id, value.value);
    }
    return key + fmt::format(" {}", measuredTableOf(*block.block, block.values));
}

/// Returns how many texels of arguments precede the values: those of n, t, l and v, or of the one
/// argument.
int argumentTexels(const EvalCase& request) {
    if (request.subject == Subject::Fields) {
        return texelsOf(numbersOf(fieldsOf(request)));
    }
    return request.subject == Subject::Model ? 4 : request.subject == Subject::Fog ? 2 : 1;
}

std::string header(const EvalShape& shape) {
    return fmt::format("#version 410 core\n#define OUT(T) out T\n#define CASE_TEXELS {}\n"
                       "#define RESULT_PIXELS {}\n#define CASES_WIDTH {}\n"
                       "#define RESULT_WIDTH {}\n#define PARAMETER_DATA(i) caseData(base + (i))\n",
                       shape.caseTexels, shape.resultPixels, evalWidth, evalWidth);
}

void addParameters(SourceBuilder& builder, const EvalBlock& block, const std::string& function,
                   std::span<const SlotFill> slots) {
    const std::vector<CompiledValue> compiled = compiledValues(block);
    builder.add(constantsSource(*block.block));
    builder.add(structSource(*block.block, compiled));
    builder.add(unpackSource(*block.block, {function, compiled, slots}));
}

/// Adds the code of what fills the model's slots, under the names that the model uses.
void addSlots(SourceBuilder& builder, const EvalCase& request) {
    for (const Slot& slot : request.block.block->slots) {
        const EvalBlock& filler = request.slot;
        if (filler.block == nullptr || filler.block->kind != slot.kind) {
            builder.add(emptySlotSource(slot.kind));
            continue;
        }
        addParameters(builder, filler, "unpack" + slotStructName(slot.kind), {});
        builder.add(tableDeclarations(*filler.block));
        builder.addBlock(*filler.block);
        builder.add(computedTables(*filler.block));
        builder.add(slotNamesSource(*filler.block));
    }
}

/// Returns "fog_ray" for "FogRay", as files of shaders/passes are named.
std::string typeWord(std::string_view type) {
    std::string word;
    for (const char c : type) {
        const bool isCapital = std::isupper(static_cast<unsigned char>(c)) != 0;
        word += isCapital && !word.empty() ? "_" : "";
        word += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
    return word;
}

/// Returns the expression for the number `index` of a case's first texels.
std::string numberText(std::size_t index) {
    return fmt::format("caseData({})[{}]", index / 4, index % 4);
}

/// Returns the expression for a field whose numbers begin at `first`.
std::string fieldText(const ArgumentField& field, std::size_t first) {
    const std::string number = numberText(first);
    if (field.isTriple()) {
        return fmt::format("vec3({}, {}, {})", number, numberText(first + 1),
                           numberText(first + 2));
    }
    return field.type == ArgumentField::Type::Flag    ? number + " > 0.5"
           : field.type == ArgumentField::Type::Whole ? fmt::format("int({})", number)
                                                      : number;
}

bool isStruct(std::string_view type) {
    return !type.empty() && std::isupper(static_cast<unsigned char>(type.front())) != 0;
}

/// Returns the code that calls a function of fields, or of the block's values alone.
std::string fieldsCall(const EvalCase& request) {
    const BlockFunction& function = calledFunction(request);
    std::string argument;
    std::size_t next = 0;
    for (const ArgumentField& field : fieldsOf(request)) {
        const std::string member =
            isStruct(function.argument) ? fmt::format(".{}", field.memberName()) : std::string();
        argument += fmt::format("    argument{} = {};\n", member, fieldText(field, next));
        next += field.numbers();
    }
    const bool takesNone = function.argument.empty();
    return fmt::format("vec4 evaluated(int part) {{\n{}{}"
                       "    return numbersOf(EVALUATED_BLOCK({}unpackEvaluated({})), part);\n}}\n",
                       takesNone ? "" : fmt::format("    {} argument;\n", function.argument),
                       argument, takesNone ? "" : "argument, ", argumentTexels(request));
}

/// Adds the code that reads the arguments of the block's function, calls it, and writes its
/// results.
void addCall(SourceBuilder& builder, const EvalCase& request) {
    const BlockFunction& function = calledFunction(request);
    const Block& block = *request.block.block;
    builder.add(fmt::format("#define EVALUATED_BLOCK {}{}\n#define LIGHT_GATE {}\n"
                            "#define VIEW_GATE {}\n",
                            functionName(block), function.suffix, block.hasGate("light"),
                            block.hasGate("view")));
    if (isStruct(function.result)) {
        builder.addFile(fmt::format("passes/evaluated_{}.glsl", typeWord(function.result)));
    }
    if (request.subject != Subject::Fields) {
        builder.addFile(fmt::format("passes/evaluate_{}.glsl", typeWord(function.argument)));
        return;
    }
    if (isStruct(function.argument)) {
        builder.addFile(fmt::format("lib/{}.glsl", typeWord(function.argument)));
    }
    builder.add(fieldsCall(request));
}

void addBlockProgram(SourceBuilder& builder, const EvalCase& request) {
    const Block& block = *request.block.block;
    addSlots(builder, request);
    std::vector<SlotFill> filled;
    if (request.slot.block != nullptr) {
        filled.push_back({request.slot.block->kind, vec4Count(*request.slot.block)});
    }
    addParameters(builder, request.block, "unpackEvaluated", filled);
    builder.add(tableDeclarations(block));
    builder.addBlock(block);
    builder.add(computedTables(block));
    addCall(builder, request);
}

void addFunctionProgram(SourceBuilder& builder, const EvalCase& request,
                        const std::filesystem::path& shaders) {
    std::vector<std::filesystem::path> files;
    std::error_code ignored; // without the folder the compiler reports an undeclared function
    for (const auto& item : std::filesystem::directory_iterator(shaders / "lib", ignored)) {
        files.push_back(item.path());
    }
    std::sort(files.begin(), files.end());
    for (const auto& file : files) {
        builder.addFile(file);
    }
    builder.add(fmt::format("#define FUNCTION_CALL {}\n",
                            reference::findFunction(request.function)->glslCall));
    builder.addFile("passes/evaluate_function.glsl");
}

void append(std::vector<double>& numbers, const glm::dvec3& v, double last = 0.0) {
    numbers.insert(numbers.end(), {v.x, v.y, v.z, last});
}

void appendValues(std::vector<double>& numbers, const EvalBlock& block) {
    if (block.block != nullptr) {
        const std::vector<double> values = block.packedValues();
        numbers.insert(numbers.end(), values.begin(), values.end());
    }
}

std::vector<float> roundedToFloats(const std::vector<double>& numbers) {
    std::vector<float> rounded;
    rounded.reserve(numbers.size());
    for (const double each : numbers) {
        rounded.push_back(static_cast<float>(each));
    }
    return rounded;
}

} // namespace

std::vector<CompiledValue> compiledValues(const EvalBlock& block) {
    std::vector<CompiledValue> values;
    for (const Parameter& parameter : block.block->parameters) {
        const bool isLooked = parameter.compiled == Compiled::WhenEqual; // the program compares it
        if (parameter.compiled != Compiled::No && !isLooked) {
            values.push_back({parameter.id, compiledText(parameter, valueOf(block, parameter))});
        }
    }
    for (const AccuracyChoice& choice : block.block->accuracy) {
        const auto level = block.accuracy.find(choice.id);
        values.push_back({choice.id, level == block.accuracy.end()
                                         ? std::string_view(choice.values.front().id)
                                         : std::string_view(level->second)});
    }
    return values;
}

std::string evalKey(const EvalCase& request) {
    if (request.subject == Subject::Function) {
        return request.function + '(' + std::to_string(request.arguments.size());
    }
    return fmt::format("{} {} | {}", programKey(request.block), calledFunction(request).suffix,
                       programKey(request.slot));
}

Result<EvalShape> evalShape(const EvalCase& request) {
    if (request.subject == Subject::Function) {
        const auto function = findEvalFunction(request);
        if (!function) {
            return tl::unexpected(function.error());
        }
        return EvalShape{std::max(texelsOf((*function)->arguments), 1),
                         texelsOf((*function)->results), (*function)->results};
    }
    int texels = argumentTexels(request) + vec4Count(*request.block.block);
    if (request.slot.block != nullptr) {
        texels += vec4Count(*request.slot.block);
    }
    const std::size_t results = resultsOf(request);
    return EvalShape{std::max(texels, 1), results > 3 ? 2 : 1, results};
}

Checked<ShaderSource> evalSource(const EvalCase& request, const EvalShape& shape,
                                 const std::filesystem::path& shaders) {
    SourceBuilder builder(shaders);
    builder.add(header(shape));
    builder.addFile("passes/evaluate.glsl");
    if (request.subject == Subject::Function) {
        addFunctionProgram(builder, request, shaders);
    } else {
        addBlockProgram(builder, request);
    }
    return builder.finish();
}

std::vector<double> placeNumbers(const EvalCase& request) {
    std::vector<double> numbers;
    switch (request.subject) {
    case Subject::Model:
        append(numbers, request.n, request.pixel.x);
        append(numbers, request.t, request.pixel.y);
        append(numbers, request.l);
        append(numbers, request.v);
        break;
    case Subject::Function:
        numbers.assign(request.arguments.begin(), request.arguments.end());
        break;
    case Subject::Light:
        append(numbers, request.l);
        break;
    case Subject::Fog:
        append(numbers, request.l, request.number);
        append(numbers, request.v);
        break;
    case Subject::Fields:
        numbers.assign(request.fields.begin(), request.fields.end());
        numbers.resize(4 * static_cast<std::size_t>(argumentTexels(request)));
        break;
    default:
        append(numbers, {request.number, 0.0, 0.0});
    }
    return numbers;
}

std::vector<double> valueNumbers(const EvalCase& request) {
    std::vector<double> numbers;
    appendValues(numbers, request.block);
    appendValues(numbers, request.slot);
    return numbers;
}

std::vector<float> placeTexels(const EvalCase& request) {
    return roundedToFloats(placeNumbers(request));
}

std::vector<float> valueTexels(const EvalCase& request) {
    return roundedToFloats(valueNumbers(request));
}

} // namespace patina
