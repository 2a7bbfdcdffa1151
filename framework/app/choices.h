#pragma once

#include <cglib/rt/raytracing_parameters.h>

#include <map>
#include <string>
#include <vector>

/// Names as on the command line, in lower case.
std::map<std::string, TextureFilterMode> const& filter_choices();

/// Like filter_choices.
std::map<std::string, TextureWrapMode> const& wrap_choices();

/// Like filter_choices.
std::map<std::string, RenderMode> const& mode_choices();

/// A parameter that is on or off.
struct Switch {
    /// As the member is called.
    char const* name;
    /// For people.
    char const* label;
    bool RaytracingParameters::*value;
};

/// All of them.
std::vector<Switch> const& switches();

/// The name of a value; empty if it has none.
template <class Enum>
std::string name_of(Enum value, std::map<std::string, Enum> const& choices)
{
    for (auto const& [name, choice] : choices)
        if (choice == value)
            return name;
    return std::string();
}
