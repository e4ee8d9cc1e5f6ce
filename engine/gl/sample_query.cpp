// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/sample_query.h"

#include <epoxy/gl.h>

namespace patina::gl {

SampleQuery SampleQuery::create() {
    SampleQuery query;
    GLuint name = 0;
    glGenQueries(1, &name);
    query.name_ = Name<deleteQuery>(name);
    return query;
}

void SampleQuery::begin() const {
    glBeginQuery(GL_ANY_SAMPLES_PASSED, name_.get());
}

void SampleQuery::end() {
    glEndQuery(GL_ANY_SAMPLES_PASSED);
}

void SampleQuery::beginCondition() const {
    glBeginConditionalRender(name_.get(), GL_QUERY_WAIT);
}

void SampleQuery::endCondition() {
    glEndConditionalRender();
}

} // namespace patina::gl
