// The only file that knows where things were built: framework/CMakeLists.txt defines both paths for it.
#include <cglib/core/build_paths.h>

std::string assets_directory()
{
    return CGLIB_ASSETS_DIRECTORY;
}

std::string openimageio_module()
{
    return CGLIB_OPENIMAGEIO_MODULE;
}
