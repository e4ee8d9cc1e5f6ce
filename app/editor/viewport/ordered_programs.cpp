// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/ordered_programs.h"

#include <iterator>
#include <utility>

#include "viewport/program_worker.h"
#include "viewport/viewed_scene.h"

namespace patina {

OrderedPrograms::OrderedPrograms(const ViewedScene& viewed) : viewed_(viewed) {
    if (canOrder()) {
        connect(viewed.sources().programs, &ProgramWorker::finished, this, &OrderedPrograms::take);
        connect(viewed.sources().programs, &ProgramWorker::givenUp, this, &OrderedPrograms::giveUp);
    }
}

bool OrderedPrograms::canOrder() const {
    return viewed_.sources().programs != nullptr;
}

bool OrderedPrograms::mustWait(FrameJob& job, const Scene& scene, const View& view) {
    if (!canOrder()) {
        return false;
    }
    const std::uint64_t missing = job.missingPrograms();
    const bool isAwaited = number_ != 0;
    if (missing == 0 || (!isAwaited && missing_ == missing)) {
        number_ = 0;
        missing_ = 0;
        return false;
    }
    order(scene, view);
    missing_ = missing;
    return true;
}

void OrderedPrograms::order(const Scene& scene, const View& view) {
    ProgramWorker::Frame frame{scene, {}, view, {}, 0, viewed_.catalog()};
    if (view.effects) {
        frame.effects = *view.effects;
    }
    frame.view.effects = nullptr;
    frame.view.environmentImage = nullptr;
    for (const Object& object : scene.objects) {
        const MeshView mesh = object.visible ? viewed_.sources().meshes(object) : MeshView();
        frame.meshes.push_back(mesh.indices.empty() ? Bounds() : mesh.bounds);
        frame.triangles += std::ssize(mesh.indices) / 3;
    }
    number_ = viewed_.sources().programs->ask(std::move(frame));
}

void OrderedPrograms::take(quint64 number) {
    if (number == number_) {
        number_ = 0;
        Q_EMIT came();
    }
}

void OrderedPrograms::giveUp(quint64 number) {
    if (number == number_) {
        number_ = 0;
        missing_ = 0; // the next frame orders them again
        Q_EMIT givenUp();
    }
}

} // namespace patina
