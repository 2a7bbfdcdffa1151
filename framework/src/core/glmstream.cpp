#include <cglib/core/glmstream.h>

namespace {
template <class Vector>
std::ostream& write_vector(std::ostream& out, Vector const& v)
{
    out << '(' << v[0];
    for (glm::length_t i = 1; i < Vector::length(); ++i)
        out << ", " << v[i];
    return out << ')';
}

template <class Matrix>
std::ostream& write_rows(std::ostream& out, Matrix const& m)
{
    auto const rows = glm::transpose(m);
    write_vector(out, rows[0]);
    for (glm::length_t i = 1; i < Matrix::length(); ++i)
        write_vector(out << '\n', rows[i]);
    return out;
}
}  // namespace

namespace glm {
std::ostream& operator<<(std::ostream& out, vec2 const& v)
{
    return write_vector(out, v);
}

std::ostream& operator<<(std::ostream& out, vec3 const& v)
{
    return write_vector(out, v);
}

std::ostream& operator<<(std::ostream& out, vec4 const& v)
{
    return write_vector(out, v);
}

std::ostream& operator<<(std::ostream& out, mat3 const& m)
{
    return write_rows(out, m);
}

std::ostream& operator<<(std::ostream& out, mat4 const& m)
{
    return write_rows(out, m);
}
}  // namespace glm
