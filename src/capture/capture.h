#pragma once

#include <memory>
#include <optional>

#include "capture_options.h"
#include "drape/base/output_file.h"
#include "drape/base/progress.h"
#include "drape/base/stop_signals.h"
#include "drape/render/renderer.h"
#include "drape/render/video_pipe.h"
#include "drape/session/session.h"
#include "drape/session/state_csv.h"
#include "frame_writer.h"
#include "gl_context.h"

namespace drape {

/// One run of `drape-capture`. All that it writes is opened, and tried, before it simulates.
class Capture {
public:
    /// @param signals that end it between two steps
    /// @throws InputError, RunError
    Capture(CaptureOptions options, const StopSignals& signals);

    /// Simulates, draws and writes.
    /// @return the exit code
    /// @throws RunError if a file could not be written
    int run();

private:
    void tell_of_crossings();
    void draw_frame();
    void follow_replay();
    void draw();
    [[nodiscard]] bool diverged() { return session_.simulation().report().status == Status::Diverged; }
    void fail();
    void end_frames(bool all);
    void finish();
    [[nodiscard]] bool finish_video();

    const StopSignals& signals_;
    CaptureOptions options_;
    Session session_;
    Camera camera_;
    std::optional<FrameWriter> frames_;
    std::optional<VideoPipe> video_;
    OutputFile stats_, state_;
    std::unique_ptr<OffscreenContext> context_;
    std::unique_ptr<Renderer> renderer_;
    Progress progress_;
    std::vector<StatsColumn> columns_;  ///< of `stats_`
    int frame_ = 0;
    double frame_rate_ = 0;  ///< per simulated second
    std::string failure_;    ///< what was told of the state that has diverged
    std::int64_t crossings_told_ = 0;
};

}  // namespace drape
