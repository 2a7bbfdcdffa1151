#pragma once

#include <cglib/rt/object.h>

#include <memory>
#include <vector>

/// Tells which objects a ray may meet, by boxes around them and by the sides of planes. Never leaves out an object
/// whose Object::intersect, computed in float in whatever order, would find a hit: all bounds are widened by far more
/// than that can be off.
class Culling {
public:
    /// `transformed`: objects stand where their matrices put them, else as if those were identities.
    Culling(std::vector<std::shared_ptr<Object>> const& objects, bool transformed);

    /// Calls test(index) for objects that the ray may meet at a distance of at most t_max, in no certain order. It
    /// gives the new t_max; a negative one ends the search.
    template <class Test>
    void visit(Ray const& ray, float t_max, Test const& test) const;

private:
    static constexpr int lanes = 4;
    using Floats = float __attribute__((vector_size(4 * lanes)));

    /// Four boxes side by side. What is not filled is empty and never met.
    struct Block {
        Floats lower[3];
        Floats upper[3];
        /// Of the object, or of the block one level below.
        int index[lanes];
    };
    using Level = std::vector<Block>;
    struct Box {
        Bounds bounds;
        int index;
    };
    struct Side {
        glm::vec3 center;
        glm::vec3 normal;
        int index;
    };
    /// A ray, ready for the boxes.
    struct Query {
        float widen;
        float origin[3];
        float inverse[3];
    };

    void add(Object const& object, glm::mat4 const& to_world, int index, std::vector<Box>* boxes);
    void build_levels(std::vector<Box> boxes);
    static Block empty_block();
    static void fill_lane(Block& block, int lane, Box const& box);
    template <class Test>
    bool visit_block(std::size_t level, Block const& block, Query const& query, float& t_max, Test const& test) const;
    Query make_query(Ray const& ray) const;
    static Floats entry(Block const& block, Query const& query, float t_max);
    bool may_meet(Side const& side, Ray const& ray, float t_max) const;

    /// The boxes of objects first, then boxes around blocks of the level before, up to a level of few blocks.
    std::vector<Level> levels_;
    std::vector<Side> sides_;
    std::vector<int> unbounded_;
    /// Largest distance of a box from the origin.
    float reach_ = 0.f;
    /// Largest condition of a matrix, 1 at least.
    float condition_ = 1.f;
};

template <class Test>
void Culling::visit(Ray const& ray, float t_max, Test const& test) const
{
    for (int const index : unbounded_)
        if ((t_max = test(index)) < 0.f)
            return;
    for (Side const& side : sides_)
        if (may_meet(side, ray, t_max) && (t_max = test(side.index)) < 0.f)
            return;
    if (levels_.empty())
        return;
    Query const query = make_query(ray);
    for (Block const& block : levels_.back())
        if (!visit_block(levels_.size() - 1, block, query, t_max, test))
            return;
}

/// False if the search is over.
template <class Test>
bool Culling::visit_block(std::size_t level, Block const& block, Query const& query, float& t_max,
                          Test const& test) const
{
    Floats const near = entry(block, query, t_max);
    for (int i = 0; i < lanes; ++i) {
        if (!(near[i] <= t_max))
            continue;
        if (level > 0) {
            if (!visit_block(level - 1, levels_[level - 1][std::size_t(block.index[i])], query, t_max, test))
                return false;
        } else if ((t_max = test(block.index[i])) < 0.f) {
            return false;
        }
    }
    return true;
}

/// Where the ray enters each box, or infinity if it misses the box or enters beyond t_max (Kay and Kajiya's slabs).
inline Culling::Floats Culling::entry(Block const& block, Query const& query, float t_max)
{
    Floats near = {0.f, 0.f, 0.f, 0.f};
    Floats far = near + (t_max + query.widen);
    for (int axis = 0; axis < 3; ++axis) {
        Floats const a = (block.lower[axis] - (query.origin[axis] + query.widen)) * query.inverse[axis];
        Floats const b = (block.upper[axis] - (query.origin[axis] - query.widen)) * query.inverse[axis];
        Floats const first = a < b ? a : b;
        Floats const second = a < b ? b : a;
        near = near > first ? near : first;
        far = far < second ? far : second;
    }
    Floats const never = {HUGE_VALF, HUGE_VALF, HUGE_VALF, HUGE_VALF};
    return near <= far ? near : never;
}
