#pragma once

#include "display.h"

namespace viewer {

/// A picture in OpenGL's hands. Needs OpenGL's context.
class PictureTexture {
public:
    PictureTexture();
    ~PictureTexture();
    PictureTexture(PictureTexture const&) = delete;
    PictureTexture& operator=(PictureTexture const&) = delete;

    /// The picture must not be empty.
    void upload(DisplayPicture const& picture);

    /// OpenGL's name for it.
    unsigned id() const { return id_; }

private:
    unsigned id_ = 0;
    int width_ = 0;
    int height_ = 0;
};

}  // namespace viewer
