#pragma once
#include "protocol/request.h"

#include <cglib/rt/asset_library.h>

#include <string>

namespace testat {
/// Where the probe finds what it loads.
struct Libraries {
    std::string upload;      ///< the student's file as a shared library
    std::string references;  ///< directory of the reference libraries: all.so, and without_<function>.so for each
};

/// Answers the request group by group, each in a forked child, and writes the answer stream (see request.h) to the
/// descriptor. Never runs code of the upload itself. Throws std::system_error when the machine refuses.
void serve(Request const& request, Libraries const& libraries, AssetLibrary& assets, int answers);
}  // namespace testat
