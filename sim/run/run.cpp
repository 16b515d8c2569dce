#include "sim/run/run.hpp"

#include "sim/base/stop_request.hpp"
#include "sim/record/provenance.hpp"
#include "sim/run/estimates.hpp"
#include "sim/run/pace.hpp"
#include "sim/run/replica.hpp"
#include "sim/run/replica_messages.hpp"
#include "sim/run/sharing.hpp"

#include <chrono>
#include <ctime>

#include <fmt/format.h>

namespace sandglass {

namespace {

constexpr std::size_t kLongestReason =
    10'000;  // an attribute of a file has room for six times as many letters

double thread_cpu_seconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// CPU and wall time since construction, on top of what an interrupted run had used.
class Stopwatch {
 public:
  explicit Stopwatch(const std::map<std::string, double>& before) : before_(before) {}
  void read(std::map<std::string, double>& timings) const {
    const auto of = [&](const char* name) { return before_.contains(name) ? before_.at(name) : 0.0; };
    timings["cpu-seconds"] = of("cpu-seconds") + thread_cpu_seconds() - cpu_;
    timings["wall-seconds"] =
        of("wall-seconds") + std::chrono::duration<double>(std::chrono::steady_clock::now() - wall_).count();
  }

 private:
  std::map<std::string, double> before_;
  double cpu_ = thread_cpu_seconds();
  std::chrono::steady_clock::time_point wall_ = std::chrono::steady_clock::now();
};

Record empty_record(const Scene& scene, const RunOptions& options) {
  Record record;
  record.provenance = current_provenance();
  record.provenance.planted_fault = options.planted_fault;
  record.dimension = scene.domain.dimension;
  record.box_size = scene.domain.size;
  for (const auto& sides : scene.domain.sides)
    record.boundary.push_back(sides[0] == Side::periodic ? "periodic" : "none");
  return record;
}

/// All replicas of one scene, one after the other, into one record; or those of this rank.
template <int D>
class Runner {
 public:
  Runner(const Scene& scene, const RunOptions& options, Record record)
      : options_(options),
        setup_(set_up<D>(scene, options.planted_fault)),
        scene_(setup_.scene),
        record_(std::move(record)),
        sharing_(sharing_of(scene, options.ranks == nullptr ? 1 : options.ranks->count(),
                            record_.state.has_value())),
        watch_(is_first() ? record_.timings : std::map<std::string, double>{}),
        pace_(options.progress) {
    record_.scene = write_scene(scene_);
    if (!record_.state) record_.warnings = plan_of(setup_).warnings;
    if (scene.output.checkpoint) checkpoints_.emplace(*scene.output.checkpoint);
    for (const Replica& replica : record_.replicas) moves_before_ += replica.counters.at("particle-moves");
  }

  Record run() {
    while (replica() < scene_.run.replicas) {
      try {
        run_replica();
      } catch (const StoppedWithinStep&) {
        throw Interrupted(fmt::format("stopped before the first step of replica {} of {}", replica() + 1,
                                      scene_.run.replicas),
                          false);
      }
    }
    if (sharing_ == Sharing::replicas)
      record_.replicas = gather_replicas(*options_.ranks, std::move(record_.replicas));
    if (is_first()) record_.estimates = estimate(record_.replicas, cumulative_);
    watch_.read(record_.timings);
    if (sharing_ != Sharing::none) add_timings();
    return std::move(record_);
  }

 private:
  bool is_first() const { return options_.ranks == nullptr || options_.ranks->is_first(); }

  /// The coming one.
  std::uint64_t replica() const {
    if (sharing_ != Sharing::replicas) return record_.replicas.size();
    return options_.ranks->rank() + options_.ranks->count() * record_.replicas.size();
  }

  void run_replica() {
    ReplicaRun<D> replica(setup_, {scene_.run.seed, this->replica()},
                          record_.state ? &*record_.state : nullptr,
                          sharing_ == Sharing::cells ? options_.ranks : nullptr);
    record_.state.reset();
    if (checkpoints_) checkpoints_->resume(replica.clock());
    cumulative_ = replica.cumulative();
    try {
      while (!replica.done()) {
        replica.step();
        attend(replica);
      }
    } catch (const Interrupted&) {
      throw;
    } catch (const std::exception& error) {
      const std::string where = place(replica.clock());
      keep_broken(replica, fmt::format("{}: {}", where, error.what()));
      if (dynamic_cast<const StoppedWithinStep*>(&error) == nullptr) throw;
      throw Interrupted("stopped within the step after " + where + ", which did not end in time", false);
    }
    finish(replica);
  }

  std::string place(const Clock& clock) const {
    return fmt::format("step {}, time {:.6g}, replica {} of {}", clock.step, clock.time, this->replica() + 1,
                       scene_.run.replicas);
  }

  /// What it has up to the last step that ended. Nothing may hide the error that broke it. Where ranks share the work the
  /// others know nothing of it yet.
  void keep_broken(ReplicaRun<D>& replica, const std::string& reason) {
    if (!options_.keep_broken || sharing_ != Sharing::none) return;
    try {
      Record broken = std::move(record_);
      take_frames(broken, replica);
      broken.replicas.push_back(replica.result());
      broken.estimates = estimate(broken.replicas, cumulative_);
      watch_.read(broken.timings);
      broken.broken = reason.substr(0, kLongestReason);
      options_.keep_broken(broken);
    } catch (const std::exception&) {
    }
  }

  /// What may happen between two steps: checkpoint, request to stop, progress.
  void attend(ReplicaRun<D>& replica) {
    if (checkpoints_ && checkpoints_->due(replica.clock())) write_checkpoint(replica);
    if (options_.stop != nullptr && any_rank(options_.stop->load(std::memory_order_relaxed))) stop(replica);
    if (pace_.due()) report(replica);
  }

  /// A signal reaches the ranks at different steps.
  bool any_rank(bool own) const {
    return sharing_ == Sharing::cells ? sum_over(*options_.ranks, {own}).front() > 0 : own;
  }

  void finish(ReplicaRun<D>& replica) {
    record_.timings["peak-bytes"] =
        std::max(record_.timings["peak-bytes"], static_cast<double>(replica.bytes()));
    if (setup_.particles > 0)
      record_.timings["bytes-per-particle"] =
          static_cast<double>(replica.bytes()) / static_cast<double>(setup_.particles);
    imbalance_ += replica.imbalance();
    ++shared_;
    take_frames(record_, replica);
    moves_before_ += static_cast<double>(replica.moves());
    record_.replicas.push_back(replica.result());
  }

  static void take_frames(Record& record, ReplicaRun<D>& replica) {
    for (const Frame& frame : replica.trajectory()) record.trajectory.push_back(frame);
  }

  void write_checkpoint(ReplicaRun<D>& replica) {
    if (options_.checkpoint_path.empty()) return;
    State state = replica.save();
    if (is_first()) write_checkpoint(replica, std::move(state));
  }

  void write_checkpoint(ReplicaRun<D>& replica, State state) {
    Record checkpoint = record_;
    checkpoint.state = std::move(state);
    take_frames(checkpoint, replica);
    watch_.read(checkpoint.timings);
    write_record(options_.checkpoint_path, checkpoint);
  }

  /// Of all ranks.
  void add_timings() {
    auto& own = record_.timings;
    const auto all = collect<double>(*options_.ranks, {own["cpu-seconds"], own["peak-bytes"]});
    own["cpu-seconds"] = own["peak-bytes"] = 0;
    for (const auto& each : all) {
      own["cpu-seconds"] += each[0];
      own["peak-bytes"] += each[1];
    }
    own["ranks"] = static_cast<double>(all.size());
    if (sharing_ == Sharing::replicas) return;
    own["imbalance"] = imbalance_ / static_cast<double>(shared_);
    if (setup_.particles > 0)
      own["bytes-per-particle"] = own["peak-bytes"] / static_cast<double>(setup_.particles);
  }

  [[noreturn]] void stop(ReplicaRun<D>& replica) {
    const bool everywhere = sharing_ != Sharing::replicas;
    if (everywhere) write_checkpoint(replica);
    any_rank(true);  // the others wait for the checkpoint
    throw Interrupted("stopped at " + place(replica.clock()), everywhere);
  }

  void report(ReplicaRun<D>& replica) {
    const Clock& clock = replica.clock();
    const double done = static_cast<double>(this->replica()) + fraction_done(scene_.run.duration, clock);
    pace_.report({done / static_cast<double>(scene_.run.replicas), 0, 0, this->replica(), clock.step,
                  clock.time, clock.collisions},
                 moves_before_ + static_cast<double>(replica.moves()));
  }

  const RunOptions& options_;
  Setup<D> setup_;
  const Scene& scene_;
  Record record_;
  Sharing sharing_;
  Stopwatch watch_;
  Pace pace_;
  std::optional<Schedule> checkpoints_;
  std::set<std::string> cumulative_;
  double moves_before_ = 0;
  double imbalance_ = 0;      ///< of the replicas of this process so far, added up
  std::uint64_t shared_ = 0;  ///< how many they are
};

Record run_from(const Scene& scene, const RunOptions& options, Record record) {
  if (scene.domain.dimension == 2) return Runner<2>(scene, options, std::move(record)).run();
  return Runner<3>(scene, options, std::move(record)).run();
}

}  // namespace

Record run_scene(const Scene& scene, const RunOptions& options) {
  validate(scene);
  return run_from(scene, options, empty_record(scene, options));
}

Record resume(const Record& checkpoint, const RunOptions& options) {
  const Scene scene = read_scene_text(checkpoint.scene, "scene of the checkpoint");
  return run_from(scene, options, checkpoint);
}

}  // namespace sandglass
