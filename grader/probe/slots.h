#pragma once
#include "functions.h"

#include <string>

/// Where the trampolines jump to. One process has one arrangement: some functions from the upload, the others from
/// the reference.
namespace testat {
/// A function as the loader gives it; never called through this type.
using Code = void*;

Code get_slot(Function function);
void set_slot(Function function, Code code);

/// Loads a library (RTLD_NOW, RTLD_LOCAL); its constructors run here. Throws std::runtime_error with the loader's
/// words.
void* load_library(std::string const& path);

/// Fills the bodies of `functions` in `library` with traps: nobody calls them in this process, however they find them.
/// Throws std::system_error.
void remove_bodies(void* library, FunctionSet functions);

/// Points the slots of `functions` at what `library` defines. A function that it does not define keeps its slot.
void fill_slots(void* library, FunctionSet functions);
}  // namespace testat
