#include "digits.h"
#include "raster.h"
#include "textures.h"

#include <cglib/core/assert.h>

#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>

namespace {
int const width = 1024;
int const height = 512;
/// Of a texel at the equator, in radians, which are radii of the ball.
float const texel = glm::two_pi<float>() / float(width);
/// All in radii of the ball.
float const disc_radius = 0.42f;
float const half_stripe = 0.56f;
float const half_stroke = 0.105f;

glm::vec3 const white(0.955f, 0.945f, 0.915f);
glm::vec3 const ink(0.055f, 0.055f, 0.06f);

/// A ball and the one with eight more have the same colour.
glm::vec3 ball_color(int number)
{
    static glm::vec3 const colors[] = {{0.965f, 0.760f, 0.070f}, {0.070f, 0.190f, 0.600f}, {0.830f, 0.110f, 0.090f},
                                       {0.330f, 0.120f, 0.450f}, {0.950f, 0.440f, 0.070f}, {0.030f, 0.420f, 0.230f},
                                       {0.500f, 0.080f, 0.110f}, {0.060f, 0.060f, 0.065f}};
    return colors[(number - 1) % 8];
}

/// Where a texel lies on the ball, seen from the middle of the nearer disc.
struct BallPoint {
    /// Right and up in a parallel view of the disc, in radii of the ball.
    glm::vec2 seen;
    float latitude;
    /// From the middle of the disc, along the ball.
    float angle;
};

BallPoint ball_point(int x, int y)
{
    float const latitude = (float(y) + 0.5f) * texel - glm::half_pi<float>();
    int const from_disc = x % (width / 2) - width / 4;
    float const longitude = (float(from_disc) + 0.5f) * texel;
    float const forward = std::cos(latitude) * std::cos(longitude);
    glm::vec2 const seen(std::cos(latitude) * std::sin(longitude), std::sin(latitude));
    return {seen, latitude, std::acos(glm::clamp(forward, -1.f, 1.f))};
}

/// How much is covered by what lies a distance away, in radii of the ball.
float covered(float distance)
{
    return coverage(distance / texel);
}

/// What is on the balls besides their colours.
class Number {
public:
    explicit Number(int number)
        : strokes_(number_strokes(number)),
          // The line under 6 and 9 needs room.
          middle_(0.f, number == 6 || number == 9 ? 0.055f : 0.f),
          size_(number < 10 ? 0.38f : 0.34f)
    {
    }

    glm::vec3 disc_color(BallPoint const& point) const
    {
        float const distance = stroke_distance(strokes_, (point.seen - middle_) / size_, half_stroke);
        return glm::mix(white, ink, covered(distance * size_));
    }

private:
    std::vector<Segment> strokes_;
    glm::vec2 middle_;
    float size_;
};

glm::vec3 ground_color(int number, BallPoint const& point)
{
    float const stripe = number > 8 ? covered(std::abs(point.latitude) - half_stripe) : 1.f;
    return glm::mix(white, ball_color(number), stripe);
}
}  // namespace

Image make_pool_ball(int number)
{
    cg_assert(number >= 1 && number <= 15);
    Number const label(number);
    return make_image(width, height, [&](int x, int y) {
        BallPoint const point = ball_point(x, y);
        float const disc = covered(point.angle - disc_radius);
        glm::vec3 const ground = ground_color(number, point);
        return disc > 0.f ? glm::mix(ground, label.disc_color(point), disc) : ground;
    });
}
