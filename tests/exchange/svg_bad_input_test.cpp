#include <gtest/gtest.h>

#include <chrono>
#include <string>

#include "exchange/svg/svg_reader.h"

namespace batten::exchange {

namespace {

using Clock = std::chrono::steady_clock;

std::string repeated(const std::string& text, std::size_t count) {
    std::string all;
    all.reserve(text.size() * count);
    for (std::size_t i = 0; i < count; ++i) all += text;
    return all;
}

std::string svg_file(const std::string& elements) {
    return "<svg>" + elements + "</svg>";
}

// Whatever it is, it is read or refused with a sentence, soon.
core::FileResult<Imported> read_soon(const std::string& text) {
    const auto start = Clock::now();
    auto imported = read_svg(text);
    EXPECT_LT(std::chrono::duration<double>(Clock::now() - start).count(), 100.0)
        << "a few seconds, but for sanitizers and busy machines";
    EXPECT_TRUE(imported || !imported.error().what.empty());
    return imported;
}

}  // namespace

TEST(BadSvg, IsRefusedWithItsLine) {
    EXPECT_EQ(read_svg("<svg>\n<path\n</svg>").error().where, "line 3");
    EXPECT_EQ(read_svg("").error().sentence(), "line 1: this is no XML: No document element found");
    EXPECT_EQ(read_svg("<html/>").error().sentence(), "the file is a 'html'; an 'svg' is needed");
    EXPECT_EQ(read_svg("\x1f\x8b\x08...").error().sentence(), "this is no XML but what gzip makes of it");
    EXPECT_EQ(read_svg(std::string("<svg>\n\0</svg>", 13)).error().where, "line 2");
    EXPECT_EQ(read_svg("<svg><text>a</text></svg>").error().sentence(),
              "nothing is read from this file: a text is left out; in the program that made it, it can be turned into "
              "paths");
}

TEST(BadSvg, OfWhichAllIsHiddenIsRefusedAsSuch) {
    const std::string path = "<path d='M0 0h1' style='display:none'/>";
    EXPECT_EQ(read_svg(svg_file(path)).error().sentence(),
              "nothing is read from this file, since all that it draws is hidden: an element is not displayed");
    EXPECT_EQ(read_svg(svg_file("<g display='none'><path d='M0 0h1'/></g>" + path)).error().sentence(),
              "nothing is read from this file, since all that it draws is hidden: 2 elements are not displayed");
}

// Sentences of what is read otherwise than it is drawn give no reason.
TEST(BadSvg, OfWhichNothingIsDrawnIsRefusedForWhatIsLeftOut) {
    const auto refusal = [](const std::string& elements) { return read_svg(svg_file(elements)).error().sentence(); };
    const std::string hidden = "<g style='display:none'><path d='M0 0L1 1'/></g>";
    const std::string nothing = "no path and no shape is drawn in this file";
    const std::string all_hidden =
        "nothing is read from this file, since all that it draws is hidden: an element is not displayed";
    EXPECT_EQ(refusal("<g clip-path='url(#c)'/>"), nothing);
    EXPECT_EQ(refusal("<g transform='turn'/>"), nothing);
    EXPECT_EQ(refusal("<style>g path{fill:red}</style>"), nothing);
    EXPECT_EQ(refusal("<style>g path{fill:red}</style>" + hidden), all_hidden);
    EXPECT_EQ(refusal("<g transform='turn'>" + hidden + "</g>"), all_hidden);
    EXPECT_EQ(refusal("<g clip-path='url(#c)'><image/></g>"), "nothing is read from this file: an image is left out");
}

TEST(BadSvg, IsReadOrRefusedTruncatedAnywhere) {
    const std::string text =
        R"svg(<?xml version="1.0"?><!DOCTYPE svg [<!ENTITY a "b">]><svg viewBox="0 0 10 10" width="3mm"><!-- c -->)svg"
        R"svg(<g transform="rotate(30 1 2)" style="stroke:#f80"><path id="a" d="M0 0C1 2 3 4 5 6A1 2 30 0 1 3 3z"/></g>)svg"
        R"svg(<use href="#a" x="3"/><polygon points="1,2 3,4 5,6"/><![CDATA[x]]><symbol id="s" viewBox="0 0 1 1"/>)svg"
        R"svg(<switch><use href="#s" width="2" systemLanguage="en" style="transform:skew(3deg,.1rad)translate(1px,5%);)svg"
        R"svg(transform-origin:1px left !important"/></switch><svg font-size="3px" width="1em" height="2rem" )svg"
        R"svg(overflow="auto"><g inkscape:groupmode="layer"><path style="&a;" d="m.1.1a5 5 0 0 1 6 8"/></g></svg></svg>)svg";
    ASSERT_TRUE(read_svg(text));
    for (std::size_t size = 0; size < text.size(); ++size) EXPECT_FALSE(read_soon(text.substr(0, size))) << size;
    for (std::size_t i = 0; i < text.size(); ++i)
        for (const char c : {'\xff', '<', '"', '9', '-', ' '}) {
            std::string changed = text;
            changed[i] = c;
            read_soon(changed);
        }
}

TEST(BadSvg, ExpandsNoEntity) {
    std::string bomb = R"(<!DOCTYPE svg [<!ENTITY a0 "M0 0h1 ">)";
    for (int i = 1; i < 30; ++i)
        bomb += "<!ENTITY a" + std::to_string(i) + " \"" + repeated("&a" + std::to_string(i - 1) + ";", 10) + "\">";
    bomb +=
        R"(<!ENTITY f SYSTEM "file:///etc/passwd">]><svg><path id="p" d="&a29;"/><path d="M0 0h1"/><text>&f;</text></svg>)";
    const auto imported = read_soon(bomb);
    ASSERT_TRUE(imported);
    EXPECT_EQ(imported->document.curves.size(), 1U);
    EXPECT_EQ(imported->report.left_out,
              (std::vector<std::string>{
                  "2 elements have entities of the file, first '&a29;', of which none is expanded; what these say of "
                  "shapes and colors is lost",
                  "the path data go wrong at character 1 of 'p'; they are read up to there",
                  "a text is left out; in the program that made it, it can be turned into paths"}));
}

// Illustrator names namespaces by entities, and in old files styles.
TEST(BadSvg, MayDefineEntitiesThatNothingDrawnHas) {
    const auto told = [](const std::string& attributes) {
        const auto imported = read_svg(
            "<!DOCTYPE svg PUBLIC '-//W3C//DTD SVG 1.1//EN' 'svg11.dtd' [<!ENTITY ns_svg "
            "'http://www.w3.org/2000/svg'>\n<!ENTITY st0 'stroke:red'>]><svg xmlns='&ns_svg;' "
            "xmlns:a='&ns_svg;'><path d='M0 0h1' " +
            attributes + "/></svg>");
        return imported->report.left_out;
    };
    EXPECT_EQ(told(""), std::vector<std::string>{});
    EXPECT_EQ(told("id='&other; &lt;'"), std::vector<std::string>{}) << "which is none of the file";
    EXPECT_EQ(told("style='&st0;'"),
              std::vector<std::string>{"'&st0;' is left as it stands, since no entity of a file is expanded; what it "
                                       "says of shapes and colors is lost"});
}

TEST(BadSvg, HasNoEntitiesInCommentsParametersAndEscapes) {
    const auto told = [](const std::string& declarations, const std::string& content) {
        const auto imported =
            read_svg("<!DOCTYPE svg [" + declarations + "]><svg><path d='M0 0h1' " + content + "</svg>");
        EXPECT_TRUE(imported) << declarations;
        return imported ? imported->report.left_out : std::vector<std::string>{};
    };
    const std::vector<std::string> none{};
    const std::vector<std::string> one{
        "'&a;' is left as it stands, since no entity of a file is expanded; what it says of shapes and colors is lost"};
    const std::string entity = "<!ENTITY a ''>";
    EXPECT_EQ(told(entity, "id='&a;'/>"), one);
    EXPECT_EQ(told(entity, "id='&amp;a;'/>"), none);
    EXPECT_EQ(told(entity, "id='&#38;a;'/>"), none);
    EXPECT_EQ(told(entity, "/><desc>R&amp;a;</desc>"), none);
    EXPECT_EQ(told(entity, "/><desc>&a;</desc>"), one);
    EXPECT_EQ(told(entity, "/><desc><![CDATA[&a;]]></desc>"), none);
    EXPECT_EQ(told("<!-- " + entity + " -->", "id='&a;'/>"), none);
    EXPECT_EQ(told("<!-- ' -->" + entity, "id='&a;'/>"), one) << "a quote in a comment begins nothing";
    EXPECT_EQ(told("<!ENTITY % a ''>", "id='&a;'/>"), none);
    EXPECT_EQ(told("<!ENTITY b \"" + entity + "\">", "id='&a;'/>"), none);
    EXPECT_EQ(told("<!ENTITY amp '&#38;#38;'>", "id='&amp;'/>"), none);
    EXPECT_EQ(told("<!ELEMENT svg ANY>\n<!ENTITY\n\ta '>'>", "id='&a;'/>"), one);
}

// A hundred thousand of them, and two million blanks behind; what takes their product takes hours.
TEST(BadSvg, MayDefineManyEntities) {
    const std::string entities = repeated("<!ENTITY a ''>", 100'000) + std::string(2'000'000, ' ');
    const auto imported = read_soon("<!DOCTYPE svg [" + entities + "]><svg><path d='M0 0h1'/></svg>");
    ASSERT_TRUE(imported);
    EXPECT_TRUE(imported->report.left_out.empty());
}

// A path of 20,000 cubics, none of which reaches as far as its control points, in 250 frames.
TEST(BadSvg, MayHaveManyFramesAroundManyPoints) {
    constexpr std::size_t count = 250;
    const auto told = [](const std::string& frame) {
        const std::string path = "<path id='p' d='M50 50" + repeated("C50 110 60 110 50 50", 20'000) + "'/>";
        const auto imported = read_soon("<svg viewBox='0 0 100 100'>" + repeated(frame, count) + path +
                                        repeated("</svg>", count) + "</svg>");
        EXPECT_TRUE(imported);
        return imported ? imported->report.left_out : std::vector<std::string>{};
    };
    EXPECT_TRUE(told("<svg width='100' height='100'>").empty());
    EXPECT_EQ(told("<svg width='100' height='100' transform='rotate(1 50 50)'>").size(), 1U)
        << "of the ninth turned one the control points count";
}

TEST(BadSvg, MayBeNestedDeep) {
    constexpr std::size_t depth = 100'000;
    const auto imported = read_soon(
        svg_file("<path d='M0 0h1'/>" + repeated("<g>", depth) + "<path d='M0 0h1'/>" + repeated("</g>", depth)));
    ASSERT_TRUE(imported);
    EXPECT_EQ(imported->document.curves.size(), 1U);
    EXPECT_EQ(imported->report.left_out,
              std::vector<std::string>{"elements that are nested more than 256 deep are left out"});
}

TEST(BadSvg, MayUseElementsTooOften) {
    std::string elements = "<g id='a0'><path d='M0 0h1'/></g>";
    for (int i = 1; i < 12; ++i)
        elements += "<g id='a" + std::to_string(i) + "'>" +
                    repeated("<use href='#a" + std::to_string(i - 1) + "'/>", 10) + "</g>";
    const auto imported = read_soon(svg_file(elements));
    ASSERT_TRUE(imported);
    EXPECT_EQ(imported->document.curves.size(), most_svg_curves);
    EXPECT_EQ(imported->report.left_out.back(),
              "what follows the first 500000 elements is left out, each counted as often as 'use' repeats it");
    std::string empty = "<path d='M0 0h1'/><g id='a0'/>";
    for (int i = 1; i < 12; ++i)
        empty += "<g id='a" + std::to_string(i) + "'>" + repeated("<use href='#a" + std::to_string(i - 1) + "'/>", 10) +
                 "</g>";
    EXPECT_EQ(read_soon(svg_file(empty))->document.curves.size(), 1U);
}

// A hundred uses of a megabyte, wherever that is: data, styles, names, elements that are not drawn.
TEST(BadSvg, MayUseMuchTooOften) {
    constexpr std::size_t megabyte = 1'000'000;
    const std::string much = repeated("x", megabyte);
    for (const std::string& used :
         {"<path id='a' d='" + much + "'/>", "<g id='a' style='" + much + "'/>",
          "<path id='a'><title>" + much + "</title></path>", "<g id='a'>" + repeated("<x:y/>", megabyte) + "</g>",
          "<symbol id='a' viewBox='" + much + "'/>"}) {
        SCOPED_TRACE(used.substr(0, 30));
        const std::string uses = repeated("<use href='#a'/>", 100);
        const auto found = read_soon(svg_file("<path d='M0 0L1 1'/><defs>" + used + "</defs>" + uses));
        ASSERT_TRUE(found);
        EXPECT_EQ(found->document.curves.size(), 1U);
        ASSERT_FALSE(found->report.left_out.empty());
        EXPECT_EQ(found->report.left_out.back(),
                  "what follows is left out, since 'use' repeats more than 67108864 bytes of the file");
    }
    // As much that is in the file itself is read.
    const std::string element = "<path d='M0 0L1 1' style='" + much + "'/>";
    const auto found = read_soon(svg_file(repeated(element, 100)));
    ASSERT_TRUE(found);
    EXPECT_EQ(found->document.curves.size(), 100U);
    EXPECT_TRUE(found->report.left_out.empty());
}

TEST(BadSvg, MayHaveAMillionSubpaths) {
    const auto imported = read_soon(
        svg_file("<path id='" + std::string(1'000'000, 'n') + "' d='" + repeated("M0 0h1", 1'000'000) + "'/>"));
    ASSERT_TRUE(imported);
    EXPECT_EQ(imported->document.curves.size(), most_svg_curves);
    EXPECT_LE(imported->document.curves[0].name.size(), 200U);
    EXPECT_EQ(
        imported->report.left_out,
        std::vector<std::string>{"a path or a shape behind the first 100000 curves is left out, wholly or in part"});
    EXPECT_FALSE(read_soon(svg_file(repeated("<a/>", 5'000'000))));
}

TEST(BadSvg, MayHaveMorePathsThanAreRead) {
    const auto imported = read_soon(svg_file(repeated("<path d='M0 0h1'/>", most_svg_curves + 3) + "<circle r='1'/>"));
    ASSERT_TRUE(imported);
    EXPECT_EQ(imported->document.curves.size(), most_svg_curves);
    EXPECT_EQ(
        imported->report.left_out,
        std::vector<std::string>{"4 paths or shapes behind the first 100000 curves are left out, wholly or in part"});
}

TEST(BadSvg, MayHaveManyPiecesInOnePath) {
    const auto imported = read_soon(svg_file("<path d='M0 0" + repeated("l1 1c1 2 3 4 5 6", 100'000) + "'/>"));
    ASSERT_TRUE(imported);
    EXPECT_EQ(imported->document.curves[0].curve->control_points().size(), 600'001U);
}

}  // namespace batten::exchange
