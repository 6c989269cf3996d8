#pragma once

#include "render/background_maker.hpp"
#include "render/ground_picture.hpp"

namespace biotope {

/// Makes pictures of the ground in the background. A ground of another extent than the one before comes as a coarse picture
/// first.
class GroundMaker {
 public:
  GroundMaker();

  /// Of what is asked for while a picture is being made only the newest counts.
  void request(GroundRequest request);
  [[nodiscard]] std::shared_ptr<const GroundPicture> take() { return maker_.take(); }
  [[nodiscard]] bool busy() const { return maker_.busy(); }
  void wait_idle() { maker_.wait_idle(); }
  void retire(std::shared_ptr<const GroundPicture> old) { maker_.retire(std::move(old)); }

 private:
  using Maker = BackgroundMaker<GroundRequest, GroundPicture>;
  void make(const GroundRequest& request, const std::stop_token& outdated, const Maker::Publish& publish);

  /// Terrain of what was asked for last; of the asking thread.
  std::shared_ptr<const Terrain> asked_;
  /// The last whole picture; of the working thread.
  std::shared_ptr<const GroundPicture> last_;
  Maker maker_;
};

}  // namespace biotope
