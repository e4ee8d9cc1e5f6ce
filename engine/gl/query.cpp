// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/query.h"

#include <epoxy/gl.h>

namespace patina::gl {

void deleteQuery(unsigned name) {
    glDeleteQueries(1, &name);
}

TimeQuery TimeQuery::create() {
    TimeQuery query;
    GLuint name = 0;
    glGenQueries(1, &name);
    query.name_ = Name<deleteQuery>(name);
    return query;
}

void TimeQuery::begin() {
    glBeginQuery(GL_TIME_ELAPSED, name_.get());
}

void TimeQuery::end() {
    glEndQuery(GL_TIME_ELAPSED);
}

bool TimeQuery::ready() const {
    GLint available = 0;
    glGetQueryObjectiv(name_.get(), GL_QUERY_RESULT_AVAILABLE, &available);
    return available != 0;
}

std::uint64_t TimeQuery::nanoseconds() const {
    GLuint64 time = 0;
    glGetQueryObjectui64v(name_.get(), GL_QUERY_RESULT, &time);
    return time;
}

} // namespace patina::gl
