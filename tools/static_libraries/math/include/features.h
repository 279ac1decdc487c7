// In place of musl's own, which its build makes more of.
#pragma once
#define hidden __attribute__((__visibility__("hidden")))
