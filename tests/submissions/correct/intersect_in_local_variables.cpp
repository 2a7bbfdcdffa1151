// verdict: {"loses": {}}
// A local Intersection, t by distance, and *isect is left alone after a miss.
bool Object::intersect(Ray const& ray, Intersection* isect) const
{
    if (RaytracingContext::get_active()->params.transform_objects) {
        Ray local_ray(transform_position(transform_world_to_object, ray.origin),
                      transform_direction(transform_world_to_object, ray.direction));
        Intersection local;
        if (geo->intersect(local_ray, &local)) {
            Intersection world = transform_intersection(local, transform_object_to_world, transform_object_to_world_normal);
            world.t = glm::distance(world.position, ray.origin);
            *isect = world;
            return true;
        }
        return false;
    }
    return geo->intersect(ray, isect);
}
