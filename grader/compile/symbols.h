#pragma once
#include "installation.h"
#include "model.h"
#include "sandbox/cage.h"

namespace testat {
/// What an upload's library says about itself.
struct SymbolReport {
    FunctionSet defined;                     ///< of the eleven
    std::map<Function, Diagnostic> missing;  ///< not defined, or with another signature
    std::vector<Diagnostic> duplicates;      ///< definitions that the framework has already
};

/// Reads the dynamic symbols of a library that was compiled from `shown`.
SymbolReport check_symbols(std::filesystem::path const& library, std::string const& shown, Installation const& where,
                           Cage& cage);

/// The C++ declaration of a mangled name of ours or of the framework: never of a name from an upload, which can take
/// for ever. The name itself if it is none.
std::string demangle(std::string const& name);
}  // namespace testat
