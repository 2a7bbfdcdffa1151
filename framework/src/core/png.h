#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

/// A decoded PNG file, top row first, four channels.
struct Png {
    int width;
    int height;
    /// 255 or 65535; all values are at most this.
    int max;
    /// One byte for each value, or two in the order of the machine.
    std::vector<unsigned char> bytes;

    /// That of channel i % 4 of pixel i / 4.
    std::uint16_t value(std::size_t i) const;
};

/// A picture to be written, top row first.
struct Bytes {
    int width;
    int height;
    /// 3 or 4.
    int channels;
    std::vector<unsigned char> values;
};

/// Throws std::runtime_error naming the path.
Png read_png(std::string const& path);

/// Compresses little, but fast. Throws std::runtime_error naming the path.
void write_png(Bytes const& bytes, std::string const& path);
