#include "sim/space/event_calendar.hpp"

#include "sim/base/random.hpp"

#include <cmath>
#include <queue>

#include <gtest/gtest.h>

namespace sandglass::event_calendar_test {
namespace {

using Entry = EventCalendar::Entry;

/// The slow twin: the timetable of the source (Baryshev 2003, 2.4), a binary heap; here with several entries an owner, as
/// the calendar has them.
struct Heap {
  struct Later {
    bool operator()(const Entry& a, const Entry& b) const { return b < a; }
  };
  std::priority_queue<Entry, std::vector<Entry>, Later> queue;
  void push(double time, std::uint32_t owner) { queue.push({time, owner}); }
};

/// Both give the same next entry; that of the calendar is taken out.
void expect_same_next(EventCalendar& calendar, Heap& heap, double& now) {
  ASSERT_FALSE(heap.queue.empty());
  const Entry* entry = calendar.front();
  ASSERT_NE(entry, nullptr);
  ASSERT_EQ(entry->time, heap.queue.top().time);
  ASSERT_EQ(entry->owner, heap.queue.top().owner);
  now = entry->time;
  calendar.pop();
  heap.queue.pop();
}

TEST(EventCalendar, AnEmptyRowHasNoNextEntry) {
  EventCalendar calendar;
  EXPECT_EQ(calendar.front(), nullptr);
  calendar.start(1, 10);
  EXPECT_EQ(calendar.front(), nullptr);
  EXPECT_EQ(calendar.front(), nullptr);
  calendar.push(3, 7);  // into the part that is already sorted
  ASSERT_NE(calendar.front(), nullptr);
  EXPECT_EQ(calendar.front()->owner, 7u);
  calendar.pop();
  EXPECT_EQ(calendar.front(), nullptr);
}

TEST(EventCalendar, TiesComeInTheOrderOfTheirOwners) {
  EventCalendar calendar;
  calendar.start(0.5, 4);
  for (const std::uint32_t owner : {5u, 3u, 9u, 0u, 4u}) calendar.push(1.25, owner);
  calendar.push(1, 8);
  for (const std::uint32_t owner : {8u, 0u, 3u, 4u, 5u, 9u}) {
    ASSERT_NE(calendar.front(), nullptr);
    EXPECT_EQ(calendar.front()->owner, owner);
    calendar.pop();
  }
}

TEST(EventCalendar, LeavesWhatLiesBeyondTheRowToTheOwner) {
  EventCalendar calendar;
  calendar.start(0.5, 4);
  calendar.push(2, 1);
  calendar.push(1e300, 2);
  calendar.push(HUGE_VAL, 3);
  EXPECT_EQ(calendar.front(), nullptr);
  calendar.push(std::nextafter(2, 0), 4);
  ASSERT_NE(calendar.front(), nullptr);
  EXPECT_EQ(calendar.front()->owner, 4u);
}

TEST(EventCalendar, ARowWithoutAnEndTakesEveryFiniteTime) {
  EventCalendar calendar;
  calendar.start(HUGE_VAL, 1);
  for (const double time : {3.0, HUGE_VAL, 1e300, 0.0}) calendar.push(time, 1);
  for (const double time : {0.0, 3.0, 1e300}) {
    ASSERT_NE(calendar.front(), nullptr);
    EXPECT_EQ(calendar.front()->time, time);
    calendar.pop();
  }
  EXPECT_EQ(calendar.front(), nullptr);
}

TEST(EventCalendar, PeekLooksAheadInTheSameOrder) {
  EventCalendar calendar;
  calendar.start(1, 100);
  for (std::uint32_t i = 0; i < 100; ++i) calendar.push(99 - i, i);
  ASSERT_NE(calendar.front(), nullptr);
  for (std::size_t ahead = 0; ahead < 20; ++ahead) {
    ASSERT_NE(calendar.peek(ahead), nullptr);
    EXPECT_EQ(calendar.peek(ahead)->time, static_cast<double>(ahead));
  }
  EXPECT_EQ(calendar.peek(1000), nullptr);
}

/// Random times at the rate of a gas: most a little ahead, some at once, some equal, some far away. One era after another.
TEST(EventCalendar, GivesTheOrderOfAHeap) {
  Random random(StreamKey(1, Purpose::positions, 0, 0), 0);
  EventCalendar calendar;
  for (const double width : {1e-140, 0.01, 0.3, 50.0, 1e140}) {
    Heap heap;
    constexpr std::size_t buckets = 40;
    calendar.start(width, buckets);
    double now = 0, equal = 0;
    std::uint32_t pushed = 0;
    const auto push = [&](double time) {
      const auto owner = static_cast<std::uint32_t>(random.bits() % 50);
      calendar.push(time, owner);
      if (time * (1 / width) < buckets) heap.push(time, owner), ++pushed;
    };
    for (int i = 0; i < 100; ++i) push(width * buckets * random.uniform());
    while (!heap.queue.empty() && pushed < 20000) {
      expect_same_next(calendar, heap, now);
      if (HasFatalFailure()) return;
      if (random.uniform() < 0.05) equal = now + width * random.uniform();
      const double kind = random.uniform();
      for (int i = 0; i < (kind < 0.1 ? 2 : 1); ++i)
        push(kind < 0.1    ? now
             : kind < 0.2  ? std::max(now, equal)
             : kind < 0.9  ? now - 0.2 * width * std::log(1 - random.uniform())
             : kind < 0.99 ? now + 5 * width * random.uniform()
                           : HUGE_VAL);
    }
    while (!heap.queue.empty()) {
      expect_same_next(calendar, heap, now);
      if (HasFatalFailure()) return;
    }
    EXPECT_EQ(calendar.front(), nullptr);
    EXPECT_GT(pushed, 200u);
  }
}

/// Storage is used again: it follows the entries to come, not those that have been.
TEST(EventCalendar, DoesNotGrowInALongRun) {
  Random random(StreamKey(2, Purpose::positions, 0, 0), 0);
  EventCalendar calendar;
  std::size_t first = 0;
  for (int era = 0; era < 20; ++era) {
    calendar.start(1, 100);
    for (std::uint32_t i = 0; i < 1000; ++i) calendar.push(3 * random.uniform(), i);
    while (const Entry* entry = calendar.front()) {
      const Entry event = *entry;
      calendar.pop();
      calendar.push(event.time + 3 * random.uniform(), event.owner);
    }
    if (era == 4) first = calendar.bytes();
  }
  EXPECT_LE(calendar.bytes(), first * 5 / 4);
  EXPECT_LT(calendar.bytes(), 200000u);
}

}  // namespace
}  // namespace sandglass::event_calendar_test
