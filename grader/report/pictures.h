#pragma once
#include "model.h"

#include <optional>

namespace testat {
enum class PictureKind { isolated, submitted, expected, difference };

/// Path of a picture file relative to report.json, such as "pictures/plane_after_c.difference.png"; nothing if there
/// is no such picture. A picture that equals the expected one to the last bit shares its file and has no difference.
std::optional<std::string> picture_file(PictureResult const& result, PictureKind kind);

/// Writes the files of all pictures below `directory`. The expected ones are copied from `envelopes`.
void write_pictures(CheckResults const& results, std::filesystem::path const& directory,
                    std::filesystem::path const& envelopes);

/// PNG of a picture, 8 bits, top row first: assignment pictures with gamma 2.2, mip levels as they are.
std::string encode_picture(std::string const& name, Picture const& picture);

/// Where and how much two pictures differ, as they are shown: black where they are equal, then from dark blue over grey
/// to yellow with the logarithm of the difference (the brightness says it all, so it can be read with any kind of
/// colour vision); white where a value is not finite.
Picture draw_difference(Picture const& submitted, Picture const& expected);
}  // namespace testat
