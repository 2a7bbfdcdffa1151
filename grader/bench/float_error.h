#pragma once
#include "bench/filters.h"
#include "checks/oracles.h"

#include <vector>

/// How far filters are off because they calculate in float: the worst error in units of the bound that the oracles of
/// the unit checks derive, by the size of u and v.
namespace testat::bench {
/// |u| and |v| up to 1, 10, ..., 10^6.
constexpr int decades = 7;

/// Random lookups of one decade. The texture is as large as the contract of a lookup allows there (|u| times its side
/// is below 2^23), up to 256 texels to a side.
struct FarLookups {
    Textures textures;  ///< one
    Group group;        ///< of Kind::lookup
};

/// `function`: evaluate_bilinear or evaluate_trilinear.
FarLookups far_lookups(Function function, int decade);

/// In units of the bound; infinite for what is not finite, or was not answered.
double worst_error(Answers const& answers, Textures const& textures);

/// A filter's answers to the same questions.
Answers ask(LookUp const& look_up, Group const& group);
}  // namespace testat::bench
