// verdict: {"loses": {"wrap_repeat": [0.5, 0.5], "evaluate_bilinear": [2, 2], "transform_position": [1, 1]}, "says": {"wrap_repeat": "partial", "evaluate_bilinear": "partial", "transform_position": "wrong"}, "policy": [], "mistake": {"wrap_repeat": "repeat_abs", "evaluate_bilinear": "bilinear_without_shift", "transform_position": "position_normalised"}}
// Computergrafik, Übung 3: Texturen und Transformationen
// Abgabe von Gruppe 17

#include <cglib/rt/intersection.h>
#include <cglib/rt/object.h>
#include <cglib/rt/ray.h>
#include <cglib/rt/raytracing_context.h>
#include <cglib/rt/render_data.h>
#include <cglib/rt/renderer.h>
#include <cglib/rt/texture.h>
#include <cglib/rt/texture_mapping.h>
#include <cglib/rt/transform.h>

#include <cglib/core/assert.h>
#include <cglib/core/glmstream.h>
#include <cglib/core/image.h>
#include <cglib/core/thread_local_data.h>

using namespace std;

// ---------------------------------------------------------------- Aufgabe a)

glm::vec4 ImageTexture::evaluate_nearest(int level, glm::vec2 const& uv) const
{
	cg_assert(level >= 0 && level < int(mip_levels.size()));

	// Größe der Stufe
	int breite = mip_levels[level]->getWidth();
	int hoehe = mip_levels[level]->getHeight();

	int i = (int)floor(uv.x * breite);
	int j = (int)floor(uv.y * hoehe);

	return get_texel(level, i, j);
}

// ---------------------------------------------------------------- Aufgabe b)

int ImageTexture::wrap_clamp(int val, int size)
{
	cg_assert(size > 0);
	if (val < 0)
		return 0;
	if (val > size - 1)
		return size - 1;
	return val;
}

int ImageTexture::wrap_repeat(int val, int size)
{
	cg_assert(size > 0);
	return abs(val % size);  // % kann negativ werden!
}

// ---------------------------------------------------------------- Aufgabe c)

glm::vec4 ImageTexture::evaluate_bilinear(int level, glm::vec2 const& uv) const
{
	cg_assert(level >= 0 && level < int(mip_levels.size()));

	float s = uv.x * mip_levels[level]->getWidth();
	float t = uv.y * mip_levels[level]->getHeight();
	int i = (int)floor(s);
	int j = (int)floor(t);
	float ds = s - i;
	float dt = t - j;

	// die vier Nachbarn
	glm::vec4 c00 = get_texel(level, i, j);
	glm::vec4 c10 = get_texel(level, i + 1, j);
	glm::vec4 c01 = get_texel(level, i, j + 1);
	glm::vec4 c11 = get_texel(level, i + 1, j + 1);

	return (1 - dt) * ((1 - ds) * c00 + ds * c10) + dt * ((1 - ds) * c01 + ds * c11);
}

// ---------------------------------------------------------------- Aufgabe d)

void ImageTexture::create_mipmap()
{
	// Width and height are powers of two.
	cg_assert((mip_levels[0]->getWidth() & (mip_levels[0]->getWidth() - 1)) == 0);
	cg_assert((mip_levels[0]->getHeight() & (mip_levels[0]->getHeight() - 1)) == 0);

	int w = mip_levels[0]->getWidth();
	int h = mip_levels[0]->getHeight();
	int level = 0;

	while (w > 1 || h > 1) {
		int w_neu = max(w / 2, 1);
		int h_neu = max(h / 2, 1);
		mip_levels.push_back(make_shared<Image>(w_neu, h_neu));
		level++;

		for (int y = 0; y < h_neu; y++) {
			for (int x = 0; x < w_neu; x++) {
				// Wenn eine Seite schon 1 ist, wird derselbe Texel zweimal genommen.
				int x0 = w > 1 ? 2 * x : 0;
				int x1 = w > 1 ? 2 * x + 1 : 0;
				int y0 = h > 1 ? 2 * y : 0;
				int y1 = h > 1 ? 2 * y + 1 : 0;
				glm::vec4 summe = get_texel(level - 1, x0, y0) + get_texel(level - 1, x1, y0) +
				                  get_texel(level - 1, x0, y1) + get_texel(level - 1, x1, y1);
				set_texel(level, x, y, summe / 4.f);
			}
		}
		w = w_neu;
		h = h_neu;
	}
}

glm::vec2 Object::compute_uv_aabb_size(const Ray rays[4], Intersection const& isect)
{
	glm::vec3 intersection_positions[4] = {isect.position, isect.position, isect.position, isect.position};

	for (int i = 0; i < 4; ++i) {
		float t;
		if (intersect_plane(rays[i].origin, rays[i].direction, isect.position, isect.normal, &t)) {
			intersection_positions[i] = rays[i].origin + t * rays[i].direction;
		}
	}

	glm::vec2 intersection_uvs[4];
	get_intersection_uvs(intersection_positions, isect, intersection_uvs);

	float min_u = FLT_MAX, max_u = -FLT_MAX;
	float min_v = FLT_MAX, max_v = -FLT_MAX;
	for (int i = 0; i < 4; ++i) {
		min_u = min(min_u, intersection_uvs[i].x);
		max_u = max(max_u, intersection_uvs[i].x);
		min_v = min(min_v, intersection_uvs[i].y);
		max_v = max(max_v, intersection_uvs[i].y);
	}
	return glm::vec2(max_u - min_u, max_v - min_v);
}

glm::vec4 ImageTexture::evaluate_trilinear(glm::vec2 const& uv, glm::vec2 const& dudv) const
{
	// Footprint in Texeln
	float S = max(dudv.x * mip_levels[0]->getWidth(), dudv.y * mip_levels[0]->getHeight());
	int letzte = (int)mip_levels.size() - 1;

	if (S <= 1.f)  // Vergrößerung, auch log2(0)
		return evaluate_bilinear(0, uv);

	float T = log2(S);
	if (T >= letzte)
		return evaluate_bilinear(letzte, uv);

	int unten = (int)floor(T);
	float anteil = T - unten;
	return (1.f - anteil) * evaluate_bilinear(unten, uv) + anteil * evaluate_bilinear(unten + 1, uv);
}

// ---------------------------------------------------------------- Aufgabe e)

glm::vec3 transform_direction(glm::mat4 const& transform, glm::vec3 const& d)
{
	return glm::normalize(glm::vec3(transform * glm::vec4(d, 0.f)));
}

glm::vec3 transform_position(glm::mat4 const& transform, glm::vec3 const& p)
{
	return glm::normalize(glm::vec3(transform * glm::vec4(p, 1.f)));
}

bool Object::intersect(Ray const& ray, Intersection* isect) const
{
	if (RaytracingContext::get_active()->params.transform_objects) {
		// in den Objektraum und zurück
		Ray ray_object = transform_ray(ray, transform_world_to_object);
		if (!geo->intersect(ray_object, isect))
			return false;
		*isect = transform_intersection(*isect, transform_object_to_world, transform_object_to_world_normal);
		isect->t = glm::length(isect->position - ray.origin);
		return true;
	}
	return geo->intersect(ray, isect);
}

// ---------------------------------------------------------------- Aufgabe f)

glm::vec3 transform_direction_to_object_space(glm::vec3 const& d, glm::vec3 const& normal, glm::vec3 const& tangent,
                                              glm::vec3 const& bitangent)
{
	glm::mat3 M(tangent, normal, bitangent);
	return glm::normalize(M * d);
}
