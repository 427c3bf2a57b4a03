#include "apps/report/report_context.h"
#include "base/text.h"

namespace lambent::report {

Section making(const ReportContext& context)
{
    const ShotRendererSettings& settings = context.renderer.settings();
    Section section{"making", "The commands", {}, {}};
    section.text.push_back(
        "Under every picture stands the command that makes it, exactly: the files beside this page "
        "are, byte for byte, what these commands write on the same machine.");
    if (context.references)
        section.text.push_back(
            text("References stop at an estimated relative error of ", percent(settings.noise), " or at ",
                 settings.samples,
                 " samples per pixel, whichever comes first; the noise that each reached stands "
                 "under its picture and in the table of errors."));
    return section;
}

} // namespace lambent::report
