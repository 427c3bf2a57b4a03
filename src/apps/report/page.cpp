#include "apps/report/page.h"

#include "apps/report/chapters.h"
#include "apps/report/figures.h"
#include "apps/report/page_files.h"

namespace lambent::report {
namespace {

std::string head_html(const Page& page)
{
    return "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
           "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
           "<meta name=\"color-scheme\" content=\"light dark\">\n"
           "<meta name=\"description\"" +
           attribute("content", page.lead.empty() ? page.title : page.lead) + ">\n" +
           element("title", page.title) + "\n<link rel=\"icon\" href=\"data:,\">\n<style>\n" +
           std::string(page_css) + "</style>\n<script>\n" + std::string(page_js) + "</script>\n</head>\n";
}

std::string link(const std::string& id, const std::string& number, const std::string& title)
{
    return "<a" + attribute("href", "#" + id) + ">" + element("span class=\"n\"", number) +
           element("span", title) + "</a>";
}

std::string contents_html(const std::vector<Chapter>& chapters, bool has_facts)
{
    std::string html = "<ol role=\"list\">\n";
    for (const Chapter& chapter : chapters) {
        html += "<li>" + link(chapter.id, chapter.number, chapter.section->title);
        if (!chapter.figure_ids.empty()) {
            html += "\n<ol role=\"list\">";
            for (std::size_t i = 0; i < chapter.figure_ids.size(); ++i)
                html += "<li>" +
                        link(chapter.figure_ids[i].id, chapter.figure_ids[i].number,
                             chapter.section->figures[i].title) +
                        "</li>\n";
            html += "</ol>";
        }
        html += "</li>\n";
    }
    if (has_facts)
        html += "<li>" + link("facts", "", "How this page was made") + "</li>\n";
    return html + "</ol>\n";
}

// The contents are in the page twice, beside the text and collapsed in the bar: one of them is always hidden.
std::string bar_html(const Page& page, const std::string& contents)
{
    return "<header class=\"bar\"><details class=\"folded\"><summary>Contents</summary>\n"
           "<nav aria-label=\"Contents\">" +
           contents + "</nav></details>\n<a class=\"home\" href=\"#top\">" + escape(page.title) +
           "</a>\n"
           "<button type=\"button\" class=\"theme\" aria-pressed=\"false\" hidden>Dark</button></header>\n";
}

std::string chapter_html(const Chapter& chapter)
{
    std::string html = "<section" + attribute("id", chapter.id) + ">\n<h2><span class=\"section-number\">" +
                       chapter.number + "</span> " + escape(chapter.section->title) + "</h2>\n";
    for (const std::string& paragraph : chapter.section->text)
        html += prose("p", paragraph) + "\n";
    for (std::size_t i = 0; i < chapter.figure_ids.size(); ++i)
        html += figure_html(chapter.section->figures[i], chapter.figure_ids[i]);
    return html + "</section>\n";
}

std::string facts_html(const Page& page)
{
    if (page.facts.empty())
        return "";
    return "<section id=\"facts\">\n<h2>How this page was made</h2>\n" + numbers_html(page.facts) +
           "</section>\n";
}

constexpr const char* viewer_html = R"(<dialog id="viewer" aria-labelledby="viewer-title">
<div class="viewer-bar"><p id="viewer-title"></p><span class="count"></span>
<button type="button" class="pixels" aria-pressed="false">Pixels</button>
<button type="button" class="previous" aria-label="Previous picture">←</button>
<button type="button" class="next" aria-label="Next picture">→</button>
<button type="button" class="close" aria-label="Close">✕</button></div>
<div class="viewer-stage"></div>
<div class="viewer-about"></div>
</dialog>
<p id="said" class="unseen" role="status"></p>
)";

} // namespace

std::string to_html(const Page& page)
{
    Ids ids;
    const std::vector<Chapter> chapters = chapters_of(page, ids);
    const std::string contents = contents_html(chapters, !page.facts.empty());
    std::string html = head_html(page) +
                       "<body id=\"top\">\n<a class=\"skip\" href=\"#text\">Skip to the text</a>\n" +
                       bar_html(page, contents) + "<main>\n";
    if (!page.cover.file.empty())
        html += cover_html(page.cover, ids);
    html += "<div class=\"columns\">\n<nav class=\"beside\" aria-label=\"Contents beside the text\">" +
            contents + "</nav>\n<article id=\"text\" tabindex=\"-1\">\n" + element("h1", page.title) + "\n";
    if (!page.lead.empty())
        html += prose("p class=\"lead\"", page.lead) + "\n";
    for (const Chapter& chapter : chapters)
        html += chapter_html(chapter);
    return html + facts_html(page) + "</article>\n</div>\n</main>\n" + viewer_html + "</body>\n</html>\n";
}

} // namespace lambent::report
