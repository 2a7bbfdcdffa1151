#pragma once

#include <string>

/// Writes all assignment images and the mip levels of `checker` as PNG files into a folder, which is made if missing.
/// A mip level that create_mipmap has not made is named on stderr and left out.
/// Throws std::runtime_error naming the file or folder that cannot be read or written.
void create_images(std::string const& assets_directory, std::string const& output_directory);
