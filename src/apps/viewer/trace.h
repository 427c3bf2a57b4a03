// A drawn picture beside what it should have been: the reference, traced bit by bit, and the difference.
#pragma once

#include "apps/viewer/shown_picture.h"
#include "apps/viewer/asset_cache.h"
#include "reference/tracer.h"

#include <memory>
#include <optional>

namespace lambent::viewer {

/// What is compared, and how it is shown.
struct TraceTask {
    cli::RenderArguments arguments; ///< of the drawn picture, with its camera
    bool shows_error = false;       ///< FLIP, pixel by pixel, instead of the reference
    std::shared_ptr<Model> model;
    std::shared_ptr<const RawEnvironment> environment;
};

/// Of the drawing thread alone.
class Trace {
public:
    /// `drawn`: the picture's light.
    Trace(TraceTask task, image::RadianceImage drawn);

    /// Traces on, as reference::Tracing::advance; whether that is the end: the limits are `lambent reference`'s usual ones.
    /// Throws as that.
    bool advance(const reference::GoOn& go_on);

    /// Whether there is anything to see.
    bool has_picture() const { return tracing_ && tracing_->has_picture(); }

    /// What there is to see, with its numbers. The rest of the picture is left to the caller.
    ShownPicture picture() const;

private:
    image::CodeImage error_codes(const image::CodeImage& traced, ShownPicture::Traced& numbers) const;

    TraceTask task_;
    image::RadianceImage drawn_;
    std::shared_ptr<const scene::Scene> scene_; ///< that is traced
    std::optional<reference::Tracing> tracing_;
    bool finished_ = false;
};

} // namespace lambent::viewer
