// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <epoxy/gl.h>

namespace patina {

/// Calls `Note` after each call of one of OpenGL's functions while the object lives. `Pointer` is
/// the function pointer through which the calls go.
template <auto Pointer, auto Note> class Overheard;

template <class... A, void (**Pointer)(A...), void (*Note)(A...)>
class Overheard<Pointer, Note> {
  public:
    Overheard() {
        real_ = *Pointer;
        *Pointer = call;
    }
    ~Overheard() { *Pointer = real_; }
    Overheard(const Overheard&) = delete;
    Overheard& operator=(const Overheard&) = delete;

  private:
    static void call(A... arguments) {
        *Pointer = real_; // the first call puts the driver's own function there
        real_(arguments...);
        real_ = *Pointer;
        *Pointer = call;
        Note(arguments...);
    }

    inline static void (*real_)(A...) = nullptr;
};

/// Records the programs that the driver really draws with, by the text that it was given. It knows
/// all that are made while it lives; only one object may exist at a time.
class BoundPrograms {
  public:
    /// Holds a kind of primitive, and how many corners were drawn at once.
    using Drawing = std::pair<GLenum, GLsizei>;

    struct Program {
        std::string text; ///< is the text of all stages
        std::set<Drawing> drawings;
    };

    BoundPrograms() { here_ = this; }

    /// Forgets what was drawn.
    void begin() {
        for (auto& [name, program] : programs_) {
            program.drawings.clear();
        }
    }

    /// Returns the programs that have drawn a mesh since begin().
    std::vector<const Program*> drawn() const {
        std::vector<const Program*> found;
        for (const auto& [name, program] : programs_) {
            if (!program.drawings.empty()) {
                found.push_back(&program);
            }
        }
        return found;
    }

  private:
    static void noteSource(GLuint shader, GLsizei count, const GLchar* const* strings,
                           const GLint* lengths) {
        std::string& text = here_->shaders_[shader];
        text.clear();
        for (GLsizei i = 0; i < count; ++i) {
            text.append(strings[i], std::size_t(lengths[i]));
        }
    }
    static void noteAttached(GLuint program, GLuint shader) {
        here_->programs_[program].text += here_->shaders_[shader];
    }
    static void noteDeleted(GLuint program) { here_->programs_.erase(program); }
    static void noteUsed(GLuint program) { here_->used_ = program; }
    static void noteDrawn(GLenum mode, GLsizei corners, GLenum, const void*, GLsizei) {
        here_->programs_[here_->used_].drawings.insert({mode, corners});
    }
    static void noteDrawnFrom(GLenum mode, GLsizei corners, GLenum, const void*, GLsizei, GLuint) {
        here_->programs_[here_->used_].drawings.insert({mode, corners});
    }

    inline static BoundPrograms* here_ = nullptr;

    std::map<GLuint, std::string> shaders_;
    std::map<GLuint, Program> programs_;
    GLuint used_ = 0;
    Overheard<&epoxy_glShaderSource, noteSource> source_;
    Overheard<&epoxy_glAttachShader, noteAttached> attach_;
    Overheard<&epoxy_glDeleteProgram, noteDeleted> delete_;
    Overheard<&epoxy_glUseProgram, noteUsed> use_;
    Overheard<&epoxy_glDrawElementsInstanced, noteDrawn> draw_;
    Overheard<&epoxy_glDrawElementsInstancedBaseInstance, noteDrawnFrom> drawFrom_;
};

} // namespace patina
