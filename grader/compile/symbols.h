#pragma once
#include "installation.h"
#include "model.h"

namespace testat {
/// What an upload's library says about itself.
struct SymbolReport {
    FunctionSet defined;                  ///< of the eleven
    std::vector<Diagnostic> diagnostics;  ///< functions missing or with another signature, definitions that the
                                          ///< framework has already
};

/// Reads the dynamic symbols of a library that was compiled from `shown`.
SymbolReport check_symbols(std::filesystem::path const& library, std::string const& shown, Installation const& where);
}  // namespace testat
