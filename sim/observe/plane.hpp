#pragma once

#include <cstdint>
#include <vector>

namespace sandglass {

/// A plane that counts the particles passing it, by normal velocity. Counts are integers: their order cannot show.
class Plane {
 public:
  /// `edges`: rising bin edges of the normal velocity; the outer bins take what lies beyond them.
  Plane(int axis, double position, std::vector<double> edges);

  int axis() const { return axis_; }
  double position() const { return position_; }
  const std::vector<double>& edges() const { return edges_; }

  /// One particle passed, with this normal velocity.
  void count(double velocity) {
    ++histogram_[bin(velocity)];
    ++(velocity > 0 ? up_ : down_);
  }

  /// Passages by bin since the last call.
  std::vector<double> take_histogram();
  /// Passages since time zero, upwards and downwards.
  double up() const { return static_cast<double>(up_); }
  double down() const { return static_cast<double>(down_); }

  /// The passages that another has counted.
  void add(const Plane& other);
  /// No passage.
  void clear();

  std::vector<double> save() const;
  void load(const std::vector<double>& state);

 private:
  std::size_t bin(double velocity) const;

  int axis_;
  double position_;
  std::vector<double> edges_;
  std::vector<std::uint64_t> histogram_;
  std::uint64_t up_ = 0, down_ = 0;
};

}  // namespace sandglass
