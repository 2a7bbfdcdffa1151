#pragma once
#include "checks/rounded.h"
#include "protocol/questions.h"

/// What the framework's shapes make of a ray in float (framework/src/rt/intersection_tests.cpp, intersectable.cpp).
namespace testat {
struct RoundedLine {
    RoundedVector origin;
    RoundedVector direction;  ///< unit
};

struct FloatHit {
    /// Perhaps: a graze, an edge, or an origin on the shape. Then the rest says nothing.
    Certainty hit = Certainty::no;
    Rounded t;
    RoundedVector position;
    RoundedVector normal;  ///< unit; outward on a sphere
};

FloatHit meet(Shape const& shape, RoundedLine const& ray);
}  // namespace testat
