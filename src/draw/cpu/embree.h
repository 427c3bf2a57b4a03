// Embree 3 or 4, whichever is installed: the two calls that differ, and who releases what.
#pragma once

#include <memory>

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
namespace lambent::draw {
inline void intersect16(const int* valid, RTCScene scene, RTCRayHit16* rays)
{
    RTCIntersectArguments arguments;
    rtcInitIntersectArguments(&arguments);
    arguments.flags = RTC_RAY_QUERY_FLAG_COHERENT;
    rtcIntersect16(valid, scene, rays, &arguments);
}
} // namespace lambent::draw
#else
#include <embree3/rtcore.h>
namespace lambent::draw {
inline void intersect16(const int* valid, RTCScene scene, RTCRayHit16* rays)
{
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    rtcIntersect16(valid, scene, &context, rays);
}
} // namespace lambent::draw
#endif

namespace lambent::draw {

struct EmbreeRelease {
    void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
    void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};
using EmbreeDevice = std::unique_ptr<RTCDeviceTy, EmbreeRelease>;
using EmbreeScene = std::unique_ptr<RTCSceneTy, EmbreeRelease>;

} // namespace lambent::draw
