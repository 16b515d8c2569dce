#include "sim/method/mixing/support.hpp"

#include <algorithm>
#include <cmath>

namespace sandglass::mixing {

namespace {
/// Columns of squares to a strip: finer ones waste less at its edges.
constexpr double kColumnsPerStrip = 2;
constexpr double kMostColumns = 1e6;
}  // namespace

Support::Support(const SupportParameters& parameters)
    : parameters_(parameters),
      columns_(static_cast<std::size_t>(std::min(kColumnsPerStrip * parameters.columns, kMostColumns))),
      first_(columns_ + 1),
      marked_(parameters.rows) {}

std::uint32_t Support::row_of(double height) const {
  const double row_height = parameters_.row_height();
  const double last = parameters_.rows - 1;
  auto row = static_cast<std::uint32_t>(std::clamp(std::floor(height / row_height), 0.0, last));
  if (row > 0 && height < row * row_height) --row;
  if (row < last && height >= (row + 1) * row_height) ++row;
  return row;
}

std::size_t Support::column_of(double x) const {
  const double column = std::floor(x / parameters_.box[0] * static_cast<double>(columns_));
  return static_cast<std::size_t>(std::clamp(column, 0.0, static_cast<double>(columns_ - 1)));
}

/// The row where its upper edge only begins holds none of it.
Support::Square Support::square_of(const Vector<2>& position, std::uint32_t particle) const {
  const double high = high_edge(position[1]);
  const std::uint32_t first = row_of(low_edge(position[1])), last = row_of(high);
  const bool begins = last > first && !(high > last * parameters_.row_height());
  return {position[0], position[1], particle, first, begins ? last - 1 : last};
}

void Support::prepare(std::span<const Phase<2>> particles) {
  std::ranges::fill(first_, 0u);
  positions_.clear();
  for (const Phase<2>& particle : particles) {
    positions_.push_back(particle.position);
    ++first_[column_of(particle.position[0])];
  }
  std::uint32_t sum = 0;
  for (std::uint32_t& first : first_) {
    sum += first;
    first = sum;
  }
  squares_.resize(particles.size());
  for (std::size_t i = particles.size(); i-- > 0;)
    squares_[--first_[column_of(positions_[i][0])]] = square_of(positions_[i], static_cast<std::uint32_t>(i));
  sort_columns();
}

/// The particle decides between equal heights, so that the order is the same on every machine.
void Support::sort_columns() {
  const auto lower = [](const Square& a, const Square& b) {
    return a.height != b.height ? a.height < b.height : a.particle < b.particle;
  };
  for (std::size_t column = 0; column < columns_; ++column)
    std::sort(squares_.begin() + first_[column], squares_.begin() + first_[column + 1], lower);
}

double Support::share(std::size_t particle) {
  const Vector<2>& position = positions_[particle];
  const double half = 0.5 * parameters_.strip();
  const std::uint32_t row = row_of(position[1]);
  if (row == 0 && !(position[1] > parameters_.diameter)) return 0;
  const Strip strip{std::max(0.0, position[0] - half), std::min(parameters_.box[0], position[0] + half),
                    row == 0 ? position[1] : row * parameters_.row_height(), row};
  const double area = area_below(particle, strip);
  if (!(area > 0)) return 1;
  return 1 - area / (strip.top * (strip.right - strip.left) + parameters_.smallest_length);
}

/// The strip lies within the box, so that walls need not cut the squares along x.
double Support::area_below(std::size_t particle, const Strip& strip) {
  const double radius = 0.5 * parameters_.diameter, height = positions_[particle][1];
  const std::size_t last = column_of(strip.right + radius);
  ++search_;
  filled_ = 0;
  double area = 0;
  for (std::size_t column = column_of(strip.left - radius); column <= last; ++column)
    for (std::uint32_t i = first_[column]; i < first_[column + 1]; ++i) {
      const Square& square = squares_[i];
      if (square.height > height || low_edge(square.height) >= strip.top) break;
      if (square.particle == particle && !parameters_.counts_itself) continue;
      const double width = std::min(square.x + radius, strip.right) - std::max(square.x - radius, strip.left);
      if (!(width > 0)) continue;
      area += width * (std::min(high_edge(square.height), strip.top) - low_edge(square.height));
      mark_rows(square, strip);
    }
  return filled_ < strip.rows ? 0 : area;
}

void Support::mark_rows(const Square& square, const Strip& strip) {
  for (std::uint32_t row = square.first_row; row <= square.last_row && row < strip.rows; ++row) {
    if (marked_[row] == search_) continue;
    marked_[row] = search_;
    ++filled_;
  }
}

std::size_t Support::bytes() const {
  return squares_.capacity() * sizeof(Square) + positions_.capacity() * sizeof(Vector<2>) +
         first_.capacity() * sizeof(std::uint32_t) + marked_.capacity() * sizeof(std::uint64_t);
}

}  // namespace sandglass::mixing
