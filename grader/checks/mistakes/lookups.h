#pragma once
#include "checks/lookup.h"
#include "checks/mistakes/mistake.h"

#include <optional>

namespace testat {
/// What a wrong lookup gives with exact arithmetic; nothing where it asks for a level that is not there.
using WrongLookup =
    std::function<std::optional<glm::dvec4>(TextureData const&, LookupQuestion const&, glm::dvec2 uv, glm::dvec2 dudv)>;

/// Explains an answer that lies among what the wrong lookup gives for all uv and dudv that differ from the question's
/// by no more than float roundings, if it scales them by the size less `smaller_by`. Where it gives nothing or no
/// finite number, the answer must not be finite either.
Model lookup_model(WrongLookup const& wrong, int smaller_by = 0);
}  // namespace testat
