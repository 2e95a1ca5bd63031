// The style sheet that every HTML report carries in itself.
#pragma once

#include <string_view>

namespace covaria {

inline constexpr std::string_view html_style = R"(
@page { size: A4; margin: 22mm 20mm; }
:root { --ink: #1c1f23; --quiet: #5d646c; --rule: #c9ced4; --accent: #1f5a8a; }
html { font: 10pt/1.4 Inter, "Liberation Sans", "DejaVu Sans", sans-serif; color: var(--ink); background: #fff; }
body { max-width: 180mm; margin: 12mm auto; padding: 0 6mm; }
h1 { font-size: 19pt; line-height: 1.2; font-weight: 600; margin: 0 0 4mm; }
h2 { font-size: 13pt; font-weight: 600; margin: 9mm 0 2mm; padding-bottom: 1mm; border-bottom: .6pt solid var(--rule); }
h3 { font-size: 10.5pt; font-weight: 600; margin: 6mm 0 1.5mm; }
h4 { font-size: 10pt; font-weight: 600; margin: 4mm 0 1mm; }
h2, h3, h4 { break-after: avoid; }
p { margin: 0 0 2.5mm; } ul { margin: 0 0 3mm; padding-left: 5mm; } li { margin-bottom: 1mm; }
.note { color: var(--quiet); font-size: 9pt; }
dl { display: grid; grid-template-columns: 46mm 1fr; gap: .8mm 4mm; margin: 0 0 4mm; }
dt { color: var(--quiet); } dd { margin: 0; }
.equation { display: flex; justify-content: space-between; gap: 6mm; margin: 0 0 1.5mm 6mm; }
.equation .source { color: var(--quiet); font-size: 8.5pt; text-align: right; }
.wide { overflow-x: auto; margin: 0 0 5mm; }
table { border-collapse: collapse; font-size: 8.5pt; font-variant-numeric: tabular-nums; }
caption { text-align: left; font-weight: 600; padding-bottom: 1mm; break-after: avoid; }
thead { display: table-header-group; } tr { break-inside: avoid; }
th, td { padding: .7mm 3mm .7mm 0; text-align: left; vertical-align: top; }
th { font-weight: 500; vertical-align: bottom; border-top: .8pt solid var(--ink); border-bottom: .5pt solid var(--ink); }
tbody tr:last-child td { border-bottom: .8pt solid var(--ink); }
td.number, th.number { text-align: right; padding: .7mm 0 .7mm 3mm; white-space: nowrap; }
td.number + td:not(.number), th.number + th:not(.number) { padding-left: 4mm; }
td.subhead { font-weight: 600; padding-top: 1.6mm; border-bottom: .4pt solid var(--rule); }
.signature { display: flex; justify-content: space-between; margin-top: 10mm; break-inside: avoid; }
.signature .line { border-top: .6pt solid var(--ink); width: 75mm; margin-top: 16mm; padding-top: 1mm; }
.end { text-align: center; color: var(--quiet); border-top: .6pt solid var(--rule); padding-top: 2mm; }
p.item { margin-left: 5mm; text-indent: -4mm; } p.item .mark { display: inline-block; width: 4mm; text-indent: 0; color: var(--quiet); }
pre { background: #f4f6f8; padding: 2mm 3mm; overflow-x: auto; } code, pre { font: 8.5pt/1.4 "Liberation Mono", monospace; }
nav input { width: 70mm; padding: 1mm 2mm; } nav ul { list-style: none; padding: 0; } nav li { margin: 0; }
nav .level-1 { font-weight: 600; margin-top: 2mm; } nav .level-2 { margin-left: 5mm; } nav .level-3, nav .level-4 { margin-left: 10mm; }
@media print { nav input { display: none; } }
sub { font-size: 75%; line-height: 0; }
img.logo { float: right; max-width: 50mm; max-height: 18mm; margin: 0 0 3mm 5mm; }
figure { margin: 0 0 5mm; break-inside: avoid; } figure img { max-width: 100%; height: auto; }
figcaption { font-size: 8.5pt; color: var(--quiet); }
@page across { size: A4 landscape; margin: 20mm; }
@media print {
body { max-width: none; margin: 0; padding: 0; } .wide { overflow: visible; }
.print-smaller table, .print-across table { font-size: 6.3pt; } .print-across { page: across; }
.print-smallest table { font-size: 4.5pt; }
.print-smaller th, .print-smaller td, .print-across th, .print-across td { padding-left: 1mm; padding-right: 1mm; }
}
)";

/// Contents that are searched: headings whose own words or those below them have all that is typed.
inline constexpr std::string_view html_search = R"(<script>
addEventListener("DOMContentLoaded", () => {
    const nav = document.getElementById("contents"), items = [...nav.querySelectorAll("li")];
    const shown = items.map(item => !item.hidden);
    const words = items.map(item => {
        const heading = document.getElementById(item.firstChild.hash.slice(1));
        let text = heading.textContent;
        for (let at = heading.nextElementSibling; at && !/^H[1-6]$/.test(at.tagName); at = at.nextElementSibling)
            text += " " + at.textContent;
        return text.toLowerCase();
    });
    nav.querySelector("input").addEventListener("input", event => {
        const wanted = event.target.value.toLowerCase().split(/\s+/).filter(word => word);
        items.forEach((item, i) => item.hidden = wanted.length ? !wanted.every(word => words[i].includes(word)) : !shown[i]);
    });
});
</script>
)";

}  // namespace covaria
