#include "../viewer.h"

#include "controls.h"
#include "drive.h"
#include "picture_area.h"
#include "picture_texture.h"
#include "window.h"

#include <GLFW/glfw3.h>
#include <imgui.h>

#include <chrono>
#include <cstdio>
#include <optional>

namespace viewer {
namespace {
using Clock = std::chrono::steady_clock;

double const seconds_of_a_frame = 1. / 60.;
/// Nobody looks.
double const seconds_of_a_driven_frame = 1e-3;
double const seconds_between_tiles = 1. / 25.;
double const for_long = 3600.;
/// ImGui needs some to come to rest after an event.
int const frames_after_an_event = 3;

class Viewer {
public:
    explicit Viewer(Options const& options)
        : window_("03_textures", 1280, 800), session_(options, &Window::wake), prints_stats_(options.stats)
    {
        if (!options.drive.empty())
            drive_.emplace(options.drive);
    }

    void run()
    {
        while (show_frame())
            if (window_.wait(patience()))
                busy_frames_ = frames_after_an_event;
            else if (busy_frames_ > 0)
                --busy_frames_;
    }

private:
    double patience() const
    {
        if (drive_ && !drive_->is_done())
            return seconds_of_a_driven_frame;
        if (busy_frames_ > 0)
            return seconds_of_a_frame;
        return session_.progress().finished ? for_long : seconds_between_tiles;
    }

    /// Whether another one is wanted.
    bool show_frame()
    {
        handle_keys();
        window_.begin_frame();
        Drive::Wishes const wishes = drive_ ? drive_->step(session_) : Drive::Wishes();
        if (session_.state.shows_panel)
            show_panel(session_);
        show_and_move();
        window_.end_frame();
        if (!wishes.screenshot.empty())
            window_.save_screenshot(wishes.screenshot);
        window_.present();
        print_first_picture();
        return !wishes.quit && !quits_ && !window_.is_closed();
    }

    void show_and_move()
    {
        State& state = session_.state;
        Area const area = picture_area(state);
        glm::ivec2 const space = glm::max(glm::ivec2(area.size * window_.pixel_scale()), 1);
        if (session_.update(space.x, space.y))
            texture_.upload(session_.display());
        CameraInput input = show_picture(session_, texture_.id(), area, window_.pixel_scale());
        if (state.flies && !ImGui::GetIO().WantTextInput)
            input.walked = ImGui::GetIO().DeltaTime * held_directions();
        glm::vec3 const before = state.view.camera.position();
        state.view = state.flies ? fly(state.view, input) : orbit(state.view, input);
        // While keys are held there are no events.
        if (state.view.camera.position() != before)
            busy_frames_ = frames_after_an_event;
    }

    glm::vec3 held_directions() const
    {
        auto const axis = [this](int forth, int back) {
            return float(window_.is_held(forth)) - float(window_.is_held(back));
        };
        return glm::vec3(axis(GLFW_KEY_D, GLFW_KEY_A), axis(GLFW_KEY_E, GLFW_KEY_Q), axis(GLFW_KEY_W, GLFW_KEY_S));
    }

    /// Before ImGui's frame begins: there Escape closes what it is meant for.
    void handle_keys()
    {
        bool const taken = ImGui::GetIO().WantTextInput || ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup);
        for (int const key : window_.take_keys())
            if (!taken)
                handle_key(key);
    }

    void handle_key(int key)
    {
        State& state = session_.state;
        if (key == GLFW_KEY_F4)
            session_.save();
        else if (key == GLFW_KEY_ESCAPE)
            quits_ = true;
        else if (key == GLFW_KEY_R)
            session_.reset_view();
        else if (key == GLFW_KEY_TAB)
            state.shows_panel = !state.shows_panel;
        else if (key >= GLFW_KEY_1 && key < GLFW_KEY_1 + TEXTURE_FILTER_MODE_COUNT)
            state.params.tex_filter_mode = TextureFilterMode(key - GLFW_KEY_1);
    }

    void print_first_picture()
    {
        if (!prints_stats_ || session_.display().width() == 0)
            return;
        prints_stats_ = false;
        std::printf("first picture on the screen after %.3f s\n",
                    std::chrono::duration<double>(Clock::now() - begin_).count());
        std::fflush(stdout);
    }

    Clock::time_point begin_ = Clock::now();
    Window window_;
    Session session_;
    PictureTexture texture_;
    std::optional<Drive> drive_;
    bool prints_stats_;
    bool quits_ = false;
    int busy_frames_ = frames_after_an_event;
};
}  // namespace
}  // namespace viewer

int show_viewer(Options const& options)
{
    viewer::Viewer(options).run();
    return 0;
}
