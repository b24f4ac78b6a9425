#include "report_page.h"

#include <fmt/core.h>

#include <map>

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
    static const std::map<char, std::string> marks{{'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}, {'"', "&quot;"}};
    std::string shown;
    for (const char c : text) shown += marks.contains(c) ? marks.at(c) : std::string(1, c);
    return shown;
}

}  // namespace

void write_report_page(const Experiment& experiment, const TableHead& head, const std::vector<Chart>& charts,
                       const std::string& summary, const std::filesystem::path& table) {
    std::string figures, lines;
    for (const Chart& chart : charts) {
        figures += fmt::format(
            "<figure>\n<a href=\"{0}.svg\"><img src=\"{0}.svg\" alt=\"{1}\"></a>\n<figcaption>{1}</figcaption>\n"
            "</figure>\n",
            escaped(chart.name), escaped(chart.caption));
    }
    for (const auto& [key, value] : head) {
        lines += fmt::format("<dt>{}</dt><dd>{}</dd>\n", escaped(key), escaped(value));
    }
    OutputFile file((table.parent_path() / "index.html").string());
    file.stream() << fmt::format(
        R"(<!doctype html>
<html lang="en">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width">
<title>Drape: {0}</title>
<style>{1}</style>
<h1>{0}: {2}</h1>
{3}<h2>What was found</h2>
<pre>{4}</pre>
<h2>Where it is from</h2>
<dl>
{5}<dt>table</dt><dd><a href="{6}">{6}</a></dd>
</dl>
</html>
)",
        experiment.name, style, escaped(experiment.question), figures, escaped(summary), lines,
        escaped(table.filename().string()));
    file.close();
}

}  // namespace drape
