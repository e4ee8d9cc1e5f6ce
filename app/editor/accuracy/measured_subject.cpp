// SPDX-License-Identifier: GPL-3.0-or-later
#include "accuracy/measured_subject.h"

#include <utility>

namespace patina {

MeasuredSubject subjectOf(Scene scene, int object, const Catalog& catalog, SubjectBlocks which) {
    scene.name.clear();
    scene.camera = {};
    MeasuredSubject subject{std::move(scene), object, {}};
    subject.blocks = which == SubjectBlocks::All ? readBlocks(catalog)
                                                 : readBlocksOf(subject.scene, catalog);
    return subject;
}

} // namespace patina
