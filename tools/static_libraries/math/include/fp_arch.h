// In place of musl's own: no processor asks for anything of its own.
#pragma once
