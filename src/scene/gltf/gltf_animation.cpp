#include "scene/gltf/gltf_animation.h"

#include "scene/gltf/gltf_accessor.h"
#include "scene/gltf_document/gltf_losses.h"
#include "scene/index.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <string>
#include <utility>

namespace lambent::scene {
namespace {

// Limit of the numbers read: a constant, and a multiple of the bytes of all buffers. Samplers may share accessors, and
// a small file could share a few of them a million times. A float takes four bytes, so each may be read sixteen times.
constexpr std::uint64_t free_numbers = 2'000'000;
constexpr std::uint64_t numbers_per_byte = 4;

// Seconds, about 30 years: far beyond the times whose fractions floats resolve.
constexpr float farthest_time = 1e9f;

std::optional<Animated> property_of(const std::string& path)
{
    if (path == "translation")
        return Animated::translation;
    if (path == "rotation")
        return Animated::rotation;
    if (path == "scale")
        return Animated::scale;
    if (path == "weights")
        return Animated::weights;
    return std::nullopt;
}

// How many morph targets a node's mesh has.
std::size_t target_count(const Document& document, int node)
{
    const int mesh = document.model.nodes[at(node)].mesh;
    if (mesh < 0 || at(mesh) >= document.model.meshes.size())
        return 0;
    const auto& primitives = document.model.meshes[at(mesh)].primitives;
    return primitives.empty() ? 0 : primitives.front().targets.size();
}

template <class Vector>
std::vector<float> numbers_of(const std::vector<Vector>& vectors)
{
    std::vector<float> numbers;
    numbers.reserve(vectors.size() * static_cast<std::size_t>(Vector::length()));
    for (const Vector& vector : vectors)
        for (int i = 0; i < Vector::length(); ++i)
            numbers.push_back(vector[i]);
    return numbers;
}

class AnimationReader {
public:
    AnimationReader(const Document& document, Warnings& warnings)
        : document_(document), warnings_(warnings), losses_(document.file, warnings),
          left_(free_numbers + numbers_per_byte * document.buffer_bytes())
    {
    }

    Animation read(std::size_t index);
    void warn();

private:
    std::optional<Track> read_track(const gltf::Animation& source, const gltf::AnimationChannel& channel,
                                    const std::string& name);
    bool is_known(const gltf::AnimationChannel& channel);
    Curve read_curve(const gltf::AnimationSampler& sampler, const Track& track, const std::string& name);
    void read_times(const gltf::AnimationSampler& sampler, const std::string& name, Curve& curve);
    void read_values(const gltf::AnimationSampler& sampler, Animated property, const std::string& name,
                     Curve& curve) const;
    void check_values(const std::string& name, const Curve& curve) const;
    void spend(std::uint64_t numbers);

    const Document& document_;
    Warnings& warnings_;
    Losses losses_;
    std::uint64_t left_; // numbers that may still be read
    std::size_t unknown_ = 0, matrices_ = 0, shapeless_ = 0, repeated_ = 0;
};

void AnimationReader::spend(std::uint64_t numbers)
{
    if (numbers > left_)
        document_.fail("its animations read more than ",
                       free_numbers + numbers_per_byte * document_.buffer_bytes(), " numbers out of ",
                       document_.buffer_bytes(), " bytes");
    left_ -= numbers;
}

// Two keys at the same time are a jump: from that time on the later one counts.
void AnimationReader::read_times(const gltf::AnimationSampler& sampler, const std::string& name, Curve& curve)
{
    std::size_t jumps = 0;
    const AccessorUse use{sampler.input, name + ", input", false, {}};
    check_floats(document_, use);
    curve.times = read_scalars(document_, use);
    for (std::size_t key = 0; key < curve.times.size(); ++key) {
        if (!(std::fabs(curve.times[key]) <= farthest_time))
            document_.fail(name, ": the time of key ", key, " is not within ", farthest_time, " s");
        if (key > 0 && curve.times[key] < curve.times[key - 1])
            document_.fail(name, ": the time of key ", key, ", ", curve.times[key],
                           " s, is before that of the key before");
        jumps += key > 0 && curve.times[key] == curve.times[key - 1] ? 1 : 0;
    }
    if (jumps != 0)
        losses_.add(text(document_.file, ": ", name, ": ", jumps,
                         " keys have the time of the key before: read as jumps"));
}

// Integers are fractions in rotations and weights; translations and scales must be floats. [glTF 2.0, 3.11]
void AnimationReader::read_values(const gltf::AnimationSampler& sampler, Animated property,
                                  const std::string& name, Curve& curve) const
{
    AccessorUse use{sampler.output, name + ", output", true, {}};
    if (property == Animated::rotation) {
        curve.values = numbers_of(read_vec4(document_, use));
    } else if (property == Animated::weights) {
        curve.values = read_scalars(document_, use);
    } else {
        check_floats(document_, use);
        curve.values = numbers_of(read_vec3(document_, use));
    }
}

void AnimationReader::check_values(const std::string& name, const Curve& curve) const
{
    const std::size_t parts = curve.interpolation == Interpolation::cubic ? 3 : 1;
    const std::size_t each = parts * curve.width;
    for (std::size_t i = 0; i < curve.values.size(); ++i)
        if (!std::isfinite(curve.values[i]))
            document_.fail(name, ": a value of key ", i / each, " is not finite");
    if (!curve.rotation)
        return;
    for (std::size_t key = 0; key < curve.times.size(); ++key) {
        const float* q = &curve.values[key * each + parts / 2 * curve.width];
        if (q[0] == 0.0f && q[1] == 0.0f && q[2] == 0.0f && q[3] == 0.0f)
            document_.fail(name, ": the rotation of key ", key, " has no length");
    }
}

Curve AnimationReader::read_curve(const gltf::AnimationSampler& sampler, const Track& track,
                                  const std::string& name)
{
    if (sampler.is_broken)
        throw told_already();
    Curve curve;
    if (sampler.interpolation == "STEP")
        curve.interpolation = Interpolation::step;
    else if (sampler.interpolation == "CUBICSPLINE")
        curve.interpolation = Interpolation::cubic;
    else if (sampler.interpolation != "LINEAR")
        document_.fail(name, ": interpolation \"", printable(sampler.interpolation),
                       "\" is not defined by glTF");
    curve.rotation = track.property == Animated::rotation;
    curve.width = curve.rotation                        ? 4
                  : track.property == Animated::weights ? target_count(document_, track.node)
                                                        : 3;
    // Elements of `output` for each key: every weight is an element.
    const std::uint64_t each = (curve.interpolation == Interpolation::cubic ? 3u : 1u) *
                               (track.property == Animated::weights ? curve.width : 1u);
    const AccessorUse input{sampler.input, name + ", input", false, {}},
        output{sampler.output, name + ", output", false, {}};
    check_accessor(document_, input);
    check_accessor(document_, output);
    const std::uint64_t keys = accessor_count(document_, input), values = accessor_count(document_, output);
    if (keys == 0)
        document_.fail(name, ": no keys");
    if (values != keys * each) // both fit 32 bits
        document_.fail(name, ": ", values, " values for ", keys, " keys, not ", each, " per key");
    spend(keys + values * (track.property == Animated::weights ? 1u : curve.width) +
          sparse_count(document_, sampler.input) + sparse_count(document_, sampler.output));
    read_times(sampler, name, curve);
    read_values(sampler, track.property, name, curve);
    check_values(name, curve);
    return curve;
}

// Whether the channel moves something that can be moved. Counts the others.
bool AnimationReader::is_known(const gltf::AnimationChannel& channel)
{
    const std::optional<Animated> property = property_of(channel.target.path);
    if (channel.target.node < 0 || !property) {
        ++unknown_;
        return false;
    }
    const bool weights = *property == Animated::weights;
    const bool shapeless = weights && target_count(document_, channel.target.node) == 0;
    const bool matrix = !weights && !document_.model.nodes[at(channel.target.node)].matrix.empty();
    shapeless_ += shapeless ? 1 : 0;
    matrices_ += matrix ? 1 : 0;
    return !shapeless && !matrix;
}

std::optional<Track> AnimationReader::read_track(const gltf::Animation& source,
                                                 const gltf::AnimationChannel& channel,
                                                 const std::string& name)
{
    if (channel.target.node >= 0 && at(channel.target.node) >= document_.model.nodes.size())
        document_.fail(name, ": node ", channel.target.node, " does not exist");
    if (at(channel.sampler) >= source.samplers.size())
        document_.fail(name, ": sampler ", channel.sampler, " does not exist");
    if (!is_known(channel))
        return std::nullopt;
    Track track;
    track.node = channel.target.node;
    track.property = *property_of(channel.target.path);
    return track;
}

Animation AnimationReader::read(std::size_t index)
{
    const gltf::Animation& source = document_.model.animations[index];
    const std::string name = text("animation ", index);
    Animation animation;
    animation.info.name = source.name.empty() ? text("animation", index) : source.name;
    std::set<std::pair<int, Animated>> targets;
    for (std::size_t i = 0; i < source.channels.size(); ++i) {
        const gltf::AnimationChannel& channel = source.channels[i];
        if (channel.is_broken)
            continue;
        std::optional<Track> track;
        const bool whole = losses_.spare("the channel is left out", [&] {
            track = read_track(source, channel, text(name, ", channel ", i));
            if (track && !targets.contains({track->node, track->property}))
                track->curve = read_curve(source.samplers[at(channel.sampler)], *track,
                                          text(name, ", sampler ", channel.sampler));
        });
        if (!whole || !track)
            continue;
        if (!targets.emplace(track->node, track->property).second) {
            ++repeated_;
            continue;
        }
        animation.info.seconds =
            std::max(animation.info.seconds, static_cast<double>(track->curve.times.back()));
        animation.tracks.push_back(std::move(*track));
    }
    return animation;
}

void AnimationReader::warn()
{
    const auto warn_if = [&](std::size_t count, const char* what) {
        if (count != 0)
            warnings_.push_back(
                text(document_.file, ": ", count, " animation channels ", what, ": left out"));
    };
    warn_if(unknown_, "of unknown properties");
    warn_if(matrices_, "of nodes with a matrix");
    warn_if(shapeless_, "of weights without morph targets");
    warn_if(repeated_, "of properties that another channel animates");
}

} // namespace

std::vector<Animation> read_animations(const Document& document, Warnings& warnings)
{
    AnimationReader reader(document, warnings);
    std::vector<Animation> animations;
    for (std::size_t i = 0; i < document.model.animations.size(); ++i)
        animations.push_back(reader.read(i));
    reader.warn();
    return animations;
}

} // namespace lambent::scene
