#include "core/document/picture.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "core/document/native_file.h"

namespace batten::core {
namespace {

namespace fs = std::filesystem;

Picture sample() {
    Picture picture;
    picture.path = "scan.png";
    picture.width = 400;
    picture.height = 100;
    picture.position = {10, 20};
    picture.scale = 0.5;
    return picture;
}

TEST(Picture, pixels_run_to_the_right_and_down) {
    const Picture picture = sample();
    EXPECT_EQ(plane_from_picture(picture, {0, 100}), Point(10, 20));
    EXPECT_EQ(plane_from_picture(picture, {0, 0}), Point(10, 70));
    EXPECT_EQ(plane_from_picture(picture, {400, 100}), Point(210, 20));
}

TEST(Picture, turns_about_its_lower_left_corner) {
    Picture picture = sample();
    picture.rotation = 90.0;
    EXPECT_EQ(plane_from_picture(picture, {0, 100}), Point(10, 20));
    EXPECT_EQ(plane_from_picture(picture, {400, 100}), Point(10, 220));
    EXPECT_EQ(plane_from_picture(picture, {0, 0}), Point(-40, 20));
    picture.rotation = 30.0;
    const Point corner = plane_from_picture(picture, {400, 100});
    EXPECT_NEAR(corner.x, 10 + 200 * 0.8660254037844386, 1e-12);
    EXPECT_NEAR(corner.y, 120.0, 1e-12);
    const PicturePlace place = picture_from_plane(picture, corner);
    EXPECT_NEAR(place.x, 400.0, 1e-10);
    EXPECT_NEAR(place.y, 100.0, 1e-10);
}

Document with_picture(Picture picture) {
    Document document;
    document.pictures.push_back(std::move(picture));
    return document;
}

TEST(Picture, comes_back_from_a_file) {
    Picture picture = sample();
    picture.rotation = -12.5;
    picture.opacity = 0.25;
    picture.visible = false;
    picture.locked = true;
    picture.unknown_members = R"({"source":"museum"})";
    const std::string text = format_document(with_picture(picture));
    const auto read = parse_document(text);
    ASSERT_TRUE(read) << read.error().sentence();
    ASSERT_EQ(read->pictures.size(), 1U);
    EXPECT_EQ(read->pictures.front(), picture);
    EXPECT_EQ(format_document(*read), text);
    // Written only where there is one.
    EXPECT_EQ(format_document({}).find("pictures"), std::string::npos);
}

TEST(Picture, is_told_from_the_folder_of_the_document) {
    const fs::path folder = fs::temp_directory_path() / "batten_picture_test";
    fs::create_directories(folder / "drawings");
    Picture picture = sample();
    picture.path = folder / "scans" / "scan.png";
    const fs::path file = folder / "drawings" / "hull.json";
    ASSERT_TRUE(save_document(with_picture(picture), file));
    EXPECT_NE(read_text(file)->find(R"("path": "../scans/scan.png")"), std::string::npos);
    const auto read = load_document(file);
    ASSERT_TRUE(read);
    EXPECT_EQ(read->pictures.front().path, picture.path);
    fs::remove_all(folder);
}

std::string refusal_of_picture(const std::string& picture) {
    const auto read = parse_document(R"({"format": "batten", "version": 1, "pictures": [)" + picture + "]}");
    return read ? "" : read.error().sentence();
}

TEST(Picture, wrong_members_are_named) {
    EXPECT_EQ(refusal_of_picture(R"({"path": "a.png", "width": 2, "height": 3})"), "");
    EXPECT_EQ(refusal_of_picture(R"({"width": 2, "height": 3})"), "/pictures/0: the member \"path\" is missing");
    EXPECT_EQ(refusal_of_picture(R"({"path": "a.png", "width": 0, "height": 3})"),
              "/pictures/0/width: found 0.0, but it must be a whole number from 1 to 1000000");
    EXPECT_EQ(refusal_of_picture(R"({"path": "a.png", "width": 2, "height": 2.5})"),
              "/pictures/0/height: found 2.5, but it must be a whole number from 1 to 1000000");
    EXPECT_EQ(refusal_of_picture(R"({"path": "a.png", "width": 2, "height": 3, "scale": 0})"),
              "/pictures/0/scale: found 0.0, but it must be a number above 0");
    EXPECT_EQ(refusal_of_picture(R"({"path": "a.png", "width": 2, "height": 3, "opacity": 1.5})"),
              "/pictures/0/opacity: found 1.5, but it must be a number from 0 to 1");
    EXPECT_EQ(refusal_of_picture("7").substr(0, 12), "/pictures/0:");
}

}  // namespace
}  // namespace batten::core
