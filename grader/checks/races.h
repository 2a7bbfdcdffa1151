#pragma once
#include "model.h"

/// Small pictures made by several threads and by one: that they differ is a remark and changes no points.
namespace testat {
/// Adds to a request renderings with all functions that are `well_behaved`, and with each alone that is `writing`
/// static or global variables. None if nobody does, because then there is nothing to race for.
void ask_about_races(Request& request, FunctionSet well_behaved, FunctionSet writing);

/// Nothing unless several threads make another picture, or crash, while one makes the same again and again.
std::optional<Remark> find_races(Observations const& observations);
}  // namespace testat
