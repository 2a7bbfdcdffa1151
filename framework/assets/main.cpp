// make_assets OUTDIR: writes the textures of the scenes.
#include "textures.h"

#include <cstdio>
#include <exception>
#include <filesystem>

namespace {
float const as_stored = 1.f;

void make_assets(std::filesystem::path const& directory)
{
    std::filesystem::create_directories(directory);
    make_checker().save((directory / "checker.png").string(), as_stored);
}
}  // namespace

int main(int argc, char** argv)
{
    if (argc != 2) {
        std::fputs("usage: make_assets OUTDIR\n", stderr);
        return 2;
    }
    try {
        make_assets(argv[1]);
        return 0;
    } catch (std::exception const& error) {
        std::fprintf(stderr, "make_assets: %s\n", error.what());
        return 2;
    }
}
