// What is told of the look of a drawing, of which curves keep a color alone.
#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "core/make/shapes.h"
#include "exchange/svg/svg_writer.h"
#include "tests/exchange/svg_elements.h"

namespace batten::exchange {

namespace {

using Sentences = std::vector<std::string>;

const std::string fill = "a shape is filled; its outline is read as a line, and the fill is left out";
const std::string pen =
    "the width or the dashes of a line are left out, since all curves are drawn alike but for their colors";
const std::string marker = "the markers of a line are left out";
const std::string pattern = "a gradient or a pattern is left out";
const std::string opacity = "the opacity or the filter of a shape is left out";
const std::string page = "the size of the page is left out; a file that is written has a page around its curves";

Sentences looks(const std::string& elements) {
    const Imported imported = read_elements(elements);
    EXPECT_EQ(imported.report.left_out, Sentences{}) << "which is about curves, of which none is missing";
    return imported.report.looks;
}

Sentences looks_of_line(const std::string& attributes) {
    return looks("<path fill='none' stroke='red' d='M0 0L3 5' " + attributes + "/>");
}

}  // namespace

TEST(SvgLooks, OfPlainLinesLoseNothing) {
    EXPECT_EQ(looks_of_line(""), Sentences{});
    EXPECT_EQ(looks_of_line("stroke-width='1px' stroke-dasharray='none' marker-end='none' opacity='1'"), Sentences{});
    EXPECT_EQ(looks("<line x2='3' y2='5' stroke='red'/>"), Sentences{}) << "a line has nothing within";
    EXPECT_EQ(read_elements("<g display='none'><path d='M0 0h1'/></g><line x2='3' stroke='red'/>").report.looks,
              Sentences{})
        << "what is not drawn has no look";
}

TEST(SvgLooks, ThatCurvesDoNotHaveAreTold) {
    EXPECT_EQ(looks("<path d='M0 0L3 5'/>"), Sentences{fill}) << "black where nothing is said";
    EXPECT_EQ(looks_of_line("style='fill:#fff'"), Sentences{fill}) << "styles beat attributes";
    EXPECT_EQ(looks_of_line("stroke-width='0.5'"), Sentences{pen});
    EXPECT_EQ(looks_of_line("style='stroke-dasharray:3,1'"), Sentences{pen});
    EXPECT_EQ(looks_of_line("marker-end='url(#arrow)'"), Sentences{marker});
    EXPECT_EQ(looks_of_line("style='marker:url(#arrow)'"), Sentences{marker});
    EXPECT_EQ(looks_of_line("style='stroke:url(#fade)'"), Sentences{pattern});
    EXPECT_EQ(looks_of_line("style='fill:url(#fade)'"), (Sentences{fill, pattern}));
    EXPECT_EQ(looks_of_line("stroke-opacity='.5'"), Sentences{opacity});
    EXPECT_EQ(looks_of_line("filter='url(#shadow)'"), Sentences{opacity});
}

TEST(SvgLooks, AreHandedToWhatIsWithin) {
    const auto within = [](const std::string& outer, const std::string& inner) {
        return looks("<g fill='none' stroke='red' " + outer + "><path d='M0 0h1' " + inner + "/></g>");
    };
    EXPECT_EQ(within("stroke-width='2'", ""), Sentences{pen});
    EXPECT_EQ(within("stroke-width='2'", "stroke-width='inherit'"), Sentences{pen});
    EXPECT_EQ(within("stroke-width='2'", "stroke-width='1'"), Sentences{});
    EXPECT_EQ(within("stroke-width='2'", "stroke='none'"), Sentences{}) << "of a line that is not drawn";
    EXPECT_EQ(within("", "fill='blue'"), Sentences{fill});
    EXPECT_EQ(within("opacity='0.5'", "opacity='1'"), Sentences{opacity}) << "the group's is on top of its own";
    EXPECT_EQ(within("stroke-opacity='0.5'", "stroke-opacity='1'"), Sentences{});
    EXPECT_EQ(within("fill-opacity='0.5'", ""), Sentences{}) << "of a fill that is not drawn";
    EXPECT_EQ(within("marker='url(#arrow)'", "marker-start='none' marker-mid='none'"), Sentences{marker});
    EXPECT_EQ(within("marker-end='url(#arrow)'", "marker-end='none'"), Sentences{});
}

TEST(SvgLooks, AreCounted) {
    EXPECT_EQ(looks("<rect width='1' height='1'/><circle r='1'/><path d='M0 0h1h1zM3 3h1h1z'/>"),
              Sentences{"3 shapes are filled; their outlines are read as lines, and the fills are left out"});
}

TEST(SvgLooks, OfAPageAreTold) {
    const auto told = [](const std::string& attributes) {
        return read_svg("<svg " + attributes + "><line x2='3' stroke='red'/></svg>")->report.looks;
    };
    EXPECT_EQ(told("viewBox='0 0 10 10'"), Sentences{page});
    EXPECT_EQ(told("width='10mm' height='5mm'"), Sentences{page});
    EXPECT_EQ(told(""), Sentences{});
}

TEST(SvgLooks, OfFilesOfThisProgramAreKept) {
    core::Document document;
    const std::vector<core::Point> points{{0, 0}, {3, 5}};
    core::DocumentCurve& curve = document.curves.emplace_back();
    curve.name = "a";
    curve.color = core::DocumentColor{255, 0, 0};
    curve.curve = std::make_shared<const core::Curve>(*core::polyline(points));
    const auto written = write_svg(document);
    ASSERT_TRUE(written);
    EXPECT_EQ(read_svg(written->text)->report.looks, Sentences{});

    std::string older = written->text;  // the first versions had no such mark
    const std::size_t mark = older.find(" styles=");
    ASSERT_NE(mark, std::string::npos);
    older.erase(mark, older.find('"', mark + 9) + 1 - mark);
    EXPECT_EQ(read_svg(older)->report.looks, Sentences{});

    std::string filled = written->text;
    const std::size_t none = filled.find("fill=\"none\"");
    ASSERT_NE(none, std::string::npos);
    const auto told = read_svg(filled.replace(none, 11, "fill=\"tan\" "))->report;
    EXPECT_EQ(told.left_out, Sentences{});
    ASSERT_FALSE(told.looks.empty());
    EXPECT_EQ(told.looks.front(), fill);
}

}  // namespace batten::exchange
