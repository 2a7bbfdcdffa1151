#pragma once

#include <cglib/core/image.h>
#include <cglib/rt/raytracing_parameters.h>
#include <cglib/rt/render_plan.h>
#include <cglib/rt/render_stats.h>

#include <memory>

class Culling;
struct Scene;

/// A part of a picture: columns [x0, x1) and rows [y0, y1), counted from the left and the bottom.
struct Tile {
    int x0, y0, x1, y1;
};

/// A scene made ready for one set of parameters: what does not depend on the pixel has been done.
class PreparedRender {
public:
    /// Plans, loads the textures that are needed, sets their filter and wrap, makes missing mip levels, and bounds the
    /// objects if `culling`. The scene must outlive this, and stay as it is meanwhile. Throws std::runtime_error if a
    /// texture is missing.
    PreparedRender(Scene& scene, RaytracingParameters const& params, bool culling = true);
    ~PreparedRender();
    PreparedRender(PreparedRender const&) = delete;
    PreparedRender& operator=(PreparedRender const&) = delete;

    /// Renders a part of the picture into the image, which has the picture's size. Several threads may do so at once,
    /// for parts that do not overlap. The random numbers of a pixel depend on its position only.
    RenderStats render(Tile const& tile, Image* image) const;

    RenderPlan const& plan() const { return plan_; }
    /// What the preparation has loaded and made.
    RenderStats const& preparation() const { return preparation_; }

private:
    void prepare_textures();

    Scene& scene_;
    RaytracingParameters params_;
    RenderPlan plan_;
    std::unique_ptr<Culling> culling_;
    RenderStats preparation_;
};
