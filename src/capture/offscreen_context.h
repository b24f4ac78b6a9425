#pragma once

#include <memory>

namespace drape {

/// An OpenGL 3.3 core context without a display, current from construction to destruction, with GLEW initialised.
/// Pictures go into framebuffer objects; there is no default framebuffer to speak of.
class OffscreenContext {
public:
    /// @throws RunError if the system has no such context
    OffscreenContext();
    ~OffscreenContext();
    OffscreenContext(const OffscreenContext&) = delete;
    OffscreenContext& operator=(const OffscreenContext&) = delete;

private:
    struct Mesa;
    std::unique_ptr<Mesa> mesa_;
};

}  // namespace drape
