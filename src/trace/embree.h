// Embree 3 or 4, whichever is installed: wrappers of the calls that differ, and owning pointers.
#pragma once

#include <memory>

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
namespace lambent::trace {
inline void intersect16(const int* valid, RTCScene scene, RTCRayHit16* rays)
{
    RTCIntersectArguments arguments;
    rtcInitIntersectArguments(&arguments);
    arguments.flags = RTC_RAY_QUERY_FLAG_COHERENT;
    rtcIntersect16(valid, scene, rays, &arguments);
}
inline void intersect1(RTCScene scene, RTCRayHit* ray)
{
    rtcIntersect1(scene, ray);
}
inline void occluded1(RTCScene scene, RTCRay* ray)
{
    rtcOccluded1(scene, ray);
}
} // namespace lambent::trace
#else
#include <embree3/rtcore.h>
namespace lambent::trace {
inline void intersect16(const int* valid, RTCScene scene, RTCRayHit16* rays)
{
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    rtcIntersect16(valid, scene, &context, rays);
}
inline void intersect1(RTCScene scene, RTCRayHit* ray)
{
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(scene, &context, ray);
}
inline void occluded1(RTCScene scene, RTCRay* ray)
{
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcOccluded1(scene, &context, ray);
}
} // namespace lambent::trace
#endif

namespace lambent::trace {

struct EmbreeRelease {
    void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
    void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};
using EmbreeDevice = std::unique_ptr<RTCDeviceTy, EmbreeRelease>;
using EmbreeScene = std::unique_ptr<RTCSceneTy, EmbreeRelease>;

} // namespace lambent::trace
