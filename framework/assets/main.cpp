// make_assets OUTDIR [STEM...]: writes the textures of the scenes, or only those named, and keeps their decoded texels.
#include "textures.h"

#include <cglib/rt/asset_library.h>

#include <cstdio>
#include <exception>
#include <filesystem>
#include <functional>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace {
using Textures = std::map<std::string, std::function<Image()>>;

float const as_stored = 1.f;

/// By stem of the file.
Textures all_textures()
{
    Textures textures = {{"checker", &make_checker},
                         {"stonewall_diffuse", &make_stonewall_diffuse},
                         {"stonewall_normal", &make_stonewall_normal},
                         {"concrete_diffuse", &make_concrete_diffuse},
                         {"concrete_normal", &make_concrete_normal},
                         {"go_board_diffuse", &make_go_board_diffuse},
                         {"go_board_normal", &make_go_board_normal},
                         {"pool_table", &make_pool_table},
                         {"warehouse", &make_warehouse},
                         {"apartment", &make_apartment}};
    for (int number = 1; number <= 15; ++number)
        textures["pool_ball_" + std::to_string(number)] = [number] { return make_pool_ball(number); };
    return textures;
}

Textures named_textures(std::vector<std::string> const& stems)
{
    Textures const all = all_textures();
    Textures named;
    for (std::string const& stem : stems) {
        auto const found = all.find(stem);
        if (found == all.end())
            throw std::invalid_argument("there is no texture '" + stem + "'");
        named.insert(*found);
    }
    return named;
}

void write(Textures const& textures, std::filesystem::path const& directory)
{
    std::filesystem::create_directories(directory);
    AssetLibrary const library(directory.string());
    for (auto const& [stem, make] : textures) {
        make().save((directory / (stem + ".png")).string(), as_stored);
        library.cache_texels(stem);
    }
}
}  // namespace

int main(int argc, char** argv)
{
    if (argc < 2) {
        std::fputs("usage: make_assets OUTDIR [STEM...]\n", stderr);
        return 2;
    }
    try {
        std::vector<std::string> const stems(argv + 2, argv + argc);
        write(stems.empty() ? all_textures() : named_textures(stems), argv[1]);
        return 0;
    } catch (std::exception const& error) {
        std::fprintf(stderr, "make_assets: %s\n", error.what());
        return 2;
    }
}
