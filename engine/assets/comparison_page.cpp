// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/comparison_page.h"

#include <fmt/format.h>

#include "core/base64.h"
#include "core/text.h"

namespace patina {
namespace {

constexpr const char* head = R"html(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; img-src data:;
      style-src 'unsafe-inline'; script-src 'unsafe-inline'">
<style>
:root { color-scheme: dark; }
body { margin: 0 auto; padding: 1em; max-width: max-content;
       background: #1e1e1e; color: #e6e6e6; font: 15px/1.4 sans-serif; }
h1 { font-size: 1.2em; }
#bar { display: none; flex-wrap: wrap; gap: .4em 1.4em; margin: .8em 0; align-items: center; }
.scripted #bar { display: flex; }
#stage { display: flex; flex-wrap: wrap; gap: 4px; position: relative; overflow: hidden; }
figure { margin: 0; position: relative; }
img { display: block; max-width: 100%; -webkit-user-drag: none; user-select: none; }
figcaption { position: absolute; top: 8px; left: 8px; padding: 2px 8px; border-radius: 4px;
             background: #000a; border-left: 6px solid var(--mark); }
#stage.wiped { display: block; width: max-content; max-width: 100%; cursor: ew-resize;
               touch-action: none; }
.wiped figure { display: none; }
.wiped figure.left, .wiped figure.right { display: block; }
.wiped figure.left { position: static; }
.wiped figure.right { position: absolute; inset: 0; }
.wiped figure.right figcaption { left: auto; right: 8px; }
.wiped.swapped figure.right figcaption { left: 8px; right: auto; }
.wiped.swapped figure.left figcaption { left: auto; right: 8px; }
.wiped figcaption { z-index: 2; }
#line { display: none; position: absolute; z-index: 1; width: 0; height: 0; pointer-events: none; }
.wiped #line { display: block; }
#line::before { content: ""; position: absolute; left: -1px; top: -3000px; width: 2px;
                height: 6000px; background: #f5f5f5; box-shadow: 0 0 3px #000; }
#line::after { content: ""; position: absolute; left: -9px; top: -9px; width: 14px; height: 14px;
               border: 2px solid #f5f5f5; border-radius: 50%; background: #303030; }
</style>
)html";

constexpr const char* bar = R"html(<div id="bar">
<label><input type="checkbox" id="wipe" checked> Wipe</label>
<label>Left <select id="left"></select></label>
<label>Right <select id="right"></select></label>
<label>Line <input type="range" id="share" min="0" max="1" step="0.005" value="0.5"></label>
<label>Turn <input type="range" id="angle" min="-180" max="180" step="1" value="0"></label>
</div>
)html";

constexpr const char* script = R"html(<script>
"use strict";
const part = id => document.getElementById(id);
const stage = part("stage"), line = part("line");
const figures = [...document.querySelectorAll("figure")];
for (const id of ["left", "right"])
    figures.forEach((f, i) => part(id).add(new Option(f.innerText.trim(), i)));
part("right").value = 1;

function across() {
    const turn = part("angle").value * Math.PI / 180, x = Math.cos(turn), y = Math.sin(turn);
    const width = Math.abs(x) * stage.clientWidth + Math.abs(y) * stage.clientHeight;
    return { x, y, reach: width / 2 };
}

function show() {
    const left = figures[part("left").value], right = figures[part("right").value];
    stage.classList.toggle("wiped", part("wipe").checked);
    for (const id of ["left", "right", "share", "angle"])
        part(id).disabled = !part("wipe").checked;
    for (const f of figures) {
        f.className = f === right ? "right" : f === left ? "left" : "";
        f.firstElementChild.style.clipPath = "";
    }
    if (!part("wipe").checked)
        return;
    const { x, y, reach } = across(), far = stage.clientWidth + stage.clientHeight;
    stage.classList.toggle("swapped", x < 0);
    const off = (2 * part("share").value - 1) * reach;
    const gripX = stage.clientWidth / 2 + off * x, gripY = stage.clientHeight / 2 + off * y;
    const point = (along, deep) =>
        `${gripX + along * y + deep * x}px ${gripY - along * x + deep * y}px`;
    right.firstElementChild.style.clipPath = "polygon(" + [point(far, 0), point(-far, 0),
        point(-far, 2 * far), point(far, 2 * far)].join() + ")";
    line.style.left = gripX + "px";
    line.style.top = gripY + "px";
    line.style.transform = `rotate(${part("angle").value}deg)`;
}

function moveTo(event) {
    if (!part("wipe").checked || event.buttons !== 1)
        return;
    const room = stage.getBoundingClientRect(), { x, y, reach } = across();
    const off = (event.clientX - room.left - room.width / 2) * x +
        (event.clientY - room.top - room.height / 2) * y;
    part("share").value = (off / reach + 1) / 2;
    show();
}

stage.addEventListener("pointerdown", e => { stage.setPointerCapture(e.pointerId); moveTo(e); });
stage.addEventListener("pointermove", moveTo);
addEventListener("input", show);
addEventListener("resize", show);
addEventListener("load", show);
document.body.classList.add("scripted");
</script>
)html";

} // namespace

std::string comparisonPage(const std::string& title, const std::vector<PagePicture>& pictures,
                           const std::vector<std::string>& notes) {
    std::string page = head;
    page +=
        fmt::format("<title>{0}</title>\n</head>\n<body>\n<h1>{0}</h1>\n{1}<div id=\"stage\">\n",
                    escapedForXml(title), bar);
    for (const PagePicture& picture : pictures) {
        page += fmt::format("<figure style=\"--mark: {}\"><img alt=\"{}: {}\" "
                            "src=\"data:image/png;base64,{}\"><figcaption><b>{}</b> "
                            "{}</figcaption></figure>\n",
                            escapedForXml(picture.colour), escapedForXml(picture.letter),
                            escapedForXml(picture.name), base64(picture.png),
                            escapedForXml(picture.letter), escapedForXml(picture.name));
    }
    page += "<div id=\"line\"></div>\n</div>\n";
    for (const std::string& note : notes) {
        page += fmt::format("<p>{}</p>\n", escapedForXml(note));
    }
    return page + script + "</body>\n</html>\n";
}

} // namespace patina
