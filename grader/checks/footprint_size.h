#pragma once
#include "checks/vectors.h"
#include "protocol/questions.h"

/// The oracle of compute_uv_aabb_size.
namespace testat {
struct Footprint {
    glm::dvec2 size;
    glm::dvec2 bound;     ///< infinite where it is not decided
    bool decided = true;  ///< false if float may take a ray for parallel, or its hit for one behind the ray
};

/// What is right, of several sizes the one nearest to `measured`: where the error of a corner decides on which side of
/// a seam it lies, or whether the framework takes a pair of corners for one with a seam between them, both are right.
Footprint footprint(FootprintQuestion const& question, glm::dvec2 measured);
}  // namespace testat
