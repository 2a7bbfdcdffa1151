#pragma once
#include <cstdint>

namespace testat {
/// Takes what the slots hold now (the reference) and puts wrappers around it: every result is moved by at most eight
/// float roundings of its operands (GRADING.md, section 4). Rays, hits, texture coordinates, footprints and lookups
/// are then as far off as a correct solution may be.
void perturb_slots();

/// Renderings with different seeds differ; seed 0 perturbs nothing.
void set_perturbation_seed(std::uint64_t seed);
}  // namespace testat
