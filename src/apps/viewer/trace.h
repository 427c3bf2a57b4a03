// The reference for a drawn picture, traced in steps, and the difference between the two.
#pragma once

#include "apps/viewer/shown_picture.h"
#include "apps/viewer/asset_cache.h"
#include "reference/tracer.h"

#include <memory>
#include <optional>

namespace lambent::viewer {

/// A picture to compare, and how the comparison is shown.
struct TraceTask {
    cli::RenderArguments arguments; ///< of the drawn picture, with its camera
    bool shows_error = false;       ///< shows the FLIP map instead of the reference
    std::shared_ptr<Model> model;
    std::shared_ptr<const RawEnvironment> environment;
};

/// Used by the drawing thread alone.
class Trace {
public:
    /// `drawn`: the radiance of the picture.
    Trace(TraceTask task, image::RadianceImage drawn);

    /// Continues as reference::Tracing::advance, which also says what is thrown. Returns whether the default limits of
    /// `lambent reference` are reached.
    bool advance(const reference::GoOn& go_on);

    /// Whether picture() may be called.
    bool has_picture() const { return tracing_ && tracing_->has_picture(); }

    /// The present picture with Kind::traced's numbers; the caller sets the other members.
    ShownPicture picture() const;

private:
    image::CodeImage error_codes(const image::CodeImage& traced, ShownPicture::Traced& numbers) const;

    TraceTask task_;
    image::RadianceImage drawn_;
    std::shared_ptr<const scene::Scene> scene_; ///< used by tracing_
    std::optional<reference::Tracing> tracing_;
    bool finished_ = false;
};

} // namespace lambent::viewer
