// What changes slowly over the surfaces that are seen, and is costly to find: asked for at some of
// the cells of an image, and at all of them where it changes quickly.
#pragma once

#include <functional>
#include <vector>

#include "core/progress.h"
#include "occlusion/visible_image.h"
#include "view/camera.h"

namespace illustrate {

// value(cell) at every visible cell, 0 at the others: exact at the corners of squares of four
// cells, linear between them. Squares are divided, down to single cells, where their corners differ
// by over an eighth, where they show several objects or nothing, or where a surface hides itself.
// Of squares of two cells beside divided ones the corners are asked, too, so that narrow things are
// followed from where they were found. What is narrower than two cells, or than four and found
// nowhere, may be lost.
//
// value: in [0, 1], along a surface continuous but for jumps; called from several threads. The
// result does not depend on their number.
std::vector<float> ask_sparsely(const Surface& surface, const VisibleImage& visible,
                                const Camera& camera,
                                const std::function<double(std::size_t cell)>& value, int threads,
                                const Progress& progress = {});

}  // namespace illustrate
