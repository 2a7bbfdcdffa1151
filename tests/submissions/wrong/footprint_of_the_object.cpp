// verdict: {"loses": {"compute_uv_aabb_size": [1, 1]}, "says": {"compute_uv_aabb_size": "partial"}, "policy": [], "mistake": {"compute_uv_aabb_size": "footprint_of_the_object"}}
// Intersects the object itself instead of its tangent plane.
glm::vec2 Object::compute_uv_aabb_size(const Ray rays[4], Intersection const& isect)
{
    glm::vec3 positions[4];
    for (int i = 0; i < 4; ++i) {
        Intersection corner;
        positions[i] = geo->intersect(rays[i], &corner) ? corner.position : isect.position;
    }
    glm::vec2 uvs[4];
    get_intersection_uvs(positions, isect, uvs);
    glm::vec2 const lower = glm::min(glm::min(uvs[0], uvs[1]), glm::min(uvs[2], uvs[3]));
    glm::vec2 const upper = glm::max(glm::max(uvs[0], uvs[1]), glm::max(uvs[2], uvs[3]));
    return upper - lower;
}
