// verdict: {"loses": {}}
// transform_ray and transform_intersection do nothing with transform_objects off, so one way serves both.
bool Object::intersect(Ray const& ray, Intersection* isect) const
{
    if (!geo->intersect(transform_ray(ray, transform_world_to_object), isect))
        return false;
    *isect = transform_intersection(*isect, transform_object_to_world, transform_object_to_world_normal);
    isect->t = glm::dot(isect->position - ray.origin, ray.direction);
    return true;
}
