// verdict: {"loses": {}}
// A direction that is not normalised keeps t as it is.
bool Object::intersect(Ray const& ray, Intersection* isect) const
{
    if (!RaytracingContext::get_active()->params.transform_objects) return geo->intersect(ray, isect);
    Ray r;
    r.origin = glm::vec3(transform_world_to_object * glm::vec4(ray.origin, 1));
    r.direction = glm::vec3(transform_world_to_object * glm::vec4(ray.direction, 0));
    if (!geo->intersect(r, isect)) return false;
    float t = isect->t;
    *isect = transform_intersection(*isect, transform_object_to_world, transform_object_to_world_normal);
    isect->t = t;
    return true;
}
