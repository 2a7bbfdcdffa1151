#pragma once

#include <cglib/rt/asset_library.h>
#include <cglib/rt/render_stats.h>

#include <functional>
#include <string>

/// Renders the pictures of the exercise sheet and writes them, with the mip levels of the checker, into the folder,
/// which is made if it is missing. Each scene is made once, each texture loaded once. `report` is told what each
/// rendered picture took. Throws std::runtime_error naming what cannot be read or written.
void create_images(AssetLibrary& assets, std::string const& output_directory, int threads,
                   std::function<void(std::string const& name, RenderStats const&)> const& report);
