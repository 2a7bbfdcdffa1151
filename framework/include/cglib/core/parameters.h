#pragma once

/// What every program that makes a picture lets one choose.
struct Parameters {
    /// Of the picture, in pixels.
    int width = 256;
    /// Of the picture, in pixels.
    int height = 256;
};
