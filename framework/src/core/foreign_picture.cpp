#include "foreign_picture.h"

#include <cglib/core/build_paths.h>

#include <dlfcn.h>
#include <fmt/format.h>

#include <stdexcept>

namespace {
void* open_module(std::string const& path)
{
    // Never closed: OpenImageIO keeps threads and caches of its own.
    static void* const module = dlopen(openimageio_module().c_str(), RTLD_NOW | RTLD_LOCAL);
    if (!module)
        throw std::runtime_error(fmt::format("cannot open {}: only PNG is supported without OpenImageIO", path));
    return module;
}

template <class Function>
Function* find_function(std::string const& path, char const* name)
{
    void* const function = dlsym(open_module(path), name);
    if (!function)
        throw std::runtime_error(fmt::format("cannot open {}: {} lacks {}", path, openimageio_module(), name));
    return reinterpret_cast<Function*>(function);
}

void check(std::string const& error, char const* what, std::string const& path)
{
    if (!error.empty())
        throw std::runtime_error(fmt::format("cannot {} {}: {}", what, path, error));
}
}  // namespace

ForeignPicture read_foreign(std::string const& path)
{
    ForeignPicture picture;
    std::string error;
    find_function<ReadForeign>(path, "cglib_openimageio_read")(path.c_str(), &picture, &error);
    check(error, "read", path);
    return picture;
}

void write_foreign(Bytes const& bytes, std::string const& path)
{
    std::string error;
    find_function<WriteForeign>(path, "cglib_openimageio_write")(path.c_str(), &bytes, &error);
    check(error, "write", path);
}
