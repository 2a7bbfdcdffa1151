#pragma once

/// How far a secondary ray starts from the surface it leaves, along its direction, in world units.
float const default_ray_epsilon = 7e-3f;

/// Normals with 1 - |n.y| below this count as poles, where a tangent along the circle of latitude does not exist.
float const pole_epsilon = 1e-4f;
