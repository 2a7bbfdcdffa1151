// verdict: {"loses": {"intersect": [1, 1]}, "says": {"intersect": "partial"}, "policy": []}
// Transforms position and normal by hand; the geometric normal stays in object space.
bool Object::intersect(Ray const& ray, Intersection* isect) const
{
    if (!RaytracingContext::get_active()->params.transform_objects)
        return geo->intersect(ray, isect);
    Ray r = transform_ray(ray, transform_world_to_object);
    if (!geo->intersect(r, isect))
        return false;
    isect->position = transform_position(transform_object_to_world, isect->position);
    isect->normal = transform_direction(transform_object_to_world_normal, isect->normal);
    isect->t = glm::distance(isect->position, ray.origin);
    return true;
}
