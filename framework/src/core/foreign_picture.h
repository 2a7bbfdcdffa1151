#pragma once

#include "png.h"

#include <string>
#include <vector>

/// A picture read by OpenImageIO: top row first, four channels, as encoded in the file (8 bit: v/255).
struct ForeignPicture {
    int width = 0;
    int height = 0;
    std::vector<float> rgba;
};

// What the module offers. It is opened when the first picture that is not PNG is met: starting a program that is
// linked with OpenImageIO takes 0.2 s. An empty error means success.
extern "C" {
using ReadForeign = void(char const* path, ForeignPicture* picture, std::string* error);
using WriteForeign = void(char const* path, Bytes const* bytes, std::string* error);
}

/// Throws std::runtime_error naming the path, also where the module is absent.
ForeignPicture read_foreign(std::string const& path);

/// Throws std::runtime_error naming the path, also where the module is absent.
void write_foreign(Bytes const& bytes, std::string const& path);
