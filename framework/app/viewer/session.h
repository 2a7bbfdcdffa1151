#pragma once

#include "progressive_render.h"
#include "state.h"

#include "../options.h"

#include <cglib/rt/asset_library.h>

#include <functional>
#include <memory>
#include <string>

namespace viewer {

/// The viewer without its window: keeps the picture to what the state says.
class Session {
public:
    /// Starts as the command line says. on_change: see ProgressiveRender.
    Session(Options const& options, std::function<void()> on_change);

    /// Takes effect with the next update.
    State state;

    /// Renders what the state asks for, if that is not what is rendered already; the space that the picture may fill
    /// is in pixels. Takes in what is there of the picture. Another scene brings its own view. Whether display() has
    /// changed.
    bool update(int width, int height);

    /// Looks as the scene's own camera does.
    void reset_view();

    /// Writes the picture as it is shown into a file of a new name in the current folder, and says so in message().
    void save();

    /// Writes the picture as it is shown. Throws std::runtime_error naming the file.
    void save(std::string const& file) const;

    /// Linear, as far as it has been rendered; empty at first.
    Image const& picture() const { return picture_; }
    /// The same for the screen.
    DisplayPicture const& display() const { return display_; }
    PictureProgress const& progress() const { return progress_; }
    /// What to tell about the last save.
    std::string const& message() const { return message_; }

private:
    void open_scene();
    RaytracingParameters wanted_params(int width, int height) const;
    void restart_if_needed(RaytracingParameters const& params);

    AssetLibrary assets_;
    std::string scene_name_;
    std::shared_ptr<Scene> scene_;
    View scene_view_;
    /// What is being rendered.
    std::shared_ptr<Scene> rendered_scene_;
    Camera rendered_camera_;
    RaytracingParameters rendered_params_;

    Image picture_;
    DisplayPicture display_;
    PictureProgress progress_;
    std::string message_;
    ProgressiveRender render_;
};

}  // namespace viewer
