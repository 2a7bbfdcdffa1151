// verdict: {"loses": {"intersect": [0.25, 0.25]}, "says": {"intersect": "partial"}, "policy": []}
// Transforms by hand, and so with transform_objects off, too.
bool Object::intersect(Ray const& ray, Intersection* isect) const
{
    Ray r(transform_position(transform_world_to_object, ray.origin),
          transform_direction(transform_world_to_object, ray.direction));
    if (!geo->intersect(r, isect))
        return false;
    isect->position = transform_position(transform_object_to_world, isect->position);
    isect->normal = transform_direction(transform_object_to_world_normal, isect->normal);
    isect->geometric_normal = transform_direction(transform_object_to_world_normal, isect->geometric_normal);
    isect->t = glm::distance(isect->position, ray.origin);
    return true;
}
