// A drawn frame, as what its plan asked for.
#pragma once

#include "apps/viewer/plan.h"
#include "apps/viewer/shown_picture.h"
#include "draw/renderer.h"

namespace lambent::viewer {

class Session;

/// Shows the frame, hands it over as a file, or reports the point that was picked. `draw_ms`: how long drawing took.
void present_frame(const Plan& plan, const draw::Frame& frame, double draw_ms, Session& session);

/// Sets what pictures of all kinds have: size, scale, input, moment and drawing time.
void complete_picture(const Plan& plan, double draw_ms, ShownPicture& picture);

/// Whether the plan shows a layer that the frame does not have: then the picture is shown instead.
bool lacks_layer(const Plan& plan, const draw::Frame& frame);

} // namespace lambent::viewer
