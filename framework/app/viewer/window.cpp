#include "window.h"

#include <cglib/core/image.h>

#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl2.h>
#include <imgui.h>

#include <stdexcept>

namespace viewer {
namespace {
[[noreturn]] void fail(std::string const& what)
{
    char const* reason = nullptr;
    glfwGetError(&reason);
    std::string const message = "cannot " + what + (reason ? std::string(": ") + reason : std::string()) +
                                "\nThe viewer needs a display with OpenGL; over ssh, log in with ssh -X. Without one, "
                                "this program writes pictures:\n"
                                "03_textures --create_images, or 03_textures --scene sphere --output sphere.png";
    throw std::runtime_error(message);
}

GLFWwindow* open(char const* title, int width, int height)
{
    if (!glfwInit())
        fail("open a window");
    GLFWwindow* const window = glfwCreateWindow(width, height, title, nullptr, nullptr);
    if (!window)
        fail("open a window with OpenGL");
    glfwMakeContextCurrent(window);
    glfwSwapInterval(1);
    return window;
}

void set_style()
{
    ImGui::StyleColorsDark();
    ImGuiStyle& style = ImGui::GetStyle();
    style.WindowPadding = ImVec2(10.f, 10.f);
    style.ItemSpacing = ImVec2(8.f, 5.f);
    style.FrameRounding = 3.f;
    style.GrabRounding = 3.f;
    style.WindowBorderSize = 0.f;
    // What a slider's grab covers can be read through it.
    style.Colors[ImGuiCol_SliderGrab].w = 0.45f;
    style.Colors[ImGuiCol_SliderGrabActive].w = 0.6f;
    style.Colors[ImGuiCol_PopupBg] = ImVec4(0.14f, 0.14f, 0.16f, 1.f);
    style.Colors[ImGuiCol_WindowBg] = ImVec4(0.11f, 0.11f, 0.12f, 1.f);
}

void start_imgui(GLFWwindow* window)
{
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    // Positions of widgets are ours: nothing is to be remembered.
    io.IniFilename = nullptr;
    io.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
    set_style();
    ImGui_ImplGlfw_InitForOpenGL(window, true);
    // It makes do with OpenGL 1.1, as on remote displays and in virtual machines.
    ImGui_ImplOpenGL2_Init();
}
}  // namespace

Window::Window(char const* title, int width, int height) : window_(open(title, width, height))
{
    glfwSetWindowUserPointer(window_, this);
    // Before ImGui's own, which calls it.
    glfwSetKeyCallback(window_, [](GLFWwindow* window, int key, int, int action, int) {
        if (action == GLFW_PRESS)
            static_cast<Window*>(glfwGetWindowUserPointer(window))->keys_.push_back(key);
    });
    start_imgui(window_);
}

Window::~Window()
{
    ImGui_ImplOpenGL2_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
    glfwDestroyWindow(window_);
    glfwTerminate();
}

bool Window::wait(double seconds)
{
    double const begin = glfwGetTime();
    glfwWaitEventsTimeout(seconds);
    return glfwGetTime() - begin < 0.95 * seconds;
}

void Window::wake()
{
    glfwPostEmptyEvent();
}

void Window::begin_frame()
{
    ImGui_ImplOpenGL2_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    ImGui::NewFrame();
}

void Window::end_frame()
{
    ImGui::Render();
    glm::ivec2 const size = framebuffer_size();
    glViewport(0, 0, size.x, size.y);
    glClearColor(0.07f, 0.07f, 0.08f, 1.f);
    glClear(GL_COLOR_BUFFER_BIT);
    ImGui_ImplOpenGL2_RenderDrawData(ImGui::GetDrawData());
}

void Window::present()
{
    glfwSwapBuffers(window_);
}

bool Window::is_closed() const
{
    return glfwWindowShouldClose(window_);
}

std::vector<int> Window::take_keys()
{
    std::vector<int> keys;
    keys.swap(keys_);
    return keys;
}

bool Window::is_held(int key) const
{
    return glfwGetKey(window_, key) == GLFW_PRESS;
}

glm::ivec2 Window::framebuffer_size() const
{
    glm::ivec2 size;
    glfwGetFramebufferSize(window_, &size.x, &size.y);
    return size;
}

glm::vec2 Window::pixel_scale() const
{
    ImVec2 const scale = ImGui::GetIO().DisplayFramebufferScale;
    return glm::vec2(scale.x, scale.y);
}

void Window::save_screenshot(std::string const& file) const
{
    glm::ivec2 const size = framebuffer_size();
    Image image(size.x, size.y);
    std::vector<unsigned char> bytes(4 * image.getPixels().size());
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, size.x, size.y, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
    for (std::size_t i = 0; i < image.getPixels().size(); ++i)
        image.getPixels()[i] = glm::vec4(bytes[4 * i], bytes[4 * i + 1], bytes[4 * i + 2], 255.f) / 255.f;
    image.save(file, 1.f);
}

}  // namespace viewer
