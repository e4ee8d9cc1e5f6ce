// SPDX-License-Identifier: GPL-3.0-or-later
#include "library/block_trials.h"

#include <algorithm>
#include <utility>

#include "free_memory.h"
#include "gl/headless_context.h"
#include "shading/block_trial.h"
#include "shading/program_cache.h"

namespace patina {

/// A context that is made when the first program is compiled in it.
class BlockTrials::Compiler {
  public:
    Errors mistakesIn(const ProgramSource& source) {
        if (!tried_) {
            tried_ = true;
            context_ = gl::HeadlessContext::create().value_or(nullptr);
        }
        if (!context_) {
            return {}; // the view says why nothing is drawn on this machine
        }
        const auto program = compileProgram(source);
        return program ? Errors() : program.error();
    }

    bool wasUsed() const { return tried_; }

  private:
    bool tried_ = false;
    std::unique_ptr<gl::HeadlessContext> context_;
};

namespace {

void addNew(Errors& errors, const Errors& more) {
    for (const Error& error : more) {
        if (std::find(errors.begin(), errors.end(), error) == errors.end()) {
            errors.push_back(error);
        }
    }
}

} // namespace

BlockTrials::BlockTrials(QObject* parent) : QObject(parent) {
    thread_.setMaxThreadCount(1);
    thread_.setExpiryTimeout(100);
}

BlockTrials::~BlockTrials() {
    ++wished_;
    thread_.waitForDone();
}

void BlockTrials::run(std::shared_ptr<const Catalog> catalog) {
    const quint64 number = ++wished_;
    const bool hasUsers = std::any_of(catalog->blocks.begin(), catalog->blocks.end(),
                                      [](const Block& block) { return !block.shipped; });
    if (!hasUsers) {
        Q_EMIT finished({});
        return;
    }
    thread_.start([this, number, held = std::move(catalog)] {
        const Errors mistakes = mistakesIn(*held, number);
        const auto tell = [this, number, mistakes] {
            if (wished_ == number) {
                Q_EMIT finished(mistakes);
            }
        };
        QMetaObject::invokeMethod(this, tell, Qt::QueuedConnection);
    });
}

/// Of nothing any more once another run is wished.
Errors BlockTrials::mistakesIn(const Catalog& catalog, quint64 number) {
    Errors mistakes;
    auto compiler = std::make_unique<Compiler>();
    for (const Block& block : catalog.blocks) {
        if (!block.shipped && wished_ == number) {
            addNew(mistakes, mistakesIn(trialProgram(block, catalog), *compiler));
        }
    }
    if (compiler->wasUsed()) {
        compiler.reset();
        returnFreeMemory();
    }
    return mistakes;
}

Errors BlockTrials::mistakesIn(const Checked<ProgramSource>& source, Compiler& compiler) {
    if (!source) {
        return source.error();
    }
    const std::string hash = source->hash();
    const auto known = known_.find(hash);
    return known != known_.end() ? known->second
                                 : known_.emplace(hash, compiler.mistakesIn(*source)).first->second;
}

} // namespace patina
