#include "kitchen/model/site.h"

#include "kitchen/model/noise.h"

#include <glm/ext/matrix_transform.hpp>
#include <glm/trigonometric.hpp>

namespace lambent::kitchen {

Site::Site(Work& work) : work_(&work)
{
    scene::Scene& scene = work.scene;
    Stuffs stuffs = make_stuffs();
    scene.materials = std::move(stuffs.materials);
    scene.images = std::move(stuffs.images);
    // One mesh for each material: few large meshes are faster to trace than many small ones.
    for (int i = 0; i < static_cast<int>(Stuff::count); ++i) {
        scene.meshes.emplace_back().material = i;
        scene.instances.push_back({i, -1, glm::mat4(1.0f)});
    }
}

Site Site::at(const glm::vec3& position, float degrees) const
{
    Site site = *this;
    site.place_ = glm::translate(site.place_, position);
    if (degrees != 0.0f)
        site.place_ = glm::rotate(site.place_, glm::radians(degrees), glm::vec3(0.0f, 1.0f, 0.0f));
    return site;
}

Site Site::tipped(float degrees) const
{
    Site site = *this;
    site.place_ = glm::rotate(site.place_, glm::radians(degrees), glm::vec3(1.0f, 0.0f, 0.0f));
    return site;
}

Site Site::scaled(float scale) const
{
    Site site = *this;
    site.place_ = glm::scale(site.place_, glm::vec3(scale));
    return site;
}

void Site::add(Stuff stuff, const scene::Mesh& mesh, const glm::vec3& tint) const
{
    append(work_->scene.meshes[static_cast<std::size_t>(stuff)], mesh, place_, glm::vec4(tint, 1.0f));
}

void Site::box(Stuff stuff, BoxShape shape, const glm::vec3& tint) const
{
    if (stuff == Stuff::wood || stuff == Stuff::marble)
        shape.uv_offset = {chance(), 3.0f * chance()};
    add(stuff, make_box(shape), tint);
}

void Site::lathe(Stuff stuff, const LatheShape& shape, const glm::vec3& tint) const
{
    add(stuff, make_lathe(shape), tint);
}

void Site::tube(Stuff stuff, const TubeShape& shape, const glm::vec3& tint) const
{
    add(stuff, make_tube(shape), tint);
}

float Site::chance() const
{
    return hashed(work_->draws++, 2021u);
}

} // namespace lambent::kitchen
