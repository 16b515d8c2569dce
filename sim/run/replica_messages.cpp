#include "sim/run/replica_messages.hpp"

#include "sim/base/number_lists.hpp"

namespace sandglass {

namespace {

/// Only what differs from replica to replica: the first rank knows the series. Counters may be others in each, as where
/// nobody came in.
void append(std::vector<double>& message, const Replica& replica) {
  for (const Series& series : replica.series) {
    append_list(message, {series.step.begin(), series.step.end()});
    append_list(message, series.time);
    append_list(message, series.value);
  }
  append_list(message, std::vector<double>(replica.counters.size()));
  for (const auto& [name, count] : replica.counters) {
    append_list(message, {name.begin(), name.end()});
    append_list(message, {count});
  }
}

Replica take(NumberLists& lists, Replica replica) {
  for (Series& series : replica.series) {
    const std::vector<double> steps = lists.take();
    series.step.assign(steps.begin(), steps.end());
    series.time = lists.take();
    series.value = lists.take();
  }
  replica.counters.clear();
  for (std::size_t left = lists.take().size(); left > 0; --left) {
    const std::vector<double> name = lists.take();
    replica.counters[std::string(name.begin(), name.end())] = lists.take().at(0);
  }
  return replica;
}

}  // namespace

std::vector<Replica> gather_replicas(Communicator& ranks, std::vector<Replica> own) {
  std::vector<double> message;
  for (const Replica& replica : own) append(message, replica);
  const auto messages = gather(ranks, bytes_of<double>(message));
  if (!ranks.is_first()) return own;
  std::vector<std::vector<double>> numbers;
  for (const auto& bytes : messages) numbers.push_back(numbers_of<double>(bytes));
  std::vector<NumberLists> lists(numbers.begin(), numbers.end());
  std::vector<Replica> all;
  while (lists[all.size() % lists.size()].any())
    all.push_back(take(lists[all.size() % lists.size()], own.front()));
  return all;
}

}  // namespace sandglass
