#pragma once

#include <glm/glm.hpp>

#include <string>
#include <vector>

struct GLFWwindow;

namespace viewer {

/// A window with OpenGL and Dear ImGui. One at a time.
class Window {
public:
    /// Throws std::runtime_error saying what to do if there is no display, or no OpenGL.
    Window(char const* title, int width, int height);
    ~Window();
    Window(Window const&) = delete;
    Window& operator=(Window const&) = delete;

    /// Sleeps until something happens, or the time is over. Whether something happened.
    bool wait(double seconds);

    /// Ends wait. For any thread, while the window lives.
    static void wake();

    /// Widgets are drawn between these two. What was drawn is on the screen after present.
    void begin_frame();
    /// See begin_frame.
    void end_frame();
    /// See begin_frame.
    void present();

    /// Whether the user wants it closed.
    bool is_closed() const;

    /// GLFW's keys that were pressed since the last call.
    std::vector<int> take_keys();
    /// Whether one of GLFW's keys is held.
    bool is_held(int key) const;

    /// Pixels for each of the units in which ImGui measures.
    glm::vec2 pixel_scale() const;

    /// Writes what was drawn between begin_frame and end_frame. Throws std::runtime_error naming the file.
    void save_screenshot(std::string const& file) const;

private:
    glm::ivec2 framebuffer_size() const;

    GLFWwindow* window_;
    std::vector<int> keys_;
};

}  // namespace viewer
