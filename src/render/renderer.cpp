#include "drape/render/renderer.h"

#include <algorithm>
#include <ctime>
#include <string>
#include <utility>

#include "cloth_colours.h"
#include "drape/base/input_error.h"
#include "drape/base/stopwatch.h"
#include "frame_data.h"
#include "marks.h"
#include "overlay_painter.h"
#include "overlay_panels.h"
#include "picture_target.h"
#include "principal_strain.h"
#include "shadow_map.h"
#include "solids.h"
#include "stream_buffer.h"
#include "studio.h"

namespace drape {

namespace {

// What stays the same over all frames, but for blending, which solids do without
void set_state(Gl& gl) {
    gl(glEnable, GL_DEPTH_TEST);
    gl(glDepthFunc, GL_LEQUAL);
    gl(glEnable, GL_MULTISAMPLE);
    gl(glEnable, GL_BLEND);
    gl(glEnable, GL_PROGRAM_POINT_SIZE);
    gl(glBlendFunc, GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    gl(glPixelStorei, GL_PACK_ALIGNMENT, 1);
}

}  // namespace

void start_glew() {
    glewExperimental = GL_TRUE;
    const GLenum status = glewInit();
    // GLEW asks for GLX last, when it has filled in all functions
    const bool no_glx = status == GLEW_ERROR_GLX_VERSION_11_ONLY || status == GLEW_ERROR_NO_GLX_DISPLAY;
    if (status != GLEW_OK && !no_glx) {
        throw RunError("OpenGL's functions were not found: " +
                       std::string(reinterpret_cast<const char*>(glewGetErrorString(status))));
    }
    if (!GLEW_VERSION_3_3) throw RunError("OpenGL's functions were not found: there is no OpenGL 3.3");
}

/// Finds frames per second and processor use, averaged over about a second.
class FrameMeter {
public:
    /// A frame has been drawn.
    void count(FrameReport& report) {
        ++frames_;
        const double elapsed = watch_.seconds();
        // In the first second, what there is so far
        if (elapsed >= 1 || (first_second_ && elapsed > 0)) {
            report.rate = frames_ / elapsed;
            report.cpu = static_cast<double>(std::clock() - processor_start_) / CLOCKS_PER_SEC / elapsed;
        }
        if (elapsed < 1) return;
        begin_again();
        first_second_ = false;
    }

    /// The pictures so far came now and then: the average begins again with this one.
    void begin_again() {
        first_second_ = true;
        frames_ = 0;
        processor_start_ = std::clock();
        watch_.lap();
    }

private:
    Stopwatch watch_;
    std::clock_t processor_start_ = std::clock();
    int frames_ = 0;
    bool first_second_ = true;
};

// In the order in which they are made; each may use those above it.
struct Renderer::Parts {
    Gl gl;
    const bool ready = (set_state(gl), true);
    StreamBuffer stream{gl};
    ShadowMap shadow{gl};
    Solids solids{gl, stream};
    Studio studio{gl};
    Marks marks{gl, stream};
    OverlayPanels panels;
    OverlayPainter painter{gl, stream};
    std::optional<PictureTarget> target;
    int width = 0, height = 0;
    FrameMeter meter;
    bool was_at_rest = false;  ///< in the picture before
    FrameReport report;

    void prepare(const FrameView& view, const Camera& camera, std::span<const std::string> notices);
    void paint(const FrameView& view);
    void note_cost() {
        report.gl_calls = static_cast<double>(gl.calls());
        report.vertices = static_cast<double>(gl.vertices());
    }
};

Renderer::Renderer() : parts_(std::make_unique<Parts>()) {}

Renderer::~Renderer() = default;

void Renderer::resize(int width, int height) {
    if (width == parts_->width && height == parts_->height) return;
    parts_->width = width;
    parts_->height = height;
    parts_->target.reset();
    if (width >= 1 && height >= 1) parts_->target.emplace(parts_->gl, PictureSize{width, height});
}

Panels& Renderer::panels() { return parts_->panels; }

void Renderer::draw(const FrameView& view, const Camera& camera, std::span<const std::string> notices) {
    Parts& parts = *parts_;
    if (!parts.target) return;
    const Stopwatch watch;
    parts.gl.restart_count();
    parts.prepare(view, camera, notices);
    parts.paint(view);
    // What is at rest is drawn now and then, which is no rate
    const bool wakes = std::exchange(parts.was_at_rest, is_at_rest(view)) && !is_at_rest(view);
    wakes ? parts.meter.begin_again() : parts.meter.count(parts.report);
    ++parts.report.frame;
    parts.report.draw_time = watch.seconds();
    parts.note_cost();
}

void Renderer::Parts::prepare(const FrameView& view, const Camera& camera, std::span<const std::string> notices) {
    const ClothColours colours = cloth_colours(view);
    const StrainCrosses crosses = strain_crosses(view);
    panels.colours = colours.scale;
    panels.full_strain = crosses.full;
    const bool overlay = panels.build(view, camera, report, notices, width, height);
    solids.follow(view);

    // Everything into the one buffer, and up
    const PictureSize drawn = target->drawn_size(is_fast(view));
    FrameData data = make_frame_data(view, camera, {width, height}, drawn, ShadowMap::texels, solids.holders(),
                                     panels.display_scale);
    const float pixels = data.view_projection.row(1).head<3>().norm() * static_cast<float>(drawn.height) / 2;
    solids.fill(view, colours.values, {camera.eye(), pixels}, stream);
    marks.fill(view, crosses.lines, stream);
    painter.fill(overlay, stream);
    marks.add_to(data);
    *stream.room<FrameData>(Region::Frame, 1) = data;
    stream.upload();
}

void Renderer::Parts::paint(const FrameView& view) {
    shadow.begin();
    solids.draw_shadow();

    const FrameData& data = *stream.data<FrameData>(Region::Frame);
    studio.follow(data);
    target->begin(is_fast(view));
    studio.copy();
    studio.draw_shadows();

    const ViewSettings& shown = view.settings->view;
    const bool failed = data.failure[0].w() > 0 || data.mode_spring[0].w() > 0;
    const auto [wide, high] = target->drawn_size(is_fast(view));
    PictureBounds bounds(data.view_projection, wide, high);
    solids.add_to(bounds, stream);
    marks.add_to(bounds);
    const bool anywhere = shown.contacts || shown.particles || failed;
    const int room = std::max(solids.room(), marks.room(data));
    target->begin_samples(anywhere ? PictureBox{0, 0, wide, high} : bounds.box(room));
    const float line_width = std::max(data.magnified.x(), 1.0f);
    gl(glLineWidth, line_width);
    gl(glDisable, GL_BLEND);
    solids.draw(shown, line_width, stream);
    studio.draw_behind();
    gl(glEnable, GL_BLEND);
    marks.draw(failed);
    target->resolve();
    painter.draw(stream);
}

void Renderer::present(bool is_recorded) {
    if (!parts_->target) return;
    const double scale = parts_->panels.display_scale;
    parts_->target->present(is_recorded ? static_cast<int>(14 * scale) : 0);
    parts_->note_cost();
}

Image Renderer::read_back() const {
    if (!parts_->target) return {};
    Image image = parts_->target->read_back();
    parts_->note_cost();
    return image;
}

const FrameReport& Renderer::report() const { return parts_->report; }

}  // namespace drape
