// An OpenGL context of our own, off screen, without any display (EGL).
#pragma once

#include "core/base/error.h"

namespace covaria::detail {

/// An OpenGL context of EGL. It is current in no thread except during the life of a `CurrentContext`.
class EglContext {
public:
    EglContext() = default;
    ~EglContext();
    EglContext(const EglContext&) = delete;
    EglContext& operator=(const EglContext&) = delete;

    /// Opens Mesa's surfaceless platform, else the first working EGL device. Error{io} says what is missing.
    Result<void> open();
    bool is_open() const { return context_ != nullptr; }
    bool is_current() const;

private:
    friend class CurrentContext;
    void* display_ = nullptr;
    void* context_ = nullptr;
};

/// Largest width and height of a picture that the current context draws.
int largest_texture();

/// Makes the context current in this thread, and what was current before again at the end.
class CurrentContext {
public:
    explicit CurrentContext(const EglContext& context);
    ~CurrentContext();
    CurrentContext(const CurrentContext&) = delete;
    CurrentContext& operator=(const CurrentContext&) = delete;

private:
    void* display_;
    void* previous_display_;
    void* previous_context_;
    void* previous_draw_;
    void* previous_read_;
    unsigned previous_api_;
};

}  // namespace covaria::detail
