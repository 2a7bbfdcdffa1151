#pragma once

#include "options.h"

/// Opens the window and returns when it is closed: the exit code of the program. Without OpenGL at build time, says so
/// and what the program can do all the same.
int show_viewer(Options const& options);
