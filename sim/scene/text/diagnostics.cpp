#include "sim/scene/text/diagnostics.hpp"

#include <algorithm>

namespace sandglass {

namespace {
/// What holds the value at `path`: "a[1].b" is in "a[1]", that in "a".
std::string holder_of(const std::string& path) {
  const std::size_t end = path.find_last_of(".[");
  return path.substr(0, end == std::string::npos ? 0 : end);
}
}  // namespace

Diagnostics::Diagnostics(std::string file_name, const Node& root) : file_name_(std::move(file_name)) {
  remember(root, "");
}

void Diagnostics::remember(const Node& node, const std::string& path) {
  places_[path] = node.place;
  for (std::size_t i = 0; i < node.items.size(); ++i) {
    const Node& item = node.items[i];
    remember(item, node.kind == Node::Kind::table ? join_path(path, item.key) : item_path(path, i));
  }
}

Place Diagnostics::find(std::string path) const {
  while (true) {
    if (const auto found = places_.find(path); found != places_.end()) return found->second;
    if (path.empty()) return {};
    path = holder_of(path);
  }
}

void Diagnostics::report(const std::string& path, const std::string& message) {
  report_at(find(path), path, message);
}

void Diagnostics::report_at(Place place, const std::string& path, const std::string& message) {
  entries_.push_back({place, path, message});
  reported_.insert(path);
  for (std::string holder = path; !holder.empty(); holder = holder_of(holder)) holders_.insert(holder);
}

bool Diagnostics::clean(const std::string& path) const {
  if (holders_.contains(path)) return false;
  for (std::string holder = path; !holder.empty(); holder = holder_of(holder))
    if (reported_.contains(holder)) return false;
  return true;
}

void Diagnostics::raise() const {
  if (entries_.empty()) return;
  std::vector<Entry> sorted = entries_;
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const Entry& a, const Entry& b) { return a.place < b.place; });
  std::vector<Diagnostic> diagnostics;
  for (const Entry& entry : sorted)
    diagnostics.push_back({file_name_, entry.place.line, entry.place.column, entry.message});
  throw InputError(std::move(diagnostics));
}

std::string join_path(const std::string& path, const std::string& key) {
  return path.empty() ? key : path + '.' + key;
}

std::string item_path(const std::string& path, std::size_t index) {
  return path + '[' + std::to_string(index) + ']';
}

std::string shown(const std::string& path) {
  std::string text = "'";
  bool number = false;
  for (const char character : path) {
    number = number || character == '[';
    if (!number) text += character;
    number = number && character != ']';
  }
  return text + "'";
}

}  // namespace sandglass
