// What becomes of a picture at rest that has bounces of light: its error is measured, and it gets more rays.
#include "image/files/image_io.h"
#include "tests/viewer/seat.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace lambent::viewer {
namespace {

using Kind = ShownPicture::Kind;

std::string command_of_last_state(Seat& seat)
{
    const std::lock_guard lock(seat.audience->mutex);
    return nlohmann::json::parse(seat.audience->states.back()).at("command");
}

// The picture at rest whose command has that word, or none of its option, with its measured error.
ShownPicture measured_picture(Seat& seat, std::uint64_t input, const std::string& passes)
{
    for (int i = 0; i < 40; ++i) {
        ShownPicture picture = seat.wait_for(Kind::rest, input);
        const std::string command = command_of_last_state(seat);
        const bool wanted = passes.empty() ? command.find("--passes") == std::string::npos
                                           : command.find(passes) != std::string::npos;
        if (picture.error && wanted)
            return picture;
    }
    ADD_FAILURE() << "no measured picture with " << passes;
    return {};
}

TEST(Refinement, APictureAtRestIsMeasuredAndGetsMoreRays)
{
    AssetCache assets({.cache = false});
    DrawScheduler scheduler(assets);
    Seat seat(scheduler, assets, small_wish("report"));
    const ShownPicture first = seat.wait_for(Kind::rest, 0);
    EXPECT_FALSE(first.error);
    EXPECT_FALSE(first.is_last);
    const ShownPicture measured = seat.wait_for(Kind::rest, 0);
    ASSERT_TRUE(measured.error);
    EXPECT_EQ(measured.codes.bytes, first.codes.bytes);
    EXPECT_LT(measured.error->low, measured.error->relative_rmse);
    const ShownPicture better = measured_picture(seat, 0, "--passes 8 ");
    EXPECT_NE(better.codes.bytes, first.codes.bytes);
    EXPECT_LT(better.error->relative_rmse, measured.error->relative_rmse);
}

// The file has the error in it, so that it is that of the command to the byte.
TEST(Refinement, WhatIsSavedIsWhatTheShownCommandWrites)
{
    AssetCache assets({.cache = false});
    DrawScheduler scheduler(assets);
    Seat seat(scheduler, assets, small_wish("report"));
    measured_picture(seat, 0, "--passes 4 ");
    seat.session->save("png");
    scheduler.nudge();
    ASSERT_TRUE(seat.audience->wait([&] { return !seat.audience->saved.empty(); }));
    const Saved saved = seat.audience->saved.front();
    EXPECT_NE(saved.command.find("--passes"), std::string::npos);
    const std::string bytes(saved.bytes.begin(), saved.bytes.end());
    EXPECT_NE(bytes.find("lambent.error"), std::string::npos);
    const testing::Folder folder;
    EXPECT_EQ(saved.bytes, rendered(saved.command, folder)) << saved.command;
}

TEST(Refinement, AMoveEndsIt)
{
    AssetCache assets({.cache = false});
    DrawScheduler scheduler(assets);
    Seat seat(scheduler, assets, small_wish("report"));
    measured_picture(seat, 0, "--passes 4 ");
    seat.change(1, [](ViewRequest& w, const OrbitCamera::World&) { w.eye.orbit(5.0, 0.0); });
    EXPECT_EQ(seat.wait_for(Kind::moving, 1).input, 1u);
    const ShownPicture rest = seat.wait_for(Kind::rest, 1);
    EXPECT_FALSE(rest.error);
    EXPECT_EQ(command_of_last_state(seat).find("--passes"), std::string::npos);
}

// A sphere alone in a furnace has no error but at its edge, so the first measurement ends it.
TEST(Refinement, EndsWhereThePictureIsGoodEnough)
{
    AssetCache assets({.cache = false});
    DrawScheduler scheduler(assets);
    ViewRequest request = small_wish("sphere");
    set_value(request.asked, "aa", "64");
    set_size(request, 320, 180);
    Seat seat(scheduler, assets, request);
    ShownPicture picture = seat.wait_for(Kind::rest, 0);
    for (int i = 0; i < 10 && !picture.is_last; ++i)
        picture = seat.wait_for(Kind::rest, 0);
    EXPECT_TRUE(picture.is_last);
    ASSERT_TRUE(picture.error);
    EXPECT_LE(picture.error->relative_rmse, 0.01);
}

TEST(Refinement, WithoutBouncesThereIsNone)
{
    AssetCache assets({.cache = false});
    DrawScheduler scheduler(assets);
    ViewRequest request = small_wish("report");
    set_value(request.asked, "bounces", "0");
    Seat seat(scheduler, assets, request);
    const ShownPicture picture = seat.wait_for(Kind::rest, 0);
    EXPECT_TRUE(picture.is_last);
    EXPECT_FALSE(picture.error);
}

// With one bounce the grid's spheres darken each other, in moving pictures too.
TEST(Refinement, MovingViewsHaveShadows)
{
    AssetCache assets({.cache = false});
    DrawScheduler scheduler(assets);
    ViewRequest request = small_wish("grid");
    const auto mean_of_moving = [&](const char* bounces) {
        set_value(request.asked, "bounces", bounces);
        Seat seat(scheduler, assets, request);
        const ShownPicture picture = seat.wait_for(Kind::moving, 0);
        EXPECT_FALSE(picture.lacks_shadows);
        double sum = 0.0;
        for (const std::uint8_t code : picture.codes.bytes)
            sum += code;
        return sum / static_cast<double>(picture.codes.bytes.size());
    };
    // Half of the picture is the background, and codes are not light: the spheres are a tenth darker.
    EXPECT_LT(mean_of_moving("1"), 0.992 * mean_of_moving("0"));
}

} // namespace
} // namespace lambent::viewer
