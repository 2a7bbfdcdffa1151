#pragma once
#include "model.h"

#include <glm/glm.hpp>

namespace testat {
/// Side of the assignment pictures, and of the checker whose mip levels are one picture too.
constexpr int picture_side = 256;
constexpr int checker_side = 128;

/// The mip levels of the checker, drawn into one picture: level 0 at the left, the others above each other beside it.
constexpr char miplevels[] = "miplevels";

/// Where a level is drawn in that picture; `size` is zero behind the last level.
struct LevelPlace {
    glm::ivec2 corner;
    glm::ivec2 size;
};
LevelPlace place_of_level(int level);
constexpr int checker_levels = 8;

/// Whether objects stand where their matrices put them in this picture.
bool is_transformed(std::string const& picture);

/// The functions that a picture is wrong without: called by the framework or the reference, and not yet right in the
/// template, as `intersect` is where objects are not transformed.
FunctionSet called_in(std::string const& picture);

/// The functions that may have a hand in a picture, whichever of their own a student calls from which.
FunctionSet functions_in(std::string const& picture);

/// The group that asks for a picture; functions and name of the group are for the caller to set.
Group picture_group(std::string const& picture);

/// The picture in an answer; nothing if it is not complete. Mip levels of the wrong size are NaN.
std::optional<Picture> read_picture(Answers const& answers);
}  // namespace testat
