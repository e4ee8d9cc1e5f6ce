// SPDX-License-Identifier: GPL-3.0-or-later
#include "library/user_block_trials.h"

#include <algorithm>
#include <utility>
#include <vector>

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

Error checkingStopped() {
    return {{},
            0,
            0,
            "checking your blocks was stopped: those that were not checked are left out",
            "a change of one of their files, which checks them again"};
}

} // namespace

/// Holds the user's blocks as they are in programs, and the mistakes that their texts alone show.
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

UserBlockTrials::UserBlockTrials(QObject* parent)
    : QObject(parent),
      worker_({.name = tr("Checking your blocks"), .canCancel = true, .atCancel = [] {
                   if (blockGate()) {
                       blockGate()->stop();
                   }
               }}) {
    if (blockGate()) {
        blockGate()->resume();
    }
}

UserBlockTrials::~UserBlockTrials() {
    worker_.cancel();
}

void UserBlockTrials::run(std::shared_ptr<const Catalog> catalog) {
    worker_.forget();
    if (blockGate()) {
        blockGate()->resume();
    }
    const bool hasUsers = std::any_of(catalog->blocks.begin(), catalog->blocks.end(),
                                      [](const Block& block) { return !block.shipped; });
    if (!hasUsers) {
        Q_EMIT finished({});
        return;
    }
    worker_.ask([this, held = std::move(catalog)](
                    const Worker::Control& control) { return mistakesIn(*held, control); },
                [this](const Result<Errors>& mistakes) {
                    Q_EMIT finished(mistakes ? *mistakes : Errors{mistakes.error()});
                });
}

/// Runs in the worker's thread.
Errors UserBlockTrials::mistakesIn(const Catalog& catalog, const Worker::Control& control) {
    Wanted wanted;
    for (const Block& block : catalog.blocks) {
        if (!block.shipped && !control.isCancelled()) {
            wanted.add(trialProgram(block, catalog));
        }
    }
    if (control.isCancelled()) {
        wanted.mistakes.push_back(checkingStopped());
        return wanted.mistakes;
    }
    if (!blockGate() || wanted.blocks.empty()) {
        return wanted.mistakes;
    }
    if (!control.openContext()) {
        return wanted.mistakes; // the view says why nothing is drawn on this machine
    }
    const BlockGate::Answer answer = blockGate()->ask(wanted.blocks, true);
    addNew(wanted.mistakes, answer.mistakes);
    if (control.isCancelled() && !answer.isFinal) {
        wanted.mistakes.push_back(checkingStopped());
    }
    return wanted.mistakes;
}

} // namespace patina
