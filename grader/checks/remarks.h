#pragma once
#include "model.h"

/// Findings that never change points: state between calls, memory read before it is written, races, leaks. The unit
/// checks' functions are asked once more along with the pictures as submitted; whatever differs then is looked into
/// along with the isolated pictures. Functions that crash, hang or are slow are left out.
namespace testat {
/// What the memory of a unit check holds that nobody has written to: 3.0039 as float, a large int, no valid pointer.
constexpr std::uint32_t usual_fill = 0x40;
/// Another one: -24.22 as float, a negative int, no valid pointer.
constexpr std::uint32_t other_fill = 0xc1;

/// Adds to a request the questions of each function of `units` in reverse order, twice over, with another fill.
/// `textures`: those that `units` were asked with.
void ask_again(Request& request, Observations const& units, std::vector<TextureData> const& textures);

/// Adds to a request what would tell apart the reasons why answers to ask_again differ, if they do; and, if they have
/// changed static or global variables, small renderings with several threads and with one.
void ask_about_differences(Request& request, Observations const& units, Observations const& again,
                           std::vector<TextureData> const& textures);

/// What the three have shown, in the order: depends_on_earlier_calls, differs_between_runs, races, leaks.
std::vector<Remark> find_remarks(Observations const& units, Observations const& again, Observations const& differences);
}  // namespace testat
