// verdict: {"loses": {"intersect": [1.75, 1.75]}, "says": {"intersect": "partial"}, "policy": [], "mistake": {"intersect": "intersect_t_not_transformed_and_not_back"}}
// Transforms the ray, and leaves everything else in object space.
bool Object::intersect(Ray const& ray, Intersection* isect) const
{
    if (!RaytracingContext::get_active()->params.transform_objects)
        return geo->intersect(ray, isect);
    Ray r = transform_ray(ray, transform_world_to_object);
    return geo->intersect(r, isect);
}
