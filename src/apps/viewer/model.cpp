#include "apps/viewer/model.h"

#include "apps/common/picture_setup.h"
#include "scene/builtin/builtin.h"

#include <utility>

namespace lambent::viewer {
namespace {

bool same(const std::optional<scene::Moment>& a, const std::optional<scene::Moment>& b)
{
    if (!a || !b)
        return !a && !b;
    return a->animation == b->animation && a->seconds == b->seconds;
}

} // namespace

Model::Model(const cli::RenderArguments& arguments, cli::RendererChoice backend, const NoteFiles& note,
             const scene::Reach& reach)
    : backend_(std::move(backend))
{
    if (scene::is_builtin(arguments.scene)) {
        scene_ = scene::make_builtin(arguments.scene, arguments.builtin);
    } else {
        file_ = std::make_unique<scene::GltfFile>(arguments.scene, warnings_, reach);
        if (note)
            note(file_->files());
        scene_ = file_->scene(std::nullopt, warnings_);
        if (file_->animations().empty())
            file_.reset(); // only poses need its bytes
    }
    bounds_ = scene::framed_bounds(scene_);
}

void Model::pose(const cli::RenderArguments& arguments)
{
    const std::optional<scene::Moment> moment = cli::moment_asked(arguments, scene_.animations);
    if (same(moment, moment_))
        return;
    std::unique_ptr<scene::Scene> posed;
    if (moment)
        posed = std::make_unique<scene::Scene>(file_->pose(*moment));
    moment_ = moment;
    posed_.swap(posed); // renderers use the old one until they are posed below
    for (const auto& [needs, renderer] : renderers_)
        renderer->pose(posed_ ? *posed_ : scene_);
}

draw::Renderer& Model::renderer(const Needs& needs)
{
    if (const auto found = renderers_.find(needs); found != renderers_.end())
        return *found->second;
    cli::RendererChoice choice = backend_;
    if (needs.cpu)
        choice.backend = cli::Backend::cpu;
    std::unique_ptr<draw::Renderer> renderer = cli::make_renderer(choice, scene_);
    if (posed_)
        renderer->pose(*posed_);
    return *renderers_.emplace(needs, std::move(renderer)).first->second;
}

draw::Renderer& Model::renderer(const draw::Settings& settings)
{
    draw::Renderer& usual = renderer(Needs{settings.texel_transfer, false});
    const bool other = settings.bounces > 0 && usual.device().backend != "cpu";
    return other ? renderer(Needs{settings.texel_transfer, true}) : usual;
}

std::shared_ptr<const scene::Scene> Model::whole_scene() const
{
    if (!posed_)
        return {std::shared_ptr<const void>(), &scene_};
    auto whole = std::make_shared<scene::Scene>(*posed_);
    whole->images = scene_.images;
    return whole;
}

} // namespace lambent::viewer
