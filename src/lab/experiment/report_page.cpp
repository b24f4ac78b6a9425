#include "report_page.h"

#include <fmt/core.h>

#include "drape/base/output_file.h"

namespace drape {
namespace {

constexpr const char* style =
    "body{font:16px/1.5 'DejaVu Sans',sans-serif;color:#222;max-width:72rem;margin:2rem auto;padding:0 1rem}"
    "h1{font-size:1.5rem}figure{margin:2.5rem 0}img{max-width:100%;height:auto;border:1px solid #ddd}"
    "figcaption{max-width:50rem;color:#444}pre{overflow-x:auto;background:#f6f6f6;padding:1rem;font-size:.85rem}"
    "dl{display:grid;grid-template-columns:max-content auto;gap:.1rem 1.5rem;font-size:.85rem}dd{margin:0}";

/// Text as a page shows it.
std::string escaped(const std::string& text) {
    std::string shown;
    for (const char c : text) {
        if (c == '&')
            shown += "&amp;";
        else if (c == '<')
            shown += "&lt;";
        else if (c == '>')
            shown += "&gt;";
        else if (c == '"')
            shown += "&quot;";
        else
            shown += c;
    }
    return shown;
}

}  // namespace

void write_report_page(const Experiment& experiment, const TableHead& head, const std::vector<Chart>& charts,
                       const std::string& summary, const std::filesystem::path& table) {
    OutputFile file((table.parent_path() / "index.html").string());
    const std::string question = escaped(experiment.question);
    file.stream() << "<!doctype html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n"
                  << "<meta name=\"viewport\" content=\"width=device-width\">\n<title>Drape: " << experiment.name
                  << "</title>\n<style>" << style << "</style>\n<h1>" << experiment.name << ": " << question
                  << "</h1>\n";
    for (const Chart& chart : charts) {
        const std::string name = escaped(chart.name), caption = escaped(chart.caption);
        file.stream() << fmt::format(
            "<figure>\n<a href=\"{0}.svg\"><img src=\"{0}.svg\" alt=\"{1}\"></a>\n<figcaption>{1}</figcaption>\n"
            "</figure>\n",
            name, caption);
    }
    const std::string csv = escaped(table.filename().string());
    file.stream() << "<h2>What was found</h2>\n<pre>" << escaped(summary)
                  << "</pre>\n<h2>Where it is from</h2>\n<dl>\n";
    for (const auto& [key, value] : head) {
        file.stream() << "<dt>" << escaped(key) << "</dt><dd>" << escaped(value) << "</dd>\n";
    }
    file.stream() << "<dt>table</dt><dd><a href=\"" << csv << "\">" << csv << "</a></dd>\n</dl>\n</html>\n";
    file.close();
}

}  // namespace drape
