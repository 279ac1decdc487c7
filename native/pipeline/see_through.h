// Glass: objects that hide nothing.
#pragma once

#include "pipeline/draw.h"

namespace illustrate {

bool any_is_seen_through(const std::vector<ObjectStyle>& styles);

// A scene with glass is two drawings in one. Of the first these objects are left out; its graph,
// tone and hatches are the result's. The second has their lines alone, with every object opaque, so
// that a bottle's own far side and what stands before it hide them.
DrawOptions without_glass(DrawOptions options);
DrawOptions glass_alone(DrawOptions options);

// Adds the strokes of the second to the first, its counts and times too.
void add_glass(DrawResult& result, const DrawResult& glass);

}  // namespace illustrate
