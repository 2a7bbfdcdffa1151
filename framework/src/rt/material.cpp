#include <cglib/rt/material.h>

#include <cglib/rt/texture.h>

namespace {
float const default_diffuse = 0.18f;
float const ambient_share = 0.1f;

std::shared_ptr<Texture> constant(float value)
{
    return std::make_shared<ConstTexture>(glm::vec3(value));
}

/// A surface cannot send back more light than it gets.
void limit_to_one(MaterialSample* sample)
{
    glm::vec3 const sum = sample->k_a + sample->k_d + sample->k_s + sample->k_r + sample->k_t;
    for (int c = 0; c < 3; ++c) {
        if (!(sum[c] > 1.f))
            continue;
        for (glm::vec3* k : {&sample->k_a, &sample->k_d, &sample->k_s, &sample->k_r, &sample->k_t})
            (*k)[c] /= sum[c];
    }
}
}  // namespace

Material::Material()
    : k_d(constant(default_diffuse)),
      k_s(constant(0.f)),
      k_r(constant(0.f)),
      k_t(constant(0.f)),
      normal(std::make_shared<ConstTexture>(glm::vec3(0.5f, 0.5f, 1.f)))
{
}

Material::~Material() = default;

bool Material::is_textured() const
{
    for (std::shared_ptr<Texture> const* k : {&k_a, &k_d, &k_s, &k_r, &k_t})
        if (*k && (*k)->depends_on_uv())
            return true;
    return false;
}

bool Material::has_normal_map() const
{
    return normal->depends_on_uv() || evaluate_normal(glm::vec2(0.f), glm::vec2(0.f)) != glm::vec3(0.f, 1.f, 0.f);
}

MaterialSample Material::evaluate(glm::vec2 const& uv, glm::vec2 const& dudv) const
{
    MaterialSample sample;
    sample.k_d = glm::vec3(k_d->evaluate(uv, dudv));
    sample.k_a = k_a ? glm::vec3(k_a->evaluate(uv, dudv)) : ambient_share * sample.k_d;
    sample.k_s = glm::vec3(k_s->evaluate(uv, dudv));
    sample.k_r = glm::vec3(k_r->evaluate(uv, dudv));
    sample.k_t = glm::vec3(k_t->evaluate(uv, dudv));
    sample.normal = glm::vec3(0.f, 1.f, 0.f);
    sample.eta = eta;
    sample.n = n;
    limit_to_one(&sample);
    return sample;
}

glm::vec3 Material::evaluate_normal(glm::vec2 const& uv, glm::vec2 const& dudv) const
{
    glm::vec4 const rgb = normal->evaluate(uv, dudv);
    return glm::normalize(glm::vec3(2.f * rgb.r - 1.f, rgb.b, 2.f * rgb.g - 1.f));
}
