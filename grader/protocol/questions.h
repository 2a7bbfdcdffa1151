#pragma once
#include <cstdint>

/// What the judge may ask the probe. Every struct is plain data of 32-bit words, so that a question is the same
/// bytes on both sides. Vectors are x, y, z; matrices are column-major as GLM stores them. No answer is ever in here.
namespace testat {
enum class Kind : std::uint32_t {
    wrap,
    lookup,
    mipmap,
    footprint,
    transform,
    intersect,
    tangent_space,
    picture,
    rendering,
    count
};

/// wrap_clamp or wrap_repeat. Answer: 1 word, an int32.
struct WrapQuestion {
    std::int32_t val;
    std::int32_t size;  ///< at least 1
};

/// evaluate_nearest, evaluate_bilinear (level is used) or evaluate_trilinear (dudv is used). Answer: 4 floats.
struct LookupQuestion {
    std::uint32_t texture;  ///< index into the textures of the request
    std::int32_t level;
    float uv[2];
    float dudv[2];
};

/// create_mipmap on level 0 of a texture. Answer: see MipmapLayout.
struct MipmapQuestion {
    std::uint32_t texture;
};

enum class ShapeKind : std::uint32_t { sphere, plane, quad, count };

/// One object as the framework's factories make it.
struct Shape {
    ShapeKind kind;
    float center[3];
    float a[3];    ///< plane: normal; quad: e0
    float b[3];    ///< plane: tangent; quad: e1
    float radius;  ///< sphere only
    float scale_uv;
};

/// compute_uv_aabb_size. Answer: 2 floats, du and dv.
struct FootprintQuestion {
    Shape shape;
    float origin[4][3];
    float direction[4][3];  ///< Ray normalises it
    float position[3];      ///< of the intersection, as all that follows
    float normal[3];
    float tangent[3];
    float bitangent[3];
    float uv[2];
};

/// transform_direction or transform_position. Answer: 3 floats.
struct TransformQuestion {
    float matrix[16];
    float vector[3];
};

/// Object::intersect. Answer: hit (0 or 1, int32), t, position, normal, geometric_normal: 11 words.
struct IntersectQuestion {
    Shape shape;
    float object_to_world[16];
    std::uint32_t transform_objects;  ///< the parameter of that name, 0 or 1
    float origin[3];
    float direction[3];  ///< Ray normalises it
};

/// transform_direction_to_object_space. Answer: 3 floats.
struct TangentSpaceQuestion {
    float d[3];
    float normal[3];
    float tangent[3];
    float bitangent[3];
};

/// One assignment picture by name (answer: width * height * 3 floats, row 0 at the bottom), or "miplevels": the mip
/// levels of the checker (answer: see MipmapLayout).
struct PictureQuestion {
    char name[32];
};

/// A small picture of the scene "sphere" with transforms and normal maps and without shadows, all of its textures being
/// one of the request's. Answer: rendering_side^2 * 3 floats, row 0 at the bottom.
struct RenderingQuestion {
    std::uint32_t texture;  ///< index into the textures of the request; needs all of its levels
    std::uint32_t filter;   ///< TextureFilterMode of the framework
    std::uint32_t wrap;     ///< TextureWrapMode of the framework
    std::uint32_t threads;  ///< 1 to max_threads
};
constexpr std::uint32_t rendering_side = 64;
constexpr std::uint32_t max_threads = 16;

/// How mip levels are laid out in an answer: word 0 is the number of levels, then width and height of up to
/// `max_levels` levels, then the RGBA floats of one level after the other, as far as `capacity_texels` reaches.
struct MipmapLayout {
    static constexpr std::uint32_t max_levels = 24;
    static constexpr std::uint32_t header_words = 1 + 2 * max_levels;
    static constexpr std::uint32_t words(std::uint32_t capacity_texels) { return header_words + 4 * capacity_texels; }
};

/// Words of one answer, for kinds where it does not depend on the question (0 otherwise).
constexpr std::uint32_t answer_words(Kind kind)
{
    switch (kind) {
        case Kind::wrap:
            return 1;
        case Kind::lookup:
            return 4;
        case Kind::footprint:
            return 2;
        case Kind::transform:
            return 3;
        case Kind::intersect:
            return 11;
        case Kind::tangent_space:
            return 3;
        case Kind::rendering:
            return 3 * rendering_side * rendering_side;
        default:
            return 0;
    }
}

/// Bytes of one question.
constexpr std::uint32_t question_bytes(Kind kind)
{
    switch (kind) {
        case Kind::wrap:
            return sizeof(WrapQuestion);
        case Kind::lookup:
            return sizeof(LookupQuestion);
        case Kind::mipmap:
            return sizeof(MipmapQuestion);
        case Kind::footprint:
            return sizeof(FootprintQuestion);
        case Kind::transform:
            return sizeof(TransformQuestion);
        case Kind::intersect:
            return sizeof(IntersectQuestion);
        case Kind::tangent_space:
            return sizeof(TangentSpaceQuestion);
        case Kind::picture:
            return sizeof(PictureQuestion);
        case Kind::rendering:
            return sizeof(RenderingQuestion);
        default:
            return 0;
    }
}
}  // namespace testat
