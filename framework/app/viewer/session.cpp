#include "session.h"

#include "picture_name.h"

#include "../choices.h"

#include <cglib/rt/scenes.h>

#include <stdexcept>
#include <tuple>

namespace viewer {
namespace {
auto fields(RaytracingParameters const& p)
{
    return std::tie(p.width, p.height, p.max_depth, p.shadows, p.ambient, p.diffuse, p.specular, p.reflection,
                    p.transmission, p.fresnel, p.ray_epsilon, p.fovy, p.spp, p.stratified, p.normal_mapping,
                    p.transform_objects, p.tex_filter_mode, p.tex_wrap_mode, p.render_mode);
}

bool same(Camera const& a, Camera const& b)
{
    return a.position() == b.position() && a.forward() == b.forward() && a.up() == b.up();
}

State initial_state(Options const& options)
{
    State state;
    state.scene = options.scene;
    state.params = options.params;
    state.size_is_fixed = options.size_is_given;
    return state;
}
}  // namespace

Session::Session(Options const& options, std::function<void()> on_change)
    : state(initial_state(options)), assets_(options.assets), render_(options.threads, std::move(on_change))
{
    open_scene();
}

void Session::open_scene()
{
    scene_ = create_scene(state.scene, assets_);
    scene_name_ = state.scene;
    scene_view_ = initial_view(scene_->camera);
    reset_view();
}

void Session::reset_view()
{
    state.view = scene_view_;
}

RaytracingParameters Session::wanted_params(int width, int height) const
{
    RaytracingParameters params = state.params;
    if (!state.size_is_fixed) {
        params.width = width;
        params.height = height;
    }
    return params;
}

void Session::restart_if_needed(RaytracingParameters const& params)
{
    Camera const& camera = state.view.camera;
    if (scene_ == rendered_scene_ && same(camera, rendered_camera_) && fields(params) == fields(rendered_params_))
        return;
    rendered_scene_ = scene_;
    rendered_camera_ = camera;
    rendered_params_ = params;
    render_.restart({scene_, camera, params});
}

bool Session::update(int width, int height)
{
    if (state.scene != scene_name_)
        open_scene();
    restart_if_needed(wanted_params(width, height));
    PictureChanges const changes = render_.take_changes(&picture_);
    progress_ = changes.progress;
    return display_.update(picture_, changes.parts, state.exposure);
}

void Session::save()
{
    try {
        RaytracingParameters const& p = state.params;
        std::string const file = free_picture_name(state.scene + '_' + name_of(p.tex_filter_mode, filter_choices()) +
                                                   '_' + name_of(p.render_mode, mode_choices()));
        save(file);
        message_ = (progress_.finished ? "Saved " : "Saved, not finished yet: ") + file;
    } catch (std::exception const& error) {
        message_ = error.what();
    }
}

void Session::save(std::string const& file) const
{
    if (picture_.getWidth() == 0 || !progress_.error.empty())
        throw std::runtime_error("There is no picture to save.");
    exposed(picture_, state.exposure).save(file, state.exposure.gamma);
}

}  // namespace viewer
