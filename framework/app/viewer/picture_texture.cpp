#include "picture_texture.h"

#include <GLFW/glfw3.h>

namespace viewer {

PictureTexture::PictureTexture()
{
    glGenTextures(1, &id_);
    glBindTexture(GL_TEXTURE_2D, id_);
    // Enlarged pixels stay what they are.
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
}

PictureTexture::~PictureTexture()
{
    glDeleteTextures(1, &id_);
}

void PictureTexture::upload(DisplayPicture const& picture)
{
    glBindTexture(GL_TEXTURE_2D, id_);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    if (picture.width() != width_ || picture.height() != height_) {
        width_ = picture.width();
        height_ = picture.height();
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, width_, height_, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    }
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, picture.bytes().data());
}

}  // namespace viewer
