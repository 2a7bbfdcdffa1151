#pragma once

namespace testat::bench {
/// What something is called, in both languages.
struct Title {
    char const* de;
    char const* en;
};
}  // namespace testat::bench
