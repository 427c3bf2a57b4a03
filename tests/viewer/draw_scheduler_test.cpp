// Sessions at the scheduler: what they are shown is what `lambent render` draws, each gets its turn, and nothing waits for
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

TEST(DrawScheduler, WhatIsSavedIsWhatTheShownCommandWrites)
{
    AssetCache assets({.cache = false});
    DrawScheduler scheduler(assets);
    Seat seat(scheduler, assets, small_wish("sphere"));
    seat.wait_for(ShownPicture::Kind::rest, 0);
    std::uint64_t input = 0;
    const auto check = [&](const std::string& kind) {
        ShownPicture rest;
        if (kind == "png")
            rest = seat.wait_for(ShownPicture::Kind::rest, input);
        seat.session->save(kind);
        scheduler.nudge();
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
    seat.change(++input, [](ViewRequest& request, const OrbitCamera::World& world) {
        request.eye.orbit(33.333333, 11.1111111);
        request.eye.pan(world, 0.123456789, -0.1, 45.0);
        request.eye.dolly(world, -0.3);
        set_value(request.asked, "exposure", "1.2345678");
        set_value(request.asked, "env-rotation", "-33.3");
    });
    check("png");
    seat.change(++input, [](ViewRequest& request, const OrbitCamera::World&) {
        set_value(request.asked, "model", "phong");
        set_value(request.asked, "alpha", "17.5");
        set_value(request.asked, "kd", "0.1,0.7,0.3");
        set_value(request.asked, "background", "none");
        set_lights(request, {"directional:10,20,1,2,3", "point:0.5,2,1,1,1,1"});
    });
    check("png");
    check("jpg");
}

// A shape that takes long to build: the old one is shown while it moves, but is neither what rests nor what is saved.
TEST(DrawScheduler, WhatIsSavedWaitsForWhatIsLoaded)
{
    AssetCache assets({.cache = false});
    DrawScheduler scheduler(assets);
    Seat seat(scheduler, assets, small_wish("sphere"));
    seat.wait_for(ShownPicture::Kind::rest, 0);
    seat.change(1, [](ViewRequest& request, const OrbitCamera::World&) {
        set_value(request.asked, "model", "phong");
        set_value(request.asked, "kd", "0.1,0.7,0.3");
        request.asked.builtin.density = 4.0f;
    });
    seat.session->save("png");
    scheduler.nudge();
    const ShownPicture rest = seat.wait_for(ShownPicture::Kind::rest, 1);
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

TEST(DrawScheduler, MovesAreShownSoonerAndSmallerThanWhatRests)
{
    AssetCache assets({.cache = false});
    DrawScheduler scheduler(assets);
    Seat seat(scheduler, assets, small_wish("sphere"));
    const ShownPicture moving = seat.wait_for(ShownPicture::Kind::moving, 0),
                       rest = seat.wait_for(ShownPicture::Kind::rest, 0);
    EXPECT_LT(moving.codes.width, 96);
    EXPECT_EQ(moving.width, 96);
    EXPECT_EQ(rest.codes.width, 96);
    EXPECT_EQ(rest.codes.height, 64);
    EXPECT_EQ(rest.scale, 1.0);
}

TEST(DrawScheduler, WhoDoesNotLookGetsTwoPicturesAndHoldsNobodyUp)
{
    AssetCache assets({.cache = false});
    DrawScheduler scheduler(assets);
    Seat stalled(scheduler, assets, small_wish("sphere")), other(scheduler, assets, small_wish("sphere"));
    for (std::uint64_t input = 1; input <= 20; ++input) {
        const Session::Change turn = [](ViewRequest& request, const OrbitCamera::World&) {
            request.eye.orbit(5.0, 0.0);
        };
        stalled.change(input, turn);
        other.change(input, turn);
        EXPECT_EQ(other.wait_for(ShownPicture::Kind::moving, input).input, input);
    }
    other.wait_for(ShownPicture::Kind::rest, 20);
    const std::lock_guard lock(stalled.audience->mutex);
    EXPECT_LE(stalled.audience->pictures.size(), std::size_t{Session::most_in_flight});
}

TEST(DrawScheduler, AMoveOvertakesALongPicture)
{
    AssetCache assets({.cache = false});
    DrawScheduler scheduler(assets);
    ViewRequest request = small_wish("grid");
    set_value(request.asked, "samples", "1024");
    set_size(request, 1600.0, 1200.0);
    Seat seat(scheduler, assets, request);
    seat.wait_for(ShownPicture::Kind::still, 0);
    // The long one is being drawn, or about to be; it is never shown, as the move comes first.
    seat.change(1, [](ViewRequest& w, const OrbitCamera::World&) { w.eye.orbit(5.0, 0.0); });
    const ShownPicture next = seat.wait_for(ShownPicture::Kind::moving, 1);
    EXPECT_EQ(next.input, 1u);
    seat.change(2, [](ViewRequest& w, const OrbitCamera::World&) { set_value(w.asked, "samples", "8"); });
    EXPECT_EQ(seat.wait_for(ShownPicture::Kind::rest, 2).input, 2u);
}

ViewRequest slow_wish()
{
    ViewRequest request = small_wish("grid");
    set_value(request.asked, "samples", "260"); // from 256 on everything is looked at more closely
    const bool is_slow_anyway = testing::patience > 1;
    set_size(request, is_slow_anyway ? 96.0 : 320.0, is_slow_anyway ? 72.0 : 240.0);
    return request;
}

// On many cores it would not be slow.
class SlowPictures : public ::testing::Test {
    tbb::global_control two_cores_{tbb::global_control::max_allowed_parallelism, 2};
};

void orbit(Seat& seat, std::uint64_t input)
{
    seat.change(input, [](ViewRequest& w, const OrbitCamera::World&) { w.eye.orbit(5.0, 0.0); });
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
    for (; !has_come(); ++moves, seat.wait_for(ShownPicture::Kind::moving, input))
        orbit(seat, ++input);
    return moves;
}

// Who moves without end is shown it, and who rests gets the whole picture all the same.
TEST_F(SlowPictures, PauseWhileOthersMove)
{
    AssetCache assets({.cache = false});
    DrawScheduler scheduler(assets);
    std::vector<std::uint8_t> alone;
    {
        Seat seat(scheduler, assets, slow_wish());
        alone = seat.wait_for(ShownPicture::Kind::rest, 0).codes.bytes;
    }
    Seat moving(scheduler, assets, small_wish("sphere"));
    moving.wait_for(ShownPicture::Kind::rest, 0);
    Seat resting(scheduler, assets, slow_wish());
    resting.wait_for(ShownPicture::Kind::still, 0);
    EXPECT_GT(move_until(moving, 0, *resting.audience, resting.audience->pictures), 20u);
    EXPECT_EQ(resting.wait_for(ShownPicture::Kind::rest, 0).codes.bytes, alone);
}

// What is saved is the picture of the moment when that was asked for, whatever moves until it is.
TEST_F(SlowPictures, AreSavedWhileTheViewMoves)
{
    AssetCache assets({.cache = false});
    DrawScheduler scheduler(assets);
    Seat seat(scheduler, assets, slow_wish());
    seat.wait_for(ShownPicture::Kind::moving, 0);
    orbit(seat, 1);
    const std::string command = command_of(seat.session->request(), "picture.png");
    seat.session->save("png");
    scheduler.nudge();
    EXPECT_GT(move_until(seat, 1, *seat.audience, seat.audience->saved), 10u);
    EXPECT_FALSE(seat.session->is_saving());
    const testing::Folder folder;
    EXPECT_EQ(seat.audience->saved.front().command, command);
    EXPECT_EQ(seat.audience->saved.front().bytes, rendered(command, folder));
}

TEST(DrawScheduler, WhoseSceneCannotBeLoadedHoldsNobodyUp)
{
    AssetCache assets({.cache = false});
    DrawScheduler scheduler(assets);
    Seat lost(scheduler, assets, small_wish("nowhere.glb")), other(scheduler, assets, small_wish("sphere"));
    other.wait_for(ShownPicture::Kind::rest, 0);
    EXPECT_FALSE(lost.session->waits_for_moving_picture());
}

TEST(DrawScheduler, APickedPointBecomesTheMiddle)
{
    AssetCache assets({.cache = false});
    DrawScheduler scheduler(assets);
    ViewRequest request = small_wish("sphere");
    request.eye = OrbitCamera(0.0, 0.0);
    Seat seat(scheduler, assets, request);
    seat.wait_for(ShownPicture::Kind::rest, 0);
    seat.session->focus(0.5, 0.5);
    scheduler.nudge();
    ASSERT_TRUE(seat.audience->wait([&] { return seat.session->request().eye.options().size() == 4; }));
    // The sphere of radius 0.5 m stands at the origin: its nearest point.
    const glm::dvec3 target = seat.session->request().eye.target({});
    EXPECT_NEAR(target.x, 0.0, 0.05);
    EXPECT_NEAR(target.y, 0.5, 0.05);
    EXPECT_NEAR(target.z, 0.5, 0.02);
}

TEST(DrawScheduler, WhatCannotBeOpenedIsSaidAndTheOldPictureStays)
{
    AssetCache assets({.cache = false});
    DrawScheduler scheduler(assets);
    Seat seat(scheduler, assets, small_wish("sphere"));
    seat.wait_for(ShownPicture::Kind::rest, 0);
    seat.session->open_scene("nowhere.glb");
    scheduler.nudge();
    const auto says = [&](const std::string& words) {
        return seat.audience->wait([&] {
            return !seat.audience->states.empty() && nlohmann::json::parse(seat.audience->states.back())
                                                             .at("error")
                                                             .get<std::string>()
                                                             .find(words) != std::string::npos;
        });
    };
    EXPECT_TRUE(says("nowhere.glb"));
    EXPECT_EQ(seat.session->request().asked.scene, "sphere");
    seat.session->open_scene("grid");
    scheduler.nudge();
    while (seat.session->request().asked.scene != "grid")
        seat.wait_for(ShownPicture::Kind::moving, 0);
    EXPECT_EQ(seat.session->request().asked.scene, "grid");
}

TEST(DrawScheduler, ChangesThatAreRefusedChangeNothing)
{
    AssetCache assets({.cache = false});
    DrawScheduler scheduler(assets);
    Seat seat(scheduler, assets, small_wish("sphere"));
    const std::string before = seat.session->state();
    EXPECT_THROW(seat.session->change(1,
                                      [](ViewRequest& request, const OrbitCamera::World&) {
                                          set_value(request.asked, "exposure", "2");
                                          set_value(request.asked, "exposure", "-2");
                                      }),
                 Error);
    EXPECT_EQ(seat.session->state(), before);
    EXPECT_THROW(seat.session->save("exe"), Error);
}

TEST(DrawScheduler, ALayerThatAModelDoesNotHaveIsSaid)
{
    AssetCache assets({.cache = false});
    DrawScheduler scheduler(assets);
    ViewRequest request = small_wish("sphere");
    set_value(request.asked, "model", "phong");
    Seat seat(scheduler, assets, request);
    const std::vector<std::uint8_t> picture = seat.wait_for(ShownPicture::Kind::rest, 0).codes.bytes;
    seat.change(1,
                [](ViewRequest& w, const OrbitCamera::World&) { set_value(w.asked, "layer", "metalness"); });
    EXPECT_EQ(seat.wait_for(ShownPicture::Kind::rest, 1).codes.bytes, picture);
    EXPECT_TRUE(seat.audience->wait([&] {
        return seat.audience->states.back().find("the model phong has no layer metalness") !=
               std::string::npos;
    }));
    seat.change(2, [](ViewRequest& w, const OrbitCamera::World&) { set_value(w.asked, "model", "ggx"); });
    EXPECT_NE(seat.wait_for(ShownPicture::Kind::rest, 2).codes.bytes, picture);
    EXPECT_TRUE(nlohmann::json::parse(seat.session->state())["error"].get<std::string>().empty());
}

TEST(DrawScheduler, EveryLayerCanBeLookedAt)
{
    AssetCache assets({.cache = false});
    DrawScheduler scheduler(assets);
    Seat seat(scheduler, assets, small_wish("sphere"));
    std::uint64_t input = 0;
    const std::vector<std::uint8_t> picture = seat.wait_for(ShownPicture::Kind::rest, 0).codes.bytes;
    for (const char* model : {"ggx", "phong"})
        for (const char* layer : {"base_color", "alpha", "roughness", "normal", "depth", "mip_level",
                                  "irradiance", "light_specular"}) {
            seat.change(++input, [&](ViewRequest& request, const OrbitCamera::World&) {
                set_value(request.asked, "model", model);
                set_value(request.asked, "layer", layer);
            });
            EXPECT_NE(seat.wait_for(ShownPicture::Kind::rest, input).codes.bytes, picture)
                << model << " " << layer;
        }
}

// The numbers are those of `lambent compare`, between what the commands write.
TEST(DrawScheduler, TheReferenceFollowsThePictureWithItsError)
{
    AssetCache assets({.cache = false});
    DrawScheduler scheduler(assets);
    ViewRequest request = small_wish("report");
    set_value(request.asked, "exposure", "0.5");
    set_value(request.asked, "layer", "reference");
    set_value(request.asked, "bounces", "2");
    Seat seat(scheduler, assets, request);
    EXPECT_FALSE(seat.wait_for(ShownPicture::Kind::rest, 0).is_last);
    ShownPicture traced = seat.wait_for(ShownPicture::Kind::traced, 0);
    EXPECT_GE(traced.traced->samples, 1.0);
    while (!traced.is_last)
        traced = seat.wait_for(ShownPicture::Kind::traced, 0);
    EXPECT_EQ(traced.codes.width, 96);
    EXPECT_GT(traced.traced->samples, 16.0);
    ASSERT_TRUE(traced.traced->noise.has_value());

    const testing::Folder folder;
    const auto run = [&](const std::vector<std::string>& words) {
        const testing::Outcome outcome = testing::run_program(LAMBENT_PROGRAM, words);
        EXPECT_EQ(outcome.code, 0) << outcome.error;
        return outcome.output;
    };
    run({"render", "report", "--env", "furnace", "--size", "96x64", "--samples", "8", "--bounces", "2", "-o",
         folder.path("a.exr")});
    const auto said =
        nlohmann::json::parse(run({"reference", "report", "--env", "furnace", "--size", "96x64", "--bounces",
                                   "2", "--exposure", "0.5", "--stats", "json", "-o", folder.path("b.exr")}));
    EXPECT_GT(*traced.traced->noise, 0.0);
    EXPECT_NEAR(*traced.traced->noise, said.at("error_covered").get<double>(), 1e-9);
    const auto found = nlohmann::json::parse(
        run({"compare", folder.path("a.exr"), folder.path("b.exr"), "--exposure", "0.5", "--clamp", "1"}));
    EXPECT_NEAR(traced.traced->error, found.at("relative_rmse").get<double>(), 2e-3); // files hold halfs
    EXPECT_GT(traced.traced->error, 0.005);

    seat.change(1, [](ViewRequest& w, const OrbitCamera::World&) { set_value(w.asked, "layer", "error"); });
    ShownPicture error = seat.wait_for(ShownPicture::Kind::traced, 1);
    while (!error.is_last)
        error = seat.wait_for(ShownPicture::Kind::traced, 1);
    run({"render", "report", "--env", "furnace", "--size", "96x64", "--samples", "8", "--exposure", "0.5",
         "--bounces", "2", "-o", folder.path("a.png")});
    run({"reference", "report", "--env", "furnace", "--size", "96x64", "--bounces", "2", "--exposure", "0.5",
         "-o", folder.path("b.png")});
    const auto flip = nlohmann::json::parse(run({"compare", folder.path("a.png"), folder.path("b.png")}));
    ASSERT_TRUE(error.traced->flip.has_value());
    EXPECT_NEAR(*error.traced->flip, flip.at("flip").get<double>(), 1e-6);
    EXPECT_NE(error.codes.bytes, traced.codes.bytes);
}

// Whoever moves gets a picture at once, and the trace begins anew.
TEST(DrawScheduler, AMoveEndsATrace)
{
    AssetCache assets({.cache = false});
    DrawScheduler scheduler(assets);
    ViewRequest request = small_wish("grid");
    set_value(request.asked, "layer", "reference");
    set_size(request, 640.0, 360.0);
    Seat seat(scheduler, assets, request);
    seat.wait_for(ShownPicture::Kind::traced, 0);
    seat.change(1, [](ViewRequest& w, const OrbitCamera::World&) { w.eye.orbit(5.0, 0.0); });
    EXPECT_EQ(seat.wait_for(ShownPicture::Kind::moving, 1).input, 1u);
    EXPECT_EQ(seat.wait_for(ShownPicture::Kind::traced, 1).input, 1u);
    seat.change(2, [](ViewRequest& w, const OrbitCamera::World&) {
        set_value(w.asked, "layer", "picture");
        set_value(w.asked, "bounces", "0");
    });
    EXPECT_TRUE(seat.wait_for(ShownPicture::Kind::rest, 2).is_last);
}

} // namespace
} // namespace lambent::viewer
