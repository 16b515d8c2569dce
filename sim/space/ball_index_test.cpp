#include "sim/space/ball_index.hpp"

#include "sim/base/random.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace sandglass::ball_index_test {
namespace {

template <int D>
Vector<D> random_point(Random& random, double size) {
  Vector<D> point;
  for (int axis = 0; axis < D; ++axis) point[axis] = size * random.uniform();
  return point;
}

/// The slow twin: every ball is asked for its distance to the box.
template <int D>
std::vector<std::uint32_t> touching(std::span<const Ball<D>> balls, const Vector<D>& low,
                                    const Vector<D>& high) {
  std::vector<std::uint32_t> list;
  for (std::uint32_t i = 0; i < balls.size(); ++i) {
    double square = 0;
    for (int axis = 0; axis < D; ++axis) {
      const double x = balls[i].centre[axis];
      square += std::pow(std::max({0.0, low[axis] - x, x - high[axis]}), 2);
    }
    if (square <= balls[i].radius * balls[i].radius) list.push_back(i);
  }
  return list;
}

template <int D>
void expect_like_twin(const BallIndex<D>& index, const Vector<D>& low, const Vector<D>& high) {
  std::vector<std::uint32_t> found;
  index.for_each_touching(low, high, [&](std::uint32_t i) {
    found.push_back(i);
    return true;
  });
  std::ranges::sort(found);
  const auto expected = touching<D>(index.balls(), low, high);
  ASSERT_EQ(found, expected);
  ASSERT_EQ(index.touches_any(low, high), !expected.empty());
}

/// Balls of every size, boxes from a point to the whole, some of them outside.
template <int D>
void expect_like_twin(std::size_t count, double largest) {
  Random random(StreamKey(7, Purpose::positions, 0, count), D);
  std::vector<Ball<D>> balls(count);
  for (Ball<D>& ball : balls)
    ball = {random_point<D>(random, 10), largest * std::pow(10, -3 * random.uniform())};
  const BallIndex<D> index(balls);
  for (int trial = 0; trial < 300; ++trial) {
    const Vector<D> low = random_point<D>(random, 16) - Vector<D>::Constant(3);
    const double size = trial % 3 == 0 ? 0 : std::pow(10, 3 * random.uniform() - 2);
    expect_like_twin<D>(index, low, low + random_point<D>(random, size));
  }
}

TEST(BallIndex, FindsWhatItsTwinFinds) {
  for (const std::size_t count : {0u, 1u, 2u, 50u, 1000u})
    for (const double largest : {0.1, 1.0, 20.0}) {
      expect_like_twin<2>(count, largest);
      expect_like_twin<3>(count, largest);
    }
}

/// A row of balls along one axis is as thin as a ball.
TEST(BallIndex, TakesBallsInARow) {
  std::vector<Ball<3>> balls;
  for (int i = 0; i < 500; ++i) balls.push_back({{0.1 * i, 0, 0}, 0.04});
  const BallIndex<3> index(balls);
  for (int i = 0; i < 500; ++i) expect_like_twin<3>(index, {0.1 * i - 0.02, -1, -1}, {0.1 * i + 0.15, 0, 0});
}

template <int D>
std::vector<Ball<D>> lattice(int edge, double radius) {
  std::vector<Ball<D>> balls(static_cast<std::size_t>(std::lround(std::pow(edge, D))));
  for (std::size_t i = 0; i < balls.size(); ++i) {
    std::size_t rest = i;
    for (int axis = 0; axis < D; ++axis, rest /= static_cast<std::size_t>(edge))
      balls[i].centre[axis] = static_cast<double>(rest % static_cast<std::size_t>(edge)) + 0.5;
    balls[i].radius = radius;
  }
  return balls;
}

/// As many balls again cost as much memory again, also with one among them that covers all others. The cells stay as large
/// as they were and their lists as long: a look costs what is near.
template <int D>
void expect_linear_memory(int edge) {
  for (const bool giant : {false, true}) {
    double per_ball[2], edge_of_cell[2];
    for (const int factor : {1, 2}) {
      std::vector<Ball<D>> balls = lattice<D>(factor * edge, 0.4);
      if (giant) balls.front().radius = 2 * factor * edge;
      const BallIndex<D> index(balls);
      per_ball[factor - 1] = static_cast<double>(index.bytes()) / static_cast<double>(balls.size());
      edge_of_cell[factor - 1] = index.cell_edge();
    }
    EXPECT_LT(per_ball[1], 1.3 * per_ball[0]);
    EXPECT_LT(per_ball[1], 350);
    EXPECT_LT(edge_of_cell[1], 1.1 * edge_of_cell[0]);
  }
}

TEST(BallIndex, TakesHundredThousandBallsInLinearMemory) {
  expect_linear_memory<2>(160);
  expect_linear_memory<3>(24);
}

}  // namespace
}  // namespace sandglass::ball_index_test
