#pragma once
#include "installation.h"

#include <iosfwd>

namespace testat {
/// Looks at everything that grading needs and says for each part whether it is there and, if not, what to do.
/// True if uploads can be graded.
bool doctor(Installation const& where, std::ostream& out);
}  // namespace testat
