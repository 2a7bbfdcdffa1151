// Stands in for the viewer where GLFW, Dear ImGui or OpenGL were not found at build time.
#include "viewer.h"

#include <cstdio>

int show_viewer(Options const&)
{
    std::puts(
        "This 03_textures was built without its viewer, because GLFW, Dear ImGui or OpenGL were not found\n"
        "(Debian: libglfw3-dev libimgui-dev libgl-dev).\n"
        "It can write pictures: 03_textures --create_images, or 03_textures --scene sphere --output sphere.png\n"
        "03_textures --help lists everything.");
    return 0;
}
