// verdict: {"loses": {}, "remarks": ["leaks"]}
// As one writes in Java: new without delete, for every ray.
bool Object::intersect(Ray const& ray, Intersection* isect) const
{
    if (!RaytracingContext::get_active()->params.transform_objects)
        return geo->intersect(ray, isect);

    Ray* object_ray = new Ray(transform_ray(ray, transform_world_to_object));
    Intersection* object_isect = new Intersection();
    if (!geo->intersect(*object_ray, object_isect))
        return false;
    *isect = transform_intersection(*object_isect, transform_object_to_world, transform_object_to_world_normal);
    isect->t = glm::length(isect->position - ray.origin);
    return true;
}
