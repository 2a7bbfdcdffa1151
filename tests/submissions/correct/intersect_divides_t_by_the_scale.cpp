// verdict: {"loses": {}}
// t over the length of the direction in object space.
bool Object::intersect(Ray const& ray, Intersection* isect) const
{
    Ray r = transform_ray(ray, transform_world_to_object);
    Intersection i;
    if (geo->intersect(r, &i)) {
        if (RaytracingContext::get_active()->params.transform_objects)
            i.t /= glm::length(glm::vec3(transform_world_to_object * glm::vec4(ray.direction, 0.0)));
        *isect = transform_intersection(i, transform_object_to_world, transform_object_to_world_normal);
        return true;
    }
    return false;
}
