// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/query.h"

#include <epoxy/gl.h>

namespace patina::gl {

void deleteQuery(unsigned name) {
    glDeleteQueries(1, &name);
}

TimeQuery TimeQuery::create() {
    TimeQuery query;
    GLuint names[2] = {};
    glGenQueries(2, names);
    query.began_ = Name<deleteQuery>(names[0]);
    query.ended_ = Name<deleteQuery>(names[1]);
    return query;
}

void TimeQuery::begin() {
    glQueryCounter(began_.get(), GL_TIMESTAMP);
}

void TimeQuery::end() {
    glQueryCounter(ended_.get(), GL_TIMESTAMP);
}

bool TimeQuery::ready() const {
    GLint available = 0;
    glGetQueryObjectiv(ended_.get(), GL_QUERY_RESULT_AVAILABLE, &available);
    return available != 0;
}

std::uint64_t TimeQuery::nanoseconds() const {
    GLuint64 began = 0;
    GLuint64 ended = 0;
    glGetQueryObjectui64v(began_.get(), GL_QUERY_RESULT, &began);
    glGetQueryObjectui64v(ended_.get(), GL_QUERY_RESULT, &ended);
    return ended > began ? ended - began : 0;
}

} // namespace patina::gl
