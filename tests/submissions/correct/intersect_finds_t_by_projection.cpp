// verdict: {"loses": {}}
// t from the hit in world space.
bool Object::intersect(Ray const& ray, Intersection* isect) const
{
    if (RaytracingContext::get_active()->params.transform_objects) {
        Ray r = transform_ray(ray, transform_world_to_object);
        if (geo->intersect(r, isect)) {
            glm::vec3 p = transform_position(transform_object_to_world, r.origin + isect->t * r.direction);
            glm::vec3 n = transform_direction(glm::transpose(transform_world_to_object), isect->normal);
            isect->position = p; isect->normal = n; isect->geometric_normal = n;
            isect->t = (p - ray.origin).length() > 0 ? sqrt(glm::dot(p - ray.origin, p - ray.origin)) : 0;
            return isect->isValid();
        }
        return false;
    }
    return geo->intersect(ray, isect);
}
