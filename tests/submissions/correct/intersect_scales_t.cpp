// verdict: {"loses": {}}
// t by the length that the direction has in object space; *isect is overwritten after a miss, too.
bool Object::intersect(Ray const& ray, Intersection* isect) const
{
    if (!RaytracingContext::get_active()->params.transform_objects)
        return geo->intersect(ray, isect);
    Ray const local = transform_ray(ray, transform_world_to_object);
    bool const hit = geo->intersect(local, isect);
    float const scale = glm::length(glm::mat3(transform_world_to_object) * ray.direction);
    float const t = isect->t / scale;
    *isect = transform_intersection(*isect, transform_object_to_world, transform_object_to_world_normal);
    isect->t = t;
    if (!hit)
        isect->position = glm::vec3(0.f);
    return hit;
}
