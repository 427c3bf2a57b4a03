// Sessions at the desk: what they are shown is what `lambent render` draws, each gets its turn, and nothing waits for
// somebody who does not look.
#include "base/file.h"
#include "image/files/image_io.h"
#include "tests/support/process.h"
#include "tests/viewer/seat.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <tbb/global_control.h>

#include <fstream>

namespace lambent::viewer {
namespace {

TEST(Desk, WhatIsSavedIsWhatTheShownCommandWrites)
{
    Stock stock({.cache = false});
    Desk desk(stock);
    Seat seat(desk, stock, small_wish("sphere"));
    seat.wait_for(Picture::Kind::rest, 0);
    std::uint64_t input = 0;
    const auto check = [&](const std::string& kind) {
        Picture rest;
        if (kind == "png")
            rest = seat.wait_for(Picture::Kind::rest, input);
        seat.session->save(kind);
        desk.nudge();
        ASSERT_TRUE(seat.audience->wait([&] { return !seat.audience->saved.empty(); }));
        const Saved saved = seat.audience->saved.front();
        seat.audience->saved.pop_front();
        const testing::Folder folder;
        EXPECT_EQ(saved.bytes, rendered(saved.command, folder)) << saved.command;
        if (kind == "png") {
            const image::CodeImage written = image::read_codes(folder.path("picture.png"));
            ASSERT_EQ(written.width, rest.codes.width);
            const std::size_t channels = static_cast<std::size_t>(rest.codes.channels);
            for (std::size_t i = 0; i < rest.codes.bytes.size() / channels; ++i)
                for (std::size_t c = 0; c < channels; ++c)
                    ASSERT_EQ(rest.codes.bytes[channels * i + c], written.bytes[4 * i + c]);
        }
    };
    seat.change(++input, [](Wish& wish, const Eye::World& world) {
        wish.eye.orbit(33.333333, 11.1111111);
        wish.eye.pan(world, 0.123456789, -0.1, 45.0);
        wish.eye.dolly(world, -0.3);
        set_value(wish.asked, "exposure", "1.2345678");
        set_value(wish.asked, "env-rotation", "-33.3");
    });
    check("png");
    seat.change(++input, [](Wish& wish, const Eye::World&) {
        set_value(wish.asked, "model", "phong");
        set_value(wish.asked, "alpha", "17.5");
        set_value(wish.asked, "kd", "0.1,0.7,0.3");
        set_value(wish.asked, "background", "none");
        set_lights(wish, {"directional:10,20,1,2,3", "point:0.5,2,1,1,1,1"});
    });
    check("png");
    check("jpg");
}

// A shape that takes long to build: the old one is shown while it moves, but is neither what rests nor what is saved.
TEST(Desk, WhatIsSavedWaitsForWhatIsLoaded)
{
    Stock stock({.cache = false});
    Desk desk(stock);
    Seat seat(desk, stock, small_wish("sphere"));
    seat.wait_for(Picture::Kind::rest, 0);
    seat.change(1, [](Wish& wish, const Eye::World&) {
        set_value(wish.asked, "model", "phong");
        set_value(wish.asked, "kd", "0.1,0.7,0.3");
        wish.asked.builtin.density = 4.0f;
    });
    seat.session->save("png");
    desk.nudge();
    const Picture rest = seat.wait_for(Picture::Kind::rest, 1);
    ASSERT_TRUE(seat.audience->wait([&] { return !seat.audience->saved.empty(); }));
    const Saved saved = seat.audience->saved.front();
    const testing::Folder folder;
    EXPECT_EQ(saved.bytes, rendered(saved.command, folder)) << saved.command;
    const image::CodeImage written = image::read_codes(folder.path("picture.png"));
    const std::size_t middle =
        static_cast<std::size_t>(written.width * (written.height / 2) + written.width / 2);
    for (std::size_t c = 0; c < 3; ++c)
        EXPECT_EQ(rest.codes.bytes[static_cast<std::size_t>(rest.codes.channels) * middle + c],
                  written.bytes[4 * middle + c]);
}

TEST(Desk, MovesAreShownSoonerAndSmallerThanWhatRests)
{
    Stock stock({.cache = false});
    Desk desk(stock);
    Seat seat(desk, stock, small_wish("sphere"));
    const Picture moving = seat.wait_for(Picture::Kind::moving, 0),
                  rest = seat.wait_for(Picture::Kind::rest, 0);
    EXPECT_LT(moving.codes.width, 96);
    EXPECT_EQ(moving.width, 96);
    EXPECT_EQ(rest.codes.width, 96);
    EXPECT_EQ(rest.codes.height, 64);
    EXPECT_EQ(rest.scale, 1.0);
}

TEST(Desk, WhoDoesNotLookGetsTwoPicturesAndHoldsNobodyUp)
{
    Stock stock({.cache = false});
    Desk desk(stock);
    Seat stalled(desk, stock, small_wish("sphere")), other(desk, stock, small_wish("sphere"));
    for (std::uint64_t input = 1; input <= 20; ++input) {
        const Session::Change turn = [](Wish& wish, const Eye::World&) { wish.eye.orbit(5.0, 0.0); };
        stalled.change(input, turn);
        other.change(input, turn);
        EXPECT_EQ(other.wait_for(Picture::Kind::moving, input).input, input);
    }
    other.wait_for(Picture::Kind::rest, 20);
    const std::lock_guard lock(stalled.audience->mutex);
    EXPECT_LE(stalled.audience->pictures.size(), std::size_t{Session::most_in_flight});
}

TEST(Desk, AMoveOvertakesALongPicture)
{
    Stock stock({.cache = false});
    Desk desk(stock);
    Wish wish = small_wish("grid");
    set_value(wish.asked, "samples", "1024");
    set_size(wish, 1600.0, 1200.0);
    Seat seat(desk, stock, wish);
    seat.wait_for(Picture::Kind::still, 0);
    // The long one is being drawn, or about to be; it is never shown, as the move comes first.
    seat.change(1, [](Wish& w, const Eye::World&) { w.eye.orbit(5.0, 0.0); });
    const Picture next = seat.wait_for(Picture::Kind::moving, 1);
    EXPECT_EQ(next.input, 1u);
    seat.change(2, [](Wish& w, const Eye::World&) { set_value(w.asked, "samples", "8"); });
    EXPECT_EQ(seat.wait_for(Picture::Kind::rest, 2).input, 2u);
}

Wish slow_wish()
{
    Wish wish = small_wish("grid");
    set_value(wish.asked, "samples", "260"); // from 256 on everything is looked at more closely
    const bool is_slow_anyway = testing::patience > 1;
    set_size(wish, is_slow_anyway ? 96.0 : 320.0, is_slow_anyway ? 72.0 : 240.0);
    return wish;
}

// On many cores it would not be slow.
class SlowPictures : public ::testing::Test {
    tbb::global_control two_cores_{tbb::global_control::max_allowed_parallelism, 2};
};

void orbit(Seat& seat, std::uint64_t input)
{
    seat.change(input, [](Wish& w, const Eye::World&) { w.eye.orbit(5.0, 0.0); });
}

// Moves, and looks each time, until a list of somebody's audience has something. How often.
template <class List>
std::uint64_t move_until(Seat& seat, std::uint64_t input, Audience& audience, const List& list)
{
    const auto has_come = [&] {
        const std::lock_guard lock(audience.mutex);
        return !list.empty();
    };
    std::uint64_t moves = 0;
    for (; !has_come(); ++moves, seat.wait_for(Picture::Kind::moving, input))
        orbit(seat, ++input);
    return moves;
}

// Who moves without end is shown it, and who rests gets the whole picture all the same.
TEST_F(SlowPictures, PauseWhileOthersMove)
{
    Stock stock({.cache = false});
    Desk desk(stock);
    std::vector<std::uint8_t> alone;
    {
        Seat seat(desk, stock, slow_wish());
        alone = seat.wait_for(Picture::Kind::rest, 0).codes.bytes;
    }
    Seat moving(desk, stock, small_wish("sphere"));
    moving.wait_for(Picture::Kind::rest, 0);
    Seat resting(desk, stock, slow_wish());
    resting.wait_for(Picture::Kind::still, 0);
    EXPECT_GT(move_until(moving, 0, *resting.audience, resting.audience->pictures), 20u);
    EXPECT_EQ(resting.wait_for(Picture::Kind::rest, 0).codes.bytes, alone);
}

// What is saved is the picture of the moment when that was asked for, whatever moves until it is.
TEST_F(SlowPictures, AreSavedWhileTheViewMoves)
{
    Stock stock({.cache = false});
    Desk desk(stock);
    Seat seat(desk, stock, slow_wish());
    seat.wait_for(Picture::Kind::moving, 0);
    orbit(seat, 1);
    const std::string command = command_of(seat.session->wish(), "picture.png");
    seat.session->save("png");
    desk.nudge();
    EXPECT_GT(move_until(seat, 1, *seat.audience, seat.audience->saved), 10u);
    EXPECT_FALSE(seat.session->is_saving());
    const testing::Folder folder;
    EXPECT_EQ(seat.audience->saved.front().command, command);
    EXPECT_EQ(seat.audience->saved.front().bytes, rendered(command, folder));
}

TEST(Desk, WhoseSceneCannotBeLoadedHoldsNobodyUp)
{
    Stock stock({.cache = false});
    Desk desk(stock);
    Seat lost(desk, stock, small_wish("nowhere.glb")), other(desk, stock, small_wish("sphere"));
    other.wait_for(Picture::Kind::rest, 0);
    EXPECT_FALSE(lost.session->is_hungry());
}

TEST(Desk, APickedPointBecomesTheMiddle)
{
    Stock stock({.cache = false});
    Desk desk(stock);
    Wish wish = small_wish("sphere");
    wish.eye = Eye(0.0, 0.0);
    Seat seat(desk, stock, wish);
    seat.wait_for(Picture::Kind::rest, 0);
    seat.session->focus(0.5, 0.5);
    desk.nudge();
    ASSERT_TRUE(seat.audience->wait([&] { return seat.session->wish().eye.options().size() == 4; }));
    // The sphere of radius 0.5 m stands at the origin: its nearest point.
    const glm::dvec3 target = seat.session->wish().eye.target({});
    EXPECT_NEAR(target.x, 0.0, 0.05);
    EXPECT_NEAR(target.y, 0.5, 0.05);
    EXPECT_NEAR(target.z, 0.5, 0.02);
}

TEST(Desk, WhatCannotBeOpenedIsSaidAndTheOldPictureStays)
{
    Stock stock({.cache = false});
    Desk desk(stock);
    Seat seat(desk, stock, small_wish("sphere"));
    seat.wait_for(Picture::Kind::rest, 0);
    seat.session->open_scene("nowhere.glb");
    desk.nudge();
    const auto says = [&](const std::string& words) {
        return seat.audience->wait([&] {
            return !seat.audience->states.empty() && nlohmann::json::parse(seat.audience->states.back())
                                                             .at("error")
                                                             .get<std::string>()
                                                             .find(words) != std::string::npos;
        });
    };
    EXPECT_TRUE(says("nowhere.glb"));
    EXPECT_EQ(seat.session->wish().asked.scene, "sphere");
    seat.session->open_scene("grid");
    desk.nudge();
    while (seat.session->wish().asked.scene != "grid")
        seat.wait_for(Picture::Kind::moving, 0);
    EXPECT_EQ(seat.session->wish().asked.scene, "grid");
}

TEST(Desk, ChangesThatAreRefusedChangeNothing)
{
    Stock stock({.cache = false});
    Desk desk(stock);
    Seat seat(desk, stock, small_wish("sphere"));
    const std::string before = seat.session->state();
    EXPECT_THROW(seat.session->change(1,
                                      [](Wish& wish, const Eye::World&) {
                                          set_value(wish.asked, "exposure", "2");
                                          set_value(wish.asked, "exposure", "-2");
                                      }),
                 Error);
    EXPECT_EQ(seat.session->state(), before);
    EXPECT_THROW(seat.session->save("exe"), Error);
}

TEST(Desk, ALayerThatAModelDoesNotHaveIsSaid)
{
    Stock stock({.cache = false});
    Desk desk(stock);
    Wish wish = small_wish("sphere");
    set_value(wish.asked, "model", "phong");
    Seat seat(desk, stock, wish);
    const std::vector<std::uint8_t> picture = seat.wait_for(Picture::Kind::rest, 0).codes.bytes;
    seat.change(1, [](Wish& w, const Eye::World&) { set_value(w.asked, "layer", "metalness"); });
    EXPECT_EQ(seat.wait_for(Picture::Kind::rest, 1).codes.bytes, picture);
    EXPECT_TRUE(seat.audience->wait([&] {
        return seat.audience->states.back().find("the model phong has no layer metalness") !=
               std::string::npos;
    }));
    seat.change(2, [](Wish& w, const Eye::World&) { set_value(w.asked, "model", "ggx"); });
    EXPECT_NE(seat.wait_for(Picture::Kind::rest, 2).codes.bytes, picture);
    EXPECT_TRUE(nlohmann::json::parse(seat.session->state())["error"].get<std::string>().empty());
}

TEST(Desk, EveryLayerCanBeLookedAt)
{
    Stock stock({.cache = false});
    Desk desk(stock);
    Seat seat(desk, stock, small_wish("sphere"));
    std::uint64_t input = 0;
    const std::vector<std::uint8_t> picture = seat.wait_for(Picture::Kind::rest, 0).codes.bytes;
    for (const char* model : {"ggx", "phong"})
        for (const char* layer : {"base_color", "alpha", "roughness", "normal", "depth", "mip_level",
                                  "irradiance", "light_specular"}) {
            seat.change(++input, [&](Wish& wish, const Eye::World&) {
                set_value(wish.asked, "model", model);
                set_value(wish.asked, "layer", layer);
            });
            EXPECT_NE(seat.wait_for(Picture::Kind::rest, input).codes.bytes, picture)
                << model << " " << layer;
        }
}

// The numbers are those of `lambent compare`, between what the commands write.
TEST(Desk, TheReferenceFollowsThePictureWithItsError)
{
    Stock stock({.cache = false});
    Desk desk(stock);
    Wish wish = small_wish("report");
    set_value(wish.asked, "exposure", "0.5");
    set_value(wish.asked, "layer", "reference");
    set_value(wish.asked, "bounces", "2");
    Seat seat(desk, stock, wish);
    EXPECT_FALSE(seat.wait_for(Picture::Kind::rest, 0).is_last);
    Picture traced = seat.wait_for(Picture::Kind::traced, 0);
    EXPECT_GE(traced.traced->samples, 1.0);
    while (!traced.is_last)
        traced = seat.wait_for(Picture::Kind::traced, 0);
    EXPECT_EQ(traced.codes.width, 96);
    EXPECT_GT(traced.traced->samples, 16.0);
    ASSERT_TRUE(traced.traced->noise.has_value());

    const testing::Folder folder;
    const auto run = [&](const std::vector<std::string>& words) {
        const testing::Outcome outcome = testing::run_program(LAMBENT_PROGRAM, words);
        EXPECT_EQ(outcome.code, 0) << outcome.error;
        return outcome.output;
    };
    run({"render", "report", "--env", "furnace", "--size", "96x64", "--samples", "8", "-o",
         folder.path("a.exr")});
    const auto said =
        nlohmann::json::parse(run({"reference", "report", "--env", "furnace", "--size", "96x64", "--bounces",
                                   "2", "--exposure", "0.5", "--stats", "json", "-o", folder.path("b.exr")}));
    EXPECT_GT(*traced.traced->noise, 0.0);
    EXPECT_NEAR(*traced.traced->noise, said.at("error_covered").get<double>(), 1e-9);
    const auto found = nlohmann::json::parse(
        run({"compare", folder.path("a.exr"), folder.path("b.exr"), "--exposure", "0.5", "--clamp", "1"}));
    EXPECT_NEAR(traced.traced->error, found.at("relative_rmse").get<double>(), 2e-3); // files hold halfs
    EXPECT_GT(traced.traced->error, 0.02);

    seat.change(1, [](Wish& w, const Eye::World&) { set_value(w.asked, "layer", "error"); });
    Picture error = seat.wait_for(Picture::Kind::traced, 1);
    while (!error.is_last)
        error = seat.wait_for(Picture::Kind::traced, 1);
    run({"render", "report", "--env", "furnace", "--size", "96x64", "--samples", "8", "--exposure", "0.5",
         "-o", folder.path("a.png")});
    run({"reference", "report", "--env", "furnace", "--size", "96x64", "--bounces", "2", "--exposure", "0.5",
         "-o", folder.path("b.png")});
    const auto flip = nlohmann::json::parse(run({"compare", folder.path("a.png"), folder.path("b.png")}));
    ASSERT_TRUE(error.traced->flip.has_value());
    EXPECT_NEAR(*error.traced->flip, flip.at("flip").get<double>(), 1e-6);
    EXPECT_NE(error.codes.bytes, traced.codes.bytes);
}

// Whoever moves gets a picture at once, and the trace begins anew.
TEST(Desk, AMoveEndsATrace)
{
    Stock stock({.cache = false});
    Desk desk(stock);
    Wish wish = small_wish("grid");
    set_value(wish.asked, "layer", "reference");
    set_size(wish, 640.0, 360.0);
    Seat seat(desk, stock, wish);
    seat.wait_for(Picture::Kind::traced, 0);
    seat.change(1, [](Wish& w, const Eye::World&) { w.eye.orbit(5.0, 0.0); });
    EXPECT_EQ(seat.wait_for(Picture::Kind::moving, 1).input, 1u);
    EXPECT_EQ(seat.wait_for(Picture::Kind::traced, 1).input, 1u);
    seat.change(2, [](Wish& w, const Eye::World&) { set_value(w.asked, "layer", "picture"); });
    EXPECT_TRUE(seat.wait_for(Picture::Kind::rest, 2).is_last);
}

} // namespace
} // namespace lambent::viewer
