#include "probe/answer.h"

#include "probe/interruptions.h"
#include "probe/memory.h"

#include <cglib/rt/texture_access.h>

#include <cglib/core/thread_pool.h>
#include <cglib/rt/assignment_images.h>
#include <cglib/rt/object.h>
#include <cglib/rt/prepared_render.h>
#include <cglib/rt/raytracing_context.h>
#include <cglib/rt/renderer.h>
#include <cglib/rt/scenes.h>
#include <cglib/rt/texture.h>
#include <cglib/rt/transform.h>

#include <algorithm>
#include <ctime>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>

namespace testat {
namespace {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool sanitized = true;  // tests against every object would take minutes
#else
constexpr bool sanitized = false;
#endif

glm::vec2 vec2(float const* v)
{
    return {v[0], v[1]};
}

glm::vec3 vec3(float const* v)
{
    return {v[0], v[1], v[2]};
}

glm::mat4 mat4(float const* m)
{
    glm::mat4 result;
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            result[column][row] = m[4 * column + row];
    return result;
}

/// Puts words of an answer one behind the other.
class Sheet {
public:
    Sheet(std::uint32_t* words, std::size_t size) : words_(words), size_(size) {}
    void word(std::uint32_t w)
    {
        if (used_ < size_)
            words_[used_] = w;
        ++used_;
    }
    void integer(std::int32_t i) { word(static_cast<std::uint32_t>(i)); }
    void number(float f)
    {
        std::uint32_t w;
        std::memcpy(&w, &f, sizeof w);
        word(w);
    }
    template <typename Vector>
    void vector(Vector const& v)
    {
        for (int i = 0; i < v.length(); ++i)
            number(v[i]);
    }
    void skip_to(std::size_t position) { used_ = position; }

private:
    std::uint32_t* words_;
    std::size_t size_;
    std::size_t used_ = 0;
};

std::shared_ptr<Image> make_image(TextureData::Level const& level)
{
    auto image = std::make_shared<Image>(level.width, level.height);
    for (int y = 0; y < level.height; ++y)
        for (int x = 0; x < level.width; ++x) {
            float const* texel = &level.texels[4 * (std::size_t(y) * std::size_t(level.width) + std::size_t(x))];
            image->setPixel(x, y, {texel[0], texel[1], texel[2], texel[3]});
        }
    return image;
}

std::unique_ptr<ImageTexture> make_texture(TextureData const& data)
{
    auto texture =
        std::make_unique<ImageTexture>(*make_image(data.levels.at(0)), NEAREST, TextureWrapMode(data.wrap_mode));
    for (std::size_t i = 1; i < data.levels.size(); ++i)
        TextureAccess::levels(*texture).push_back(make_image(data.levels[i]));
    return texture;
}

std::unique_ptr<Object> make_object(Shape const& shape)
{
    switch (shape.kind) {
        case ShapeKind::sphere:
            return create_sphere(vec3(shape.center), shape.radius, shape.scale_uv);
        case ShapeKind::plane:
            return create_plane(vec3(shape.center), vec3(shape.a), vec3(shape.b), shape.scale_uv);
        case ShapeKind::quad:
            return create_quad(vec3(shape.center), glm::normalize(glm::cross(vec3(shape.a), vec3(shape.b))),
                               vec3(shape.a), vec3(shape.b), shape.scale_uv);
        default:
            throw std::runtime_error("request: unknown shape");
    }
}

void write_levels(std::vector<std::shared_ptr<Image>> const& levels, Sheet& sheet)
{
    sheet.integer(int(levels.size()));
    std::size_t const shown = std::min<std::size_t>(levels.size(), MipmapLayout::max_levels);
    for (std::size_t i = 0; i < shown; ++i) {
        sheet.integer(levels[i]->getWidth());
        sheet.integer(levels[i]->getHeight());
    }
    sheet.skip_to(MipmapLayout::header_words);
    for (std::size_t i = 0; i < shown; ++i)
        for (int y = 0; y < levels[i]->getHeight(); ++y)
            for (int x = 0; x < levels[i]->getWidth(); ++x)
                sheet.vector(levels[i]->getPixel(x, y));
}

void write_pixels(Image const& image, Sheet& sheet)
{
    for (int y = 0; y < image.getHeight(); ++y)
        for (int x = 0; x < image.getWidth(); ++x)
            sheet.vector(glm::vec3(image.getPixel(x, y)));
}

/// What a group needs to answer its questions; textures are made when the first question asks for them.
class Answerer {
public:
    Answerer(Group const& group, std::vector<TextureData> const& textures, AssetLibrary& assets)
        : group_(group), textures_(textures), assets_(assets), activation_(context_)
    {
    }

    void answer(std::byte const* question, Sheet& sheet)
    {
        switch (group_.kind) {
            case Kind::wrap:
                return wrap(read<WrapQuestion>(question), sheet);
            case Kind::lookup:
                return lookup(read<LookupQuestion>(question), sheet);
            case Kind::mipmap:
                return mipmap(read<MipmapQuestion>(question), sheet);
            case Kind::footprint:
                return footprint(read<FootprintQuestion>(question), sheet);
            case Kind::transform:
                return transform(read<TransformQuestion>(question), sheet);
            case Kind::intersect:
                return intersect(read<IntersectQuestion>(question), sheet);
            case Kind::tangent_space:
                return tangent_space(read<TangentSpaceQuestion>(question), sheet);
            case Kind::picture:
                return picture(read<PictureQuestion>(question), sheet);
            case Kind::rendering:
                return rendering(read<RenderingQuestion>(question), sheet);
            default:
                throw std::runtime_error("request: unknown kind of question");
        }
    }

private:
    static constexpr int tile_rows = 4;  ///< of a rendering
    static_assert(rendering_side % tile_rows == 0);

    template <typename T>
    static T read(std::byte const* bytes)
    {
        T question;
        std::memcpy(&question, bytes, sizeof question);
        return question;
    }

    ImageTexture& texture(std::uint32_t index)
    {
        auto& made = made_[index];
        if (!made)
            made = make_texture(textures_.at(index));
        return *made;
    }

    void wrap(WrapQuestion const& q, Sheet& sheet) const
    {
        bool const clamp = group_.under_test == Function::wrap_clamp;
        fill_stack(group_.fill);
        sheet.integer(clamp ? ImageTexture::wrap_clamp(q.val, q.size) : ImageTexture::wrap_repeat(q.val, q.size));
    }

    void lookup(LookupQuestion const& q, Sheet& sheet)
    {
        ImageTexture const& t = texture(q.texture);
        fill_stack(group_.fill);
        switch (group_.under_test) {
            case Function::evaluate_nearest:
                return sheet.vector(t.evaluate_nearest(q.level, vec2(q.uv)));
            case Function::evaluate_bilinear:
                return sheet.vector(t.evaluate_bilinear(q.level, vec2(q.uv)));
            default:
                return sheet.vector(t.evaluate_trilinear(vec2(q.uv), vec2(q.dudv)));
        }
    }

    /// On a texture of its own, as the framework never asks for mip levels where there are some.
    void mipmap(MipmapQuestion const& q, Sheet& sheet) const
    {
        auto const t = make_texture(textures_.at(q.texture));
        fill_stack(group_.fill);
        t->create_mipmap();
        write_levels(t->get_mip_levels(), sheet);
    }

    void footprint(FootprintQuestion const& q, Sheet& sheet) const
    {
        auto const object = make_object(q.shape);
        Ray const rays[4] = {
            {vec3(q.origin[0]), vec3(q.direction[0])},
            {vec3(q.origin[1]), vec3(q.direction[1])},
            {vec3(q.origin[2]), vec3(q.direction[2])},
            {vec3(q.origin[3]), vec3(q.direction[3])},
        };
        Intersection isect;
        isect.position = vec3(q.position);
        isect.geometric_normal = isect.normal = vec3(q.normal);  // there is no shading_normal yet
        isect.tangent = vec3(q.tangent);
        isect.bitangent = vec3(q.bitangent);
        isect.uv = vec2(q.uv);
        isect.t = glm::length(isect.position - rays[0].origin);
        fill_stack(group_.fill);
        sheet.vector(object->compute_uv_aabb_size(rays, isect));
    }

    void transform(TransformQuestion const& q, Sheet& sheet) const
    {
        bool const direction = group_.under_test == Function::transform_direction;
        fill_stack(group_.fill);
        sheet.vector(direction ? transform_direction(mat4(q.matrix), vec3(q.vector))
                               : transform_position(mat4(q.matrix), vec3(q.vector)));
    }

    void intersect(IntersectQuestion const& q, Sheet& sheet)
    {
        context_.params.transform_objects = q.transform_objects != 0;
        auto const object = make_object(q.shape);
        object->set_transform_object_to_world(mat4(q.object_to_world));
        Intersection isect;
        fill_stack(group_.fill);
        bool const hit = object->intersect(Ray(vec3(q.origin), vec3(q.direction)), &isect);
        sheet.integer(hit ? 1 : 0);
        sheet.number(isect.t);
        sheet.vector(isect.position);
        sheet.vector(isect.normal);
        sheet.vector(isect.geometric_normal);
    }

    void tangent_space(TangentSpaceQuestion const& q, Sheet& sheet) const
    {
        fill_stack(group_.fill);
        sheet.vector(
            transform_direction_to_object_space(vec3(q.d), vec3(q.normal), vec3(q.tangent), vec3(q.bitangent)));
    }

    void picture(PictureQuestion const& q, Sheet& sheet)
    {
        std::string const name(q.name, strnlen(q.name, sizeof q.name));
        if (name == "miplevels")
            return checker_levels(sheet);
        auto const& all = assignment_images();
        auto const found = std::find_if(all.begin(), all.end(), [&](auto const& image) { return image.name == name; });
        if (found == all.end())
            throw std::runtime_error("request: no assignment picture " + name);
        render(*found, sheet);
    }

    void checker_levels(Sheet& sheet)
    {
        ImageTexture checker(*assets_.load("checker", 1.f), NEAREST, REPEAT);
        checker.create_mipmap();
        write_levels(checker.get_mip_levels(), sheet);
    }

    void render(AssignmentImage const& wanted, Sheet& sheet)
    {
        Image image(wanted.params.width, wanted.params.height);
        RenderOptions options;
        options.culling = group_.culling || sanitized;
        render_scene(*create_scene(wanted.scene, assets_), wanted.params, &image, options);
        write_pixels(image, sheet);
    }

    void rendering(RenderingQuestion const& q, Sheet& sheet)
    {
        if (q.filter > TRILINEAR || q.wrap > ZERO || q.threads < 1 || q.threads > max_threads)
            throw std::runtime_error("request: malformed rendering");
        RaytracingParameters params;
        params.width = params.height = int(rendering_side);
        params.max_depth = 1;
        params.shadows = false;
        params.normal_mapping = true;
        params.tex_filter_mode = TextureFilterMode(q.filter);
        params.tex_wrap_mode = TextureWrapMode(q.wrap);
        PreparedRender const prepared(scene_of(q.texture), params);
        Image image(params.width, params.height);
        bool const interrupted = q.threads > 1;
        ThreadPool(int(q.threads)).run(params.height / tile_rows, [&](int i) {
            std::optional<Interruptions> interruptions;
            if (interrupted)
                interruptions.emplace();
            prepared.render({0, i * tile_rows, params.width, (i + 1) * tile_rows}, &image);
        });
        write_pixels(image, sheet);
    }

    /// "sphere", all of its textures being that one.
    Scene& scene_of(std::uint32_t index)
    {
        auto& scene = scenes_[index];
        if (scene)
            return *scene;
        scene = create_scene("sphere", assets_);
        for (auto const& entry : scene->textures)
            TextureAccess::levels(*entry.texture) = texture(index).get_mip_levels();
        return *scene;
    }

    Group const& group_;
    std::vector<TextureData> const& textures_;
    AssetLibrary& assets_;
    RaytracingContext context_;
    RaytracingContext::Activation activation_;
    std::map<std::uint32_t, std::unique_ptr<ImageTexture>> made_;
    std::map<std::uint32_t, std::unique_ptr<Scene>> scenes_;
};

/// CPU time. Not the process's: where that is limited its clock only goes on with the kernel's ticks.
double thread_seconds()
{
    timespec now = {};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
}

void answer_all(Answerer& answerer, Group const& group, std::uint32_t* words, std::uint32_t volatile* answered)
{
    std::size_t const stride = question_bytes(group.kind);
    for (std::uint32_t i = 0; i < group.count; ++i) {
        Sheet sheet(words + std::size_t(i) * group.words_per_answer, group.words_per_answer);
        answerer.answer(group.questions.data() + i * stride, sheet);
        *answered = i + 1;
    }
}
}  // namespace

double answer(Group const& group, std::vector<TextureData> const& textures, AssetLibrary& assets, std::uint32_t* words,
              std::uint32_t volatile* answered)
{
    Answerer answerer(group, textures, assets);
    answer_all(answerer, group, words, answered);
    double fastest = 0;
    for (std::uint32_t pass = 0; pass < group.passes; ++pass) {
        double const start = thread_seconds();
        answer_all(answerer, group, words, answered);
        double const taken = thread_seconds() - start;
        fastest = pass == 0 ? taken : std::min(fastest, taken);
    }
    return fastest;
}
}  // namespace testat
