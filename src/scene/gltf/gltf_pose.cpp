#include "scene/gltf/gltf_pose.h"

#include "base/error.h"
#include "base/text.h"
#include "scene/index.h"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

namespace lambent::scene {
namespace {

// Numbers clamped to the range of floats, far beyond values that can be drawn.
std::vector<double> limited(std::vector<double> numbers)
{
    constexpr double most = std::numeric_limits<float>::max();
    for (double& number : numbers)
        number = std::clamp(number, -most, most);
    return numbers;
}

void apply(const Track& track, double seconds, NodePose& pose)
{
    std::vector<double> v = limited(value_at(track.curve, seconds));
    if (track.property == Animated::translation)
        pose.translation = glm::dvec3(v[0], v[1], v[2]);
    else if (track.property == Animated::rotation)
        pose.rotation = glm::dquat(v[3], v[0], v[1], v[2]);
    else if (track.property == Animated::scale)
        pose.scale = glm::dvec3(v[0], v[1], v[2]);
    else
        pose.weights = std::move(v);
}

} // namespace

Pose pose_of(const Document& document, std::span<const Animation> animations,
             const std::optional<Moment>& moment)
{
    Pose pose;
    for (const Animation& animation : animations)
        for (const Track& track : animation.tracks) {
            NodePose& node = pose[track.node];
            if (track.property != Animated::weights || node.morphs)
                continue;
            const gltf::Node& source = document.model.nodes[at(track.node)];
            node.weights =
                source.weights.empty() ? document.model.meshes[at(source.mesh)].weights : source.weights;
            node.morphs = true;
        }
    if (!moment)
        return pose;
    if (moment->animation < 0 || at(moment->animation) >= animations.size())
        throw Error(Failure::usage, text(document.file, ": there is no animation ", moment->animation));
    const Animation& animation = animations[at(moment->animation)];
    const double seconds = moment->seconds > 0.0 ? std::min(moment->seconds, animation.info.seconds) : 0.0;
    for (const Track& track : animation.tracks)
        apply(track, seconds, pose[track.node]);
    return pose;
}

} // namespace lambent::scene
