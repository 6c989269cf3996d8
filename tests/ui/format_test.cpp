#include <catch2/catch.hpp>
#include <limits>

#include "ui/format.hpp"

using namespace biotope;

TEST_CASE("a number shows three significant digits and its thousands apart") {
  CHECK(format_number(0) == "0");
  CHECK(format_number(4.5678) == "4.57");
  CHECK(format_number(45.678) == "45.7");
  CHECK(format_number(456.78) == "457");
  CHECK(format_number(4567.8) == "4568");
  CHECK(format_number(1234567) == "1 234 567");
  CHECK(format_number(-12345) == "-12 345");
  CHECK(format_number(0.012345) == "0.0123");
  CHECK(format_number(0.99996) == "1.00");
  CHECK(format_number(9.9996) == "10.0");
}

TEST_CASE("what is not known is never shown as zero") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(format_number(nan) == "unknown");
  CHECK(format_value(nan, "m") == "unknown");
  CHECK(format_percent(nan) == "unknown");
  CHECK(format_length(std::numeric_limits<double>::infinity()) == "unknown");
}

TEST_CASE("a share that is tiny is not shown as none") {
  CHECK(format_percent(0) == "0 %");
  CHECK(format_percent(0.0001) == "< 0.1 %");
  CHECK(format_percent(0.034) == "3.4 %");
  CHECK(format_percent(0.996) == "100 %");
}

TEST_CASE("lengths change to kilometres at a kilometre") {
  CHECK(format_length(850) == "850 m");
  CHECK(format_length(3200) == "3.20 km");
}

TEST_CASE("a round length claims no digits it does not have") {
  CHECK(format_round_length(1000) == "1 km");
  CHECK(format_round_length(2500) == "2.5 km");
  CHECK(format_round_length(200) == "200 m");
  CHECK(format_round_length(0.5) == "0.5 m");
  CHECK(format_round_number(2) == "2");
  CHECK(format_round_number(-0.25) == "-0.25");
  CHECK(format_round_number(1e-7) == "1.0e-07");
}

TEST_CASE("an hour is read modulo a day") {
  CHECK(format_clock(6 + 40 / 60.0) == "06:40");
  CHECK(format_clock(24) == "00:00");
  CHECK(format_clock(-1) == "23:00");
  CHECK(format_clock(23.9999) == "00:00");
}

TEST_CASE("memory has units") {
  CHECK(format_bytes(999) == "999 B");
  CHECK(format_bytes(3'400'000) == "3.24 MiB");
  // What a setting says in megabytes of memory is told as that.
  CHECK(format_bytes(std::size_t(1024) << 20) == "1.00 GiB");
  CHECK(format_bytes(std::size_t(512) << 20) == "512 MiB");
}

TEST_CASE("months have names") {
  CHECK(month_name(0) == "January");
  CHECK(short_month_name(11) == "Dec");
}
