#pragma once

#include <string>

namespace viewer {

/// STEM.png in the current folder, or the first of STEM-2.png, STEM-3.png ... that does not exist; as absolute path.
std::string free_picture_name(std::string const& stem);

}  // namespace viewer
