// SPDX-License-Identifier: GPL-3.0-or-later
#include "library/user_block_trials.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "background/free_memory.h"
#include "gl/headless_context.h"
#include "shading/effects/block_trial.h"
#include "shading/program/block_gate.h"

namespace patina {

namespace {

void addNew(std::vector<StrangerBlock>& blocks, const std::vector<StrangerBlock>& more) {
    for (const StrangerBlock& block : more) {
        if (std::find(blocks.begin(), blocks.end(), block) == blocks.end()) {
            blocks.push_back(block);
        }
    }
}

} // namespace

/// The user's blocks as they stand in programs, and what their texts alone show to be wrong.
class UserBlockTrials::Wanted {
  public:
    void add(const Checked<ProgramSource>& source) {
        if (!source) {
            addNew(mistakes, source.error());
            return;
        }
        addNew(blocks, source->vertex.strangers);
        addNew(blocks, source->fragment.strangers);
        if (source->geometry) {
            addNew(blocks, source->geometry->strangers);
        }
    }

    std::vector<StrangerBlock> blocks;
    Errors mistakes;
};

UserBlockTrials::UserBlockTrials(QObject* parent) : QObject(parent) {
    thread_.setMaxThreadCount(1);
    thread_.setExpiryTimeout(100);
    if (blockGate()) {
        blockGate()->resume();
    }
}

UserBlockTrials::~UserBlockTrials() {
    ++wished_;
    if (blockGate()) {
        blockGate()->stop();
    }
    thread_.waitForDone();
}

void UserBlockTrials::run(std::shared_ptr<const Catalog> catalog) {
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

void UserBlockTrials::tellBegun(const QStringList& names, quint64 number) {
    const auto tell = [this, number, names] {
        if (wished_ == number) {
            Q_EMIT begun(names);
        }
    };
    QMetaObject::invokeMethod(this, tell, Qt::QueuedConnection);
}

/// Says nothing more once another run is wished.
Errors UserBlockTrials::mistakesIn(const Catalog& catalog, quint64 number) {
    Wanted wanted;
    for (const Block& block : catalog.blocks) {
        if (!block.shipped && wished_ == number) {
            wanted.add(trialProgram(block, catalog));
        }
    }
    if (!blockGate() || wanted.blocks.empty() || wished_ != number) {
        return wanted.mistakes;
    }
    auto context = gl::HeadlessContext::create().value_or(nullptr);
    if (!context) {
        return wanted.mistakes; // the view says why nothing is drawn on this machine
    }
    QStringList names;
    for (const StrangerBlock& block : wanted.blocks) {
        if (!blockGate()->ask(std::span(&block, 1), false).isFinal) {
            names << QString::fromStdString(block.id);
        }
    }
    if (!names.isEmpty()) {
        tellBegun(names, number);
    }
    addNew(wanted.mistakes, blockGate()->ask(wanted.blocks, true).mistakes);
    context.reset();
    returnFreeMemory();
    return wanted.mistakes;
}

} // namespace patina
