// The module cglib_openimageio, see foreign_picture.h.
#include "foreign_picture.h"

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>

#include <exception>

namespace {
/// Grey is spread over rgb, and alpha is 1 where there is none.
OIIO::ImageBuf with_four_channels(OIIO::ImageBuf const& picture)
{
    int const channels = picture.nchannels();
    bool const color = channels >= 3;
    int const alpha = channels == 2 ? 1 : channels >= 4 ? 3 : -1;
    return OIIO::ImageBufAlgo::channels(picture, 4, {0, color ? 1 : 0, color ? 2 : 0, alpha}, {0.f, 0.f, 0.f, 1.f});
}

std::string read(char const* path, ForeignPicture* picture)
{
    OIIO::ImageBuf file(path);
    if (!file.read(0, 0, true, OIIO::TypeDesc::FLOAT)) {
        std::string const error = file.geterror();
        return error.empty() ? "it cannot be read" : error;
    }
    OIIO::ImageBuf const rgba = with_four_channels(file);
    picture->width = rgba.spec().width;
    picture->height = rgba.spec().height;
    picture->rgba.resize(std::size_t(picture->width) * std::size_t(picture->height) * 4);
    bool const copied = rgba.get_pixels(rgba.roi(), OIIO::TypeDesc::FLOAT, picture->rgba.data());
    return copied ? std::string() : rgba.geterror();
}

std::string write(char const* path, Bytes const& bytes)
{
    OIIO::ImageSpec const spec(bytes.width, bytes.height, bytes.channels, OIIO::TypeDesc::UINT8);
    OIIO::ImageBuf const picture(spec, const_cast<unsigned char*>(bytes.values.data()));
    if (picture.write(path))
        return std::string();
    std::string const error = picture.geterror();
    return error.empty() ? "it cannot be written in a format of this name" : error;
}
}  // namespace

extern "C" {
ReadForeign cglib_openimageio_read;
WriteForeign cglib_openimageio_write;
}

void cglib_openimageio_read(char const* path, ForeignPicture* picture, std::string* error)
{
    try {
        *error = read(path, picture);
    } catch (std::exception const& e) {
        *error = e.what();
    }
}

void cglib_openimageio_write(char const* path, Bytes const* bytes, std::string* error)
{
    try {
        *error = write(path, *bytes);
    } catch (std::exception const& e) {
        *error = e.what();
    }
}
