#pragma once
#include "protocol/request.h"

#include <cglib/rt/asset_library.h>

#include <string>

namespace testat {
/// Answers every question of the group in order through the functions in the slots. `words` has room for
/// group.answer_size() words and is written as each answer is known; `answered` counts them.
/// Then asks again as often as the group wants; returns the CPU seconds of the fastest of these passes, 0 without any.
/// Runs the upload's code: anything may happen, and whatever is in `words` afterwards is not to be trusted.
double answer(Group const& group, std::vector<TextureData> const& textures, AssetLibrary& assets, std::uint32_t* words,
              std::uint32_t volatile* answered);
}  // namespace testat
