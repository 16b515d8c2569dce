#include "sim/method/mixing/support.hpp"

#include <algorithm>
#include <cmath>

namespace sandglass::mixing {

namespace {
/// Columns of squares to a strip: finer ones waste less at its edges. Those of filled rows waste no time.
constexpr double kColumnsPerStrip = 2, kColumnsOfRowsPerStrip = 8;
constexpr double kMostColumns = 1e6;

std::uint32_t columns_of(const SupportParameters& parameters, double per_strip) {
  return static_cast<std::uint32_t>(std::min(per_strip * parameters.columns, kMostColumns));
}
}  // namespace

Support::Support(const SupportParameters& parameters)
    : parameters_(parameters),
      radius_(0.5 * parameters.diameter),
      columns_(columns_of(parameters, kColumnsPerStrip)),
      rows_above_(static_cast<std::uint32_t>(
          std::min(std::ceil(radius_ / parameters.row_height()) + 1, static_cast<double>(parameters.rows)))),
      filled_(parameters.box[0], columns_of(parameters, kColumnsOfRowsPerStrip), parameters.rows),
      first_(columns_ + 1),
      below_(columns_),
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
  sort_into_columns(particles);
  take_apart();
  shares_.resize(particles.size());
  for (std::size_t column = 0; column < columns_; ++column)
    for (std::uint32_t i = first_[column]; i < first_[column + 1]; ++i)
      shares_[squares_[i].particle] = share_of(squares_[i], column);
}

/// The particle decides between equal heights, so that the order is the same on every machine.
void Support::sort_into_columns(std::span<const Phase<2>> particles) {
  std::ranges::fill(first_, 0u);
  for (const Phase<2>& particle : particles) ++first_[column_of(particle.position[0])];
  std::uint32_t sum = 0;
  for (std::uint32_t& first : first_) {
    sum += first;
    first = sum;
  }
  squares_.resize(particles.size());
  for (std::size_t i = particles.size(); i-- > 0;) {
    const Vector<2>& position = particles[i].position;
    squares_[--first_[column_of(position[0])]] = square_of(position, static_cast<std::uint32_t>(i));
  }
  const auto lower = [](const Square& a, const Square& b) {
    return a.height != b.height ? a.height < b.height : a.particle < b.particle;
  };
  for (std::size_t column = 0; column < columns_; ++column)
    std::sort(squares_.begin() + first_[column], squares_.begin() + first_[column + 1], lower);
}

/// Into what the loop over whole squares reads, and into rows.
void Support::take_apart() {
  left_.resize(squares_.size());
  right_.resize(squares_.size());
  tall_.resize(squares_.size());
  filled_.begin(squares_.size());
  for (std::size_t i = 0; i < squares_.size(); ++i) {
    const Square& square = squares_[i];
    left_[i] = square.x - radius_;
    right_[i] = square.x + radius_;
    tall_[i] = high_edge(square.height) - low_edge(square.height);
    filled_.add(square.x, square.first_row, square.last_row);
  }
  std::ranges::fill(below_, Below{});
}

Support::Strip Support::strip_of(const Square& square) const {
  const double half = 0.5 * parameters_.strip();
  const std::uint32_t row = row_of(square.height);
  Strip strip{std::max(0.0, square.x - half),
              std::min(parameters_.box[0], square.x + half),
              row == 0 ? square.height : row * parameters_.row_height(),
              row,
              0,
              0};
  strip.first = column_of(strip.left - radius_);
  strip.last = column_of(strip.right + radius_);
  return strip;
}

double Support::share_of(const Square& square, std::size_t column) {
  const Strip strip = strip_of(square);
  if (strip.rows == 0 && !(square.height > parameters_.diameter)) return 0;
  if (filled_.touched(strip.left - radius_, strip.right + radius_) < strip.rows) return 1;
  find_below(square, strip, column);
  if (!is_carried(square, strip)) return 1;
  const double area = area_below(square, strip);
  if (!(area > 0)) return 1;
  return 1 - area / (strip.top * (strip.right - strip.left) + parameters_.smallest_length);
}

/// Particles of `own` come by height, and with it the top of their strips: nothing that was below one is not below the next.
void Support::find_below(const Square& square, const Strip& strip, std::size_t own) {
  for (std::size_t column = strip.first; column <= strip.last; ++column) {
    Below& below = below_[column];
    if (below.of != own + 1) below = {own + 1, first_[column], first_[column]};
    const std::uint32_t end = first_[column + 1];
    while (below.whole < end && high_edge(squares_[below.whole].height) < strip.top) ++below.whole;
    while (below.end < end && squares_[below.end].height <= square.height &&
           low_edge(squares_[below.end].height) < strip.top)
      ++below.end;
  }
}

/// No row is empty. Those that no square above the particle reaches down to show in the columns that lie in the strip.
bool Support::is_carried(const Square& square, const Strip& strip) {
  if (strip.rows == 0) return true;
  const std::uint32_t lower = strip.rows - std::min(strip.rows, rows_above_);
  const std::uint32_t sure =
      lower == 0 ? 0 : std::min(lower, filled_.within(strip.left - radius_, strip.right + radius_));
  return count_filled(square, strip, sure) == strip.rows - sure;
}

/// Rows that are not empty from this one on.
std::uint32_t Support::count_filled(const Square& square, const Strip& strip, std::uint32_t from_row) {
  ++search_;
  std::uint32_t filled = 0;
  for (std::size_t column = strip.first; column <= strip.last; ++column)
    for (std::uint32_t i = below_[column].end; i-- > first_[column];) {
      const Square& other = squares_[i];
      if (other.last_row < from_row) break;
      if (!counts(square, other) || !(width_in(other, strip) > 0)) continue;
      for (std::uint32_t row = std::max(other.first_row, from_row); row <= other.last_row && row < strip.rows;
           ++row) {
        filled += marked_[row] != search_;
        marked_[row] = search_;
      }
    }
  return filled;
}

/// The strip lies within the box, so that walls need not cut the squares along x.
double Support::area_below(const Square& square, const Strip& strip) const {
  double area = 0;
  for (std::size_t column = strip.first; column <= strip.last; ++column) {
    const Below& below = below_[column];
    area = add_whole(area, first_[column], below.whole, strip);
    for (std::uint32_t i = below.whole; i < below.end; ++i) {
      const Square& other = squares_[i];
      if (!counts(square, other)) continue;
      const double width = width_in(other, strip);
      if (width > 0) area += width * (std::min(high_edge(other.height), strip.top) - low_edge(other.height));
    }
  }
  return area;
}

/// One after the other, as the listing adds them up.
double Support::add_whole(double area, std::uint32_t first, std::uint32_t last, const Strip& strip) const {
  for (std::uint32_t i = first; i < last; ++i) {
    const double width = std::min(right_[i], strip.right) - std::max(left_[i], strip.left);
    area += std::max(width, 0.0) * tall_[i];
  }
  return area;
}

std::size_t Support::bytes() const {
  return squares_.capacity() * sizeof(Square) + filled_.bytes() +
         (left_.capacity() + right_.capacity() + tall_.capacity() + shares_.capacity()) * sizeof(double) +
         first_.capacity() * sizeof(std::uint32_t) + below_.capacity() * sizeof(Below) +
         marked_.capacity() * sizeof(std::uint64_t);
}

}  // namespace sandglass::mixing
