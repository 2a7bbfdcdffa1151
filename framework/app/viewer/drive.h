#pragma once

#include "session.h"

#include <functional>
#include <iosfwd>
#include <map>
#include <string>
#include <vector>

namespace viewer {

/// Plays a user, for tests: obeys one line of a file in each frame, through the state that the widgets edit.
///
///     scene NAME, filter NAME, wrap NAME, mode NAME     names as on the command line
///     normal_mapping on|off, ... (any of switches())
///     depth N, spp N, epsilon X, fov X, exposure X, gamma X
///     size WIDTH HEIGHT, size window
///     panel on|off, camera orbit|fly, reset
///     drag X Y          with the left button, 1 being the height of the picture
///     wait              until the picture is finished, or has failed
///     save FILE         as F4 does
///     screenshot FILE   of the whole window
///     quit
class Drive {
public:
    /// Throws std::runtime_error if the file cannot be read.
    explicit Drive(std::string const& file);

    /// What the window has to do at the end of a frame.
    struct Wishes {
        bool quit = false;
        /// The file; empty if none is wanted.
        std::string screenshot;
    };

    /// For each frame, before the session is updated. At the end of the file the user takes over. Throws
    /// std::runtime_error naming a line that it does not understand.
    Wishes step(Session& session);

    /// Whether all lines have been obeyed.
    bool is_done() const { return next_ >= lines_.size(); }

private:
    bool must_wait(Session const& session);

    std::string file_;
    std::vector<std::string> lines_;
    std::size_t next_ = 0;
    int frames_waited_ = 0;
};

}  // namespace viewer
