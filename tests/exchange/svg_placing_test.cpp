// Where SVG draws its elements, and which: the places are those that Chromium gives them.
#include <gtest/gtest.h>

#include <cmath>

#include "core/curve/control_box.h"
#include "tests/exchange/svg_elements.h"

namespace batten::exchange {

namespace {

using core::Point;

// The end of a line from (0, 0) to (3, 5) with these attributes, y upward.
Point end_with(const std::string& attributes) {
    return points_of(curve_of(read_elements("<path d='M0 0L3 5' " + attributes + "/>"))).back();
}

std::vector<std::string> told_with(const std::string& attributes) {
    return read_elements("<path id='p' d='M0 0L3 5' " + attributes + "/>").report.left_out;
}

// What a file with a viewBox of 100 by 100 draws, seen from its upper left corner with y downward.
std::vector<Point> drawn_below(const std::string& elements, const std::string& attributes = "") {
    const auto imported = read_svg("<svg viewBox='0 0 100 100' " + attributes + ">" + elements + "</svg>");
    EXPECT_TRUE(imported);
    if (!imported) return {};
    std::vector<Point> points = points_of(curve_of(*imported));
    for (Point& point : points) point.y = 100 - point.y;
    return points;
}

}  // namespace

TEST(SvgUse, GivesSymbolsTheSizeThatItSays) {
    const std::string symbol = "<symbol id='s' viewBox='0 0 10 10' %><path d='M0 0L10 10'/></symbol>";
    const auto used = [&](const std::string& of_symbol, const std::string& of_use) {
        std::string text = symbol;
        return drawn_below(text.replace(text.find('%'), 1, of_symbol) + "<use href='#s' " + of_use + "/>");
    };
    using Line = std::vector<Point>;
    EXPECT_EQ(used("", "width='20' height='40'"), (Line{{0, 10}, {20, 30}}));
    EXPECT_EQ(used("", "width='20' height='40' x='5' y='-1'"), (Line{{5, 9}, {25, 29}}));
    EXPECT_EQ(used("", "width='20%' height='40%'"), (Line{{0, 10}, {20, 30}}));
    EXPECT_EQ(used("preserveAspectRatio='none'", "width='20' height='40'"), (Line{{0, 0}, {20, 40}}));
    EXPECT_EQ(used("preserveAspectRatio='xMaxYMax slice'", "width='20' height='40'"), (Line{{-20, 0}, {20, 40}}));
    EXPECT_EQ(used("preserveAspectRatio='xMinYMin'", "width='20' height='40'"), (Line{{0, 0}, {20, 20}}));
    EXPECT_EQ(used("width='60' height='30'", ""), (Line{{15, 0}, {45, 30}}));
    EXPECT_EQ(used("width='60' height='30'", "width='30'"), (Line{{0, 0}, {30, 30}})) << "each by itself";
    EXPECT_EQ(used("", ""), (Line{{0, 0}, {100, 100}}));
    EXPECT_EQ(used("", "width='20' height='20' transform='scale(2)'"), (Line{{0, 0}, {40, 40}}));
}

TEST(SvgUse, GivesInnerDrawingsTheSizeThatItSays) {
    const std::string inner =
        "<defs><svg id='s' x='1' viewBox='0 0 10 10' width='70' height='70'><path d='M0 0L10 10'/></svg></defs>";
    EXPECT_EQ(drawn_below(inner + "<use href='#s' width='20' height='20'/>"), (std::vector<Point>{{1, 0}, {21, 20}}));
    EXPECT_EQ(drawn_below(inner + "<use href='#s'/>"), (std::vector<Point>{{1, 0}, {71, 70}}));
}

TEST(SvgUse, OfNoSizeDrawsNothing) {
    const Imported imported = read_elements(
        "<symbol id='s' viewBox='0 0 10 10'><path d='M0 0L10 10'/></symbol><use href='#s' width='0' height='9'/>"
        "<svg height='0'><path d='M0 0h3'/></svg><path id='other' d='M0 0h1'/>");
    ASSERT_EQ(imported.document.curves.size(), 1U);
    EXPECT_EQ(imported.document.curves[0].name, "other");
}

TEST(SvgUse, TakesTheColorsOfTheSymbol) {
    const Imported imported = read_elements(
        "<symbol id='s' stroke='#102030'><path d='M0 0L10 10'/></symbol><symbol id='h' style='display:none'>"
        "<path d='M0 0L10 10'/></symbol><use href='#s'/><use href='#h'/>");
    ASSERT_EQ(imported.document.curves.size(), 1U);
    EXPECT_EQ(imported.document.curves[0].color, (core::DocumentColor{0x10, 0x20, 0x30}));
    EXPECT_EQ(imported.report.left_out, std::vector<std::string>{"an element that is not displayed is left out"});
}

TEST(SvgStyles, MoveElements) {
    EXPECT_EQ(end_with("style='stroke:red;transform: translate(30px,40px)'"), Point(33, -45));
    expect_near(end_with("style='transform:translate(1cm)'"), {3 + 96 / 2.54, -5});
    EXPECT_EQ(end_with("style='transform:translateX(2px) translateY(-3px)'"), Point(5, -2));
    EXPECT_EQ(end_with("style='transform:scale(2, 300%)'"), Point(6, -15));
    EXPECT_EQ(end_with("style='transform:scaleX(2)scaleY(-1)'"), Point(6, 5));
    EXPECT_EQ(end_with("style='transform:matrix(1,2,3,4,5,6)'"), Point(23, -32));
    for (const std::string angle : {"90deg", "100grad", "0.25turn", "1.5707963267948966rad"})
        expect_near(end_with("style='transform:rotate(" + angle + ")'"), {-5, -3});
    expect_near(end_with("style='transform:skewX(45deg)'"), {8, -5});
    expect_near(end_with("style='transform:skewY(45deg)'"), {3, -8});
    // Both at once, which is not one after the other.
    expect_near(end_with("style='transform:skew(45deg, 45deg)'"), {8, -8});
    EXPECT_EQ(end_with("style='transform:rotate(0)'"), Point(3, -5));
    EXPECT_EQ(end_with("style='transform:none' transform='scale(9)'"), Point(3, -5)) << "before the attribute";
    EXPECT_EQ(drawn_below("<path d='M0 0L3 5' style='transform:translate(50%, 10%)'/>").back(), Point(53, 15));
}

TEST(SvgStyles, TurnElementsAboutTheirOrigin) {
    expect_near(end_with("transform='rotate(90)' transform-origin='3 0'"), {-2, 0});
    expect_near(end_with("style='transform:rotate(90deg);transform-origin:0px 5px'"), {0, -8});
    EXPECT_EQ(drawn_below("<path d='M0 0L3 5' style='transform:scale(2);transform-origin:center'/>").back(),
              Point(-44, -40));
    EXPECT_EQ(drawn_below("<path d='M0 0L3 5' style='transform:scale(2);transform-origin:right 10%'/>").back(),
              Point(-94, 0));
    EXPECT_EQ(end_with("transform-origin='3 0'"), Point(3, -5)) << "of no turn";
}

TEST(SvgStyles, TellWhatIsNotRead) {
    const std::vector<std::string> told{"the transform of 'p' cannot be read, so it stands where it would without"};
    for (const std::string style :
         {"transform:translate(30,40)", "transform:translate(1em)", "transform:translate3d(1px,2px,3px)",
          "transform:turn(3deg)", "transform:rotate(3)", "transform:rotate(3deg,1px,2px)", "transform:scale(2px)",
          "transform:scale(1 2)", "transform:translate(1px", "transform:translate()", "transform:matrix(1,2,3)",
          "rotate:30deg", "translate:3px", "transform:scale(2);transform-origin:bottom left",
          "transform:scale(2);transform-box:fill-box"}) {
        EXPECT_EQ(told_with("style='" + style + "'"), told) << style;
        EXPECT_EQ(end_with("style='" + style + "'"), Point(3, -5)) << style;
    }
    EXPECT_TRUE(told_with("style='rotate:none;transform:none'").empty());
}

TEST(SvgStyles, TakeTheLastValueButTheImportantOne) {
    const auto color = [](const std::string& style) {
        return *read_elements("<path d='M0 0h1' stroke='#999' style='" + style + "'/>").document.curves[0].color;
    };
    EXPECT_EQ(color("stroke:#010203; stroke : #040506"), (core::DocumentColor{4, 5, 6}));
    EXPECT_EQ(color("stroke:#010203 !important; stroke:#040506"), (core::DocumentColor{1, 2, 3}));
    EXPECT_EQ(color("stroke:#010203 !important; stroke:#040506!important"), (core::DocumentColor{4, 5, 6}));
}

TEST(SvgSheets, HideColorAndMoveWhatTheirRulesAreFor) {
    const Imported imported = read_elements(R"(<defs><style type="text/css"><![CDATA[
        /* as Illustrator has it */ .st0{display:none;}
        .st1, .st2 {stroke:#010203}  .st2{ transform: translate(10px, 0px) }
        #here{visibility:hidden} line { stroke: #040506 }
      ]]></style></defs>
      <path class="st0" d="M0 0h1"/><path class="other st2" d="M0 0h1"/><path id="here" class="st1" d="M0 0h1"/>
      <line x1="1"/><path d="M0 0h1"/>)");
    EXPECT_EQ(imported.report.left_out, std::vector<std::string>{"an element that is not displayed is left out"});
    const auto& curves = imported.document.curves;
    ASSERT_EQ(curves.size(), 4U);
    EXPECT_EQ(curves[0].color, (core::DocumentColor{1, 2, 3}));
    EXPECT_EQ(points_of(*curves[0].curve).front(), Point(10, 0));
    EXPECT_FALSE(curves[1].visible);
    EXPECT_EQ(curves[1].color, (core::DocumentColor{1, 2, 3}));
    EXPECT_EQ(curves[2].color, (core::DocumentColor{4, 5, 6}));
    EXPECT_FALSE(curves[3].color);
}

// The color of a path of class 'a b' and id 'i' in a group of class 'g', by the cascade of CSS.
TEST(SvgSheets, GiveWayToWhatIsMoreSpecificOrLater) {
    const auto color = [](const std::string& sheet, const std::string& attributes = "") {
        const Imported imported = read_elements("<style>" + sheet + "</style><g class='g'><path id='i' class='a b' " +
                                                attributes + " d='M0 0h1'/></g>");
        EXPECT_TRUE(imported.report.left_out.empty());
        return core::color_text(imported.document.curves.at(0).color.value_or(core::DocumentColor{}));
    };
    const std::string plain = "stroke='#999999'";
    EXPECT_EQ(color("path{stroke:#111111}", plain), "#111111") << "before the attribute";
    EXPECT_EQ(color("*{stroke:#111111}", plain), "#111111");
    EXPECT_EQ(color(".g{stroke:#111111}", plain), "#999999") << "what is inherited comes last";
    EXPECT_EQ(color(".g{stroke:#111111}"), "#111111");
    EXPECT_EQ(color(".a{stroke:#111111}path{stroke:#222222}*{stroke:#333333}"), "#111111");
    EXPECT_EQ(color("#i{stroke:#111111}.a{stroke:#222222}path.a{stroke:#333333}"), "#111111");
    EXPECT_EQ(color("path.a{stroke:#111111}.b{stroke:#222222}"), "#111111");
    EXPECT_EQ(color(".b{stroke:#111111}.a{stroke:#222222}"), "#222222") << "the later rule, not the later word";
    EXPECT_EQ(color(".a{stroke:#111111}.a{stroke:#222222}"), "#222222");
    EXPECT_EQ(color(".a{stroke:#111111!important}.a{stroke:#222222}#i{stroke:#333333}"), "#111111");
    EXPECT_EQ(color("#i{stroke:#111111}", "style='stroke:#222222'"), "#222222");
    EXPECT_EQ(color("#i{stroke:#111111 ! important}", "style='stroke:#222222'"), "#111111");
    EXPECT_EQ(color("*{stroke:#111111!important}", "style='stroke:#222222!important'"), "#222222");
    EXPECT_EQ(color(".c,\n.a ,line{stroke:#111111}"), "#111111");
    EXPECT_EQ(color("line.a{stroke:#111111}.A{stroke:#222222}#a{stroke:#333333}", plain), "#999999");
    EXPECT_EQ(color("@font-face{font-family:x}.a{stroke:#111111}"), "#111111");
    EXPECT_EQ(color("a > path:hover{cursor:pointer} .a{content:'}';stroke:#111111"), "#111111");
    EXPECT_EQ(color("</style><style media='print'>.a{stroke:#222222}</style><style>.a{stroke:#111111}"), "#111111");
}

TEST(SvgSheets, AreToldWhereTheyAreNotRead) {
    const auto told = [](const std::string& sheet) {
        return read_elements("<style>" + sheet + "</style><path class='a' d='M0 0h1'/>").report.left_out;
    };
    const auto rule = [](const std::string& name) {
        return std::vector<std::string>{
            "a style rule is not read: '" + name +
            "'; colors and lines may be others, and what it hides or moves is read as if it did not"};
    };
    EXPECT_EQ(told("g > .a{display:none}"), rule("g > .a"));
    EXPECT_EQ(told(".b, .a:hover{fill:red}"), rule(".a:hover"));
    EXPECT_EQ(told("[d]{fill:red}"), rule("[d]"));
    EXPECT_EQ(told("@media print{.a{display:none}} .b{fill:red}"), rule("@media print"));
    EXPECT_EQ(told("@import 'a.css';"), rule("@import 'a.css'"));
    EXPECT_EQ(told("g .a{fill:red}.a.b{fill:red}"),
              std::vector<std::string>{
                  "2 style rules are not read, the first one 'g .a'; colors and lines may be others, and "
                  "what they hide or move is read as if they did not"});
    EXPECT_TRUE(told("g > .a{font-size:3px}").empty()) << "which changes nothing here";
    EXPECT_EQ(read_svg("<?xml-stylesheet href='a.css'?><svg><path d='M0 0h1'/></svg>")->report.left_out,
              std::vector<std::string>{
                  "a style sheet is not read, so colors and lines may be others, and what it hides or moves "
                  "is read as if it did not"});
}

TEST(SvgSheets, OfManyRulesAreReadInTime) {
    std::string sheet;
    for (int i = 0; i < 20'000; ++i) sheet += ".c" + std::to_string(i) + ",";
    std::string properties;
    for (int i = 0; i < 20'000; ++i) properties += "fill:#123456;";
    const Imported imported =
        read_elements("<style>" + sheet + "x{" + properties + "}</style><path class='c777' d='M0 0h1'/>");
    EXPECT_EQ(imported.document.curves[0].color, (core::DocumentColor{0x12, 0x34, 0x56}));
}

TEST(SvgStyles, OfSizesAreTold) {
    const auto told = [](const std::string& elements) { return read_elements(elements).report.left_out; };
    const std::vector<std::string> size{"the style of 'r' sets a size or a place, which are read as attributes alone"};
    EXPECT_EQ(told("<rect id='r' width='2' height='2' style='width:10px'/>"), size);
    EXPECT_EQ(told("<style>rect{x:3px}</style><rect id='r' width='2' height='2'/>"), size);
    EXPECT_EQ(told("<style>#r{d:path('M0 0')}</style><path id='r' d='M0 0h1'/>"), size);
    EXPECT_TRUE(told("<rect id='r' width='2' height='2' style='width:auto;height:2'/>").empty());
    EXPECT_TRUE(told("<style>g{width:3px}</style><g><path d='M0 0h1'/></g>").empty());
    const auto of_file = [](const std::string& style) {
        return read_svg("<svg id='r' style='" + style + "'><path d='M0 0h1'/></svg>")->report.left_out;
    };
    EXPECT_EQ(of_file("width:3cm"), size);
    EXPECT_TRUE(of_file("width:100%;height:auto").empty()) << "of the window";
}

// Lengths of CSS: 1em is the size of the font, which is 16px where nothing is said; 1rem that of the svg element.
TEST(SvgLengths, MayBeInSizesOfTheFont) {
    const auto right_end = [](const std::string& elements, const std::string& of_file = "") {
        const auto imported = read_svg("<svg viewBox='0 0 100 100' " + of_file + ">" + elements + "</svg>");
        EXPECT_TRUE(imported);
        EXPECT_TRUE(imported->report.left_out.empty());
        return core::control_box(curve_of(*imported)).upper.x;
    };
    const std::string rect = "<rect width='2em' height='1px'/>";
    EXPECT_EQ(right_end(rect), 32);
    EXPECT_EQ(right_end(rect, "font-size='10'"), 20);
    EXPECT_EQ(right_end("<g font-size='10px'><g style='font-size:50%'>" + rect + "</g></g>"), 10);
    EXPECT_EQ(right_end("<g font-size='10px'><g style='font-size:3em'>" + rect + "</g></g>"), 60);
    EXPECT_EQ(right_end("<style>g{font-size:1in}</style><g font-size='1'>" + rect + "</g>"), 192);
    EXPECT_EQ(right_end("<g font-size='10px'><g font-size='medium'>" + rect + "</g></g>"), 32);
    EXPECT_EQ(right_end("<rect width='2em' height='1px' font-size='3'/>"), 6) << "of its own font";
    EXPECT_EQ(right_end("<g font-size='3'><circle r='2rem'/></g>", "font-size='10'"), 20);
    EXPECT_EQ(right_end("<defs><path id='a' d='M0 0h1'/></defs><use href='#a' x='1em'/>"), 17);
    EXPECT_EQ(right_end("<g style='font-size:20'>" + rect + "</g>"), 32) << "CSS drops what has no unit";
    EXPECT_EQ(right_end("<style>g{font-size:20}</style><g font-size='10'>" + rect + "</g>"), 20);
    EXPECT_EQ(right_end("<g style='font-size:10px;font-size:20'>" + rect + "</g>"), 20);
    EXPECT_EQ(right_end("<g font='Arial'>" + rect + "</g>"), 32) << "which is no attribute";
    EXPECT_EQ(right_end("<style>@font-face{font-size:3px}</style>" + rect), 32);
    EXPECT_EQ(right_end("<svg x='1em' font-size='5'><path d='M0 0h1'/></svg>"), 6);
    EXPECT_EQ(right_end("<symbol id='s' viewBox='0 0 2 2'><path d='M0 0h1'/></symbol>"
                        "<use href='#s' width='1em' height='1em'/>"),
              8);
}

TEST(SvgLengths, OfThePageMayBeInSizesOfTheFont) {
    const auto page =
        read_svg("<svg width='10em' height='5rem' style='font-size:10px'><rect width='50%' height='20%'/></svg>");
    ASSERT_TRUE(page);
    EXPECT_TRUE(page->report.left_out.empty());
    EXPECT_EQ(core::control_box(curve_of(*page)).lower, Point(0, 40));
    EXPECT_EQ(core::control_box(curve_of(*page)).upper, Point(50, 50));
    EXPECT_EQ(page->document.units, (core::DocumentUnits{.unit = core::LengthUnit::px}));
    const auto scaled = read_svg("<svg width='10em' height='10em' viewBox='0 0 80 80'><path d='M0 0h1'/></svg>");
    EXPECT_EQ(scaled->document.units, (core::DocumentUnits{.unit = core::LengthUnit::px, .scale = 0.5}));
    EXPECT_EQ(read_svg("<svg width='10em' font-size='larger'><path d='M0 0h1'/><rect width='50%' height='1'/></svg>")
                  ->report.left_out.size(),
              1U)
        << "of a font of unknown size";
}

TEST(SvgLengths, ThatTheFileDoesNotSayAreTold) {
    const auto told = [](const std::string& elements, const std::string& of_file = "viewBox='0 0 9 9'") {
        const auto imported = read_svg("<svg " + of_file + "><path d='M0 0h1'/>" + elements + "</svg>");
        EXPECT_EQ(imported->document.curves.size(), 1U) << elements;
        return imported->report.left_out;
    };
    const std::vector<std::string> one{
        "'r' is left out, since the file does not say how long its lengths are: % of what has no size, units of a "
        "window or of a font"};
    for (const std::string length : {"2ex", "2vw", "2ch", "calc(1px + 2px)", "2parsecs"}) {
        EXPECT_EQ(told("<rect id='r' width='1' height='" + length + "'/>"), one) << length;
        EXPECT_EQ(told("<circle id='r' cx='" + length + "' r='1'/>"), one) << length;
        EXPECT_EQ(told("<svg id='r' x='" + length + "'><path d='M0 0h1'/></svg>"), one) << length;
        EXPECT_EQ(told("<defs><path id='a' d='M0 0h1'/></defs><use id='r' href='#a' y='" + length + "'/>"), one);
    }
    const std::string em = "<rect id='r' width='1em' height='1'/>";
    const auto is_left_out = [&](const std::string& elements) {
        const std::vector<std::string> sentences = told(elements);
        return sentences.size() == 2 && sentences.front() == one.front();  // and the rule
    };
    EXPECT_TRUE(is_left_out("<style>@media screen { g { font-size: 30px } }</style>" + em));
    EXPECT_TRUE(is_left_out("<style>@media screen{@supports(x:y){g{fill:red}g{font:9px x}}}</style>" + em));
    EXPECT_TRUE(is_left_out("<style media='(width > 9px)'>g{font-size:30px}</style>" + em));
    EXPECT_TRUE(is_left_out("<style>@import 'a.css';</style>" + em));
    EXPECT_TRUE(is_left_out("<style media='(width > 9px)'>@import 'a.css';</style>" + em));
    const auto beside_sheet =
        read_svg("<?xml-stylesheet href='a.css'?><svg viewBox='0 0 9 9'><path d='M0 0h1'/>" + em + "</svg>");
    EXPECT_EQ(beside_sheet->document.curves.size(), 1U);
    EXPECT_EQ(beside_sheet->report.left_out.front(), one.front());
    EXPECT_EQ(told(em, "font-size='larger'"), one);
    EXPECT_EQ(told(em, "style='font:12px serif'"), one);
    EXPECT_EQ(told("<style>g > rect{font-size:3px}</style>" + em), one);
    EXPECT_EQ(told("<line id='a' y2='1vh'/><ellipse id='b' rx='1vw' ry='1'/>"),
              std::vector<std::string>{"2 elements are left out, first 'a', since the file does not say how long their "
                                       "lengths are: % of what has no size, units of a window or of a font"});
}

TEST(SvgLengths, InPartsOfAPageWithoutASizeAreTold) {
    const auto told = [](const std::string& element, const std::string& of_file) {
        return read_svg("<svg " + of_file + "><path d='M0 0h1'/>" + element + "</svg>")->report.left_out.size();
    };
    const std::string rect = "<rect width='50%' height='1'/>";
    const std::string circle = "<circle r='50%'/>";
    const std::string inner = "<svg viewBox='0 0 2 2'><path d='M0 0h1'/></svg>";
    const std::string moved = "<path d='M0 0h1' style='transform:translate(50%)'/>";
    const std::string turned = "<path d='M0 0h1' transform='scale(2)' transform-origin='center'/>";
    for (const std::string& element : {rect, circle, inner, moved, turned}) {
        EXPECT_EQ(told(element, ""), 1U) << element;
        EXPECT_EQ(told(element, "width='100%' height='100%'"), 1U) << element;
        EXPECT_EQ(told(element, "width='80' height='60'"), 0U) << element;
        EXPECT_EQ(told(element, "viewBox='0 0 8 6'"), 0U) << element;
    }
    EXPECT_EQ(told(rect, "width='80'"), 0U) << "the height does not count";
    EXPECT_EQ(told("<rect x='0%' width='5' height='1'/>", ""), 0U) << "no part is nothing";
    EXPECT_EQ(told("<svg><path d='M0 0h1'/></svg>", ""), 0U) << "nothing is scaled";
}

TEST(SvgFrames, ThatCutShapesOffAreTold) {
    const auto told = [](const std::string& elements) {
        return read_svg("<svg viewBox='0 0 100 100'>" + elements + "</svg>")->report.left_out;
    };
    const auto inner = [&](const std::string& attributes, const std::string& shape) {
        return told("<svg x='10' y='20' width='30' height='40' " + attributes + ">" + shape + "</svg>");
    };
    const std::vector<std::string> cut{
        "'p' is read whole, though the inner drawing or the symbol that it is in cuts it off"};
    const std::vector<std::string> none{};
    EXPECT_EQ(inner("", "<path id='p' d='M0 0L30 40'/>"), none);
    EXPECT_EQ(inner("", "<path id='p' d='M0 0L30.001 40'/>"), cut);
    EXPECT_EQ(inner("", "<path id='p' d='M0 0L30 40M0 -.001h1'/>"), cut);
    EXPECT_EQ(inner("overflow='visible'", "<path id='p' d='M0 0L31 40'/>"), none);
    EXPECT_EQ(inner("style='overflow:visible'", "<path id='p' d='M0 0L31 40'/>"), none);
    // The highest point of the cubic is at 3/4 of its control points.
    EXPECT_EQ(inner("", "<path id='p' d='M0 30C0 43 30 43 30 30'/>"), none);
    EXPECT_EQ(inner("", "<path id='p' d='M0 30C0 43.5 30 43.5 30 30'/>"), cut);
    // The box is as wide as the element, also where the viewBox is not.
    EXPECT_EQ(inner("viewBox='0 0 30 30'", "<path id='p' d='M0 -5V35'/>"), none);
    EXPECT_EQ(inner("viewBox='0 0 30 30'", "<path id='p' d='M0 -5.1V35'/>"), cut);
    EXPECT_EQ(inner("transform='rotate(30) scale(2)'", "<circle id='p' cx='15' cy='15' r='15'/>"), none);
    EXPECT_EQ(inner("transform='rotate(30) scale(2)'", "<circle id='p' cx='15' cy='15' r='15.1'/>"), cut);
    // Of two boxes also the outer one cuts off.
    EXPECT_EQ(inner("", "<svg width='50' height='9'><path id='p' d='M0 0h29'/></svg>"), none);
    EXPECT_EQ(inner("", "<svg width='50' height='9'><path id='p' d='M0 0h31'/></svg>"), cut);
    EXPECT_EQ(told("<symbol id='s' viewBox='0 0 2 2'><path id='p' d='M0 0h3'/></symbol><use href='#s' width='9' "
                   "height='9'/>"),
              cut);
    // Each axis has room of its own, and that which rounding of the numbers of the page needs.
    const auto flat = [&](const std::string& y) {
        return told("<svg y='20' width='1000' height='1e-6'><path id='p' d='M0 0L10 " + y + "'/></svg>");
    };
    EXPECT_EQ(flat("1e-6"), none);
    EXPECT_EQ(flat("1.5e-6"), cut);
    EXPECT_EQ(flat("1.001e-6"), cut);
    EXPECT_EQ(inner("", "<path id='p' d='M0 0h31'/><path d='M0 0v41'/>"),
              std::vector<std::string>{"2 shapes are read whole, first 'p', though the inner drawings or symbols that "
                                       "they are in cut them off"});
}

TEST(SvgSwitch, ShowsWhatAReaderOfEnglishSees) {
    const auto ends = [](const std::string& first, const std::string& second) {
        const Imported imported = read_elements("<switch><path " + first + " d='M0 0h1'/><path " + second +
                                                " d='M0 0h2'/><path d='M0 0h3'/></switch>");
        EXPECT_EQ(
            imported.report.left_out,
            std::vector<std::string>{"2 alternatives that viewers do not show for readers of English are left out"});
        EXPECT_EQ(imported.document.curves.size(), 1U);
        return points_of(curve_of(imported)).back().x;
    };
    EXPECT_EQ(ends("systemLanguage='xx'", ""), 2);
    EXPECT_EQ(ends("systemLanguage='de, en-GB'", ""), 1);
    EXPECT_EQ(ends("systemLanguage=' EN '", ""), 1);
    EXPECT_EQ(ends("systemLanguage='enx'", "systemLanguage=''"), 3);
    EXPECT_EQ(ends("systemLanguage='e'", "systemLanguage=',,en'"), 2);
    EXPECT_EQ(ends("requiredExtensions='http://example.org'", "requiredExtensions=''"), 3);
    EXPECT_EQ(ends("requiredFeatures='http://www.w3.org/TR/SVG11/feature#Shape'", ""), 1);
}

// As Illustrator writes it; and conditions count outside of a switch, too.
TEST(SvgSwitch, MayHoldPrivateDataFirst) {
    const Imported imported = read_elements(
        "<switch><foreignObject requiredExtensions='x'/><title>t</title><g><path d='M0 0h3'/></g></switch>");
    EXPECT_EQ(imported.document.curves.size(), 1U);
    EXPECT_TRUE(imported.report.left_out.empty());
    EXPECT_EQ(read_elements("<g systemLanguage='fr'><path d='M0 0h1'/></g><path d='M0 0h1'/>").report.left_out,
              std::vector<std::string>{"an alternative that viewers do not show for readers of English is left out"});
}

TEST(SvgRoot, MayBeMovedAsAWhole) {
    const std::string square = "<path d='M10 10L20 30'/>";
    const std::string page = "width='200' height='200' transform='";
    EXPECT_EQ(drawn_below(square, page + "translate(20, 0)'"), (std::vector<Point>{{20, 10}, {30, 30}}))
        << "px of the page";
    EXPECT_EQ(drawn_below(square, page + "scale(2)'"), (std::vector<Point>{{20, 20}, {40, 60}}));
    EXPECT_EQ(drawn_below(square, page + "rotate(90)'"), (std::vector<Point>{{-10, 10}, {-30, 20}}));
    EXPECT_EQ(drawn_below(square, "style='transform:scale(1,-1)'"), (std::vector<Point>{{10, -10}, {20, -30}}));
    EXPECT_EQ(read_svg("<svg id='all' transform='turn'><path d='M0 0h1'/></svg>")->report.left_out,
              std::vector<std::string>{"the transform of 'all' cannot be read, so it stands where it would without"});
}

}  // namespace batten::exchange
