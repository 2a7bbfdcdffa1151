#pragma once
#include "bench/footprint.h"

/// How far a filter's picture is from the truth. Alpha does not count. Not finite if a colour is not.
namespace testat::bench {
/// Root of the mean square over all pixels and channels, linear units.
double rmse(Colours const& colours, Truth const& truth);

/// What an eye sees: the mean CIE 1976 colour difference Delta E*ab (CIE 15:2004, 8.2.1) over all pixels. Channels are
/// those of sRGB (IEC 61966-2-1), linear, 1 being white (D65); below 0 they count as 0. A difference of about 2.3 is
/// just noticeable.
double mean_delta_e(Colours const& colours, Truth const& truth);
}  // namespace testat::bench
