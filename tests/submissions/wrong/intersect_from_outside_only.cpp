// verdict: {"loses": {"intersect": [2, 2]}, "says": {"intersect": "wrong"}, "policy": []}
// Rejects whatever is hit from behind, and so rays that start inside a sphere.
bool Object::intersect(Ray const& ray, Intersection* isect) const
{
    if (!RaytracingContext::get_active()->params.transform_objects)
        return geo->intersect(ray, isect);
    Ray object_ray = transform_ray(ray, transform_world_to_object);
    if (!geo->intersect(object_ray, isect) || glm::dot(isect->normal, object_ray.direction) > 0.f)
        return false;
    *isect = transform_intersection(*isect, transform_object_to_world, transform_object_to_world_normal);
    isect->t = glm::length(isect->position - ray.origin);
    return true;
}
