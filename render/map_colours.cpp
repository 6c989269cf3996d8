#include "render/map_colours.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "render/map_renderer.hpp"

namespace biotope {
namespace {

using Colour = std::array<float, 3>;

// Nine evenly spaced samples of matplotlib's viridis and inferno (CC0 data).
constexpr std::array<Colour, 9> viridis{{{0.267F, 0.005F, 0.329F},
                                         {0.279F, 0.175F, 0.483F},
                                         {0.230F, 0.322F, 0.546F},
                                         {0.173F, 0.449F, 0.558F},
                                         {0.128F, 0.567F, 0.551F},
                                         {0.158F, 0.684F, 0.502F},
                                         {0.369F, 0.789F, 0.383F},
                                         {0.678F, 0.864F, 0.190F},
                                         {0.993F, 0.906F, 0.144F}}};
constexpr std::array<Colour, 9> inferno{{{0.001F, 0.000F, 0.014F},
                                         {0.122F, 0.047F, 0.282F},
                                         {0.336F, 0.062F, 0.428F},
                                         {0.536F, 0.134F, 0.415F},
                                         {0.735F, 0.216F, 0.330F},
                                         {0.894F, 0.351F, 0.194F},
                                         {0.978F, 0.558F, 0.035F},
                                         {0.976F, 0.789F, 0.203F},
                                         {0.988F, 0.998F, 0.645F}}};
// Ramps of our own, lightness falling evenly from pale to deep.
constexpr std::array<Colour, 5> greens{{{0.930F, 0.925F, 0.760F},
                                        {0.690F, 0.800F, 0.480F},
                                        {0.400F, 0.640F, 0.300F},
                                        {0.170F, 0.460F, 0.230F},
                                        {0.040F, 0.260F, 0.150F}}};
constexpr std::array<Colour, 5> browns{{{0.960F, 0.900F, 0.770F},
                                        {0.890F, 0.730F, 0.500F},
                                        {0.760F, 0.520F, 0.290F},
                                        {0.560F, 0.320F, 0.150F},
                                        {0.310F, 0.150F, 0.070F}}};
constexpr std::array<Colour, 5> blues{{{0.910F, 0.930F, 0.900F},
                                       {0.620F, 0.790F, 0.840F},
                                       {0.340F, 0.600F, 0.750F},
                                       {0.150F, 0.390F, 0.610F},
                                       {0.050F, 0.180F, 0.400F}}};
// Orange - pale - blue: told apart with any kind of colour vision.
constexpr std::array<Colour, 5> diverging{{{0.650F, 0.300F, 0.050F},
                                           {0.930F, 0.670F, 0.380F},
                                           {0.950F, 0.940F, 0.910F},
                                           {0.520F, 0.690F, 0.820F},
                                           {0.130F, 0.330F, 0.560F}}};
// Okabe and Ito's eight, without black, and five between them.
constexpr std::array<Colour, category_colours> categorical{{{0.902F, 0.624F, 0.000F},
                                                            {0.337F, 0.706F, 0.914F},
                                                            {0.000F, 0.620F, 0.451F},
                                                            {0.800F, 0.475F, 0.655F},
                                                            {0.941F, 0.894F, 0.259F},
                                                            {0.000F, 0.447F, 0.698F},
                                                            {0.835F, 0.369F, 0.000F},
                                                            {0.600F, 0.600F, 0.560F},
                                                            {0.560F, 0.760F, 0.400F},
                                                            {0.480F, 0.380F, 0.640F},
                                                            {0.720F, 0.560F, 0.420F},
                                                            {0.350F, 0.420F, 0.400F}}};

float to_linear(float c) { return c <= 0.04045F ? c / 12.92F : std::pow((c + 0.055F) / 1.055F, 2.4F); }
float to_display(float c) {
  c = std::clamp(c, 0.0F, 1.0F);
  return c <= 0.0031308F ? 12.92F * c : 1.055F * std::pow(c, 1 / 2.4F) - 0.055F;
}

/// Ottosson's Oklab, in which equal steps look equal.
Colour to_oklab(const Colour& c) {
  const float r = to_linear(c[0]), g = to_linear(c[1]), b = to_linear(c[2]);
  const float l = std::cbrt(0.4122214708F * r + 0.5363325363F * g + 0.0514459929F * b);
  const float m = std::cbrt(0.2119034982F * r + 0.6806995451F * g + 0.1073969566F * b);
  const float s = std::cbrt(0.0883024619F * r + 0.2817188376F * g + 0.6299787005F * b);
  return {0.2104542553F * l + 0.7936177850F * m - 0.0040720468F * s, 1.9779984951F * l - 2.4285922050F * m + 0.4505937099F * s,
          0.0259040371F * l + 0.7827717662F * m - 0.8086757660F * s};
}

Colour from_oklab(const Colour& c) {
  const float l = std::pow(c[0] + 0.3963377774F * c[1] + 0.2158037573F * c[2], 3.0F);
  const float m = std::pow(c[0] - 0.1055613458F * c[1] - 0.0638541728F * c[2], 3.0F);
  const float s = std::pow(c[0] - 0.0894841775F * c[1] - 1.2914855480F * c[2], 3.0F);
  return {to_display(4.0767416621F * l - 3.3077115913F * m + 0.2309699292F * s),
          to_display(-1.2684380046F * l + 2.6097574011F * m - 0.3413193965F * s),
          to_display(-0.0041960863F * l - 0.7034186147F * m + 1.7076147010F * s)};
}

Colour along(std::span<const Colour> stops, float t) {
  const float position = std::clamp(t, 0.0F, 1.0F) * float(stops.size() - 1);
  const auto stop = std::min(std::size_t(position), stops.size() - 2);
  const float f = position - float(stop);
  const Colour a = to_oklab(stops[stop]);
  const Colour b = to_oklab(stops[stop + 1]);
  return from_oklab({a[0] + f * (b[0] - a[0]), a[1] + f * (b[1] - a[1]), a[2] + f * (b[2] - a[2])});
}

}  // namespace

std::array<float, 3> colour_of(ColourMap map, float t) {
  switch (map) {
    case ColourMap::viridis:
      return along(viridis, t);
    case ColourMap::greens:
      return along(greens, t);
    case ColourMap::browns:
      return along(browns, t);
    case ColourMap::blues:
      return along(blues, t);
    case ColourMap::inferno:
      return along(inferno, t);
    case ColourMap::diverging:
      return along(diverging, t);
    case ColourMap::categorical:
      break;
  }
  const int category = std::clamp(int(t * float(category_colours)), 0, category_colours - 1);
  return categorical[std::size_t(category)];
}

std::array<float, 3> category_colour(int category) {
  const int wrapped = ((category % category_colours) + category_colours) % category_colours;
  return categorical[std::size_t(wrapped)];
}

std::vector<std::uint8_t> colour_table() {
  std::vector<std::uint8_t> table;
  table.reserve(std::size_t(colour_maps) * colour_table_width * 4);
  for (int map = 0; map < colour_maps; ++map) {
    for (int i = 0; i < colour_table_width; ++i) {
      const Colour colour = colour_of(ColourMap(map), (float(i) + 0.5F) / float(colour_table_width));
      for (const float channel : colour) table.push_back(std::uint8_t(std::lround(channel * 255.0F)));
      table.push_back(255);
    }
  }
  return table;
}

}  // namespace biotope
