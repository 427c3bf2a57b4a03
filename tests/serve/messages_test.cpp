// Messages of browsers and of those who are none.
#include "apps/serve/link.h"
#include "apps/serve/messages.h"
#include "base/error.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace lambent::serve {
namespace {

class Nobody : public viewer::Presenter {
public:
    void show(viewer::ShownPicture) override {}
    void say(const std::string&) override {}
    void save(viewer::Saved) override {}
};

struct Messages : ::testing::Test {
    MessageKind said(const std::string& message) { return handle_message(message, session, files); }
    viewer::ViewRequest request() { return session.request(); }

    viewer::AssetCache assets{{.cache = false}};
    viewer::FileList files{{}};
    viewer::Session session{viewer::default_request("plane", "furnace"), assets, std::make_shared<Nobody>()};
};

TEST_F(Messages, DoWhatTheySay)
{
    EXPECT_EQ(said(R"({"do": "seen"})"), MessageKind::seen);
    EXPECT_EQ(said(R"({"do": "set", "name": "exposure", "value": 2.5, "id": 3})"), MessageKind::input);
    said(R"({"do": "set", "name": "tone", "value": "agx"})");
    said(R"({"do": "turn", "by": 190})");
    said(R"({"do": "lights", "list": ["point:1,2,3,4,5,6"]})");
    said(R"({"do": "size", "width": 100, "height": 50})");
    said(R"({"do": "orbit", "x": 10, "y": 5})");
    EXPECT_EQ(viewer::value_of(request().asked, "exposure"), "2.5");
    EXPECT_EQ(viewer::value_of(request().asked, "tone"), "agx");
    EXPECT_EQ(viewer::value_of(request().asked, "env-rotation"), "-170");
    EXPECT_EQ(request().asked.light_words.size(), 1u);
    EXPECT_EQ(request().asked.settings.width, 100);
    EXPECT_NEAR(request().eye.azimuth(), 40.0, 1e-3);
    said(R"({"do": "reset"})");
    EXPECT_EQ(viewer::value_of(request().asked, "exposure"), "1");
    EXPECT_NEAR(request().eye.azimuth(), 30.0, 1e-3);
    EXPECT_EQ(request().asked.settings.width, 100);
}

TEST_F(Messages, MalformedOnesAreNamedAndChangeNothing)
{
    const std::string before = session.state();
    const std::string deep = std::string(4000, '[') + std::string(4000, ']');
    for (const std::string& message :
         {std::string(), std::string("x"), std::string("[]"), std::string("1"), std::string("{}"),
          std::string("{\"do\":1}"), std::string("{\"do\":\"fly\"}"), std::string("{\"do\":\"orbit\"}"),
          std::string("{\"do\":\"orbit\",\"x\":\"1\",\"y\":0}"),
          std::string("{\"do\":\"set\",\"name\":1,\"value\":1}"),
          std::string("{\"do\":\"set\",\"name\":\"tone\",\"value\":[]}"),
          std::string("{\"do\":\"lights\",\"list\":[1]}"), std::string("{\"do\":\"lights\",\"list\":{}}"),
          std::string("{\"do\":\"scene\"}"), std::string("{\"do\":\"save\"}"), std::string("\xff\xfe{}"),
          std::string("{\"do\":\"seen\"", 12), deep})
        EXPECT_THROW(said(message), Malformed) << message.substr(0, 60);
    EXPECT_EQ(session.state(), before);
}

TEST_F(Messages, ValuesThatDoNotFitAreRefusedWithALine)
{
    const std::string before = session.state();
    for (const char* message :
         {R"({"do": "set", "name": "exposure", "value": -1})",
          R"({"do": "set", "name": "samples", "value": 1e9})", R"({"do": "set", "name": "fly", "value": 1})",
          R"({"do": "lights", "list": ["spot:1"]})", R"({"do": "save", "kind": "../x"})",
          R"({"do": "scene", "name": "/etc/passwd"})", R"({"do": "scene", "name": "../../x.glb"})",
          R"({"do": "environment", "name": "x.hdr"})"})
        EXPECT_THROW(said(message), Error) << message;
    EXPECT_EQ(session.state(), before);
}

TEST_F(Messages, HugeNumbersLeaveAPictureThatCanBeDrawn)
{
    for (const char* what : {"orbit", "pan"})
        for (const char* amount : {"1e308", "-1e308"})
            said(std::string("{\"do\": \"") + what + "\", \"x\": " + amount + ", \"y\": " + amount + "}");
    said(R"({"do": "dolly", "by": 1e308})");
    said(R"({"do": "turn", "by": 1e308})");
    said(R"({"do": "size", "width": 1e308, "height": -1e308})");
    EXPECT_NO_THROW(viewer::arguments_of(request()));
}

TEST(Message, FramesBeginWithTheLengthOfTheirHeader)
{
    const std::vector<std::uint8_t> picture = {1, 2, 3}, frame = frame_message("{}", picture);
    EXPECT_EQ(frame, (std::vector<std::uint8_t>{2, 0, 0, 0, '{', '}', 1, 2, 3}));
    EXPECT_EQ(frame_message(std::string(300, ' '), picture)[1], 1);
}

TEST(Message, TheHelloIsJson)
{
    const nlohmann::json hello = nlohmann::json::parse(serve::hello(viewer::FileList({})));
    EXPECT_EQ(hello.at("parameters").size(), viewer::parameters().size());
    EXPECT_GT(hello.at("scenes").size(), 3u);
    EXPECT_EQ(nlohmann::json::parse(error_message("a\nb")).at("line"), "a?b");
}

TEST(Link, QualityFollowsTheWay)
{
    Link link;
    for (int i = 0; i < 50; ++i)
        link.seen(500.0);
    EXPECT_EQ(link.quality(), Link::worst);
    for (int i = 0; i < 50; ++i)
        link.seen(5.0);
    EXPECT_EQ(link.quality(), Link::best);
}

} // namespace
} // namespace lambent::serve
