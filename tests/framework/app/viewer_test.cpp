// Drives the viewer in a window that nobody sees, and compares its pictures with those of the command line.
#include "textures_run.h"

#include <choices.h>

#include <cglib/core/image.h>
#include <cglib/rt/scenes.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <set>
#include <tuple>
#include <vector>

namespace {
std::string const with_display = "'" WITH_DISPLAY "' ";

bool has(std::string const& program)
{
    return std::system(("command -v " + program + " > /dev/null").c_str()) == 0;
}

Image load(TexturesRun const& run, std::string const& name)
{
    Image image;
    image.load(run.directory.path(name), 1.f);
    return image;
}

/// A folder in which the viewer has obeyed lines, and the program can render offline.
struct Viewer {
    explicit Viewer(std::string const& lines, std::string const& options = "")
    {
        std::ofstream(viewed.directory.path("lines")) << lines << "\nquit\n";
        exit_code = viewed.exit_code("--drive lines " + options);
    }

    Image offline(std::string const& options)
    {
        TexturesRun run(TEXTURES_PROGRAM);
        EXPECT_EQ(run.exit_code("--output a.png " + options), 0) << options << run.err();
        return load(run, "a.png");
    }

    TexturesRun viewed{TEXTURES_PROGRAM, with_display};
    int exit_code;
};

/// Lines for the viewer, with the options that make the same picture offline.
struct Step {
    std::string lines;
    std::string options;
};

template <class Enum>
void add_steps(std::vector<Step>* steps, std::string const& what, std::map<std::string, Enum> const& choices,
               Step const& given)
{
    for (auto const& [name, value] : choices)
        steps->push_back({given.lines + what + " " + name + "\n", given.options + " --" + what + " " + name});
}

/// Every value of every combo and of some switches.
std::vector<Step> all_steps()
{
    std::vector<Step> steps;
    for (std::string const& scene : scene_names())
        steps.push_back({"scene " + scene + "\n", "--scene " + scene});
    add_steps(&steps, "filter", filter_choices(), {"scene goboard\n", "--scene goboard"});
    add_steps(&steps, "wrap", wrap_choices(), {"scene plane\nfilter bilinear\n", "--scene plane --filter bilinear"});
    add_steps(&steps, "mode", mode_choices(),
              {"scene sphere\nfilter trilinear\n", "--scene sphere --filter trilinear"});
    steps.push_back({"scene sphere\nnormal_mapping on\n", "--scene sphere --normal_mapping"});
    steps.push_back({"scene pooltable\ntransform_objects off\n", "--scene pooltable --no_transforms"});
    steps.push_back({"scene plane\nspp 4\nstratified on\n", "--scene plane --spp 4 --stratified"});
    steps.push_back({"scene goboard\ndepth 0\n", "--scene goboard --depth 0"});
    return steps;
}

std::string const defaults =
    "filter nearest\nwrap repeat\nmode recursive\nnormal_mapping off\ntransform_objects on\nspp 1\nstratified off\n"
    "depth 4\nsize 80 50\n";

int num_colours(Image const& image, int x0, int x1)
{
    std::set<std::tuple<float, float, float>> colours;
    for (int y = 0; y < image.getHeight(); ++y)
        for (int x = x0; x < x1; ++x) {
            glm::vec4 const pixel = image.getPixel(x, y);
            colours.emplace(pixel.r, pixel.g, pixel.b);
        }
    return int(colours.size());
}

float largest_difference(Image const& a, Image const& b)
{
    float largest = 0.f;
    for (std::size_t i = 0; i < a.getPixels().size(); ++i)
        for (int c = 0; c < 3; ++c)
            largest = std::max(largest, std::abs(a.getPixels()[i][c] - b.getPixels().at(i)[c]));
    return largest;
}
}  // namespace

// A test that skips itself must do so in its own body. CI installs everything, so there nothing may be missing.
#define SKIP_WITHOUT(program)                             \
    do {                                                  \
        if (has(program))                                 \
            break;                                        \
        ASSERT_EQ(std::getenv("CI"), nullptr) << program; \
        GTEST_SKIP() << program " is not installed";      \
    } while (false)

TEST(Viewer, SavesThePicturesOfTheCommandLine)
{
    SKIP_WITHOUT("Xvfb");
    std::vector<Step> const steps = all_steps();
    std::string lines;
    for (std::size_t i = 0; i < steps.size(); ++i)
        lines += defaults + steps[i].lines + "wait\nsave " + std::to_string(i) + ".png\n";
    Viewer viewer(lines);
    ASSERT_EQ(viewer.exit_code, 0) << viewer.viewed.err();
    for (std::size_t i = 0; i < steps.size(); ++i) {
        Image const image = load(viewer.viewed, std::to_string(i) + ".png");
        Image const expected = viewer.offline("--width 80 --height 50 " + steps[i].options);
        // Times are never the same.
        bool const is_time = steps[i].options.find("--mode time") != std::string::npos;
        EXPECT_TRUE(is_time || image.getPixels() == expected.getPixels()) << steps[i].options;
    }
}

TEST(Viewer, ShowsThePictureInTheWholeWindow)
{
    SKIP_WITHOUT("Xvfb");
    Viewer viewer("panel off\nwait\nscreenshot a.png", "--scene sphere --filter bilinear");
    ASSERT_EQ(viewer.exit_code, 0) << viewer.viewed.err();
    Image const screen = load(viewer.viewed, "a.png");
    Image const expected = viewer.offline("--width 1280 --height 800 --scene sphere --filter bilinear");
    EXPECT_LT(largest_difference(screen, expected), 1.01f / 255.f);
}

TEST(Viewer, ShowsPanelAndPicture)
{
    SKIP_WITHOUT("Xvfb");
    Viewer viewer("wait\nscreenshot a.png", "--scene sphere");
    Image const screen = load(viewer.viewed, "a.png");
    ASSERT_EQ(screen.getWidth(), 1280);
    EXPECT_GT(num_colours(screen, 0, 300), 20);
    EXPECT_GT(num_colours(screen, 400, 1280), 1000);
}

TEST(Viewer, CameraMovesAndComesBack)
{
    SKIP_WITHOUT("Xvfb");
    Viewer viewer("drag 0.1 0.05\nwait\nsave a.png\nreset\nwait\nsave b.png", "--width 40 --height 30");
    Image const home = viewer.offline("--width 40 --height 30");
    EXPECT_FALSE(load(viewer.viewed, "a.png").getPixels() == home.getPixels());
    EXPECT_TRUE(load(viewer.viewed, "b.png").getPixels() == home.getPixels());
}

TEST(Viewer, MissingTextureIsShownAndForgotten)
{
    SKIP_WITHOUT("Xvfb");
    Viewer viewer("wait\nscreenshot a.png\nmode normal\nwait\nsave b.png",
                  "--assets . --scene sphere --width 40 --height 30");
    ASSERT_EQ(viewer.exit_code, 0) << viewer.viewed.err();
    glm::vec4 const corner = load(viewer.viewed, "a.png").getPixel(1200, 780);
    EXPECT_GT(corner.r, 2.f * corner.b);
    EXPECT_TRUE(load(viewer.viewed, "b.png").getPixels() ==
                viewer.offline("--scene sphere --width 40 --height 30 --mode normal").getPixels());
}

TEST(Viewer, ScriptThatIsNoneIsAnError)
{
    SKIP_WITHOUT("Xvfb");
    for (char const* line : {"filter cubic", "spp", "dance"}) {
        Viewer viewer(std::string("wait\n") + line);
        EXPECT_EQ(viewer.exit_code, 2);
        EXPECT_NE(viewer.viewed.err().find("line 2"), std::string::npos) << viewer.viewed.err();
    }
}

TEST(Viewer, ObeysKeysAndMouse)
{
    SKIP_WITHOUT("Xvfb");
    SKIP_WITHOUT("xdotool");
    TexturesRun run(TEXTURES_PROGRAM, with_display + "'" KEYS_TEST "' ");
    ASSERT_EQ(run.exit_code(""), 0) << run.out() << run.err();
    Image const home = load(run, "plane_trilinear_recursive.png");
    EXPECT_FALSE(load(run, "plane_nearest_recursive.png").getPixels() == home.getPixels());
    EXPECT_TRUE(load(run, "plane_trilinear_recursive-2.png").getPixels() == home.getPixels());
    EXPECT_FALSE(load(run, "plane_trilinear_recursive-3.png").getPixels() == home.getPixels());
    EXPECT_TRUE(load(run, "plane_trilinear_recursive-4.png").getPixels() == home.getPixels());
    EXPECT_TRUE(load(run, "plane_trilinear_recursive-5.png").getPixels() == home.getPixels());
}

TEST(Viewer, WithoutDisplayItSaysWhatToDo)
{
    TexturesRun run(TEXTURES_PROGRAM, "env -u DISPLAY -u WAYLAND_DISPLAY ");
    EXPECT_EQ(run.exit_code(""), 2);
    EXPECT_NE(run.err().find("--create_images"), std::string::npos);
}
