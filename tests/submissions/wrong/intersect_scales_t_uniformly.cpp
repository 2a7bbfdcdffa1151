// verdict: {"loses": {"intersect": [1, 1]}, "says": {"intersect": "partial"}, "policy": []}
// t times the length of one column: right where the scale is uniform.
bool Object::intersect(Ray const& ray, Intersection* isect) const
{
    if (!RaytracingContext::get_active()->params.transform_objects)
        return geo->intersect(ray, isect);
    Ray object_ray = transform_ray(ray, transform_world_to_object);
    if (!geo->intersect(object_ray, isect))
        return false;
    float t = isect->t * glm::length(glm::vec3(transform_object_to_world[0]));
    *isect = transform_intersection(*isect, transform_object_to_world, transform_object_to_world_normal);
    isect->t = t;
    return true;
}
