#pragma once

#include <string>

/// The folder into which this build's generator has written the textures.
std::string assets_directory();

/// The module that reads and writes pictures other than PNG. It is absent where OpenImageIO was not found.
std::string openimageio_module();
