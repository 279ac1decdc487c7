// Memory asked for before it is needed, where the places to look at are known but far apart.
#pragma once

namespace illustrate {

// A hint: no effect but on time.
inline void prefetch(const void* place) { __builtin_prefetch(place); }

}  // namespace illustrate
