// Scenes that move, played and stopped.
#include "tests/scene/sliding_model.h"
#include "tests/viewer/seat.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <fstream>

namespace lambent::viewer {
namespace {

class Animations : public ::testing::Test {
protected:
    Animations() { write(scene::test::sliding_model()); }

    void write(const std::vector<std::uint8_t>& bytes) const
    {
        std::ofstream(model, std::ios::binary)
            .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    }

    ViewRequest request() const
    {
        ViewRequest request = small_wish(model);
        set_value(request.asked, "background", "none");
        return request;
    }

    testing::Folder folder;
    const std::string model = folder.path("m.glb");
    AssetCache assets{{.cache = false}};
    DrawScheduler scheduler{assets};
};

// Where what is seen is on average, from the left.
double middle_of(const image::CodeImage& codes)
{
    double sum = 0.0, count = 0.0;
    for (std::size_t i = 0; i < codes.bytes.size() / 4; ++i)
        if (codes.bytes[4 * i + 3] > 127) {
            sum += static_cast<double>(i % static_cast<std::size_t>(codes.width));
            count += 1.0;
        }
    return sum / count;
}

TEST_F(Animations, AMomentIsDrawnAsTheCommandDrawsIt)
{
    Seat seat(scheduler, assets, request());
    const ShownPicture still = seat.wait_for(ShownPicture::Kind::rest, 0);
    seat.session->animate(1, 0.0);
    seat.session->seek(2, 1.5);
    scheduler.nudge();
    const ShownPicture moved = seat.wait_for(ShownPicture::Kind::rest, 2);
    EXPECT_EQ(moved.moment, 1.5);
    EXPECT_NE(moved.codes.bytes, still.codes.bytes);
    seat.session->save("png");
    scheduler.nudge();
    ASSERT_TRUE(seat.audience->wait([&] { return !seat.audience->saved.empty(); }));
    const Saved saved = seat.audience->saved.front();
    EXPECT_NE(saved.command.find(" --animation=slide --moment=1.5"), std::string::npos) << saved.command;
    EXPECT_EQ(saved.bytes, rendered(saved.command, folder)) << saved.command;
    // And back: the first scene again, byte for byte.
    seat.session->animate(3, -1.0);
    scheduler.nudge();
    EXPECT_EQ(seat.wait_for(ShownPicture::Kind::rest, 3).codes.bytes, still.codes.bytes);
}

TEST_F(Animations, TwoViewersSeeTheirOwnMoments)
{
    Seat one(scheduler, assets, request()), two(scheduler, assets, request());
    one.wait_for(ShownPicture::Kind::rest, 0);
    one.session->animate(1, 0.0);
    one.session->seek(2, 2.0);
    scheduler.nudge();
    const ShownPicture moved = one.wait_for(ShownPicture::Kind::rest, 2),
                       still = two.wait_for(ShownPicture::Kind::rest, 0);
    EXPECT_NE(moved.codes.bytes, still.codes.bytes);
    two.change(1, [](ViewRequest& w, const OrbitCamera::World&) { set_value(w.asked, "exposure", "2"); });
    two.change(2, [](ViewRequest& w, const OrbitCamera::World&) { set_value(w.asked, "exposure", "1"); });
    EXPECT_EQ(two.wait_for(ShownPicture::Kind::rest, 2).codes.bytes, still.codes.bytes);
}

TEST_F(Animations, PlayingGoesOnUntilItIsStopped)
{
    Seat seat(scheduler, assets, request());
    seat.wait_for(ShownPicture::Kind::rest, 0);
    seat.session->play(1, true);
    scheduler.nudge();
    ShownPicture first = seat.wait_for(ShownPicture::Kind::moving, 1), later = first;
    for (int i = 0; i < 1000 && !(later.moment > first.moment + 0.3); ++i)
        later = seat.wait_for(ShownPicture::Kind::moving, 1);
    EXPECT_GT(later.moment, first.moment + 0.3);
    seat.session->play(2, false);
    scheduler.nudge();
    const ShownPicture rest = seat.wait_for(ShownPicture::Kind::rest, 2);
    EXPECT_GE(rest.moment, later.moment);
    EXPECT_LE(rest.moment, 2.0);
    const auto state = nlohmann::json::parse(seat.session->state());
    EXPECT_EQ(state["animations"],
              nlohmann::json::parse(R"([{"name":"slide","seconds":2.0},{"name":"sink","seconds":4.0}])"));
    EXPECT_EQ(state["animation"], 0);
    EXPECT_FALSE(state["playing"].get<bool>());
}

// A metre to the right, whatever is asked for beyond the end.
TEST_F(Animations, MomentsEndWithTheAnimation)
{
    Seat seat(scheduler, assets, request());
    seat.session->animate(1, 0.0); // also before it is loaded
    const double before = middle_of(seat.wait_for(ShownPicture::Kind::rest, 0).codes);
    seat.session->animate(2, 0.0);
    seat.session->seek(3, 1e300);
    scheduler.nudge();
    const ShownPicture end = seat.wait_for(ShownPicture::Kind::rest, 3);
    EXPECT_EQ(end.moment, 2.0);
    EXPECT_GT(middle_of(end.codes), before + 5.0);
    seat.session->seek(4, std::nan(""));
    EXPECT_EQ(seat.session->request().moment, 0.0);
    EXPECT_THROW(seat.session->animate(5, 2.0), Error);
    EXPECT_THROW(seat.session->animate(5, 0.5), Error);
}

TEST_F(Animations, TheReferenceIsOfTheMoment)
{
    ViewRequest still = request();
    set_value(still.asked, "bounces", "0");
    set_value(still.asked, "layer", "reference");
    Seat seat(scheduler, assets, still);
    seat.wait_for(ShownPicture::Kind::rest, 0);
    seat.session->animate(1, 0.0);
    seat.session->seek(2, 2.0);
    scheduler.nudge();
    const ShownPicture drawn = seat.wait_for(ShownPicture::Kind::rest, 2),
                       traced = seat.wait_for(ShownPicture::Kind::traced, 2);
    EXPECT_NEAR(middle_of(traced.codes), middle_of(drawn.codes), 1.0);
    EXPECT_LT(traced.traced->error, 0.2);
}

// A trace is of the file as it is now, not as it was when the trace began.
TEST_F(Animations, TheReferenceBeginsAnewWhenTheFileChanges)
{
    ViewRequest compared = request();
    set_value(compared.asked, "layer", "reference");
    Seat seat(scheduler, assets, compared);
    const double before = middle_of(seat.wait_for(ShownPicture::Kind::traced, 0).codes);
    scene::test::GltfBuilder changed = scene::test::triangle();
    changed.document["nodes"].push_back({{"mesh", 0}, {"translation", {2, 0, 0}}});
    changed.document["scenes"][0]["nodes"].push_back(changed.document["nodes"].size() - 1);
    write(changed.glb());
    ShownPicture traced = seat.wait_for(ShownPicture::Kind::traced, 0);
    for (int i = 0; i < 1000 && std::fabs(middle_of(traced.codes) - before) < 3.0; ++i)
        traced = seat.wait_for(ShownPicture::Kind::traced, 0);
    const ShownPicture drawn = [&] {
        seat.change(
            1, [](ViewRequest& w, const OrbitCamera::World&) { set_value(w.asked, "layer", "picture"); });
        return seat.wait_for(ShownPicture::Kind::rest, 1);
    }();
    EXPECT_NEAR(middle_of(traced.codes), middle_of(drawn.codes), 1.0);
}

// The file is exported again without what was chosen: the viewer goes on.
TEST_F(Animations, OneThatIsGoneIsForgotten)
{
    Seat seat(scheduler, assets, request());
    seat.wait_for(ShownPicture::Kind::rest, 0);
    seat.session->animate(1, 1.0);
    seat.session->play(2, true);
    scheduler.nudge();
    seat.wait_for(ShownPicture::Kind::moving, 2);
    write(scene::test::triangle().glb());
    seat.wait_for(ShownPicture::Kind::rest, 2); // it plays no more
    EXPECT_EQ(seat.session->request().asked.animation, "");
    EXPECT_TRUE(nlohmann::json::parse(seat.session->state())["error"].get<std::string>().empty());
}

// Whoever plays always waits for the next picture: others' long ones are left for it.
TEST_F(Animations, WhoPlaysIsHungry)
{
    Seat seat(scheduler, assets, request());
    seat.wait_for(ShownPicture::Kind::rest, 0);
    EXPECT_FALSE(seat.session->waits_for_moving_picture());
    seat.session->play(1, true);
    for (int i = 0; i < 5; ++i) {
        EXPECT_TRUE(seat.session->waits_for_moving_picture());
        scheduler.nudge();
        seat.wait_for(ShownPicture::Kind::moving, 1);
    }
    seat.session->play(2, false);
    scheduler.nudge();
    seat.wait_for(ShownPicture::Kind::rest, 2);
    EXPECT_FALSE(seat.session->waits_for_moving_picture());
}

} // namespace
} // namespace lambent::viewer
