// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <random>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "measure/eval/eval_case.h"
#include "physics_cases.h"

namespace patina::physics {

/// Draws random numbers by seed. It keeps what was drawn: initialising a generator takes longer
/// than a case, and few seeds are used again and again.
class SeededDraws {
  public:
    void seed(std::size_t seed) {
        current_ = &series_.try_emplace(seed, static_cast<unsigned>(seed)).first->second;
        next_ = 0;
    }

    std::size_t operator()() {
        if (next_ == current_->drawn.size()) {
            current_->drawn.push_back(current_->random());
        }
        return current_->drawn[next_++];
    }

  private:
    struct Series {
        explicit Series(unsigned seed) : random(seed) {}

        std::mt19937 random;
        std::vector<std::size_t> drawn;
    };

    std::map<std::size_t, Series> series_;
    Series* current_ = nullptr;
    std::size_t next_ = 0;
};

/// Makes random values of a block and random geometry, all exact in float.
class RandomCases {
  public:
    explicit RandomCases(const Block& block)
        : RandomCases(block, findKind(block.kind)->functions.front()) {}
    RandomCases(const Block& block, const BlockFunction& function)
        : block_(block), function_(function) {}
    virtual ~RandomCases() = default;

    EvalCase next() {
        EvalCase request;
        choices_.seed(any(programs));
        request.gpu = true;
        request.block = valuesOf(block_);
        request.called = &function_;
        request.subject = subjectOf(function_).value();
        if (request.subject == EvalCase::Subject::Model && !block_.slots.empty()) {
            const Slot& slot = block_.slots.front();
            const auto fillers = catalog().ofKind(slot.kind);
            const bool mayStayEmpty = slot.defaultBlock.empty();
            const std::size_t chosen = choices_() % (fillers.size() + (mayStayEmpty ? 1 : 0));
            if (chosen < fillers.size() && (fillsOptionalSlots_ || !mayStayEmpty)) {
                request.slot = valuesOf(*fillers[chosen]);
            }
        }
        place(request);
        return request;
    }

    /// Keeps optional slots empty: a model's claims are its own, and what may fill its slot makes
    /// its own claims.
    void leaveOptionalSlotsEmpty() { fillsOptionalSlots_ = false; }

  protected:
    void place(EvalCase& request) {
        switch (request.subject) {
        case EvalCase::Subject::Model:
            placeDirections(request);
            break;
        case EvalCase::Subject::Fresnel:
            request.number = inFloat(cosine());
            break;
        case EvalCase::Subject::Light:
            request.l = inFloat(glm::dvec3(coordinate(), coordinate(), coordinate()));
            break;
        case EvalCase::Subject::Fog:
            request.number = inFloat(std::abs(coordinate()));
            request.l = inFloat(glm::dvec3(coordinate(), coordinate(), coordinate()));
            request.v = inFloat(someDirection());
            break;
        default:
            placeFields(request);
        }
    }

    void placeFields(EvalCase& request) {
        double* number = request.fields.data();
        glm::dvec3 direction(0.0);
        for (const ArgumentField& field : fieldsOf(request)) {
            glm::dvec3 value(std::min(std::abs(cosine()), 1.0) * field.max);
            if (field.isDirection()) {
                value = inFloat(someDirection());
                value =
                    field.type == ArgumentField::Type::Normal && glm::dot(value, direction) < 0.0
                        ? -value
                        : value;
                direction = value;
            } else if (field.isTriple()) {
                value = glm::dvec3(std::abs(coordinate()));
            }
            for (std::size_t i = 0; i < field.numbers(); ++i) {
                const double x = inFloat(value[int(i)]);
                *number++ = field.isContinuous() ? std::min(x, value[int(i)]) : std::round(x);
            }
        }
    }

    virtual void placeDirections(EvalCase& request) = 0;
    virtual double cosine() = 0;
    virtual double coordinate() = 0;
    virtual double numberOf(const Parameter& parameter) = 0;

    std::size_t any(std::size_t count) { return random_() % count; }
    double uniform(double low, double high) {
        return std::uniform_real_distribution(low, high)(random_);
    }
    glm::dvec3 someDirection() {
        const double c = uniform(-1.0, 1.0);
        const double phi = uniform(0.0, 6.283185307179586);
        const double s = std::sqrt(1.0 - c * c);
        return {s * std::cos(phi), s * std::sin(phi), c};
    }
    static double inFloat(double x) { return static_cast<double>(static_cast<float>(x)); }
    static glm::dvec3 inFloat(const glm::dvec3& v) { return glm::dvec3(glm::vec3(v)); }

  private:
    EvalBlock valuesOf(const Block& block) {
        EvalBlock result{&block, {}, {}};
        for (const Parameter& parameter : block.parameters) {
            result.values.emplace(parameter.id, valueOf(parameter));
        }
        return result;
    }

    Value valueOf(const Parameter& parameter) {
        switch (parameter.type) {
        case ParameterType::Enum:
            return parameter.values[choices_() % parameter.values.size()].id;
        case ParameterType::Bool:
            return choices_() % 2 == 0;
        case ParameterType::Int:
            return static_cast<int>(numberOf(parameter));
        case ParameterType::Color:
        case ParameterType::Vec3:
            return glm::dvec3(numberOf(parameter), numberOf(parameter), numberOf(parameter));
        case ParameterType::Vec2:
            return glm::dvec2(numberOf(parameter), numberOf(parameter));
        default:
            return numberOf(parameter);
        }
    }

    /// Is how many combinations of choices are drawn: each is a program of its own on the GPU.
    static constexpr std::size_t programs = 64;

    const Block& block_;
    const BlockFunction& function_;
    bool fillsOptionalSlots_ = true;
    std::mt19937 random_{20251121};
    SeededDraws choices_;
};

/// Makes cases as artists do: cosines of at least 0.05, one viewer in three near the mirror
/// direction, and values that a slider reaches.
class OrdinaryCases : public RandomCases {
  public:
    using RandomCases::RandomCases;

  private:
    void placeDirections(EvalCase& request) override {
        request.l = upperDirection();
        request.v = any(3) == 0 ? nearMirror(request.l) : upperDirection();
        // Some marks from the corner: far out the rounding of a place moves their edges.
        request.pixel = {inFloat(uniform(0.0, 24.0)), inFloat(uniform(0.0, 24.0))};
    }
    double cosine() override { return uniform(0.05, 1.0); }
    double coordinate() override { return uniform(-5.0, 5.0); }

    /// Returns a unit direction with a cosine of at least 0.05.
    glm::dvec3 upperDirection() {
        const double c = cosine();
        const double s = std::sqrt(1.0 - c * c);
        const double phi = uniform(0.0, 2.0 * std::numbers::pi);
        return inFloat({s * std::cos(phi), s * std::sin(phi), c});
    }

    /// Returns the mirror direction of l, up to 0.1 off in x and y.
    glm::dvec3 nearMirror(const glm::dvec3& l) {
        const glm::dvec3 off{uniform(-0.1, 0.1), uniform(-0.1, 0.1), 0.0};
        return inFloat(reference::geometry({0, 0, 1}, {1, 0, 0}, l,
                                           glm::dvec3(-l.x, -l.y, std::max(l.z, 0.05)) + off)
                           .v);
    }

    double numberOf(const Parameter& parameter) override {
        const double low = parameter.softMin;
        const double high = parameter.softMax;
        const bool log = parameter.scale == Scale::Log && low > 0.0;
        return inFloat(log ? std::exp(uniform(std::log(low), std::log(high))) : uniform(low, high));
    }
};

/// Makes cases that break formulas: cosines down to 1e-8 and up to 1, azimuths and mirror
/// directions that are off by little or nothing, opposite and parallel directions, and values at
/// the ends of the ranges that a file may hold.
class EdgeCases : public RandomCases {
  public:
    using RandomCases::RandomCases;

  private:
    void placeDirections(EvalCase& request) override {
        request.l = edgeCaseDirection();
        switch (any(6)) {
        case 0:
            request.v = request.l;
            break;
        case 1:
            request.v = -request.l;
            break;
        case 2:
        case 3:
            request.v = {-request.l.x + offset(), -request.l.y + offset(), request.l.z};
            break;
        default:
            request.v = edgeCaseDirection();
        }
        request.v = inFloat(request.v);
        if (any(50) == 0) {
            request.t = {offset(), offset(), 1.0};
        }
    }

    double cosine() override {
        static constexpr double steps[] = {0.0,  1e-8,       1e-7,       1e-6,       1e-5, 1e-4,
                                           1e-3, 1e-2,       0.1,        0.3,        0.5,  0.7,
                                           0.9,  1.0 - 1e-4, 1.0 - 1e-6, 1.0 - 1e-7, 1.0};
        return any(4) == 0 ? uniform(0.0, 1.0) : steps[any(std::size(steps))];
    }

    double coordinate() override {
        static constexpr double steps[] = {0.0, 1e-30, 1e-6, 1.0, 1e3, 1e6};
        return (any(2) == 0 ? -1.0 : 1.0) * steps[any(std::size(steps))];
    }

    double numberOf(const Parameter& parameter) override {
        const double middle = 0.5 * (parameter.softMin + parameter.softMax);
        const double step = parameter.step;
        const double values[] = {parameter.min,
                                 parameter.max,
                                 parameter.softMin,
                                 parameter.softMax,
                                 parameter.softMin + step,
                                 middle};
        return inFloat(std::clamp(values[any(std::size(values))], parameter.min, parameter.max));
    }

    double offset() {
        static constexpr double steps[] = {0.0, 1e-8, 1e-7, 1e-6, 1e-4, 1e-2, 0.3};
        return (any(2) == 0 ? -1.0 : 1.0) * steps[any(std::size(steps))];
    }

    /// Returns a direction, one in ten of which is below the horizon.
    glm::dvec3 edgeCaseDirection() {
        const double c = cosine() * (any(10) == 0 ? -1.0 : 1.0);
        const double s = std::sqrt(std::max(0.0, 1.0 - c * c));
        const double phi = any(2) == 0 ? offset() : uniform(0.0, 2.0 * std::numbers::pi);
        return inFloat(glm::dvec3(s * std::cos(phi), s * std::sin(phi), c));
    }
};

inline std::string described(const EvalCase& request, const std::vector<double>& exact,
                             const std::vector<double>& answer) {
    std::string text =
        fmt::format("{} {}", request.block.block->id, calledFunction(request).suffix);
    const auto add = [&text](const char* name, const std::vector<double>& numbers) {
        text += std::string("\n  ") + name;
        for (const double x : numbers) {
            text += ' ' + std::to_string(x);
        }
    };
    add("parameters", request.block.packedValues());
    if (request.slot.block != nullptr) {
        add(request.slot.block->id.c_str(), request.slot.packedValues());
    }
    add("l", {request.l.x, request.l.y, request.l.z});
    add("v", {request.v.x, request.v.y, request.v.z});
    add("number", {request.number});
    add("double", exact);
    add("gpu", answer);
    return text;
}

/// Returns "models/..." of every block in the catalogue that can be evaluated alone.
inline std::vector<std::string> blockNames() {
    std::vector<std::string> names;
    for (const Block& block : catalog().blocks) {
        if (!evaluatedFunctions(block).empty()) {
            names.push_back(block.kind + '/' + block.id);
        }
    }
    return names;
}

inline const Block& blockNamed(const std::string& name) {
    const auto slash = name.find('/');
    const Block* block = catalog().find(name.substr(0, slash), name.substr(slash + 1));
    if (block == nullptr) {
        throw std::runtime_error("no block " + name);
    }
    return *block;
}

/// Replaces the characters that a test's name must not have by underscores.
inline std::string testName(std::string name) {
    for (char& c : name) {
        c = std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
    }
    return name;
}

} // namespace patina::physics
