#include "picture_name.h"

#include <filesystem>

namespace viewer {

std::string free_picture_name(std::string const& stem)
{
    std::filesystem::path file = std::filesystem::absolute(stem + ".png");
    for (int number = 2; std::filesystem::exists(file); ++number)
        file = std::filesystem::absolute(stem + '-' + std::to_string(number) + ".png");
    return file.string();
}

}  // namespace viewer
