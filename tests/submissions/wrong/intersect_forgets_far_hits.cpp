// verdict: {"loses": {"intersect": [1, 1]}, "says": {"intersect": "partial"}, "policy": []}
// What is farther than a thousand is no hit.
bool Object::intersect(Ray const& ray, Intersection* isect) const
{
    if (!RaytracingContext::get_active()->params.transform_objects)
        return geo->intersect(ray, isect);

    Ray const object_ray = transform_ray(ray, transform_world_to_object);
    if (!geo->intersect(object_ray, isect))
        return false;
    *isect = transform_intersection(*isect, transform_object_to_world, transform_object_to_world_normal);
    // Rays are unit in both spaces, so the distance is measured again in the world's.
    isect->t = glm::length(isect->position - ray.origin);
    return isect->t < 1e3f;
}
