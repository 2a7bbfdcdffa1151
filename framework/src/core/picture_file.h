#pragma once

#include <cglib/core/image.h>

#include <string>

/// Reads a picture: by libspng if the path ends in .png, else by OpenImageIO. rgb = (v/255)^gamma.
/// Throws std::runtime_error naming the path.
Image read_picture(std::string const& path, float gamma);

/// Writes an 8-bit picture in the format of the path's extension, see Image::save.
/// Throws std::runtime_error naming the path.
void write_picture(Image const& image, std::string const& path, float gamma);

/// What Image::save makes of one value: 255 max(0, value)^exponent, rounded and clamped; NaN is 0.
unsigned char quantize(float value, float exponent);

/// (v/max)^gamma for every v in 0..max.
std::vector<float> decoding_table(int max, float gamma);
