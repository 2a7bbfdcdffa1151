#pragma once
#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <stdexcept>
#include <string>

namespace testat {
/// A JSON file that cannot be read or breaks its schema; says which file, where in it, and what.
struct BadJson : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Parses a file. Throws BadJson.
nlohmann::json read_json(std::filesystem::path const& file);

/// Throws BadJson with the innermost place that breaks the schema. `name` is how the document is called in it.
void validate_json(nlohmann::json const& document, std::filesystem::path const& schema, std::string const& name);
}  // namespace testat
