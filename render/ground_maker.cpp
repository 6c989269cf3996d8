#include "render/ground_maker.hpp"

#include <algorithm>

namespace biotope {

GroundMaker::GroundMaker()
    : maker_([this](const GroundRequest& request, const std::stop_token& outdated, const Maker::Publish& publish) {
        make(request, outdated, publish);
      }) {}

void GroundMaker::request(GroundRequest request) {
  const bool elsewhere = asked_ && !same_extent(*asked_, request.snapshot->terrain());
  asked_ = request.snapshot->surface();
  maker_.request(std::move(request), elsewhere);
}

void GroundMaker::make(const GroundRequest& request, const std::stop_token& outdated, const Maker::Publish& publish) {
  const Terrain& terrain = request.snapshot->terrain();
  if (!last_ || !same_extent(last_->terrain(), terrain)) {
    last_.reset();
    if (std::max(terrain.height.width(), terrain.height.height()) > coarse_ground_side) publish(make_coarse_ground(request));
  }
  auto picture = make_ground(request, last_.get(), outdated);
  if (!picture) return;
  last_ = picture;
  publish(std::move(picture));
}

}  // namespace biotope
