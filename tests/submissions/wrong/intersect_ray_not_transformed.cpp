// verdict: {"loses": {"intersect": [2, 2]}, "says": {"intersect": "wrong"}, "policy": [], "mistake": {"intersect": "intersect_ray_not_transformed"}}
// The ray stays in world space, the hit is transformed.
bool Object::intersect(Ray const& ray, Intersection* isect) const
{
    if (!RaytracingContext::get_active()->params.transform_objects)
        return geo->intersect(ray, isect);
    if (!geo->intersect(ray, isect))
        return false;
    *isect = transform_intersection(*isect, transform_object_to_world, transform_object_to_world_normal);
    isect->t = glm::length(isect->position - ray.origin);
    return true;
}
