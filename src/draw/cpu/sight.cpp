#include "draw/cpu/sight.h"

#include "draw/reach.h"

#include <algorithm>

namespace lambent::draw {
namespace {

// A ray that has passed through this many back faces hits nothing.
constexpr int most_backs = 256;

} // namespace

Sight::Sight(const PreparedScene& scene, const RayMap& map)
    : scene_(scene), map_(map), within_reach_(within_reach(map))
{
}

void Sight::trace(const std::vector<Look*>& looks)
{
    rays_.resize(looks.size());
    hits_.resize(looks.size());
    for (std::size_t i = 0; i < looks.size(); ++i) {
        const Look& look = *looks[i];
        const glm::vec3 origin = map_.origin + look.x * map_.origin_dx + look.y * map_.origin_dy;
        const glm::vec3 direction = map_.direction + look.x * map_.direction_dx + look.y * map_.direction_dy;
        for (int axis = 0; axis < 3; ++axis) {
            rays_.origin[axis][i] = origin[axis];
            rays_.direction[axis][i] = direction[axis];
        }
        rays_.near[i] = std::max(look.near, map_.near);
    }
    rays_.far = map_.far;
    scene_.visibility().trace(rays_, hits_.data());
    for (std::size_t i = 0; i < looks.size(); ++i)
        looks[i]->hit = hits_[i];
}

void Sight::look(std::vector<Look>& looks)
{
    waiting_.clear();
    if (!within_reach_) {
        for (Look& look : looks)
            look.hit = {};
        return;
    }
    for (Look& look : looks)
        waiting_.push_back(&look);
    for (int round = 0; round < most_backs && !waiting_.empty(); ++round) {
        trace(waiting_);
        std::size_t left = 0;
        for (Look* look : waiting_)
            if (look->hit.found() && !look->hit.front && scene_.culls_back(look->hit.instance)) {
                look->near = behind(look->hit.distance);
                waiting_[left++] = look;
            }
        waiting_.resize(left);
    }
    for (Look* look : waiting_)
        look->hit = {};
}

} // namespace lambent::draw
