// Who may come in.
#include "apps/serve/gate.h"

#include <gtest/gtest.h>

namespace lambent::serve {
namespace {

const Gate local{"127.0.0.1", true, ""}, far_away{"0.0.0.0", false, "a b&c"};

TEST(Gate, OnLoopbackOnlyThisMachinesNames)
{
    for (const char* host : {"localhost", "localhost:8080", "127.0.0.1:1", "[::1]:8080", "[::1]"})
        EXPECT_EQ(local.check({host, "", "", "/"}).status, 0u) << host;
    // What a name that somebody else points at this machine sends.
    for (const char* host : {"evil.example", "evil.example:8080", "localhost.evil.example",
                             "127.0.0.1.evil.example", "0.0.0.0", "localhost:8080@evil.example"})
        EXPECT_EQ(local.check({host, "", "", "/"}).status, 403u) << host;
    EXPECT_EQ(local.check({"", "", "", "/"}).status, 400u);
    EXPECT_EQ(local.check({":80", "", "", "/"}).status, 400u);
}

TEST(Gate, OriginsAreTheHosts)
{
    EXPECT_EQ(local.check({"localhost:80", "http://localhost:80", "", "/"}).status, 0u);
    EXPECT_EQ(local.check({"localhost:80", "https://localhost:80", "", "/"}).status, 0u);
    for (const char* origin :
         {"http://evil.example", "null", "http://localhost:81", "http://localhost", "localhost:80"})
        EXPECT_EQ(local.check({"localhost:80", origin, "", "/"}).status, 403u) << origin;
}

TEST(Gate, TokensComeInTheQueryOrTheHeader)
{
    EXPECT_EQ(far_away.check({"h", "", "", "/?token=a%20b%26c"}).status, 0u);
    EXPECT_EQ(far_away.check({"h", "", "", "/socket?x=1&token=a+b%26c"}).status, 0u);
    EXPECT_EQ(far_away.check({"h", "", "Bearer a b&c", "/"}).status, 0u);
    for (const char* target : {"/", "/?token=", "/?token=a", "/?token=a%20b%26d", "/?token=a%20b%26ca",
                               "/?tokens=a%20b%26c", "/?token=%", "/?token=%zz", "/?&&=&token"})
        EXPECT_EQ(far_away.check({"h", "", "", target}).status, 401u) << target;
    EXPECT_EQ(far_away.check({"h", "", "Basic a b&c", "/"}).status, 401u);
}

TEST(Gate, EqualIsEqual)
{
    EXPECT_TRUE(equal_in_constant_time("", ""));
    EXPECT_TRUE(equal_in_constant_time("secret", "secret"));
    for (const char* given : {"", "s", "secre", "secretsecret", "Secret", "secreT"})
        EXPECT_FALSE(equal_in_constant_time(given, "secret")) << given;
    EXPECT_FALSE(equal_in_constant_time("x", ""));
}

} // namespace
} // namespace lambent::serve
