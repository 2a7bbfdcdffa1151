#pragma once

#include <cglib/core/image.h>

#include <functional>
#include <vector>

/// What lies beyond the border of a field: its other side, or more of the border.
enum class Border { repeat, clamp };

/// The heights of a relief, one a texel, measured in texels.
class HeightField {
public:
    /// Several threads call height_at.
    HeightField(int width, int height, Border border, std::function<float(int x, int y)> const& height_at);

    /// In texels.
    int width() const { return width_; }
    /// In texels.
    int height() const { return height_; }

    /// At most one width (height) outside.
    float at(int x, int y) const;

    /// (dh/du, dh/dv) by central differences, both u and v in texels.
    glm::vec2 slope(int x, int y) const;

    /// The mean over squares of 2 radius + 1 texels.
    HeightField blurred(int radius) const;

private:
    int width_;
    int height_;
    Border border_;
    std::vector<float> values_;
};

/// Where the bitangent of the mapping points: that of planes and quads along growing v, the default one, which spheres
/// have, along falling v.
enum class Bitangent { along_v, against_v };

/// The unit normals (x, y, z) as rgb = ((x + 1) / 2, (z + 1) / 2, y): x is along growing u, y away from the surface, z
/// along the bitangent, so that (x, y, z) ~ (-dh/du, 1, -dh/dv), or (-dh/du, 1, dh/dv) for Bitangent::against_v.
Image make_normal_map(HeightField const& field, Bitangent bitangent);
