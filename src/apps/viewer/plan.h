// One piece of work for the drawing thread.
#pragma once

#include "apps/viewer/asset_cache.h"
#include "apps/viewer/draw_state.h"
#include "apps/viewer/trace.h"

#include <array>
#include <chrono>
#include <memory>
#include <optional>
#include <string>

namespace lambent::viewer {

using Clock = std::chrono::steady_clock;

struct Plan {
    enum class Task {
        moving, ///< a reduced picture of a view that may move on
        still,  ///< the whole picture with few samples
        rest,   ///< the picture that the request's command writes
        refine, ///< the same with a measured error, then with more rays
        trace,  ///< the reference, as far as it gets
        save,   ///< the picture at rest as a file
        pick,   ///< the depth at a point
    };
    Task task = Task::moving;
    cli::RenderArguments arguments; ///< with the camera, at the size to draw
    std::string layer;              ///< "picture", or one of the frame's layers
    std::shared_ptr<Model> model;
    std::shared_ptr<const cli::LoadedEnvironment> environment;
    double scale = 1.0;                ///< of the sides, as ShownPicture::scale
    double moment = 0.0;               ///< as ShownPicture::moment
    int width = 0, height = 0;         ///< as requested
    DrawState::Serial serial = 0;      ///< of the request
    std::uint64_t input = 0;           ///< as ShownPicture::input
    std::shared_ptr<Trace> trace;      ///< trace: to continue
    bool is_compared = false;          ///< rest: a trace follows
    bool is_refined = false;           ///< rest: pictures with more rays follow
    bool lacks_shadows = false;        ///< as ShownPicture::lacks_shadows
    std::optional<audit::Error> error; ///< of the drawn picture
    std::string file, command;         ///< save
    std::array<double, 2> place{};     ///< pick: x and y from 0 to 1, from the picture's top left

    /// Whether drawing may take long: then other sessions have their turn in between.
    bool is_long() const { return task != Task::moving && task != Task::pick; }
};

} // namespace lambent::viewer
